"""Openings of a facade as it stands: holes of the wall, whatever is seen in them.

Each pixel of an elevation (`grid`) shows the wall, something behind it, something in front, or nothing
(`states`). A wall has a surface that leans and bulges (`wall_surface`) and may have parallel parts in front
and behind (`layers`); how far apart its points are changes over it (`spacings`). What shows something behind
are regions (`regions`), without the shadows of cars (`shadows`) and divided at landings (`floors`), and what
is seen in them gives their depth and their use (`content`, `niches`). The outlines of the parts are in
`parts`; those of the openings are made in the room `outlines`.

Public names: `states.make_states`, `regions.find_regions`, `floors.divide_at_floors`,
`content.fill_regions`, `content.Opening`, `niches.with_niches`, `parts.part_outlines`,
`settings.OpeningSettings`.
"""

"""Openings of a facade as it stands: holes of the wall, whatever is seen in them.

Each pixel of an elevation (`grid`) shows the wall, something behind it, something in front, or nothing
(`states`). A wall has a surface that leans and bulges (`wall_surface`) and may have parallel parts in front
and behind (`layers`). What shows something behind are regions (`regions`), and what is seen in them gives
their depth and their use (`content`, `niches`). Their outlines are made in the room `outlines`.

Public names: `states.make_states`, `regions.find_regions`, `content.fill_regions`, `content.Opening`,
`niches.with_niches`, `settings.OpeningSettings`.
"""

"""The plan of a storey that lies under a ceiling: faces and seen floor first (beyond the paper).

The points become voxels with normals (`voxels`), which show floor, ceiling and upright surfaces (`levels`).
Upright surfaces become straight sheets (`sheets`) on common lines (`regular`). Where floor or ceiling was
seen is in `footprint`. The lines of the sheets and the outline of the footprint divide the storey into cells
(`arrangement`), which are room or solid by the cheapest cut (`division`, `minimum_cut`). How much upright
surface stands along a line is in `evidence`.

Rooms end at openings and necks (`room_cells`, `openings`, `necks`, `spaces`). The walls stand behind their
faces, and behind those that bound no room (`free_faces`, `wall_bodies`). They are cut into pieces
(`wall_pieces`) and measured (`walls`). In the region of the storey (`roof`) its plan replaces that of the
density image (`joining`).

Public names: `joining.plan_storey`, `joining.join_walls`, `joining.join_rooms`, `joining.bodies`,
`storey_plan.make_storey_plan`, `storey_plan.StoreyPlan`, `storey_plan.LeftOut`, `room_cells.Room`,
`walls.Wall`, `settings.StoreySettings`.
"""

"""The plan of a storey: faces and seen floor first.

From points to rooms and walls, one step a module, each on arrays and shapely geometry:

voxels        points become voxels of 2 cm with normals; spacing and noise are measured
levels        floor, ceiling, and by pixel the levels of 10 cm that upright surface fills
sheets        straight upright surfaces are grown over these pixels; `regular` puts them on common lines
footprint     by pixel, how sure it is that floor or ceiling was seen
arrangement   the lines of sheets and the footprint's outline divide the storey into cells
evidence      how much upright surface stands along a line
division      `minimum_cut` calls the cells room or solid; the borders between them are faces or limits
openings      rooms are cut under lintels and over sills; `necks` cuts them at narrow places
room_cells    the rooms, and the parapets below windows
free_faces    faces that bound no room: facades, and thin walls that stand free
wall_bodies   what stands behind faces; `wall_pieces` cuts it between junctions, `walls` measures it
storey_plan   all of it: `make_storey_plan`
"""

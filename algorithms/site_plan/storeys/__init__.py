"""The plan of a storey that lies under a ceiling: faces and seen floor first (beyond the paper).

What the points show is in `evidence`. It divides the storey into rooms and solid (`division`). Rooms end at
openings and necks (`rooms`), and walls stand behind faces (`walls`). In the region of the storey its plan
replaces that of the density image (`joining`). What the user should look at is in `doubts`.

Public names: `joining.plan_storey`, `joining.join_walls`, `joining.join_rooms`, `joining.bodies`,
`doubts.doubts`, `storey_plan.make_storey_plan`, `storey_plan.StoreyPlan`, `settings.StoreySettings`.
"""

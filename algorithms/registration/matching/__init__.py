"""Which target of a scan is which control point.

Public names: `scan_matching.match_scan`, which returns a `ScanMatch` or a `refusals.Refusal`.
The search: `matching_matrix` or `similar_triangles` -> `seeds` -> `refinement` -> `solution_search`. The
decision: `accidental_matches`, `refusals`, `diagnosis`, `match_warnings`. Both work on a
`matching_task.MatchingTask`.
"""

"""Which target of a scan is which control point.

The search: `matching_matrix` or `similar_triangles` -> `seeds` -> `refinement` -> `solution_search`. The
decision: `accidental_matches`, `refusals`, `diagnosis`, `match_warnings`. Both work on a
`matching_task.MatchingTask`.

Public names: `scan_matching.match_scan`, `scan_matching.ScanMatch`, `refusals.Refusal`.
"""

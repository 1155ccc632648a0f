"""The parameters and destinations of the algorithms.

Kinds: `parameter` (`Number`, `Choice`, `Flag`, `ReferenceSystem`), `files`, `point_lists`, `outlines`, and
`destinations` for outputs. The parameters themselves are in modules named after what they are about.
"""

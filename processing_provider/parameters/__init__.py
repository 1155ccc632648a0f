"""The parameters and destinations of the algorithms.

The kinds of inputs are in `parameter`, `files`, `point_lists` and `outlines`, those of outputs in
`destinations`. The parameters themselves are in modules named after what they are about.

Public names: `parameter.Number`, `parameter.Choice`, `parameter.Flag`, `parameter.ReferenceSystem`; and the
lists of parameters in the other modules.
"""

"""New files of points: chosen ones, labelled ones, transformed ones.

Public names: `point_selection.write_cloud`, `labelling.write_labelled`, `transformation.transform_cloud`,
`transformation.transformed_names`, `transformation.refuse_other_units`,
`transformation.rounding_warnings`.
"""

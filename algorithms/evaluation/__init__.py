"""How good a result is: a plan against a reference, a schedule against tape measurements.

Public names: `plan.compare_plan`, `plan.PlanAgreement`, `reference.drawn_reference`,
`reference.compare_with_reference`, `outlines.outlines_of`, `outlines.disagreements`,
`plan_layer.write_errors`, `plan_report.write_plan_report`, `length_lists.read_schedule`,
`length_lists.read_reference`, `lengths.compare_lengths`, `lengths.LengthComparison`,
`lengths_table.write_table`, `lengths_report.write_lengths_report`, `settings.EvaluationSettings`.
"""

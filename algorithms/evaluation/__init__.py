"""How good a result is: a plan against a reference, a schedule against tape measurements.

Public names, by their modules: `plan` compare_plan, PlanAgreement; `outlines` outlines_of, disagreements;
`plan_layer` write_errors; `plan_report` write_plan_report; `length_lists` read_schedule, read_reference;
`lengths` compare_lengths, LengthComparison; `lengths_table` write_table; `lengths_report`
write_lengths_report; `settings` EvaluationSettings.
"""

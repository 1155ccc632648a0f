"""The least squares adjustment of one scan and of all, and its statistics.

Public names: `scan_adjustment.fit_scan`, `block_adjustment.adjust_block`, `evaluation.Evaluation`,
`control_network.ControlNetwork`, `similarity.Pose`, `similarity.fit_pose`; and the tests of
`statistical_tests`.
"""

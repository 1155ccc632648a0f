"""The simulation of scans, before they are made.

Public names: `simulation.simulate`, `simulation_report.write_simulation_report`, `trials.write_trials`.
"""

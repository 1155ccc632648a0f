"""Every reader on damaged files, in child processes with limits of memory and time.

    python3 -m ichnograph.tests.fuzz --minutes 10 las e57

Public names: `readers.READERS`, `mutations.mutate`.
"""

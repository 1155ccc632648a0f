"""Reference systems in threads that Python did not make."""

import sys

import pytest
from ichnograph.processing_provider import projections


def test_what_pyproj_makes_for_a_thread_of_qgis_is_there_in_the_next_run(qgis_application):
    pyproj = pytest.importorskip("pyproj")
    from qgis.PyQt.QtCore import QRunnable, QThreadPool

    names, made = [], []

    class Run(QRunnable):
        def run(self):
            with projections.projections_kept():
                names.append(pyproj.CRS.from_epsg(25833).name)
                context = sys.modules.get("pyproj._context")
                made.append(getattr(context, "get_context_manager", lambda: None)())

    pool = QThreadPool()
    pool.setMaxThreadCount(1)
    pool.setExpiryTimeout(-1)
    runs = [Run(), Run(), Run()]
    for run in runs:
        run.setAutoDelete(False)
        pool.start(run)
        assert pool.waitForDone(60_000)

    assert names == ["ETRS89 / UTM zone 33N"] * 3
    assert {manager for manager in made if manager is not None} <= projections._kept

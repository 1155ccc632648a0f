"""What pyproj keeps for a thread, in the threads of QGIS.

QGIS runs an algorithm in a thread of a pool. Python forgets such a thread when the run ends, and pyproj 3.7.0
to 3.7.2 then frees its context of PROJ, but finds it again when the next run takes the same thread: QGIS
crashes (https://github.com/pyproj4/pyproj/issues/1622). A context that is kept here is not freed.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

_kept: set[Any] = set()
"""One a thread of the pool, until QGIS ends; nothing shorter outlives the thread."""


@contextmanager
def projections_kept() -> Iterator[None]:
    """Keep what pyproj has made for this thread while the block ran."""
    try:
        yield
    finally:
        module = sys.modules.get("pyproj._context")
        # Before 3.7.0 there is no such function, and no such error.
        manager = getattr(module, "get_context_manager", lambda: None)()
        if manager is not None:
            _kept.add(manager)

"""Load the checkout as the package ``ichnograph``, whatever its folder is called."""

import importlib.util
import os
import sys
from pathlib import Path

ROOT = Path(__file__).parent

# The tests read what QGIS says in English, whatever the language of the computer.
os.environ["LC_ALL"] = "C.UTF-8"

if "ichnograph" not in sys.modules:
    spec = importlib.util.spec_from_file_location(
        "ichnograph", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["ichnograph"] = package
    spec.loader.exec_module(package)

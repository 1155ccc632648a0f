"""What each idea of the plan of a storey contributes: it is switched off, on real scans with drawn plans.

make ablation CLOUDS=folder [REFERENCES=folder], or: python3 -m ichnograph.benchmarks.ablation FOLDER
    [--references FOLDER]

FOLDER holds clouds, REFERENCES drawn plans of the same names, as for `make real`. Means over all clouds at
5 cm; all other settings are the defaults.
"""

import argparse
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.algorithms.site_plan.storeys.settings import StoreySettings

from .real_clouds import Row, compared, scans

NEVER = 1e9

IDEAS: dict[str, tuple[str, dict[str, float]]] = {
    "nothing": ("cut", {}),
    "planes are tried through sparse points": ("voxels", {"lonely_share": 1.0, "mixing_radius_m": NEVER}),
    "the steps of stairs are floor": ("footprint", {"riser_m": -NEVER}),
    "borders cost less on full faces": ("cut", {"seen_border": 1.0}),
    "what was seen of a core counts for all of it": ("cut", {"core_seen_share": 0.0}),
    "lines extend to hidden corners": ("cut", {"extension_m": 0.0}),
    "shadows are filled": ("cut", {"shadow_share": 0.0}),
    "faces hidden in solid are explained": ("cut", {"unexplained_m": 0.0}),
    "a wall has surface": (
        "cut",
        {"fewest_levels": 0.0, "off_sheet_levels": 0.0, "cut_levels": 0.0, "body_levels": 0.0},
    ),
    "the side of upright surface is not known": ("footprint", {"upright_levels": 65}),
    "only sampling gaps are closed": ("footprint", {"closed_m": 0.5, "closed_spacings": 12.0}),
    "sheets share lines": ("sheets", {"shared_offset_m": 0.0}),
    "short sheets are squared": ("sheets", {"square_within_m": 0.0}),
    "rooms end at openings": ("rooms", {"widest_opening_m": 0.0, "widest_window_m": 0.0}),
    "rooms end at necks": ("rooms", {"neck_m": 0.01}),
    "faces may bound no room": ("free_faces", {"run_m": NEVER, "screen_m": NEVER}),
    "columns of the density image": ("joining", {"column_m2": 0.0}),
}
"""Ideas, and the settings of a stage without which the plan does without them."""


def without(idea: str) -> StoreySettings:
    """Return the settings with an idea switched off."""
    stage, values = IDEAS[idea]
    settings = StoreySettings()
    return replace(settings, **{stage: replace(getattr(settings, stage), **values)})


def row(label: str, found: list[Row]) -> str:
    """Return a row of the table: means over clouds, and sums of rooms."""
    means = [
        np.mean([getattr(one.agreement, name) for one in found]) for name in ("completeness", "correctness")
    ]
    rooms = [one.rooms for one in found if one.rooms]
    sums = [sum(getattr(one, name) for one in rooms) for name in ("found", "missed", "invented")]
    return f"| {label} | {means[0]:.3f} | {means[1]:.3f} | {' / '.join(map(str, sums))} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--references", type=Path, help="folder of <cloud>.geojson; that of the clouds")
    parser.add_argument("--idea", nargs="+", choices=list(IDEAS), default=list(IDEAS))
    arguments = parser.parse_args()
    references = arguments.references or arguments.folder
    print("| without | complete | correct | rooms found / missed / invented |")
    print("|---|---|---|---|")
    with tempfile.TemporaryDirectory() as work:
        clouds = [
            (path, references / f"{name}.geojson")
            for name, path in scans(arguments.folder, Path(work))
            if (references / f"{name}.geojson").exists()
        ]
        for idea in arguments.idea:
            settings = SitePlanSettings(with_rooms=True, storeys=without(idea))
            found = [compared(make_site_plan(open_cloud([path]), settings), truth) for path, truth in clouds]
            print(row(idea, found), flush=True)
        # For comparison, without all of them.
        density = SitePlanSettings(with_rooms=True, storey=False)
        found = [compared(make_site_plan(open_cloud([path]), density), truth) for path, truth in clouds]
        print(row("the plan of the storey (STOREY=no)", found))


if __name__ == "__main__":
    main()

"""Print a digest of every layer and list that the toolbox makes, to see what a change of the code changed.

scripts/fingerprints.py OUT --plans FOLDER --facades FOLDER --lists FOLDER > before.txt

Run it before and after a change, and compare the two lists.

Makes the layers of every simulated scene at one seed, and those of the clouds and lists in the folders,
through qgis_process. Clouds and results stay in OUT; simulated clouds that are there already are used again.
"""

import argparse
import hashlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCENES = ("columns", "interior", "rooms", "ruins", "terraces", "yard")
FACADES = ("medina", "storehouse", "townhouse")
COARSE = ("--angular-step", "0.3")
PLACE = ("--move", "12", "412345.6", "5812345.7", "71.3", "--crs", "EPSG:25833")
CLOUDS = (".las", ".laz", ".xyz", ".e57", ".ptx", ".pts", ".ply")
LAYERS = (".shp", ".dbf", ".shx", ".prj", ".tif", ".json", ".csv")


def run(algorithm: str, *arguments: str) -> None:
    """Run an algorithm; if it refuses its input, its files are missing from the digests."""
    command = [str(ROOT / "scripts" / "qgis_process"), "run", f"ichnograph:{algorithm}", "--", *arguments]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        errors = [line for line in done.stderr.splitlines() if line.strip()]
        print(f"{algorithm} {' '.join(arguments)}: {errors[-1] if errors else 'failed'}", file=sys.stderr)


def simulate(module: str, name: str, path: Path, *arguments: str) -> Path:
    """Write a simulated scan, unless it exists."""
    if not path.exists():
        command = [sys.executable, "-m", module, name, str(path), *arguments]
        subprocess.run(command, check=True, env={**os.environ, "PYTHONPATH": python_path()})
    return path


def python_path() -> str:
    """Return where Python finds the checkout and its packages."""
    return os.pathsep.join(str(ROOT / folder) for folder in (".plugins", ".packages"))


def site_plan(cloud: Path, folder: Path) -> None:
    """Make the plan of a cloud, with the outlines on the faces and with those of pixels."""
    new(folder)
    outputs = ("density.tif", "plan.tif", "walls.shp", "axes.shp", "rooms.shp")
    named = [f"{Path(name).stem.upper()}={folder / name}" for name in outputs]
    run("siteplan", f"INPUT={cloud}", *named)
    run("siteplan", f"INPUT={cloud}", "REFINE=false", f"WALLS={folder / 'pixels.shp'}")


def facade(cloud: Path, folder: Path) -> None:
    """Make the elevation and the planes of a cloud."""
    new(folder)
    outputs = {"ELEVATION": "elevation.shp", "DETAILS": "details.shp", "ORTHOIMAGE": "orthoimage.tif"}
    outputs["SCHEDULE"] = "schedule.csv"
    run("facadedetails", f"INPUT={cloud}", *(f"{key}={folder / name}" for key, name in outputs.items()))
    run("facadeplanes", f"INPUT={cloud}", f"PLANES={folder / 'planes.shp'}")


def registration(control: Path, targets: list[Path], folder: Path, *arguments: str) -> None:
    """Register scans by their lists of targets."""
    new(folder)
    outputs = ("transforms.json", "residuals.shp", "control_out.shp")
    named = [f"{Path(name).stem.upper()}={folder / name}" for name in outputs]
    run("registerscans", f"CONTROL={control}", *(f"TARGETS={path}" for path in targets), *arguments, *named)


def new(folder: Path) -> None:
    """Empty a folder of results."""
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        path.unlink()


def simulated(out: Path) -> None:
    """Make the layers of every simulated scene."""
    for scene in SCENES:
        cloud = simulate(
            "ichnograph.tests.scenes", scene, out / f"{scene}.laz", "--angular-step", "0.3", *PLACE
        )
        site_plan(cloud, out / scene)
    for name in FACADES:
        path = out / f"{name}.laz"
        facade(
            simulate("ichnograph.tests.scenes.facades", name, path, "--spacing", "0.02", *PLACE), out / name
        )
    control = out / "control.txt"
    options = (*COARSE, "--survey", str(control), *PLACE[:5])
    simulate("ichnograph.tests.scenes", "ruins", out / "survey.laz", *options)
    registration(control, sorted(out.glob("survey_*.txt")), out / "survey", "CRS=EPSG:25833")


def clouds(folder: Path) -> Iterator[tuple[Path, str]]:
    """Yield the clouds in a folder, and a name for the results of each."""
    for cloud in sorted(path for path in folder.rglob("*") if path.suffix.lower() in CLOUDS):
        yield cloud, "_".join(cloud.relative_to(folder).parts).replace(".", "_")


def published(folder: Path, out: Path) -> None:
    """Register the published lists in a folder, with every model."""
    for target in sorted(folder.rglob("*_target.txt")):
        source = target.with_name(target.name.replace("_target", "_source"))
        for model in range(5):
            registration(target, [source], out / f"{source.stem}_{model}", f"MODEL={model}", "SIGMA=0.05")


def digests(out: Path) -> Iterator[str]:
    """Yield a line for each layer and list; the date in a dbf is left out."""
    for path in sorted(path for path in out.rglob("*") if path.suffix in LAYERS and path.parent != out):
        content = bytearray(path.read_bytes())
        if path.suffix == ".dbf":
            content[1:4] = bytes(3)
        yield f"{hashlib.sha256(content).hexdigest()} {path.relative_to(out)}"


def main() -> None:
    """Make all layers, and print their digests."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("out", type=Path)
    for kind, help_text in (
        ("plans", "of clouds for plans"),
        ("facades", "of clouds for elevations"),
        ("lists", "of lists *_source.txt, *_target.txt"),
    ):
        parser.add_argument(f"--{kind}", type=Path, nargs="*", default=[], metavar="FOLDER", help=help_text)
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    simulated(out)
    for folder in arguments.plans:
        for cloud, name in clouds(folder.resolve()):
            site_plan(cloud, out / "plans" / name)
    for folder in arguments.facades:
        for cloud, name in clouds(folder.resolve()):
            facade(cloud, out / "facades" / name)
    for folder in arguments.lists:
        published(folder.resolve(), out / "lists")
    print("\n".join(digests(out)))


if __name__ == "__main__":
    main()

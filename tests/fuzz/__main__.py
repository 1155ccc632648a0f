"""Run the readers on damaged files for as long as asked, and print how many there were and what was found.

    python3 -m ichnograph.tests.fuzz --minutes 60 [reader ...]

Each finding is kept in build/fuzz with its traceback. A test of the reader should follow from it.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

from .child import SECONDS
from .readers import READERS

BATCH = 20
"""Seconds that a child runs; a new one begins with fresh memory."""


def main() -> int:
    """Return 1 if anything was found."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("readers", nargs="*", metavar="reader", help=", ".join(READERS))
    parser.add_argument("--minutes", type=float, default=2.0)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--findings", type=Path, default=Path("build/fuzz"))
    chosen = parser.parse_args()
    names = chosen.readers or list(READERS)
    each = 60 * chosen.minutes / len(names)
    print("| reader | minutes | files | findings |\n|---|---|---|---|")
    found = 0
    for name in names:
        if name not in READERS:
            parser.error(f"there is no reader {name}; choose among {', '.join(READERS)}")
        cases, findings = _fuzz(name, chosen.first, each, chosen.findings)
        found += len(findings)
        print(f"| {name} | {each / 60:.1f} | {cases} | {len(findings)} |", flush=True)
        for number, text in findings.items():
            (chosen.findings / f"{name}_{number}.log").write_text(text, encoding="utf-8")
            print(f"  {name} {number}: {text.strip().splitlines()[-1]}", flush=True)
    return int(bool(found))


def _fuzz(name: str, first: int, seconds: float, folder: Path) -> tuple[int, dict[int, str]]:
    """Return how many files were tried, and what was found by the number of the file."""
    findings: dict[int, str] = {}
    number, left = first, seconds
    folder.mkdir(parents=True, exist_ok=True)
    while left > 0:
        batch = min(BATCH, left)
        module = f"{__package__}.child"
        command = [sys.executable, "-m", module, name, str(number), str(batch), str(folder)]
        try:
            run = subprocess.run(
                command, capture_output=True, text=True, timeout=batch + 30 * SECONDS, check=False
            )
            lines, died = run.stdout.splitlines(), run.returncode
            reason = f"the process died ({died}): {run.stderr[-2000:]}"
        except subprocess.TimeoutExpired as error:
            output = error.stdout or b""
            lines, died, reason = output.decode(errors="replace").splitlines(), 1, "the process hung"
        for line in map(json.loads, lines):
            number = line["case"] + 1
            if "found" in line:
                findings[line["case"]] = line["found"]
        if died:
            findings[number - 1] = reason
            if not lines:
                break
            for kept in folder.glob(f"{name}_running.*"):
                kept.replace(folder / f"{name}_{number - 1}{kept.suffix}")
        left -= batch
    for kept in folder.glob(f"{name}_running.*"):
        kept.unlink()
    return number - first, findings


if __name__ == "__main__":
    sys.exit(main())

"""Print what a release is measured by: the zip and what scans find in it, helps and translations.

make release, or: python3 -m ichnograph.scripts.release
"""

import json
import subprocess
import tempfile
from pathlib import Path
from zipfile import ZipFile

from ichnograph.processing_provider.language import TRANSLATIONS
from ichnograph.processing_provider.provider import Provider

from .house import ROOT
from .provider import run_with_provider
from .texts import texts
from .translations import LANGUAGES, read

TOOLS = ROOT / ".tools" / "bin"


def output_of(tool: str, *arguments: str, folder: Path) -> str:
    """Return what a tool of `make lint` prints; those that find something end with 1."""
    command = [str(TOOLS / tool), *arguments]
    ended = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if ended.returncode not in (0, 1):
        raise RuntimeError(f"{tool} failed: {ended.stderr}")
    return ended.stdout


def scans_of(folder: Path) -> dict[str, int]:
    """Return how many findings each scan of the plugin repository has in an unpacked zip."""
    bandit = json.loads(output_of("bandit", "-q", "-r", "-f", "json", ".", folder=folder))
    secrets = json.loads(output_of("detect-secrets", "scan", "--all-files", ".", folder=folder))
    # As `make lint` runs it.
    style = ["--max-line-length", "120", "--extend-ignore", "E203", "."]
    return {
        "bandit": len(bandit["results"]),
        "detect-secrets": sum(map(len, secrets["results"].values())),
        "flake8": len(output_of("flake8", *style, folder=folder).splitlines()),
    }


def print_release(provider: Provider) -> None:
    """Print the table of docs/releases.md."""
    with tempfile.TemporaryDirectory() as folder:
        packed = Path(folder) / "ichnograph.zip"
        archive = ["git", "archive", "--prefix=ichnograph/", "--output", str(packed), "HEAD"]
        subprocess.run(archive, cwd=ROOT, check=True)
        size = packed.stat().st_size
        with ZipFile(packed) as files:
            files.extractall(folder)
        packed.unlink()
        found = scans_of(Path(folder) / "ichnograph")
    definitions = [item for one in provider.algorithms() for item in one.parameterDefinitions()]
    wanted, bare = texts(), sum(not item.help() for item in definitions)
    print("| measure | value |\n|---|---|")
    print(f"| size of the zip | {size / 1e6:.2f} MB |")
    for tool, count in found.items():
        print(f"| findings of {tool} in the zip | {count} |")
    print(f"| parameters without a help, of {len(definitions)} | {bare} |")
    for language in LANGUAGES:
        present = read(TRANSLATIONS / f"ichnograph_{language}.ts")
        missing = sum(not present.get(text) for text in wanted)
        print(f"| texts without a translation ({language}), of {len(wanted)} | {missing} |")


if __name__ == "__main__":
    run_with_provider(print_release)

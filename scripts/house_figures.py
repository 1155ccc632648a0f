"""Print how the code is divided: files, functions, imports between chapters, types, constants.

make house, or: python3 -m ichnograph.scripts.house_figures
"""

import ast
import subprocess
from collections import Counter
from collections.abc import Iterable

from ichnograph.algorithms.settings import constants

from .constants_page import settings_of
from .house import CHAPTERS, PLUGIN, ROOT, SHARED, Module, modules, room_of

LONGEST = 5


def main() -> None:
    """Print all figures."""
    every = modules()
    _print_folders(every)
    _print_longest(every)
    _print_imports(modules("algorithms"))
    _print_constants()
    print(f"mypy: {_mypy()}")


def _print_folders(every: Iterable[Module]) -> None:
    files, lines = Counter[str](), Counter[str]()
    for module in every:
        folder = str(module.path.parent)
        files[folder] += not module.is_package
        lines[folder] += module.lines
    print("| folder | files | lines |\n|---|---|---|")
    for folder in sorted(files):
        print(f"| {folder} | {files[folder]} | {lines[folder]} |")
    print(f"| all | {sum(files.values())} | {sum(lines.values())} |\n")


def _print_longest(every: Iterable[Module]) -> None:
    every = list(every)
    functions = [
        (item.lines, f"{module.path}: {item.name}") for module in every for item in module.functions()
    ]
    print("| longest functions | lines |\n|---|---|")
    for lines, name in sorted(functions, reverse=True)[:LONGEST]:
        print(f"| {name} | {lines} |")
    print("\n| longest files | lines |\n|---|---|")
    for module in sorted(every, key=lambda module: -module.lines)[:LONGEST]:
        print(f"| {module.path} | {module.lines} |")


def _print_imports(core: Iterable[Module]) -> None:
    found = Counter(
        (room_of(module.name), room_of(item.module))
        for module in core
        for item in module.imports()
        if item.module.startswith(PLUGIN[0])
    )
    between = sum(
        count
        for (importer, imported), count in found.items()
        if importer in CHAPTERS and imported in CHAPTERS and imported not in (importer, "clouds")
    )
    print("\n| imports | of | count |\n|---|---|---|")
    for (importer, imported), count in sorted(found.items()):
        if importer != imported:
            print(f"| {importer} | {imported} | {count} |")
    print(f"\nimports between chapters, of clouds aside: {between}")


def _print_constants() -> None:
    print("\n| constants | physical | statistical | judged | of modules |\n|---|---|---|---|---|")
    for package in (*SHARED, *CHAPTERS):
        kinds = Counter(
            constant.kind for settings in settings_of(package) for constant in constants(settings)
        )
        counts = " | ".join(str(kinds[kind]) for kind in ("physical", "statistical", "judged"))
        print(f"| {package} | {counts} | {sum(map(_numbers, modules(f'algorithms/{package}')))} |")
    print()


def _numbers(module: Module) -> int:
    """Count the module's constants that are numbers, which no caller can pass."""
    return sum(
        isinstance(node, ast.Assign)
        and isinstance(node.targets[0], ast.Name)
        and node.targets[0].id.lstrip("_").isupper()
        and any(
            isinstance(leaf, ast.Constant) and type(leaf.value) in (int, float)
            for leaf in ast.walk(node.value)
        )
        for node in module.tree.body
    )


def _mypy() -> str:
    program = ROOT / ".tools" / "bin" / "mypy"
    if not program.exists():
        return "not installed; run make lint"
    done = subprocess.run([str(program)], cwd=ROOT, capture_output=True, text=True, check=False)
    return done.stdout.splitlines()[-1]


if __name__ == "__main__":
    main()

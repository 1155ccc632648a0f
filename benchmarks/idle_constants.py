"""Which constants of the settings change no result at all on any scene if they are 30 % smaller or larger.

make idle-constants, or: python3 -m ichnograph.benchmarks.idle_constants [site_plan facade registration]
    [--change 0.3] [--match storeys] [--scenes flat office] [--clouds FOLDER --references FOLDER]

Many are varied at once: where the result of a scene stays the same to the last digit, none of them matters
there, otherwise the halves are varied. A constant that matters on a scene is not varied on the next one. What
is left at the end is a candidate for deletion, unless it guards against what no scene holds.
"""

import argparse
import re
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path

from ichnograph.algorithms.settings import Constant, constants, with_constant

from .sensitivity import Scene, add_arguments, chapters, outcome, varied


def varied_settings(settings: object, chosen: Sequence[Constant], factor: float) -> object:
    """Return the settings with all chosen constants changed by a factor."""
    for constant in chosen:
        settings = with_constant(settings, constant.path, varied(constant.value, factor))
    return settings


def that_matter(
    run: Scene, settings: object, base: bytes, chosen: Sequence[Constant], factor: float
) -> set[Constant]:
    """Return those of the chosen constants that change the result `base` of a scene."""

    def matters(some: Sequence[Constant]) -> bool:
        return bool(some) and outcome(run, varied_settings(settings, some, factor)).result != base

    def search(some: Sequence[Constant]) -> set[Constant]:
        """Return those that matter of constants that matter together."""
        if len(some) == 1:
            return set(some)
        first, second = some[: len(some) // 2], some[len(some) // 2 :]
        if not matters(first):
            return search(second)
        return search(first) | (search(second) if matters(second) else set())

    return search(chosen) if matters(chosen) else set()


def can_be_varied(constant: Constant, factors: Sequence[float]) -> bool:
    """Return whether a constant is a number that the factors change."""
    return all(varied(constant.value, factor) not in (None, constant.value) for factor in factors)


def main() -> None:
    """Print which constants matter on each scene, and those that are left at the end."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    add_arguments(parser)
    arguments = parser.parse_args()
    factors = 1 - arguments.change, 1 + arguments.change
    with tempfile.TemporaryDirectory() as folder:
        for name, chapter in chapters(arguments, Path(folder)):
            every = [item for item in constants(chapter.settings) if can_be_varied(item, factors)]
            left = [item for item in every if re.search(arguments.match, ".".join(item.path))]
            print(f"\n{name}: {len(left)} constants", flush=True)
            for scene, run in chapter.scenes.items():
                base = outcome(run, chapter.settings).result
                for factor in factors:
                    matter = that_matter(run, chapter.settings, base, left, factor)
                    left = [item for item in left if item not in matter]
                    print(f"{len(left)} left; on {scene} matter {_names(matter)}", flush=True)
            print(f"\n{_names(left)}", flush=True)


def _names(some: Iterable[Constant]) -> str:
    return ", ".join(sorted(f"`{'.'.join(item.path)}`" for item in some))


if __name__ == "__main__":
    main()

"""Print whether the errors at the end of a chain of scans are as large as predicted.

Twenty scans in a row: only the first sees surveyed points, the others are registered to targets of the one
before. The ratio of the true errors to the predicted standard deviations (root mean square over all chains)
is 1 if the covariance of appended points is propagated correctly: once for each scan after the other, and
once after the block adjustment.
"""

import argparse
from collections.abc import Sequence
from typing import Optional

import numpy as np
from ichnograph.algorithms.registration.adjustment.control_network import ControlNetwork
from ichnograph.algorithms.registration.registration import reduced, register_scans
from ichnograph.algorithms.registration.sequential_registration import register_in_sequence
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.tests.scenes.target_chain import TargetChain, target_chain

LENGTH = 20


def main(arguments: Optional[Sequence[str]] = None) -> None:
    """Run the chains and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chains", type=int, default=100)
    chains = parser.parse_args(arguments).chains
    print("| control points | adjustment | chains | true / predicted | largest error (m) |")
    print("|---|---|---|---|---|")
    for control_sigma in (0.0, 0.003):
        settings = Settings(control_sigma=control_sigma)
        results: dict[str, list[tuple[float, float]]] = {"scan by scan": [], "in one block": []}
        for seed in range(chains):
            chain = target_chain(LENGTH, seed, control_noise=control_sigma)
            results["scan by scan"] += _one_by_one(chain, settings)
            results["in one block"] += _in_one_block(chain, settings)
        kind = f"{1000 * control_sigma:.0f} mm" if control_sigma else "held fixed"
        for adjustment, errors in results.items():
            ratios, lengths = np.array(errors).T
            ratio = np.sqrt(np.mean(ratios**2))
            print(f"| {kind} | {adjustment} | {chains} | {ratio:.2f} | {lengths.max():.3f} |")


def _one_by_one(chain: TargetChain, settings: Settings) -> list[tuple[float, float]]:
    """Return ratio and length of the errors of the targets at the end, without the block adjustment."""
    control, origin = reduced(chain.control)
    network = ControlNetwork.of_surveyed(control.names, control.xyz, settings.control_sigma)
    scans = {scan.name: reduced(scan)[0] for scan in chain.scans}
    network = register_in_sequence(scans, network, settings).network
    last = chain.scans[-1].name
    return [
        _compared(
            network.points[row] + origin, network.covariance_of(np.array([row])), chain, network.labels[row]
        )
        for row, scan in enumerate(network.origins)
        if scan == last
    ]


def _in_one_block(chain: TargetChain, settings: Settings) -> list[tuple[float, float]]:
    last = chain.scans[-1].name
    points = register_scans(chain.control, chain.scans, settings).points
    return [
        _compared(point.position, point.covariance, chain, point.name.split(":")[1])
        for point in points
        if point.origin == last
    ]


def _compared(
    position: np.ndarray, covariance: np.ndarray, chain: TargetChain, target: str
) -> tuple[float, float]:
    error = position - chain.places[chain.scans[-1].name][target]
    return float(np.sqrt(error @ np.linalg.solve(covariance, error) / 3)), float(np.linalg.norm(error))


if __name__ == "__main__":
    main()

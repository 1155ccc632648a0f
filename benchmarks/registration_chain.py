"""Print whether the errors at the end of a chain of scans are as large as predicted.

Twenty scans in a row: only the first sees surveyed points, the others are registered to targets of the one
before. The ratio of the true errors to the predicted standard deviations (root mean square over all chains)
is 1 if the covariance of appended points is propagated correctly: once for each scan after the other, and
once after the block adjustment.

With --surfaces, the scans are also tied by the surfaces of the rooms, seen from the doors between them. The
drift is the error at the end as the first scan sees it: nothing in the chain shows how the first scan
stands on the surveyed points.
"""

import argparse
from collections.abc import Sequence
from typing import Optional

import numpy as np
from ichnograph.algorithms.registration.adjustment.control_network import ControlNetwork
from ichnograph.algorithms.registration.registration import reduced, register_scans
from ichnograph.algorithms.registration.results import Registration
from ichnograph.algorithms.registration.sequential_registration import register_in_sequence
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.tests.scenes.surface_rooms import chain_surfaces
from ichnograph.tests.scenes.target_chain import TargetChain, target_chain

LENGTH = 20


def main(arguments: Optional[Sequence[str]] = None) -> None:
    """Run the chains and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chains", type=int, default=100)
    parser.add_argument("--surfaces", action="store_true", help="tie the scans by surfaces; takes minutes")
    parser.add_argument("--step", type=float, default=0.25, help="between rays, degrees (with --surfaces)")
    given = parser.parse_args(arguments)
    chains = given.chains
    if given.surfaces:
        _with_surfaces(chains, given.step)
        return
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


def _with_surfaces(chains: int, step_deg: float) -> None:
    """Run chains by targets alone and with surfaces, and print the table."""
    print("| tied by | chains | true / predicted | largest error (m) | drift rms (m) | largest drift (m) |")
    print("|---|---|---|---|---|---|")
    results: dict[str, list[tuple[float, float, float]]] = {"targets": [], "targets and surfaces": []}
    for seed in range(chains):
        chain = target_chain(LENGTH, seed)
        surfaces = chain_surfaces(chain, seed, step_deg)
        for kind, own in zip(results, ({}, surfaces)):
            registration = register_scans(chain.control, chain.scans, Settings(), surfaces=own)
            drift = _drift(registration, chain)
            results[kind] += [(*item, drift) for item in _at_the_end(registration, chain)]
    for kind, errors in results.items():
        ratios, lengths, drifts = np.array(errors).T
        print(
            f"| {kind} | {chains} | {np.sqrt(np.mean(ratios**2)):.2f} | {lengths.max():.3f} | "
            f"{np.sqrt(np.mean(drifts**2)):.3f} | {drifts.max():.3f} |"
        )


def _drift(registration: Registration, chain: TargetChain) -> float:
    """Return how far the last scan is from where it is for the first, metres."""
    first, last = registration.scans[0], registration.scans[-1]
    middle = (*chain.scans[-1].xyz.mean(axis=0), 1.0)
    moved = chain.matrices[first.name] @ np.linalg.inv(first.matrix) @ last.matrix
    return float(np.linalg.norm(((moved - chain.matrices[last.name]) @ middle)[:3]))


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
    return _at_the_end(register_scans(chain.control, chain.scans, settings), chain)


def _at_the_end(registration: Registration, chain: TargetChain) -> list[tuple[float, float]]:
    last = chain.scans[-1].name
    return [
        _compared(point.position, point.covariance, chain, point.name.split(":")[1])
        for point in registration.points
        if point.origin == last
    ]


def _compared(
    position: np.ndarray, covariance: np.ndarray, chain: TargetChain, target: str
) -> tuple[float, float]:
    error = position - chain.places[chain.scans[-1].name][target]
    return float(np.sqrt(error @ np.linalg.solve(covariance, error) / 3)), float(np.linalg.norm(error))


if __name__ == "__main__":
    main()

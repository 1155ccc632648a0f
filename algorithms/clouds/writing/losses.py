"""What files of unlike kinds lose where they are written as one."""

from collections.abc import Collection
from pathlib import Path

import laspy

from ..cloud import Cloud, names_of
from ..formats.las import LasSource
from .las_files import copied_header


def losses(cloud: Cloud, target: Path, kept: Collection[str] = ()) -> tuple[str, ...]:
    """Return a sentence on what the files of a cloud have that a common file cannot hold of all.

    Parameters
    ----------
    cloud : Cloud
    target : Path
        What is written, for messages.
    kept : collection of str
        Names of attributes that are written besides coordinates, intensity and colour.
    """
    lost = dict.fromkeys(name for source in cloud.sources for name in source.others if name not in kept)
    if not lost:
        return unlike_values(cloud, target)
    return (
        f"Left out of {target.name}: {', '.join(lost)}. Write LAS or LAZ from LAS or LAZ files of one point "
        "format to keep everything.",
        *unlike_values(cloud, target),
    )


def unlike_values(cloud: Cloud, target: Path) -> tuple[str, ...]:
    """Return a sentence if some files of a cloud lack the colour or the intensity that others have."""
    said = []
    for held, sentence in (
        ("has_rgb", "There is no colour in {0}, so the points from there are black in {1}."),
        ("has_intensity", "There is no intensity in {0}, so it is 0 in {1} for the points from there."),
    ):
        lacking = tuple(source for source in cloud.sources if not getattr(source, held))
        if 0 < len(lacking) < len(cloud.sources):
            said.append(sentence.format(names_of(lacking), target.name))
    return tuple(said)


def unlike_times(files: tuple[LasSource, ...], target: Path) -> tuple[str, ...]:
    """Return a sentence if LAS files count their times from unlike moments."""
    times = [
        _kind_of_time(file)
        for file in files
        if "gps_time" in file.point_format.dimension_names and "gps_time" in file.others
    ]
    if len(set(times)) < 2:
        return ()
    return (
        f"Some inputs have the seconds of a week as GPS times and others those since 1980. {target.name} "
        f"holds them unchanged, and states the kind of {files[0].path.name}.",
    )


def _kind_of_time(file: LasSource) -> "laspy.header.GpsTimeType":
    header, _ = copied_header(file.path)
    return header.global_encoding.gps_time_type

"""Units in the names of columns are found however they are attached."""

import pytest
from ichnograph.algorithms.tables.units import (
    as_unit,
    factor_of,
    is_unit,
    unit_of,
    unit_of_remark,
    without_unit,
)


@pytest.mark.parametrize(
    ("name", "unit", "metres"),
    [
        ("X [mm]", "mm", 1e-3),
        ("x_mm", "mm", 1e-3),
        ("Breite (in cm)", "cm", 1e-2),
        ("Breite in cm", "cm", 1e-2),
        ("z/m", "m", 1.0),
        ("Höhe [Meter]", "meter", 1.0),
        ("Easting (US-ft)", "usft", None),
        ("x_ft", "ft", None),
        ("height", None, 1.0),
        ("mm", None, 1.0),
        ("Northing (LV95)", None, 1.0),
        ("x [µm]", "um", 1e-6),
        ("X [1/10 mm]", "1/10 mm", None),
        ("X [0.1 mm]", "0.1 mm", None),
        ("X en cm", "cm", 1e-2),
        ("x ['']", "in", None),
        ("Breite [Zoll]", "zoll", None),
        ("alpha [°]", "deg", None),
    ],
)
def test_the_unit_of_a_column_follows_its_name(name, unit, metres):
    assert unit_of(name) == unit
    assert factor_of(unit) == metres


def test_a_name_without_its_unit_is_the_name():
    assert [without_unit(name) for name in ("X [mm]", "x_mm", "width_std", "Punkt (neu)")] == [
        *("x", "x", "width_std", "punkt")
    ]


@pytest.mark.parametrize(
    ("line", "unit"),
    [
        ("# units: mm", "mm"),
        ("Export in mm", "mm"),
        ("Exportiert in cm", "cm"),
        ("// Einheit = cm", "cm"),
        ("# Unité : m", "m"),
        ("# Units: US survey feet", "feet"),
        ("# unit:mm", "mm"),
        ("# the units are in mm", "mm"),
        ("# unit mm", "mm"),
        ("Units;mm", "mm"),
        ("# in millimetres", "millimetres"),
        ("# All coordinates in mm", "mm"),
        ("# Koordinaten in cm", "cm"),
        ("// X, Y, Z [mm]", "mm"),
        ("# points are in feet", "feet"),
        ("# Linear units: mm", "mm"),
        ("# XYZ units = cm", "cm"),
        ("# EPSG:25832, unit: mm", "mm"),
        ("# coordinates in degrees", "degrees"),
        ("# Angle unit: gon", None),
        ("# angular units: deg", None),
        ("# Einheit: gon", None),
        ("voxel size unit: cm", None),
        ("# spacing in mm: 5", None),
        ("# intensity in m", None),
        ("# points: 5 m", None),
        ("# the unit of the army", None),
        ("# Unit 3, room in the west wing", None),
        ("# unit: Trimble S7 in hall", None),
        ("# Coordinates and unit vectors, in metres", None),
        ("# Scan: M", None),
        ("# File = M", None),
        ("# scans are given in mm", "mm"),
        ("# Scanner unit: FARO, room 12 cm thick", None),
    ],
)
def test_a_remark_may_state_the_unit(line, unit):
    assert unit_of_remark(line) == unit


def test_a_field_may_be_a_unit_alone():
    assert as_unit("[mm]") == as_unit(" mm ") == "mm"
    assert as_unit("12") is None
    assert not is_unit("wall")


def test_a_number_with_its_unit_is_not_a_unit():
    assert not is_unit("0.9 m")
    assert as_unit("900 mm") is None


@pytest.mark.parametrize(
    ("remark", "unit"),
    [
        ("# US Survey Feet", "feet"),
        ("// mm", "mm"),
        ("[m]", "m"),
        ("International feet", "feet"),
        ("# Millimetres", "millimetres"),
        ("# Chain", None),
        ("Hall", None),
        ("# mm of rain", None),
    ],
)
def test_a_remark_may_be_a_unit_alone(remark, unit):
    assert unit_of_remark(remark) == unit


@pytest.mark.parametrize("unit", ["ift", "US survey feet", "International feet", "usft", "ft (int)"])
def test_every_foot_is_known_so_that_it_is_refused(unit):
    assert factor_of(unit_of(f"X [{unit}]")) is None

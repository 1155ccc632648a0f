"""What QGIS lists: the public contract, with help and units."""

import re
from pathlib import Path

import pytest

NUMBERS = {
    "SPACING": 0.05,
    "PIXEL_SIZE": 0.10,
    "NEIGHBOURHOOD": 1,
    "THRESHOLD": None,
    "MIN_AREA": None,
    "MAX_FILL": 0.4,
    "MIN_ELONGATION": 3,
    "CLOSING": None,
    "MIN_HEIGHT": 0.4,
    "THRESHOLD_STEPS": 10,
    "THRESHOLD_MAX": None,
}
HEIGHTS = {"ZMIN": None, "ZMAX": None}
SIMULATION = {"TARGETS_PER_SCAN": 5, "SCALE_PPM": 10, "TRIALS": 1000, "SEED": 1, "REACH": None}
FACADE = {
    "DISTANCE": 0.05,
    "SEED_RADIUS": 0.2,
    "SEED_COLOUR": 30,
    "SEED_VARIANCE": None,
    "GROW_COLOUR": 60,
    "INTENSITY": None,
    "TRIANGLE_FACTOR": 3,
    "TRIANGLE_COUNT": 5,
    "NOISE_ITERATIONS": 10,
    "ALPHA": None,
    "FACADE": 0,
}
PLANES = {"MIN_POINTS": None, "MAX_PLANES": 10}
OWN_DEFAULTS = {"facadedetails": {"PIXEL_SIZE": None}, "compareplan": {"TOLERANCE": 0.10}}
DEFAULTS = {
    **NUMBERS,
    **HEIGHTS,
    **SIMULATION,
    **FACADE,
    **PLANES,
    "SIGMA": 0.003,
    "CONTROL_SIGMA": 0,
    "TOLERANCE": None,
    "MAX_STD": None,
    "DOOR_WIDTH": 1.3,
    "SECTION": 1.1,
    "SIZE": None,
    "SCALE": 50,
}
WALL_PARAMETERS = {*NUMBERS} - {"SPACING", "PIXEL_SIZE", "NEIGHBOURHOOD"}
WALL_NUMBERS = {"WALL_COUNT", "WALL_AREA", "WALL_LENGTH"}
FURTHER_FILES = {"DRAWING", "AXES", "ROOMS", "LIMITS", "LEFT_OUT", "REPORT"}
FACADE_FILES = {"ORTHOIMAGE", "DETAILS", "ELEVATION", "SCHEDULE", "DRAWING", "REPORT", "LEFT_OUT"}
REGISTRATION_FILES = {"TRANSFORMS", "RESIDUALS", "CONTROL_OUT", "REPORT"}

CONTRACT = {
    "thincloud": ({"INPUT", "SPACING", "SCHEDULER", "OUTPUT"}, {"OUTPUT", "POINTS_IN", "POINTS_OUT"}),
    "transformcloud": (
        {"INPUT", "TRANSFORMS", "OUTPUT_FOLDER"},
        {"OUTPUT_FOLDER", "CLOUDS", "SCANS_TRANSFORMED", "POINTS"},
    ),
    "findtargets": (
        {"INPUT", "KIND", "SIZE", "STATION", "CRS", "OUTPUT_FOLDER", "TARGETS_LAYER", "REPORT"},
        {"OUTPUT_FOLDER", "LISTS", "TARGETS_LAYER", "REPORT", "TARGET_COUNT"},
    ),
    "registerscans": (
        {"CONTROL", "TARGETS", "MATCHING", "SIGMA", "CONTROL_SIGMA", "TOLERANCE", "MODEL", "CRS", "MAX_STD"}
        | {"REFINE", "SCANS"}
        | REGISTRATION_FILES,
        {"SCANS_REGISTERED", "SIGMA0", "MAX_RESIDUAL", "TRANSFORMS_PAGE"} | REGISTRATION_FILES,
    ),
    "simulateregistration": (
        {"CONTROL", "TARGETS_PER_SCAN", "SIGMA", "SCALE_PPM", "TRIALS", "SEED", "MODEL", "REACH"}
        | {"TABLE", "REPORT"},
        {"TABLE", "TABLE_PAGE", "REPORT", "SUCCESS_RATE"},
    ),
    "facadeplanes": (
        {"INPUT", "DISTANCE", "CRS", "SEGMENTS", "PLANES"} | {*PLANES},
        {"SEGMENTS", "PLANES", "PLANE_COUNT"},
    ),
    "facadedetails": (
        {"INPUT", "CRS", "SIDE", "MIN_AREA", "REGULARISE", "PIXEL_SIZE", "FILL_HOLES"}
        | {"FACADE_NEAR", "FACADE_ALONG", "COLOURED", "UNROLL", "ALL"}
        | {*FACADE}
        | FACADE_FILES,
        {"DETAIL_COUNT", "FACADE_COUNT", "WALL_AREA", "SCHEDULE_PAGE", "ALL", "ALL_FILES"} | FACADE_FILES,
    ),
    "comparelengths": (
        {"SCHEDULE", "REFERENCE", "TABLE", "REPORT"},
        {"TABLE", "TABLE_PAGE", "REPORT", "MEAN_DIFFERENCE", "STD_DIFFERENCE", "MAX_DIFFERENCE", "COUNT"},
    ),
    "compareplan": (
        {"WALLS", "REFERENCE", "ROOMS", "TOLERANCE", "ERRORS", "REPORT"},
        {"ERRORS", "REPORT", "COMPLETENESS", "CORRECTNESS", "IOU", "MEDIAN_OFFSET", "P95_OFFSET"}
        | {"ROOMS_FOUND", "ROOMS_MISSED", "ROOMS_INVENTED"},
    ),
    "planlayout": (
        {"WALLS", "ROOMS", "AXES", "IMAGE", "KIND", "SCALE", "SHEET", "TITLE", "PDF", "SVG"},
        {"PDF", "SVG"},
    ),
    "exampledata": ({"OUTPUT_FOLDER"}, {"OUTPUT_FOLDER", "FILES"}),
    "densityimage": (
        {"INPUT", "SPACING", "PIXEL_SIZE", "NEIGHBOURHOOD", "CRS", "DENSITY", "HEIGHTS", *HEIGHTS}
        | {"SCHEDULER"},
        {"DENSITY", "POINTS_IN", "POINTS_KEPT"},
    ),
    "extractwalls": ({"INPUT", "PLAN", "WALLS"} | WALL_PARAMETERS, {"PLAN", "WALLS"} | WALL_NUMBERS),
    "siteplan": (
        {"INPUT", "REFINE", "STOREY", "SECTION", "CRS", "DENSITY", "PLAN", "WALLS", "DOOR_WIDTH"}
        | {"HEIGHTS", "SCHEDULER", *HEIGHTS}
        | {*NUMBERS}
        | FURTHER_FILES,
        {"DENSITY", "PLAN", "WALLS", "POINTS_IN", "POINTS_KEPT", "ROOM_COUNT", "ROOM_AREA"}
        | WALL_NUMBERS
        | FURTHER_FILES,
    ),
}


@pytest.fixture(params=sorted(CONTRACT))
def algorithm(provider, request):
    return provider.algorithm(request.param)


def test_lists_the_algorithms_that_work(provider):
    listed = {item.name(): item for item in provider.algorithms()}
    assert {name for name, item in listed.items() if item.group() != "Models"} == {*CONTRACT}


def test_every_name_is_the_one_that_models_store(algorithm):
    parameters, outputs = CONTRACT[algorithm.name()]

    assert {item.name() for item in algorithm.parameterDefinitions()} == parameters
    assert {item.name() for item in algorithm.outputDefinitions()} == outputs


def test_defaults_are_those_of_the_contract(algorithm):
    numbers = [item for item in algorithm.parameterDefinitions() if item.type() == "number"]

    expected = {**DEFAULTS, **OWN_DEFAULTS.get(algorithm.name(), {})}
    assert {item.name(): item.defaultValue() for item in numbers} == {
        item.name(): expected[item.name()] for item in numbers
    }


def test_every_parameter_has_help_and_every_number_a_unit_unless_it_counts(algorithm):
    from qgis.core import QgsProcessingParameterNumber

    for item in algorithm.parameterDefinitions():
        assert len(item.help()) > 20, item.name()
        if item.type() == "number" and item.dataType() == QgsProcessingParameterNumber.Type.Double:
            assert re.search(r"\(.+\)$", item.description()), item.name()


def test_help_is_plain_text_that_describes_all_parameters(algorithm):
    text = algorithm.shortHelpString()

    assert not set("<>&") & set(text)
    for item in algorithm.parameterDefinitions():
        assert f"{item.description()}: {item.help()}" in text


def test_every_algorithm_can_be_found_and_looked_up(algorithm):
    assert algorithm.displayName()[0].isupper()
    assert algorithm.shortDescription().endswith(".")
    assert algorithm.group() in ("Site plan", "Clouds", "Registration", "Facade", "Example")
    assert len(algorithm.tags()) > 3
    assert algorithm.helpUrl().endswith(f"/docs/{algorithm.name()}.md")
    assert Path(algorithm.svgIconPath()).name == f"{algorithm.name()}.svg"
    assert not algorithm.icon().isNull()


def test_the_page_of_an_algorithm_names_every_parameter_and_output(algorithm):
    page = (Path(__file__).parents[2] / "docs" / f"{algorithm.name()}.md").read_text(encoding="utf-8")

    names = [item.name() for item in (*algorithm.parameterDefinitions(), *algorithm.outputDefinitions())]
    assert [name for name in names if name not in page] == []


def test_areas_are_in_square_metres_everywhere(algorithm):
    definitions = (*algorithm.parameterDefinitions(), *algorithm.outputDefinitions())
    assert not any("m2" in item.description() for item in definitions)


def test_the_version_is_that_of_the_metadata(provider):
    metadata = (Path(__file__).parents[2] / "metadata.txt").read_text(encoding="utf-8")
    assert f"version={provider.versionInfo()}\n" in metadata


def test_heights_are_found_without_opening_the_advanced_parameters(provider):
    from qgis.core import QgsProcessingParameterDefinition

    advanced = QgsProcessingParameterDefinition.Flag.FlagAdvanced
    shown = [
        item.name()
        for item in provider.algorithm("siteplan").parameterDefinitions()
        if not item.flags() & advanced
    ]
    assert {"ZMIN", "ZMAX", "HEIGHTS"} <= {*shown}
    assert not {"MAX_FILL", "MIN_ELONGATION", "MIN_AREA", "NEIGHBOURHOOD"} & {*shown}


def test_what_the_manual_calls_advanced_is_advanced_in_the_dialog(algorithm):
    from qgis.core import QgsProcessingParameterDefinition

    advanced = QgsProcessingParameterDefinition.Flag.FlagAdvanced
    page = (Path(__file__).parents[2] / "docs" / f"{algorithm.name()}.md").read_text(encoding="utf-8")
    rows = [line.split("|")[1] for line in page.splitlines() if "| advanced: " in line]
    names = [name.strip() for row in rows for name in row.split(",")]
    assert [name for name in names if not algorithm.parameterDefinition(name).flags() & advanced] == []


def test_algorithms_run_in_the_background_and_can_be_cancelled(algorithm):
    from qgis.core import QgsProcessingAlgorithm

    # Layouts belong to the main thread.
    in_front = bool(algorithm.flags() & QgsProcessingAlgorithm.Flag.FlagNoThreading)
    assert in_front == (algorithm.name() == "planlayout")
    assert algorithm.flags() & QgsProcessingAlgorithm.Flag.FlagCanCancel


def test_the_provider_leaves_with_the_plugin_and_comes_back(plugin, qgis_application):
    registry = qgis_application.processingRegistry()

    plugin.unload()
    try:
        assert registry.providerById("ichnograph") is None
    finally:
        plugin.initProcessing()
    assert registry.providerById("ichnograph") is not None

"""The fields of all layers as a person reads them: with units, in the attribute table and in forms."""

from html import escape

from .language import translated

ALIASES = {
    # Site plan
    "wall_id": "Wall",
    "kind": "Kind",
    "length": "Length (m)",
    "thickness": "Thickness (m)",
    "thick_sd": "Standard deviation of the thickness (m)",
    "z_base": "Base (m)",
    "z_top": "Top (m)",
    "height": "Height (m)",
    "azimuth": "Azimuth (°)",
    "radius": "Radius (m)",
    "density": "Density (standard deviations)",
    "coverage": "Share of the outline with points",
    "rms": "Distance of the points, rms (m)",
    "votes": "Number of thresholds",
    "body": "Connected body",
    "axis_id": "Axis",
    "room_id": "Room",
    "area": "Area (m²)",
    "perimeter": "Perimeter (m)",
    "openings": "Openings",
    "z_floor": "Floor (m)",
    "z_ceiling": "Ceiling (m)",
    "seen": "Share of the border that was seen",
    "reason": "Reason",
    # Comparison of a plan
    "side": "Boundary of",
    "state": "State",
    "offset": "Median offset (m)",
    "max_offset": "Largest offset (m)",
    # Facade
    "id": "Number",
    "use": "Use",
    "shape": "Shape",
    "head": "Head",
    "measured": "Measured sides",
    "completed": "Completed sides",
    "open_side": "Open sides",
    "wall_depth": "Depth of the wall (m)",
    "width": "Width (m)",
    "sill": "Sill (m)",
    "w_std": "Standard deviation of the width (m)",
    "h_std": "Standard deviation of the height (m)",
    "std_left": "Standard deviation, left (m)",
    "std_right": "Standard deviation, right (m)",
    "std_bottom": "Standard deviation, bottom (m)",
    "std_top": "Standard deviation, top (m)",
    "depth": "Depth behind the wall (m)",
    "points": "Points",
    "red": "Red (0 to 255)",
    "green": "Green (0 to 255)",
    "blue": "Blue (0 to 255)",
    "intensity": "Intensity",
    "x0": "Origin, x (m)",
    "y0": "Origin, y (m)",
    "z0": "Origin, z (m)",
    "tilt": "Tilt (°)",
    "plane": "Plane",
    "nx": "Normal, x",
    "ny": "Normal, y",
    "nz": "Normal, z",
    "distance": "Distance from the origin (m)",
    # Registration
    "scan": "Scan",
    "target": "Target",
    "control": "Control point",
    "surveyed": "Surveyed (1 yes)",
    "used": "Used (1 yes)",
    "v": "Residual (m)",
    **{f"v{axis}": f"Residual, {axis} (m)" for axis in "xyz"},
    **{f"r{axis}": f"Redundancy, {axis}" for axis in "xyz"},
    **{f"w{axis}": f"Baarda's w, {axis}" for axis in "xyz"},
    **{f"t{axis}": f"Pope's t, {axis}" for axis in "xyz"},
    **{f"mdb{axis}": f"Minimal detectable bias, {axis} (m)" for axis in "xyz"},
    **{f"ell_{axis}": f"Confidence ellipsoid, semi-axis {axis} (m)" for axis in "abc"},
    "name": "Name",
    "size": "Size (m)",
    "std": "Standard deviation in space (m)",
    "range": "Distance from the scanner (m)",
    "incidence": "Angle of incidence (°)",
    "quality": "Quality (0 to 1)",
    "doubtful": "Doubtful (1 yes)",
    "doubt": "Reason of the doubt",
    "origin": "Origin",
    **{f"s{axis}": f"Standard deviation, {axis} (m)" for axis in "xyz"},
    **{f"r{axes}": f"Correlation, {axes[0]} and {axes[1]}" for axes in ("xy", "xz", "yz")},
    "scans": "Number of scans",
    "seen_by": "Seen by",
}
"""Aliases by the names of the fields, which are the same in all layers."""


DIGITS = {
    **dict.fromkeys(("x0", "y0", "z0", "width", "height", "sill", "depth", "wall_depth", "distance"), 3),
    **dict.fromkeys(("area", "azimuth", "tilt"), 3),
    **dict.fromkeys(("nx", "ny", "nz"), 6),
}
"""Decimals that are shown of fields whose values are exact, because coordinates are computed from them."""


def digits_of(fields: list[str]) -> str:
    """Return how many decimals of the fields of a layer are shown, as the element of a QML style."""
    rows = [
        f'<field name="{name}"><editWidget type="Range"><config><Option type="Map">'
        f'<Option type="int" name="Precision" value="{DIGITS[name]}"/>'
        "</Option></config></editWidget></field>"
        for name in fields
        if name in DIGITS
    ]
    return f"<fieldConfiguration>{''.join(rows)}</fieldConfiguration>"


def aliases_of(fields: list[str]) -> str:
    """Return the aliases of a layer with `fields`, as the element of a QML style."""
    rows = [
        f'<alias index="{number}" field="{escape(name)}" name="{escape(translated(ALIASES[name]))}"/>'
        for number, name in enumerate(fields)
        if name in ALIASES
    ]
    return f"<aliases>{''.join(rows)}</aliases>"

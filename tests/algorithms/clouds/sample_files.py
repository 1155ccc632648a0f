"""Write clouds in formats that only the plugin reads."""

import struct

import laspy
import lazrs
import numpy as np
import pytest
from laspy.vlrs.known import LasZipVlr
from laspy.vlrs.vlrlist import VLRList

IDENTITY = np.eye(4)


def write_ptx(path, *scans):
    """Write scans, each an array of cells, shape (n, 3, 4 or 7), or a pair of that and its pose."""
    with path.open("w") as stream:
        for scan in scans:
            cells, pose = scan if isinstance(scan, tuple) else (np.array(scan), IDENTITY)
            # PTX multiplies rows from the left.
            rows = np.transpose(pose)
            np.savetxt(stream, [[1], [len(cells)]], "%d")
            np.savetxt(stream, rows[[3, 0, 1, 2], :3], "%.17g")
            np.savetxt(stream, rows, "%.17g")
            np.savetxt(stream, cells, "%.17g")
    return path


def write_ply(path, points, encoding="binary_little_endian", types=None, before="", after=""):
    """Write `points`, an array of rows or a structured one, as the vertices of a PLY.

    `types` are the names of the properties' types, `before` and `after` further lines of the header.
    """
    if getattr(points, "dtype", np.dtype(float)).names is None:
        points = np.rec.fromarrays(np.transpose(points).astype(float), names="x,y,z")
    types = types or ["double"] * len(points.dtype.names)
    properties = [f"property {kind} {name}\n" for kind, name in zip(types, points.dtype.names)]
    header = f"ply\nformat {encoding} 1.0\ncomment by hand\n{before}element vertex {len(points)}\n"
    content = (header + "".join(properties) + after + "end_header\n").encode()
    if encoding == "ascii":
        content += "".join(" ".join(map(str, row)) + "\n" for row in points.tolist()).encode()
    else:
        order = "<" if "little" in encoding else ">"
        content += np.asarray(points, points.dtype.newbyteorder(order)).tobytes()
    path.write_bytes(content)
    return path


def write_e57(path, *scans, wkt=""):
    """Write scans, each an array of coordinates or a dictionary.

    The dictionary holds the values by the names of E57 fields, and may hold `pose`, a pair of a
    quaternion (w, x, y, z) and a shift, and `limits`, a dictionary of limits by their paths. Whole
    numbers become integer fields, others floating ones.
    """
    libe57 = pytest.importorskip("pye57", reason="pye57 is not installed").libe57
    image = libe57.ImageFile(str(path), "w")
    image.extensionsAdd("", libe57.E57_V1_0_URI)
    image.extensionsAdd("nor", "http://www.libe57.org/E57_EXT_surface_normals.txt")
    image.root().set("coordinateMetadata", libe57.StringNode(image, wkt))
    image.root().set("data3D", libe57.VectorNode(image, True))
    for scan in scans:
        if not isinstance(scan, dict):
            scan = dict(zip(("cartesianX", "cartesianY", "cartesianZ"), np.transpose(scan).astype(float)))
        _append_scan(libe57, image, dict(scan))
    image.close()
    return path


def _append_scan(libe57, image, fields):
    pose, limits = fields.pop("pose", None), fields.pop("limits", {})
    node = libe57.StructureNode(image)
    if pose:
        node.set("pose", libe57.StructureNode(image))
        for name, components, values in (
            ("rotation", "wxyz", pose[0]),
            ("translation", "xyz", pose[1]),
        ):
            node.set(f"pose/{name}", libe57.StructureNode(image))
            for component, value in zip(components, values):
                node.set(f"pose/{name}/{component}", libe57.FloatNode(image, float(value)))
    for place, value in limits.items():
        group = place.split("/")[0]
        if not node.isDefined(group):
            node.set(group, libe57.StructureNode(image))
        node.set(place, libe57.FloatNode(image, float(value)))
    prototype, buffers = libe57.StructureNode(image), libe57.VectorSourceDestBuffer()
    arrays = {}
    for name, values in fields.items():
        values = np.asarray(values)
        if values.dtype.kind in "iu":
            low, high = int(values.min()), int(values.max())
            prototype.set(name, libe57.IntegerNode(image, low, low, high))
        else:
            prototype.set(name, libe57.FloatNode(image, 0.0))
        arrays[name] = values.astype(np.float64)
        buffers.append(libe57.SourceDestBuffer(image, name, arrays[name], len(values), True, True))
    points = libe57.CompressedVectorNode(image, prototype, libe57.VectorNode(image, True))
    node.set("points", points)
    image.root()["data3D"].append(node)
    writer = points.writer(buffers)
    writer.write(len(values))
    writer.close()


def leave_usable(records):
    """Make random records of a LAS neither withheld nor noise."""
    if "raw_classification" in records.dtype.names:
        records["raw_classification"] = records["raw_classification"] % 7
    else:
        records["classification"] = records["classification"] % 7
        records["classification_flags"] &= 0b1111_1011


def las_records(count, point_format=3):
    """Return a header and points with random coordinates and intensity."""
    rng = np.random.default_rng(0)
    header = laspy.LasHeader(point_format=point_format)
    header.scales = np.full(3, 0.001)
    points = laspy.ScaleAwarePointRecord.zeros(count, header=header)
    for name in "XYZ":
        points[name] = rng.integers(-100_000, 100_000, count)
    points["intensity"] = rng.integers(1, 65535, count)
    return header, points


def write_las(path, header, points):
    """Write records as LAS or LAZ."""
    with laspy.open(path, "w", header=header) as writer:
        writer.write_points(points)
    return path


def table_of(data):
    """Return where the table of the chunks of a LAZ begins."""
    return struct.unpack_from("<q", data, struct.unpack_from("<I", data, 96)[0])[0]


def write_copc(path, header, points, nodes):
    """Write `points` in `nodes` chunks of unlike size, as an octree with one level of children."""
    header.are_points_compressed = True
    laszip = lazrs.LazVlr.new_for_compression(header.point_format.id, 0, True)
    header.vlrs.extend([laspy.VLR("copc", 1, "", bytes(160)), LasZipVlr(laszip.record_data())])
    cuts = np.linspace(0, np.sqrt(len(points)), nodes + 1).astype(int) ** 2
    with path.open("wb+") as stream:
        header.write_to(stream)
        compressor = lazrs.LasZipCompressor(stream, laszip)
        for start, stop in zip(cuts, [*cuts[1:-1], len(points)]):
            compressor.compress_many(np.frombuffer(points.array[start:stop].tobytes(), np.uint8))
            compressor.finish_current_chunk()
        compressor.done()
        hierarchy = stream.seek(0, 2) + 60
        stream.seek(header.offset_to_point_data)
        offset, entries = header.offset_to_point_data + 8, b""
        for node, (count, size) in enumerate(lazrs.read_chunk_table(stream, laszip)):
            key = (0, 0, 0, 0) if node == 0 else (1, *np.unravel_index(node - 1, (2, 2, 2)))
            entries += struct.pack("<4iQii", *key, offset, size, count)
            offset += size
        cube = (*header.offsets, 200.0, 1.0)
        info = struct.pack("<5d2Q2d", *cube, hierarchy, len(entries), 0, 0).ljust(160, b"\0")
        header.vlrs[0] = laspy.VLR("copc", 1, "", info)
        header.point_count, header.number_of_evlrs = len(points), 1
        header.start_of_first_evlr = stream.seek(0, 2)
        VLRList([laspy.VLR("copc", 1000, "", entries)]).write_to(stream, as_extended=True)
        stream.seek(0)
        header.write_to(stream, ensure_same_size=True)
    return path

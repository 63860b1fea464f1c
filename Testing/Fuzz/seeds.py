# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write a folder of small valid inputs for each fuzz target.

    seeds.py FOLDER
"""

import json
import pathlib
import random
import struct
import sys

FLIGHT = "longitude,latitude,height,heading,pitch\n7.5,46.5,3000,90,-20\n\n7.6,46.6,3100,95,-10\n"
MESSAGES = "move 1 2 0\npress 0 1 2 0 1\nwheel -1 1 2 7\nkeydown 1 ArrowLeft\nresize 80 60 100\nshown\n"
TRANSFER = "# value red green blue opacity\n0 0 0 1 0\n0.2 1 1 0 0.5\n0.4 1 0 0 1\n"
CUBE_POINTS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
FACES = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4)]
RASTER_FORMATS = ("asc", "pgm", "tif", "hgt", "png")  # in the order of FuzzRaster.cxx
MESH_FORMATS = ("ply", "obj", "gltf", "glb", "stl", "ex2", "vtp", "vtu", "pvtu")


def patches():
    rows = "".join(f"{i} {j} {0.1 * i * j}\n" for i in range(4) for j in range(4))
    yield "1\n3 3\n" + rows
    yield "2\n1 1\n0 0 0 1 0 0\n0 1 0 1 1 1\n1 2\n0 0 0 1 0 0 2 0 0\n0 1 0 1 1 1 2 1 0\n"


def rasters():
    header = "ncols 8\nnrows 4\nxllcorner 7\nyllcorner 46\ncellsize 0.01\nNODATA_value -9\n"
    rows = "\n".join(" ".join(str(i * j) for i in range(8)) for j in range(4))
    yield "asc", (header + rows + "\n").encode()
    yield "pgm", b"P5 4 3 255\n" + bytes(range(12))
    yield "pgm", b"P2 2 2 9\n1 2 3 4\n"
    yield "tif", tiff(6, 5)
    yield "hgt", struct.pack(">9h", *range(9))


def tiff(width, height):
    """A grey image of 16 bits, with a pixel size and a tie point."""
    pixels = struct.pack(f"<{width * height}H", *range(width * height))
    scale = struct.pack("<3d", 0.01, 0.01, 0.0)
    tie = struct.pack("<6d", 0.0, 0.0, 0.0, 7.0, 46.0, 0.0)
    data = 8 + 2 + 12 * 10 + 4
    entries = [
        (256, 3, 1, width), (257, 3, 1, height), (258, 3, 1, 16), (259, 3, 1, 1), (262, 3, 1, 1),
        (273, 4, 1, data), (277, 3, 1, 1), (279, 4, 1, len(pixels)),
        (33550, 12, 3, data + len(pixels)), (33922, 12, 6, data + len(pixels) + len(scale)),
    ]
    directory = b"".join(struct.pack("<HHII", *entry) for entry in entries)
    start = b"II*\0" + struct.pack("<IH", 8, len(entries)) + directory + struct.pack("<I", 0)
    return start + pixels + scale + tie


def pyramid_indices():
    """The body of an index of three levels: see PyramidIndex::Write()."""
    absent = struct.pack("<3f", float("inf"), float("-inf"), 0.0)
    record = struct.pack("<Q3f", 1 << 32 | 1, -5.0, 900.0, 2.5)
    level = struct.pack("<Q", 1) + record
    kind = b"\0\xff" * 256  # runs of zeros; FuzzPyramidIndex finds the length
    tiles = struct.pack("<QQ", 1, 0) + kind
    yield absent + 3 * struct.pack("<Q", 0) + struct.pack("<if", 0, 0.0) + struct.pack("<Q", 0)
    yield absent + 3 * level + struct.pack("<if", 0, 4.0) + tiles


def meshes():
    points = "".join(f"{x} {y} {z}\n" for x, y, z in CUBE_POINTS)
    polygons = "".join("4 " + " ".join(map(str, face)) + "\n" for face in FACES)
    vertices = "".join(f"property float {axis}\n" for axis in "xyz")
    for layout in ("ascii", "binary_little_endian"):
        header = f"ply\nformat {layout} 1.0\nelement vertex 8\n{vertices}element face 3\n"
        header += "property list uchar int vertex_indices\nend_header\n"
        body = (points + polygons).encode()
        if layout != "ascii":
            body = b"".join(struct.pack("<3f", *point) for point in CUBE_POINTS)
            body += b"".join(struct.pack("<B4i", 4, *face) for face in FACES)
        yield "ply", header.encode() + body
    faces = "".join("f " + " ".join(f"{i + 1}/1/1" for i in face) + "\n" for face in FACES)
    lines = points.replace("\n", "\nv ").removesuffix("v ")
    yield "obj", f"v {lines}vt 0 0\nvn 0 0 1\n{faces}".encode()
    buffer = b"".join(struct.pack("<3f", *point) for point in CUBE_POINTS[:3])
    scene = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": len(buffer)}],
        "buffers": [{"byteLength": len(buffer)}],
    }
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(buffer)
    yield "gltf", text
    yield "glb", (struct.pack("<4sII", b"glTF", 2, size) + struct.pack("<I4s", len(text), b"JSON")
                  + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)
    triangle = struct.pack("<12fH", *range(12), 0)
    yield "stl", bytes(80) + struct.pack("<I", 1) + triangle
    yield "stl", b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n" \
                 b"vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
    yield "ex2", b"CDF\x01" + struct.pack(">11I", 0, 10, 1, 1, 0x6E000000, 4, 0, 0, 0, 0, 0)
    for kind, parts in (("PolyData", "Polys"), ("UnstructuredGrid", "Cells")):
        yield "vtp" if parts == "Polys" else "vtu", (
            f'<VTKFile type="{kind}" version="0.1"><{kind}><Piece NumberOfPoints="0">'
            f'<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">'
            f"</DataArray></Points><{parts}/></Piece></{kind}></VTKFile>\n").encode()
    yield "pvtu", (b'<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid '
                   b'GhostLevel="0"><Piece Source="m.vtu"/></PUnstructuredGrid></VTKFile>\n')


def reliefs():
    image = (
        '<VTKFile type="ImageData" version="0.1"><ImageData WholeExtent="0 1 0 1 0 0" '
        'Origin="0 0 0" Spacing="1 1 1"><FieldData>'
        '<DataArray type="Int32" Name="ReliefProjection" NumberOfTuples="1" format="ascii">0'
        '</DataArray><DataArray type="Float64" Name="ReliefMatrix" NumberOfTuples="16" '
        'format="ascii">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</DataArray></FieldData>'
        '<Piece Extent="0 1 0 1 0 0"><PointData>'
        '<DataArray type="UInt8" Name="Color" NumberOfComponents="3" format="ascii">'
        "1 2 3 4 5 6 7 8 9 10 11 12</DataArray>"
        '<DataArray type="Float32" Name="Depth" format="ascii">0 1 2 nan</DataArray>'
        "</PointData></Piece></ImageData></VTKFile>\n"
    )
    yield "FILE,name,time\nr.vti,a,0.5\n\0" + image
    yield 'name,"FILE","FILE_PNG"\n"x ""y""",r.vti,r.png\n\0' + image


def micro_meshes():
    """The chunks of a triangle of level 1: see MicroMeshFile.h and ArrayPacking.h."""
    def planes(code, *values):
        width = struct.calcsize(f"<{code}")
        packed = [struct.pack(f"<{code}", value) for value in values]
        return b"".join(bytes(value[i] for value in packed) for i in range(width))

    def differences(code, *values):
        mask = (1 << 8 * struct.calcsize(f"<{code}")) - 1
        pairs = zip(values, (0, *values[:-1]))
        return planes(code.upper(), *((value - last) & mask for value, last in pairs))

    short, integer, floating = (4, 16), (6, 32), (10, 32)  # VTK's type, bits
    arrays = [
        (0, floating, 3, 3, "", b"".join(planes("f", *x) for x in ((0, 1, 0), (0, 0, 1), (0, 0, 0)))),
        (1, integer, 3, 1, "", b"".join(differences("i", i) for i in (0, 1, 2))),
        (2, floating, 3, 3, "MicroMeshDirections",
         b"".join(planes("f", *x) for x in ((0, 0, 0), (0, 0, 0), (1, 1, 1)))),
        (3, integer, 5, 1, "MicroMeshFaces", b"".join(differences("i", i) for i in (0, 2, 4, 3, 1))),
        (4, integer, 2, 3, "MicroMeshEdges",
         differences("i", 0, 1, 2) + differences("i", 1, 1, 1)),
        (4, short, 1, 3, "MicroMeshDisplacements", differences("h", 5, -300, 7)),
    ]
    table = b"".join(
        struct.pack("<BBBBIQI", owner, kind[0], kind[1], 0, components, tuples, len(name))
        + name.encode() for owner, kind, components, tuples, name, _ in arrays)
    yield b"".join(struct.pack("<H", len(chunk)) + chunk
                   for chunk in (table, *(array[-1] for array in arrays)))


def arguments():
    yield "a.tif\n--output\nb.png\n--size\n640x480\n--exaggeration=2\n--stats"
    yield "--volume\na.vtu\n--isosurfaces=0.1,0.2\n--clip\n0,0,0,1,0,0\n--output=b.png"
    yield "a.ply\n--lic=V\n--level\n3\n--export\nb.vtp\n--"
    yield "--flight=f.csv\n--output=f/%04d.png\na.tif\n--error=1\n--center=86.9E,27.9N"


def choices(rng):
    """Bytes that choose random calls."""
    for size in (16, 64, 256, 1024):
        yield bytes(rng.randrange(256) for _ in range(size))


def write(folder, target, seeds):
    (folder / target).mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(seeds):
        content = seed.encode() if isinstance(seed, str) else seed
        (folder / target / f"{number}").write_bytes(content)


def main():
    folder = pathlib.Path(sys.argv[1])
    for target in ("FuzzCells", "FuzzFlow", "FuzzIntersection", "FuzzMeshes", "FuzzRelief"):
        write(folder, target, choices(random.Random(target)))
    write(folder, "FuzzArguments", arguments())
    write(folder, "FuzzFlight", [FLIGHT])
    write(folder, "FuzzWindowMessages", [MESSAGES])
    write(folder, "FuzzMicroMeshFile", micro_meshes())
    write(folder, "FuzzPatchFile", patches())
    write(folder, "FuzzPyramidIndex", pyramid_indices())
    write(folder, "FuzzReliefDatabase", reliefs())
    write(folder, "FuzzTransferFunction", [TRANSFER])
    for target, formats, files in (("FuzzRaster", RASTER_FORMATS, rasters()),
                                   ("FuzzFileChecks", MESH_FORMATS, meshes())):
        write(folder, target, (bytes([formats.index(name)]) + text for name, text in files))


if __name__ == "__main__":
    main()

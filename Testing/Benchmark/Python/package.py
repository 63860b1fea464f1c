#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measure the Python package: package.py RELEVO_VIEW FOLDER [--quick]

Prints tables of the time of imports, of one-line calls against relevo-view for the same picture,
and of the memory that arrays take. FOLDER is for data and pictures, and gets package.json. Times
are seconds of all processor cores, which other programs hardly affect.
"""

from __future__ import annotations

import compileall
import importlib.util
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
from collections.abc import Sequence
from typing import Any

# Python's statements draw the pictures that relevo-view draws with these arguments (TestDrawings).
CALLS = {
    "terrain": (
        'relevo.terrain("dem.tif", exaggeration=2).screenshot("a.png")',
        ["dem.tif", "--exaggeration", "2"],
    ),
    "refined": ('relevo.refined("mesh.ply").screenshot("a.png")', ["mesh.ply"]),
    "volume": (
        'relevo.volume("block.vtu", "DistanceToCenter").screenshot("a.png")',
        ["block.vtu", "--volume", "DistanceToCenter"],
    ),
    "patches": (
        'relevo.patches("curved.vtu", scalars="DistanceToCenter", edges=True).screenshot("a.png")',
        ["curved.vtu", "--array", "DistanceToCenter", "--patch-edges"],
    ),
    "lic": ('relevo.lic("flow.vtp", "V").screenshot("a.png")', ["flow.vtp", "--lic", "V"]),
    "intersection": (
        'relevo.intersection("mesh.ply", "other.ply").screenshot("a.png")',
        ["mesh.ply", "--against", "other.ply"],
    ),
}

# Creates the variable `array` and the statement whose memory is measured.
ARRAYS = {
    "heights to a terrain": (
        "array = numpy.random.default_rng(1).random((n, n), numpy.float32)",
        "result = relevo.terrain(array)",
    ),
    "heights to a vtkHeightMap": (
        "array = numpy.random.default_rng(1).random((n, n), numpy.float32)",
        "result = arrays.height_map(array)",
    ),
    "points to a mesh": (
        "array = numpy.random.default_rng(1).random((n * n // 3, 3))",
        'result = relevo.refined((array, [[0, 1, 2]]), surface="linear", max_level=0)',
    ),
    "faces (int64) to a mesh": (
        "array = numpy.arange(n * n // 3 * 3).reshape(-1, 3) % 3; points = numpy.eye(3)",
        "result = _inputs.make_mesh(points, array)",
    ),
    "faces (int32) to a mesh, of int64": (
        "array = numpy.arange(n * n // 3 * 3).reshape(-1, 3) % 3; points = numpy.eye(3);"
        " given = array.astype(numpy.int32)",
        "result = _inputs.make_mesh(points, given)",
    ),
    "points of a mesh": (
        "points = numpy.random.default_rng(1).random((n * n // 3, 3));"
        " mesh = _inputs.make_mesh(points, [[0, 1, 2]]);"
        " array = vtk_to_numpy(mesh.GetPoints().GetData())",
        "result = arrays.triangles(mesh)",
    ),
    "samples of an image": (
        "image = arrays.image(numpy.random.default_rng(1).random((n, n), numpy.float32));"
        " array = arrays.samples(image)",
        "result = arrays.samples(image)",
    ),
}
MEMORY_PROGRAM = """
import numpy, relevo
from relevo import _inputs, arrays
from vtkmodules.util.numpy_support import vtk_to_numpy

def read(name):
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith(name))

n = {size}
# Load the libraries before the measurement.
small = relevo.refined((numpy.eye(3), [[0, 1, 2]])), relevo.terrain(numpy.eye(8))
arrays.height_map(numpy.eye(8))
{setup}
del small
with open("/proc/self/clear_refs", "w") as file:
    file.write("5")  # forget the peak
before = read("VmRSS")
{statement}
print((read("VmHWM") - before) / array.nbytes, (read("VmRSS") - before) / array.nbytes)
"""


def run(command: Sequence[object], folder: pathlib.Path) -> float:
    """Run a program. Return its processor seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(own) for own in command], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"package.py: error: {' '.join(map(str, command))}: {done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def run_python(statements: str, folder: pathlib.Path) -> float:
    return run([sys.executable, "-c", statements], folder)


def compile_package() -> None:
    """Compile the package's modules, as installed packages are."""
    found = importlib.util.find_spec("relevo")
    assert found and found.origin
    compileall.compile_dir(pathlib.Path(found.origin).parent, quiet=1)


def make_data(folder: pathlib.Path, size: int) -> None:
    """Write a raster of size x size heights, and meshes."""
    import numpy
    import relevo
    from DrawingData import make_block, make_sphere
    from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_HEXAHEDRON
    from vtkmodules.vtkIOImage import vtkTIFFWriter
    from vtkmodules.vtkIOPLY import vtkPLYWriter
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

    y, x = numpy.mgrid[-2 : 2 : size * 1j, -2 : 2 : size * 1j]
    heights = 3000 * numpy.exp(-x * x - y * y) + 300 * numpy.sin(5 * x) * numpy.cos(7 * y)
    cells = max(2, size // 128)
    data: list[tuple[str, Any, Any]] = [
        ("dem.tif", vtkTIFFWriter(), relevo.arrays.image(heights.astype(numpy.float32))),
        ("mesh.ply", vtkPLYWriter(), make_sphere(cells * 8)),
        ("block.vtu", vtkXMLUnstructuredGridWriter(), make_block(size=(cells, cells, cells))),
        (
            "curved.vtu",
            vtkXMLUnstructuredGridWriter(),
            make_block(VTK_QUADRATIC_HEXAHEDRON, (cells, cells, 2)),
        ),
        ("flow.vtp", vtkXMLPolyDataWriter(), make_sphere(cells * 8)),
    ]
    other = make_sphere(cells * 8)
    for i in range(other.GetNumberOfPoints()):
        a, b, c = other.GetPoint(i)
        other.GetPoints().SetPoint(i, a + 0.3, b, c)
    data.append(("other.ply", vtkPLYWriter(), other))
    for name, writer, mesh in data:
        writer.SetFileName(str(folder / name))
        writer.SetInputData(mesh)
        writer.Write()


def count_differing_pixels(folder: pathlib.Path) -> float:
    """Return the share of pixels of the pictures that differ by more than 2 of 255."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    pictures = []
    for name in ("a.png", "b.png"):
        reader = vtkPNGReader()
        reader.SetFileName(str(folder / name))
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        pictures.append(pixels[:, :3].astype(int))
    return float((numpy.abs(pictures[0] - pictures[1]) > 2).any(axis=1).mean())


def measure_imports(folder: pathlib.Path, rounds: int) -> dict[str, float]:
    programs = {
        "VTK": "import vtkmodules.vtkCommonCore, vtkmodules.vtkRenderingOpenGL2",
        "relevo": "import relevo",
        "relevo, and the first drawing": "import relevo; relevo.refined",
        "relevo, and the first raster": "import relevo; relevo.vtkHeightMap",
    }
    times: dict[str, list[float]] = {name: [] for name in programs}
    for _ in range(rounds):
        for name, program in programs.items():
            times[name].append(run_python(program, folder))
    result = {name: statistics.median(own) for name, own in times.items()}
    print("| import | seconds | more than VTK |\n|---|---:|---:|")
    for name, seconds in result.items():
        print(f"| {name} | {seconds:.3f} | {seconds - result['VTK']:+.3f} |")
    return result


def measure_calls(viewer: str, folder: pathlib.Path, rounds: int) -> dict[str, float]:
    print("\n| call | Python, s | relevo-view, s | ratio | pixels that differ |")
    print("|---|---:|---:|---:|---:|")
    result = {}
    for name, (statement, arguments) in CALLS.items():
        program = f"import relevo; {statement}"
        command = [viewer, *arguments, "--output", "b.png"]
        run(command, folder)  # makes the index of the raster
        times = [(run_python(program, folder), run(command, folder)) for _ in range(rounds)]
        ratio = statistics.median(python / program for python, program in times)
        python, viewed = (statistics.median(own) for own in zip(*times))
        differing = count_differing_pixels(folder)
        print(f"| {name} | {python:.2f} | {viewed:.2f} | {ratio:.2f} | {100 * differing:.3f} % |")
        result[name] = ratio
    return result


def measure_memory(folder: pathlib.Path, size: int) -> dict[str, list[float]]:
    print("\n| array | largest use, in sizes of the array | afterwards |\n|---|---:|---:|")
    result = {}
    for name, (setup, statement) in ARRAYS.items():
        program = MEMORY_PROGRAM.format(size=size, setup=setup, statement=statement)
        done = subprocess.run(
            [sys.executable, "-c", program], cwd=folder, capture_output=True, text=True
        )
        if done.returncode:
            sys.exit(f"package.py: error: {name}: {done.stderr}")
        result[name] = [float(own) for own in done.stdout.split()]
        print(f"| {name} | {result[name][0]:.2f} | {result[name][1]:.2f} |")
    return result


def main(viewer: str, name: str, *options: str) -> None:
    folder = pathlib.Path(name)
    folder.mkdir(parents=True, exist_ok=True)
    os.environ.pop("DISPLAY", None)
    quick = "--quick" in options
    compile_package()
    make_data(folder, 256 if quick else 2048)
    rounds = 1 if quick else 3
    results = {
        "import": measure_imports(folder, rounds),
        "calls": measure_calls(viewer, folder, rounds),
        "memory": measure_memory(folder, 512 if quick else 4096),
    }
    (folder / "package.json").write_text(json.dumps(results, indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])

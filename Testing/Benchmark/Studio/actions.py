# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measure what users of relevo-studio do: actions.py PROGRAM FOLDER [--quick]

Prints tables in Markdown and writes FOLDER/actions.json. The window has 1280 x 800 pixels. Ratios
compare medians of one run. Times of steps are processor times.
"""

from __future__ import annotations

import json
import os
import pathlib
import statistics
import subprocess
import sys
import time
import typing

from StudioRun import SIZE, Layout, figure, run_script
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter


def write_grid(file: pathlib.Path, side: int, step: int = 0) -> None:
    """Write hexahedra, of this number along each side, with a point array."""
    image = vtkImageData()
    image.SetDimensions(side + 1, side + 1, side + 1)
    height = vtkFloatArray()
    height.SetName("Height")
    height.SetNumberOfValues(image.GetNumberOfPoints())
    for i in range(image.GetNumberOfPoints()):
        x, y, z = image.GetPoint(i)
        height.SetValue(i, x + (0.1 + step) * y + 0.01 * z * z)
    image.GetPointData().SetScalars(height)
    append = vtkAppendFilter()
    append.AddInputData(image)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputConnection(append.GetOutputPort())
    writer.SetFileName(str(file))
    writer.SetCompressorTypeToNone()
    writer.EncodeAppendedDataOff()
    writer.Write()


def median(layouts: list[Layout], name: str) -> float:
    """Return the median of a figure."""
    return statistics.median(figure(layout, name) for layout in layouts)


def measure_dragging(program: str, folder: pathlib.Path, is_quick: bool) -> dict[str, float]:
    """Return how many positions of sliders are drawn, and what they build."""
    file = folder / "dragged.vtu"
    write_grid(file, 10)
    first = ["set clip 5,0,0,1,0,0", "set metric screen-edge", "set range 1,5", "wait"]
    last = run_script(program, file, first)[0][-1]
    names = ["clip-position", "range.0", "range.1"]
    drags = []
    for name in names[: 1 if is_quick else 3]:
        left, top, width, height = last[name]["rectangle"]
        middle = top + height / 2
        drags.append(f"drag {left + width / 2} {middle} {left + width * 0.8} {middle}")
    layouts, _ = run_script(program, file, first + drags)
    dragged = [
        layout for layout in layouts if figure(layout, "frames") > figure(last, "frames")
    ]
    values = {(layout["clip-position"]["value"], layout["range"]["value"]) for layout in dragged}
    return {
        "positions": 8.0 * len(drags),
        "pictures": float(len(values)),
        "bufferBuilds": figure(layouts[-1], "buffer-builds") - figure(last, "buffer-builds"),
        "shaderBuilds": figure(layouts[-1], "shader-builds") - figure(last, "shader-builds"),
    }


def measure_cut(program: str, folder: pathlib.Path, is_quick: bool) -> dict[str, float]:
    """Return frame times in ms through hexahedra: whole, and with a cut that moves."""
    side = 20 if is_quick else 100
    frames = 3 if is_quick else 9
    file = folder / "cut.vtu"
    write_grid(file, side)
    lights = [f"set light.0 {100 + i}" for i in range(frames)]
    places = [side * (0.3 + 0.4 * i / frames) for i in range(frames)]
    axis = [f"set clip 0,0,{place},0,0,1" for place in places]
    skew = [f"set clip {place},{place},{place},1,0.3,0.7" for place in places]
    layouts, _ = run_script(program, file, [*lights, *axis, "set clip default", *skew])

    def pick(value: typing.Callable[[Layout], bool]) -> float:
        return median([layout for layout in layouts if value(layout)], "frame-ms")

    whole = pick(lambda layout: bool(layout["light"]["value"]) and not layout["clip"]["value"])
    return {
        "whole": whole,
        "axis": pick(lambda layout: layout["clip"]["value"].startswith("0,0,")) / whole,
        "skew": pick(lambda layout: layout["clip"]["value"].endswith("1,0.3,0.7")) / whole,
    }


def measure_probe(program: str, folder: pathlib.Path, is_quick: bool) -> dict[str, float]:
    """Return the median time of finding the values under the mouse, in ms."""
    side = 20 if is_quick else 60
    file = folder / "probed.vtu"
    write_grid(file, side)
    moves = [f"drag {420 + 7 * i} {380 + 5 * i} {420 + 7 * i} {380 + 5 * i}" for i in range(2 if is_quick else 6)]
    times = {}
    for name, lines in (
        ("surface", []),
        ("cut", [f"set clip 0,0,{side * 0.6},0,0,1"]),
        ("volume", ["set volume Height"]),
    ):
        layouts, _ = run_script(program, file, [*lines, "wait", *moves])
        probed = [layout for layout in layouts if "readout" in layout][1:]
        times[name] = median(probed, "probe-ms")
    return times


def measure_step(program: str, folder: pathlib.Path, is_quick: bool) -> dict[str, float]:
    """Return the processor time in s of opening a file anew, and of a time step of it."""
    side = 10 if is_quick else 60
    steps = 2 if is_quick else 8
    for step in range(2):
        write_grid(folder / f"step{step}.vtu", side, step)
    sets = "".join(f'<DataSet timestep="{s}" file="step{s}.vtu"/>' for s in range(2))
    file = folder / "steps.pvd"
    file.write_text(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>')
    empty = folder / "empty.vtu"
    write_grid(empty, 1)
    times: dict[str, list[float]] = {"start": [], "open": [], "steps": []}
    for _ in range(1 if is_quick else 3):
        times["start"].append(run_script(program, empty, ["quit"])[1])
        times["open"].append(run_script(program, file, ["quit"])[1])
        lines = [f"set time {1 - i % 2}" for i in range(steps)]
        times["steps"].append(run_script(program, file, lines)[1])
    start, opened, stepped = (statistics.median(own) for own in times.values())
    step = (stepped - opened) / steps
    return {"open": opened - start, "step": step, "ratio": step / (opened - start)}


def measure_still(program: str, folder: pathlib.Path, is_quick: bool) -> dict[str, float]:
    """Return the frames, and the share of a core, of a served studio in which nothing changes."""
    file, layout = folder / "dragged.vtu", folder / "still.json"
    process = subprocess.Popen(
        [program, file, SIZE, "--serve=0", "--layout", layout], stdout=subprocess.PIPE, text=True
    )

    def used() -> float:
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def frames() -> float:
        entries = json.loads(layout.read_text())
        return next(e["value"] for e in entries if e["name"] == "figure-frames")

    try:
        assert process.stdout
        process.stdout.readline()
        time.sleep(3)
        before, drawn, start = used(), frames(), time.monotonic()
        time.sleep(1 if is_quick else 10)
        span = time.monotonic() - start
        return {"frames": frames() - drawn, "share": (used() - before) / span}
    finally:
        process.kill()
        process.wait()


def main() -> None:
    """Measure and print."""
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    is_quick = "--quick" in sys.argv
    kinds: dict[str, typing.Callable[[str, pathlib.Path, bool], dict[str, float]]] = {
        "dragging": measure_dragging,
        "cut": measure_cut,
        "probe": measure_probe,
        "step": measure_step,
        "still": measure_still,
    }
    chosen = [name for name in sys.argv[3:] if name in kinds] or list(kinds)
    results = {}
    print("| action | figures |")
    print("|---|---|")
    for name in chosen:
        results[name] = kinds[name](program, folder, is_quick)
        text = ", ".join(f"{key} {value:.3g}" for key, value in results[name].items())
        print(f"| {name} | {text} |", flush=True)
    (folder / "actions.json").write_text(json.dumps(results, indent=2) + "\n")


if __name__ == "__main__":
    main()

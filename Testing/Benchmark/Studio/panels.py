# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measure the panels of relevo-studio: panels.py PROGRAM FOLDER [--quick]

Prints a table in Markdown and writes FOLDER/panels.json. The window has 1280 x 800 pixels. A frame
with panels has all groups open, and the scene is beside them. A frame of the panels alone moves the
focus from one control to the next. Rounds of all rows alternate.
"""

from __future__ import annotations

import json
import pathlib
import statistics
import sys

from StudioRun import figure, run_script
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

GROUPS = ("Surface", "Level of detail", "Streamlines", "Streaks", "Volume", "Terrain", "Reliefs",
          "Light and camera", "Save")
TITLE = "drag 965 9 965 9"  # shows or hides the panel below its title
KINDS = ("without panels", "with all panels", "panels alone")


def write_sphere(file: pathlib.Path, triangles: int) -> None:
    """Write a sphere of about this many triangles."""
    source = vtkSphereSource()
    side = int((triangles / 2) ** 0.5)
    source.SetThetaResolution(side)
    source.SetPhiResolution(side)
    source.Update()
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(source.GetOutput())
    writer.Write()


def measure(program: str, file: pathlib.Path, rounds: int, frames: int) -> dict[str, list[float]]:
    """Return the frame times in milliseconds of each kind."""
    lights = [f"set light.0 {100 + i}" for i in range(frames)]
    lines = [f"click group {name}" for name in GROUPS]
    for _ in range(rounds):
        lines += [*lights, "key Tab", *["key Down"] * frames, "key Escape"]
        lines += [TITLE, *lights, TITLE]
    layouts, _ = run_script(program, file, lines)
    times: dict[str, list[float]] = {kind: [] for kind in KINDS}
    repeated, light = 0.0, None
    for layout in layouts:
        time = figure(layout, "frame-ms")
        shown = layout.get("light.0", {}).get("value")
        if figure(layout, "panel-frames") > repeated:
            times["panels alone"].append(time)
        elif shown is None:
            times["without panels"].append(time)
        elif shown != light:
            times["with all panels"].append(time)
        repeated = figure(layout, "panel-frames")
        light = shown or light
    return times


def main() -> None:
    """Measure and print."""
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    is_quick = "--quick" in sys.argv
    results = {}
    print("| scene | without panels, ms | with all panels, ms | ratio | panels alone, ms |")
    print("|---|---|---|---|---|")
    for name, triangles in (("2 k triangles", 2000), ("500 k triangles", 500000)):
        file = folder / f"sphere{triangles}.vtp"
        write_sphere(file, triangles)
        times = measure(program, file, 1 if is_quick else 3, 3 if is_quick else 10)
        medians = {kind: statistics.median(own) for kind, own in times.items()}
        results[name] = medians
        without, with_panels, alone = (medians[kind] for kind in KINDS)
        print(f"| {name} | {without:.1f} | {with_panels:.1f} | {with_panels / without:.2f} |"
              f" {alone:.1f} |", flush=True)
    (folder / "panels.json").write_text(json.dumps(results, indent=2) + "\n")


if __name__ == "__main__":
    main()

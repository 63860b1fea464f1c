# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measure vtkWindowServer over loopback: server.py FOLDER [--quick]

Prints a table in Markdown and writes FOLDER/server.json. The window has 1280 x 800 pixels, the camera
moves, and rounds of all rows alternate.
"""

from __future__ import annotations

import json
import pathlib
import statistics
import subprocess
import sys
import time

import relevo
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
from WindowClient import WindowClient

SIZE = (1280, 800)
CLIENT = "client"  # an argument: this program is the reader of pictures


def run_client(url: str, is_reading: bool) -> None:
    """Read pictures until the server ends, and print their number and size in bytes."""
    client = WindowClient(url, is_slow=not is_reading)
    print("connected", flush=True)
    count = size = 0
    while client.is_open and is_reading:
        client.update(0.1)
        count += len(client.pictures)
        size += sum(map(len, client.pictures))
        client.pictures.clear()
    if not is_reading:
        sys.stdin.read()
    print(count, size)


def make_window(triangles: int) -> relevo.vtkEGLOffscreenRenderWindow:
    """Return a window with a sphere of about this many triangles."""
    source = vtkSphereSource()
    side = int((triangles / 2) ** 0.5)
    source.SetThetaResolution(side)
    source.SetPhiResolution(side)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.SetBackground(0.9, 0.92, 0.95)
    renderer.SetBackground2(0.4, 0.5, 0.7)
    renderer.GradientBackgroundOn()
    renderer.AddActor(actor)
    window = relevo.vtkEGLOffscreenRenderWindow()
    window.SetMultiSamples(4)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    window.Render()
    return window


def measure(window: relevo.vtkEGLOffscreenRenderWindow, seconds: float, kind: str) -> dict:
    """Return frames and pictures per second: of the window alone, read, or not read."""
    server = relevo.vtkWindowServer()
    server.AllowResizingOff()
    server.SetRenderWindow(window)
    client = None
    if kind != "window":
        server.Start()
        client = subprocess.Popen(
            [sys.executable, __file__, CLIENT, server.GetURL(), kind], text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        )
        assert client.stdout and client.stdout.readline() == "connected\n"
    camera = window.GetRenderers().GetFirstRenderer().GetActiveCamera()

    def draw_for(time_span: float) -> int:
        frames, end = 0, time.perf_counter() + time_span
        while time.perf_counter() < end:
            camera.Azimuth(1)
            window.Render()
            server.ProcessRequests(0)
            frames += 1
        return frames

    draw_for(0.3)
    pictures = server.GetNumberOfPictures()
    start = time.perf_counter()
    frames = draw_for(seconds)
    span = time.perf_counter() - start
    pictures = server.GetNumberOfPictures() - pictures
    server.Stop()
    size = 0
    if client:
        output, _ = client.communicate("")
        size = int(output.split()[1])
    return {"frames": frames / span, "pictures": pictures / span, "bytes": size}


def main() -> None:
    """Measure and print."""
    if sys.argv[1] == CLIENT:
        run_client(sys.argv[2], sys.argv[3] == "read")
        return
    is_quick = "--quick" in sys.argv
    rounds, seconds = (1, 0.3) if is_quick else (5, 2.0)
    results = {}
    print("| scene | window, frames/s | served, frames/s | pictures/s | ratio | not read, frames/s |")
    print("|---|---|---|---|---|---|")
    for name, triangles in (("2 k triangles", 2000), ("1 M triangles", 1000000)):
        window = make_window(triangles)
        runs: dict[str, list[dict]] = {"window": [], "read": [], "not read": []}
        for _ in range(rounds):
            for kind, own in runs.items():
                own.append(measure(window, seconds, kind))

        def median(kind: str, value: str, runs: dict[str, list[dict]] = runs) -> float:
            return statistics.median(run[value] for run in runs[kind])

        row = {
            "window": median("window", "frames"),
            "served": median("read", "frames"),
            "pictures": median("read", "pictures"),
            "ratio": median("read", "pictures") / median("window", "frames"),
            "notRead": median("not read", "frames"),
        }
        results[name] = row
        print(f"| {name} | {row['window']:.1f} | {row['served']:.1f} | {row['pictures']:.1f} |"
              f" {row['ratio']:.2f} | {row['notRead']:.1f} |", flush=True)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "server.json").write_text(json.dumps(results, indent=2) + "\n")


if __name__ == "__main__":
    main()

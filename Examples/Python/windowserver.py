# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Show a window in a browser: windowserver.py [SECONDS]

Prints a URL and serves a render window until Ctrl-C, or for this time. No display is needed.
"""

from __future__ import annotations

import sys
import time

import relevo
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer


def make_renderer() -> vtkRenderer:
    """Return a renderer with a cone."""
    source = vtkConeSource()
    source.SetResolution(60)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.2, 0.5, 0.8)
    renderer = vtkRenderer()
    renderer.SetBackground(0.9, 0.92, 0.95)
    renderer.AddActor(actor)
    return renderer


def main() -> None:
    """Serve the window."""
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    seconds = float(sys.argv[1]) if len(sys.argv) == 2 else float("inf")
    window = relevo.vtkEGLOffscreenRenderWindow()
    window.SetSize(800, 600)
    window.AddRenderer(make_renderer())

    server = relevo.vtkWindowServer()
    server.SetRenderWindow(window)
    if not server.Start():
        sys.exit(1)
    print(server.GetURL(), flush=True)
    end = time.monotonic() + seconds
    while time.monotonic() < end and server.ProcessRequests(0.1):
        pass
    print(server.GetNumberOfPictures(), "pictures")
    server.Stop()


if __name__ == "__main__":
    main()

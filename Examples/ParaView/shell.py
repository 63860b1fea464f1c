# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A translucent shell, displaced by a function, around a ball.

    . build-paraview/env.sh
    pvbatch Examples/ParaView/shell.py [shell.png]
"""

import os
import sys
import tempfile

from paraview.simple import *

view = CreateView("RenderView")
view.ViewSize = [600, 600]
view.OrientationAxesVisibility = 0
ball = Show(Sphere(Radius=0.3, ThetaResolution=16, PhiResolution=12), view)
ball.Representation = "Adaptive Refinement"
ball.Surface = "PN Triangles"
ball.DiffuseColor = ball.AmbientColor = [0.9, 0.3, 0.1]
shell = Show(Sphere(Radius=0.5, ThetaResolution=32, PhiResolution=24), view)
shell.Representation = "Adaptive Refinement"
shell.MaximumLevel = 5
shell.Metric.ReferenceLength = 4
shell.Surface = "Procedural"
shell.Surface.BaseSurface = "PN Triangles"
shell.Surface.Amplitude = 0.05
shell.Surface.Frequency = 1.5
shell.Opacity = 0.4
shell.Specular = 0.6
shell.DiffuseColor = shell.AmbientColor = [0.5, 0.8, 1]
view.CameraPosition = [1.4, 1.0, 1.6]
view.CameraFocalPoint = [0, 0, 0]
path = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "shell.png")
with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as part:
    if not SaveScreenshot(os.path.join(part, "part.png"), view):
        sys.exit(f"cannot write {path!r}")
    os.replace(os.path.join(part, "part.png"), path)

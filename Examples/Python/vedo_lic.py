# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw streaks on a mesh in a plotter of vedo: vedo_lic.py PICTURE.png

Two whirls turn on a torus. It needs vedo 2023.4 or later, and a display.
"""

import numpy
import relevo
import vedo
from arguments import read_arguments

(picture,) = read_arguments()
torus = vedo.Torus(r1=1.0, r2=0.4, res=48)
x, y, z = torus.points().T if callable(torus.points) else torus.points.T
torus.pointdata["Wind"] = numpy.stack([numpy.sin(3 * y), numpy.sin(3 * x), x * y], axis=1)

plotter = vedo.Plotter(offscreen=True, size=(640, 400), bg="white")
streaks = relevo.lic(torus, "Wind")
streaks.add_to(plotter)
plotter.show(viewup="z", elevation=-50, zoom=1.8)
plotter.screenshot(picture)
print(streaks.mapper.GetNumberOfDrawnTriangles(), "triangles")

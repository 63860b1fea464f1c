# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw a topographic map in a plotter of PyVista: pyvista_terrain.py HEIGHTMAP IMAGERY PICTURE.png

It does what PyVista's example of a topographic map does, with rasters of any size and any two
coordinate systems. It needs PyVista 0.48 or later.
"""

import pyvista
from arguments import check_file, read_arguments

heightmap, imagery, picture = read_arguments()
plotter = pyvista.Plotter(off_screen=True, window_size=[640, 400])
terrain = plotter.relevo.add_terrain(check_file(heightmap), imagery=check_file(imagery))
plotter.set_background("aliceblue")
plotter.view_vector((0.4, -1.0, 0.9), viewup=(0, 0, 1))
plotter.camera.Zoom(1.3)
plotter.screenshot(picture)
print(terrain.mapper.GetNumberOfDrawnTriangles(), "triangles, exact to 1 pixel")

# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw files in one line each, without a display: oneline.py NAME PICTURE FILE [FILE]

NAME and the files are
  terrain      a height map and an image
  refined      a mesh
  volume       a mesh of 3D cells with the array EQPS
  patches      a mesh of curved cells
  time         a mesh with time steps and the array convected
  lic          a mesh with vectors
  streamlines  3D cells with vectors
  relief       a height map
"""

import sys
from typing import Any

import relevo
from arguments import check_file, read_arguments

DRAWINGS: dict[str, Any] = {
    "terrain": lambda dem, photo: relevo.terrain(dem, imagery=photo, exaggeration=2),
    "refined": lambda mesh: relevo.refined(mesh, surface="pn", metric="curvature", max_level=5),
    "volume": lambda mesh: relevo.volume(mesh, "EQPS"),
    "patches": lambda mesh: relevo.patches(mesh, edges=True, up="z"),
    "time": lambda mesh: relevo.refined(mesh, scalars="convected", time=1),
    "lic": lambda mesh: relevo.lic(mesh),
    "streamlines": lambda mesh: relevo.streamlines(mesh, seeds=40, range=(0, 0.3), up="z"),
    "relief": lambda dem: relevo.relief(dem),
}
VIEWS = {"lic": (110, 15)}  # azimuth and elevation of the viewer

name, picture, *files = [*read_arguments(), "", ""][: max(2, len(read_arguments()))]
if name not in DRAWINGS or len(files) != DRAWINGS[name].__code__.co_argcount:
    sys.exit(f"usage: oneline.py NAME PICTURE FILE [FILE]; NAME is one of {', '.join(DRAWINGS)}")
drawing = DRAWINGS[name](*map(check_file, files))
drawing.screenshot(picture, size=(640, 400), camera=VIEWS.get(name))
print(f"{name}: {drawing.mesh().GetNumberOfPoints()} points")

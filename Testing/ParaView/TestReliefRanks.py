# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that several ranks draw reliefs, still and while the view moves, like one rank.

Run this on one rank and then on others, with a file of pictures as argument."""

import os
import sys

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import RelevoParaView as relevo
from ReliefData import move, pair, passes, write_database, write_image

FIRST = sys.argv[1]
RANKS = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
LIMITS = {"database": 0, "piece": 0, "moving 0": 20, "moving 1": 20, "moving 2": 20, "still": 4}


def new_view():
    view = relevo.view()
    view.UseFXAA = 0
    return view


def show(source):
    """The picture of a source as Relief."""
    view = new_view()
    simple.Show(source, view).Representation = "Relief"
    relevo.picture(view)
    view.CameraPosition = [40, -70, -90]
    view.CameraFocalPoint = [40, 20, 5]
    view.CameraViewUp = [0, -1, 0]
    return relevo.picture(view)


def reliefs():
    """A database, and an image that its reader would divide among the ranks."""
    path = f"{FIRST}.cdb"
    image = f"{FIRST}.vti"
    if not os.path.exists(path):
        write_image(pair()[0], image)
        write_database(path, pair())
    return {
        "database": show(simple.ReliefDatabaseReader(FileName=path)),
        "piece": show(simple.XMLImageDataReader(FileName=[image])),
    }


def motion():
    """Frames of surfaces that are distributed over the ranks."""
    view = new_view()
    ball = simple.Elevation(Input=simple.Sphere(ThetaResolution=40, PhiResolution=30))
    shown = simple.Show(ball, view)
    simple.ColorBy(shown, ("POINTS", "Elevation"))
    shown.SetScalarBarVisibility(view, False)
    small = simple.Show(simple.Sphere(Center=[0.6, 0, 0.3], Radius=0.2), view)
    small.AmbientColor = small.DiffuseColor = [0, 0.8, 0.2]
    relevo.picture(view)
    simple.ResetCamera(view)
    view.ShowReliefsWhileMoving = 1
    relevo.picture(view)
    pictures = {f"moving {i}": move(view, 4) for i in range(3)}
    captures, frames = passes(view)
    assert frames == 3 and captures < 3, (captures, frames)
    pictures["still"] = relevo.picture(view)
    share = relevo.differing(pictures["moving 2"], pictures["still"], 20)
    assert share < 0.05 * relevo.foreground(pictures["still"]), share

    # Translucent objects need an order of ranks.
    shown.Opacity = 0.5
    with relevo.messages() as told:
        relevo.picture(view)
        move(view, 1)
        move(view, 1)
    expected = 1 if RANKS > 1 else 0
    assert told().count("not available for translucent objects") == expected, told()
    return pictures


pictures = {**reliefs(), **motion()}
if relevo.compare_with_one_rank(FIRST, pictures, LIMITS):  # otherwise pvbatch ends MPI
    raise SystemExit(1)

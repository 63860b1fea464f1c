# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Long work of VTK: other threads run meanwhile, and Ctrl-C stops it."""

from __future__ import annotations

import time

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor

import relevo

from . import _interruptible
from ._error import Error
from ._interrupts import Interrupts
from ._messages import Messages

_PAUSE = 0.02  # seconds


def _runs_python(algorithm: vtkAlgorithm) -> bool:
    """Return whether an algorithm, or one before it, is written in Python."""
    if algorithm.IsA("vtkPythonAlgorithm"):
        return True
    return any(
        _runs_python(algorithm.GetInputConnection(port, i).GetProducer())
        for port in range(algorithm.GetNumberOfInputPorts())
        for i in range(algorithm.GetNumberOfInputConnections(port))
    )


def update(algorithm: vtkAlgorithm) -> None:
    """Update an algorithm and those before it. Raise its errors."""
    with Messages():
        if _runs_python(algorithm):
            algorithm.Update()  # such algorithms need the lock of Python, and may not take it
        else:
            _interruptible.update(algorithm, Interrupts.is_stopped)


def render(window: vtkRenderWindow) -> None:
    """Render a window, and raise the errors of its props."""
    with Messages():
        _interruptible.render(window, Interrupts.is_stopped)


def start(interactor: vtkRenderWindowInteractor) -> None:
    """Run the event loop of a window until it is closed. Errors are printed."""
    with Interrupts():
        _interruptible.start(interactor, Interrupts.is_stopped)


def update_heights(heights: relevo.vtkHeightField) -> None:
    """Update heights. Raise their errors.

    They are not an algorithm, so a filter that needs them updates them.
    """
    displacement = relevo.vtkDisplacement()
    displacement.SetHeightMap(heights)
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMaximumLevel(0)
    recipe.SetDisplacement(displacement)
    plane = vtkPlaneSource()
    refine = relevo.vtkAdaptiveRefinementFilter()
    refine.SetInputConnection(plane.GetOutputPort())
    refine.SetRefinement(recipe)

    def stop(caller: relevo.vtkHeightField, event: str) -> None:
        if Interrupts.is_stopped() and isinstance(caller, relevo.vtkHeightMap):
            caller.AbortExecuteOn()

    tag = heights.AddObserver("ProgressEvent", stop)
    try:
        update(refine)
    except Error as error:
        # The filter reports the error again.
        raise Error(heights.GetErrorMessage() or str(error)) from None
    finally:
        heights.RemoveObserver(tag)


def wait_for_index(pyramid: relevo.vtkTerrainPyramid) -> None:
    """Wait until the index of a raster is complete. Raise its errors."""
    while not pyramid.HasIndexEnded():
        time.sleep(_PAUSE)
    with Messages():
        pyramid.WaitForIndex()

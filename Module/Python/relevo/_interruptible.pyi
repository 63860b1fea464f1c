# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Callable

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor

def update(algorithm: vtkAlgorithm, is_stopped: Callable[[], bool], /) -> None: ...
def render(window: vtkRenderWindow, is_stopped: Callable[[], bool], /) -> None: ...
def start(interactor: vtkRenderWindowInteractor, is_stopped: Callable[[], bool], /) -> None: ...

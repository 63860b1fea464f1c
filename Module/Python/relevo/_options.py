# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The options that all functions for meshes share."""

from __future__ import annotations

import dataclasses
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkPlane

from . import _camera, _section
from ._colours import Colours


@dataclasses.dataclass
class MeshOptions:
    """How a mesh is read and looks.

    up: the vertical axis, "x", "y" or "z". lighting: whether lights shade it, or None for the
    default of the drawing. time: the time of the step to draw, or None. scalars: the array for
    colours, or None. clip: the plane of a cut, as for make_plane(), or None. colours: those of the
    array.
    """

    up: str
    lighting: bool | None
    time: float | None
    scalars: str | None = None
    clip: Any = None
    colours: Colours = dataclasses.field(default_factory=Colours)

    def __post_init__(self) -> None:
        self.axis: int = _camera.find_axis(self.up)
        self.plane: vtkPlane | None = None if self.clip is None else _section.make_plane(self.clip)

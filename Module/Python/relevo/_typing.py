# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Types for annotations."""

from __future__ import annotations

import os
from typing import Any, Protocol, TypeVar, Union

import numpy
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkCamera

Array = NDArray[numpy.float64]
Bounds = tuple[float, float, float, float]
Camera = Union[vtkCamera, tuple[float, float], None]
Path = Union[str, "os.PathLike[str]"]

Item = TypeVar("Item", covariant=True)


class Items(Protocol[Item]):
    """Lists, tuples and arrays, which VTK takes as vectors and matrices."""

    def __len__(self) -> int: ...

    def __getitem__(self, index: Any, /) -> Item: ...

# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Types for annotations."""

from __future__ import annotations

import os
from typing import Any, Protocol, TypeVar, Union

import numpy
from vtkmodules.vtkRenderingCore import vtkCamera

Array = numpy.ndarray[Any, numpy.dtype[numpy.float64]]  # numpy.typing takes time to load
Bounds = tuple[float, float, float, float]
Camera = Union[vtkCamera, tuple[float, float], None]
Path = Union[str, "os.PathLike[str]"]

Item = TypeVar("Item", covariant=True)


class Items(Protocol[Item]):
    """Lists, tuples and arrays, which VTK takes as vectors and matrices."""

    def __len__(self) -> int: ...

    def __getitem__(self, index: Any, /) -> Item: ...

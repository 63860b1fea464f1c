# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colour tables, as relevo-view has them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

VIRIDIS = (
    (0.267, 0.005, 0.329),
    (0.229, 0.322, 0.546),
    (0.128, 0.567, 0.551),
    (0.369, 0.789, 0.383),
    (0.993, 0.906, 0.144),
)
RELIEF = (
    (0.27, 0.47, 0.29),
    (0.53, 0.64, 0.39),
    (0.83, 0.79, 0.55),
    (0.70, 0.55, 0.37),
    (0.58, 0.49, 0.44),
    (0.97, 0.97, 0.97),
)


def make_table(
    low: float, high: float, colours: Sequence[tuple[float, float, float]] = VIRIDIS
) -> vtkColorTransferFunction:
    """Return a table of evenly spaced colours. A constant gets the lowest colour."""
    extent = high - low if high > low else 1.0
    table = vtkColorTransferFunction()
    table.SetVectorModeToMagnitude()
    for i, colour in enumerate(colours):
        table.AddRGBPoint(low + extent * i / (len(colours) - 1), *colour)
    return table


def make_title(name: str, array: vtkDataArray) -> str:
    """Return the name of an array with its unit, if it has one."""
    title = f"{name} (magnitude)" if array.GetNumberOfComponents() > 1 else name
    information = array.GetInformation() if array.HasInformation() else None
    key: Any = vtkDataArray.UNITS_LABEL()
    return f"{title} [{information.Get(key)}]" if information and information.Has(key) else title

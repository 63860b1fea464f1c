# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colour tables, as relevo-view has them."""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Sequence
from typing import Any

from vtkmodules.vtkCommonCore import vtkDataArray, vtkLookupTable, vtkScalarsToColors
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkMapper

from ._palettes import PALETTES

Colour = tuple[float, float, float]
RELIEF = PALETTES["relief"]
_LOG_COLOURS = 1024


def make_table(
    low: float, high: float, colours: Sequence[Colour] = PALETTES["viridis"], log: bool = False
) -> vtkColorTransferFunction:
    """Return a table of evenly spaced colours. A constant gets the lowest colour."""
    if not high > low:
        high = 10 * low if log else low + 1
    table = vtkColorTransferFunction()
    last = len(colours) - 1
    for i, colour in enumerate(colours):
        share = i / last
        value = low * (high / low) ** share if log else low + (high - low) * i / last
        # The ends are exact, because colours of other values begin there.
        table.AddRGBPoint(low if i == 0 else high if i == last else value, *colour)
    if log:
        table.SetScaleToLog10()
    return table


def choose_array(mapper: vtkMapper, name: str, of_points: bool) -> None:
    """Colour a surface by an array of points or cells."""
    if of_points:
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(name)
    mapper.ScalarVisibilityOn()


def set_table(mapper: vtkMapper, table: vtkScalarsToColors) -> None:
    """Set the colours of the array of a surface, with the range of the table."""
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()


def make_title(name: str, array: vtkDataArray) -> str:
    """Return the name of an array with its unit, if it has one."""
    title = f"{name} (magnitude)" if array.GetNumberOfComponents() > 1 else name
    information = array.GetInformation() if array.HasInformation() else None
    key: Any = vtkDataArray.UNITS_LABEL()
    return f"{title} [{information.Get(key)}]" if information and information.Has(key) else title


def is_log(table: vtkScalarsToColors) -> bool:
    """Return whether the colours of a table depend on logarithms."""
    return bool(
        table.UsingLogScale()
        or (isinstance(table, vtkColorTransferFunction) and table.GetScale() == 1)
    )


def _find_colour(colour: Any, option: str) -> Colour | None:
    """Return red, green and blue, from 0 to 1, of three numbers, "#rrggbb" or a name."""
    if colour is None:
        return None
    if isinstance(colour, str):
        from vtkmodules.vtkCommonColor import vtkNamedColors

        names = vtkNamedColors()
        is_number = re.fullmatch("#[0-9a-fA-F]{6}", colour)
        if is_number or (colour and names.ColorExists(colour)):
            found = names.HTMLColorToRGB(colour) if is_number else names.GetColor3ub(colour)
            return (found.GetRed() / 255, found.GetGreen() / 255, found.GetBlue() / 255)
        raise ValueError(f"{option} must be a colour such as 'white' or '#ff8800', not {colour!r}")
    try:
        red, green, blue = (float(number) for number in colour)
    except (TypeError, ValueError):
        raise TypeError(
            f"{option} must be a colour such as 'white', '#ff8800' or (1, 0.5, 0), not {colour!r}"
        ) from None
    if not all(0 <= number <= 1 for number in (red, green, blue)):
        raise ValueError(f"{option}: red, green and blue must be from 0 to 1, not {colour!r}")
    return red, green, blue


@dataclasses.dataclass
class Colours:
    """The options for colours of an array.

    palette: a name of PALETTES. range: (low, high), "all" for those of all time steps, or None for
    those of the drawn step. log: whether colours depend on logarithms. below, above: the colours of
    values out of range.
    """

    palette: str | None = None
    range: Any = None
    log: bool = False
    below: Any = None
    above: Any = None

    def __post_init__(self) -> None:
        if self.palette is not None and self.palette not in PALETTES:
            names = ", ".join(sorted(PALETTES))
            raise ValueError(f"palette must be one of {names}, not {self.palette!r}")
        self.below = _find_colour(self.below, "below")
        self.above = _find_colour(self.above, "above")
        if self.range is None or (isinstance(self.range, str) and self.range == "all"):
            return
        try:
            low, high = (float(number) for number in self.range)
        except (TypeError, ValueError):
            raise TypeError(f"range must be (low, high) or 'all', not {self.range!r}") from None
        if not (math.isfinite(high - low) and low < high):
            raise ValueError(f"range must be finite numbers that increase, not {self.range!r}")
        if self.log and low <= 0:
            raise ValueError(f"log needs a range above 0, not {self.range!r}")
        self.range = low, high

    @property
    def of_all_steps(self) -> bool:
        return isinstance(self.range, str)

    def find_given(self) -> str | None:
        """Return the name of an option that is set, or None."""
        fields = dataclasses.fields(self)
        return next((own.name for own in fields if getattr(self, own.name) != own.default), None)

    def choose_range(self, low: float, high: float, name: str) -> tuple[float, float]:
        """Return the range of the colours for an array with these values."""
        if isinstance(self.range, tuple):
            return self.range[0], self.range[1]
        if self.log and low <= 0:
            hint = f"set range=({1e-3 * high:g}, {high:g}), for example" if high > 0 else "omit log"
            raise ValueError(
                f"log needs values above 0, and {name!r} is from {low:g} to {high:g}; {hint}"
            )
        return low, high

    def make_function(self, low: float, high: float) -> vtkColorTransferFunction:
        """Return the colours of a range."""
        function = make_table(low, high, PALETTES[self.palette or "viridis"], self.log)
        if self.below is not None:
            function.SetBelowRangeColor(self.below)
            function.UseBelowRangeColorOn()
        if self.above is not None:
            function.SetAboveRangeColor(self.above)
            function.UseAboveRangeColorOn()
        return function

    def make_table(self, low: float, high: float) -> vtkScalarsToColors:
        """Return the colours of a range for mappers of surfaces, which map vectors by magnitude.

        Of a logarithmic scale, VTK's mappers need a vtkLookupTable.
        """
        function = self.make_function(low, high)
        function.SetVectorModeToMagnitude()
        if not self.log:
            return function
        low, high = function.GetRange()
        table = vtkLookupTable()
        table.SetVectorModeToMagnitude()
        table.SetNumberOfTableValues(_LOG_COLOURS)
        table.SetTableRange(low, high)
        table.SetScaleToLog10()
        for i in range(_LOG_COLOURS):
            value = low * (high / low) ** ((i + 0.5) / _LOG_COLOURS)
            table.SetTableValue(i, *function.GetColor(value), 1.0)
        table.SetBelowRangeColor(*function.GetBelowRangeColor(), 1.0)
        table.SetUseBelowRangeColor(function.GetUseBelowRangeColor())
        table.SetAboveRangeColor(*function.GetAboveRangeColor(), 1.0)
        table.SetUseAboveRangeColor(function.GetUseAboveRangeColor())
        return table

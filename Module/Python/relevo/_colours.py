# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colour tables and colour bars, as relevo-view has them."""

import math
import textwrap

from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws the text

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
_BAR = (0.01, 0.55, 0.11, 0.43)  # left, bottom, width and height, relative to the picture


def make_table(low, high, colours=VIRIDIS):
    """Return a table of evenly spaced colours. A constant gets the lowest colour."""
    extent = high - low if high > low else 1.0
    table = vtkColorTransferFunction()
    table.SetVectorModeToMagnitude()
    for i, colour in enumerate(colours):
        table.AddRGBPoint(low + extent * i / (len(colours) - 1), *colour)
    return table


def make_title(name, array):
    """Return the name of an array with its unit, if it has one."""
    title = f"{name} (magnitude)" if array.GetNumberOfComponents() > 1 else name
    information = array.GetInformation() if array.HasInformation() else None
    key = vtkDataArray.UNITS_LABEL()
    return f"{title} [{information.Get(key)}]" if information and information.Has(key) else title


def _make_label_format(low, high):
    """Return a format of three digits, in which neighbours of five labels differ in two."""
    largest = max(abs(low), abs(high))
    exponent = math.floor(math.log10(largest)) if largest > 0 else 0
    if not -3 <= exponent <= 5:
        return "%.2e"
    step = (high - low) / 4
    decimals = 2 - exponent
    if step > 0:
        decimals = max(decimals, math.ceil(1 - math.log10(step)))
    decimals = min(max(decimals, 0), 14 - exponent)
    labels = [low + i * step for i in range(5)]
    while decimals > 0 and all(
        abs(label - round(label, decimals - 1)) <= 1e-9 * largest for label in labels
    ):
        decimals -= 1
    return f"%.{decimals}f"


def make_bar(table, title, size):
    """Return a colour bar in a picture, and the columns and rows of the corner that it takes."""
    left, bottom, width, height = _BAR
    font = max(8, min(14, size[1] // 45))
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(textwrap.fill(title, max(8, int(width * size[0] / (0.55 * font)))))
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat(_make_label_format(*table.GetRange()))
    bar.SetVerticalTitleSeparation(12)
    bar.UnconstrainedFontSizeOn()
    bar.SetPosition(left, bottom)
    bar.SetWidth(width)
    bar.SetHeight(height)
    bar.SetBarRatio(0.2)
    bar.SetMaximumNumberOfColors(256)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0.1, 0.1, 0.1)
        text.SetFontSize(font)
        text.BoldOff()
        text.ItalicOff()
        text.ShadowOff()
    return bar, (round((2 * left + width) * size[0]), round((1 - bottom) * size[1]))

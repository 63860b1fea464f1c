# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colour bars, as relevo-view has them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence

import numpy
from vtkmodules.util.numpy_support import ID_TYPE_CODE, numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints, vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import (
    vtkActor2D,
    vtkColorTransferFunction,
    vtkCoordinate,
    vtkPolyDataMapper2D,
    vtkTextActor,
    vtkTextProperty,
    vtkTextRenderer,
)

import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws the text

from . import _colours

# In pixels.
_SMALLEST_SIZE = (240, 180)
_BAR_WIDTH = 20
_HIGHEST_BAR = 200
_LOWEST_BAR = 60
_LABEL_PITCH = 18  # smallest distance of labels
_GAP = 6
_SWATCH_HEIGHT = 8  # of colours below and above the range
_SWATCH_GAP = 2
_FONT_SIZE = 14
_NARROWEST_TITLE = 110
_TITLE_SHARE = 0.14  # relative to the picture's width
_FEW_LINES = 4
_MOST_LINES = 6
_GROUND_OPACITY = 0.4
_DOTS = 72  # per inch, VTK's default


def _make_label_format(low: float, high: float) -> str:
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


def _get_size(text: str, font: vtkTextProperty) -> tuple[int, int]:
    """Return columns and rows of a text."""
    box = [0, 0, 0, 0]
    vtkTextRenderer.GetInstance().GetBoundingBox(font, text, box, _DOTS)
    return box[1] - box[0] + 1, box[3] - box[2] + 1


def _split(word: str, fits: Callable[[str], bool]) -> tuple[list[str], bool]:
    """Return the parts of a word that fit, after joining characters if possible, and whether."""
    if fits(word):
        return [word], True
    parts, is_at_joints = [], True
    for part in re.findall(r"[^_\-/:;,.]*[_\-/:;,.]+\s*|[^_\-/:;,.]+", word):
        while not fits(part) and len(part) > 1:
            is_at_joints = False
            length = next((i for i in range(len(part) - 1, 1, -1) if fits(part[:i])), 1)
            parts.append(part[:length])
            part = part[length:]
        parts.append(part)
    return parts, is_at_joints


def _wrap(title: str, font: vtkTextProperty, limit: int) -> tuple[list[str], bool]:
    """Return the lines of a title, and whether no word is broken."""

    def fits(text: str) -> bool:
        return _get_size(text.rstrip(), font)[0] <= limit

    lines, is_whole = [""], True
    for word in re.findall(r"\S+\s*", title):
        parts, is_at_joints = _split(word, fits)
        is_whole = is_whole and is_at_joints
        for part in parts:
            if lines[-1] and not fits(lines[-1] + part):
                lines.append("")
            lines[-1] += part
    return [line.rstrip() for line in lines], is_whole


def _make_font() -> vtkTextProperty:
    font = vtkTextProperty()
    font.SetColor(0.1, 0.1, 0.1)
    font.SetFontSize(_FONT_SIZE)
    return font


def _set_title(title: str, font: vtkTextProperty, limit: int) -> str:
    """Return the title with line breaks. Long ones get a smaller font."""
    for size in (_FONT_SIZE, _FONT_SIZE - 2, _FONT_SIZE - 4):
        font.SetFontSize(size)
        lines, is_whole = _wrap(title, font, limit)
        if is_whole and len(lines) <= _FEW_LINES:
            break
    if len(lines) > _MOST_LINES:
        lines = [*lines[: _MOST_LINES - 1], "..."]
    return "\n".join(lines)


def _is_indexed(table: vtkScalarsToColors) -> bool:
    return bool(table.GetIndexedLookup()) and table.GetNumberOfAnnotatedValues() > 0


def _make_rows(table: vtkScalarsToColors, height: int) -> list[tuple[float, str]]:
    """Return the labels of a bar, as pairs of position from 0 to 1 and text."""
    if _is_indexed(table):
        number = table.GetNumberOfAnnotatedValues()
        return [((i + 0.5) / number, table.GetAnnotation(i)) for i in range(number)]
    low, high = table.GetRange()
    if _colours.is_log(table):
        values = _list_log_labels(low, high, height // _LABEL_PITCH + 1)
        extent = math.log(high / low) or 1.0
        return [(math.log(value / low) / extent, f"{float(f'{value:.3g}'):g}") for value in values]
    number = next(number for number in (5, 3, 2) if (number - 1) * _LABEL_PITCH <= height)
    style = _make_label_format(low, high)
    return [(i / (number - 1), style % _get_value(table, i / (number - 1))) for i in range(number)]


def _list_log_labels(low: float, high: float, most: int) -> list[float]:
    """Return the ends of a range above 0, and powers of ten between them, at most a number."""
    length = math.log10(high / low)
    margin = length / max(most - 1, 1)  # keeps the labels of the ends free
    first = math.ceil(math.log10(low) + margin - 1e-9)
    last = math.floor(math.log10(high) - margin + 1e-9)
    step = max(math.ceil(margin - 1e-9), 1)
    return [low, *(10.0**exponent for exponent in range(first, last + 1, step)), high]


def _get_swatch(table: vtkScalarsToColors, end: str) -> list[float] | None:
    """Return the colour of values "Below" or "Above" the range, or None for that of its end."""
    if not isinstance(table, (vtkColorTransferFunction, vtkLookupTable)):
        return None
    if not getattr(table, f"GetUse{end}RangeColor")():
        return None
    return list(getattr(table, f"Get{end}RangeColor")()[:3])


def _get_value(table: vtkScalarsToColors, position: float) -> float:
    low, high = table.GetRange()
    if _colours.is_log(table) and low * high > 0:
        return float(low * (high / low) ** position)
    return low + position * (high - low)


def _get_colour(table: vtkScalarsToColors, position: float) -> list[float]:
    colour = [0.0, 0.0, 0.0, 1.0]
    if _is_indexed(table):
        row = int(position * table.GetNumberOfAnnotatedValues())
        table.GetAnnotationColor(table.GetAnnotatedValue(row), colour)
    else:
        colour = [0.0, 0.0, 0.0]
        table.GetColor(_get_value(table, position), colour)
    return colour[:3]


def _place(actor: vtkActor2D, anchor: vtkCoordinate, x: float, y: float) -> None:
    """Place an actor at columns and rows from the upper left corner of the picture."""
    coordinate = actor.GetPositionCoordinate()
    coordinate.SetCoordinateSystemToViewport()
    coordinate.SetReferenceCoordinate(anchor)
    coordinate.SetValue(x, -y, 0)


def _make_rectangles(width: int, heights: Sequence[int]) -> tuple[vtkActor2D, vtkPolyData]:
    """Return an actor of rectangles one above the other, from y = 0 upwards, and its mesh."""
    ends = numpy.arange(len(heights) + 1).repeat(2)
    levels = numpy.concatenate([[0], numpy.cumsum(heights)])
    corners = numpy.zeros((len(ends), 3))
    corners[1::2, 0] = width
    corners[:, 1] = levels[ends]
    first = 2 * numpy.arange(len(heights))[:, None]
    ids = (first + (0, 1, 3, 2)).astype(ID_TYPE_CODE)
    mesh = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(corners, deep=True))
    mesh.SetPoints(points)
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtkIdTypeArray(ids.reshape(-1), deep=True))
    mesh.SetPolys(cells)
    actor = vtkActor2D()
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(mesh)
    actor.SetMapper(mapper)
    return actor, mesh


def _make_text(text: str, font: vtkTextProperty) -> vtkTextActor:
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetTextProperty(font)
    return actor


def make_legend(
    table: vtkScalarsToColors, title: str, size: tuple[int, int]
) -> tuple[list[vtkActor2D], tuple[int, int]]:
    """Return the actors of a colour bar, and the columns and rows of the corner that it takes.

    There are none if the picture is too small.
    """
    margin = min(max(3 * min(size) // 200, 4), 16)
    title_font, label_font = _make_font(), _make_font()
    title_font.SetVerticalJustificationToTop()
    label_font.SetVerticalJustificationToCentered()
    title = _set_title(title, title_font, max(_NARROWEST_TITLE, int(_TITLE_SHARE * size[0])))
    title_size = _get_size(title, title_font)
    # The labels at the ends extend beyond the bar by half their height.
    overhang = _FONT_SIZE // 2
    below, above = _get_swatch(table, "Below"), _get_swatch(table, "Above")
    swatch = _SWATCH_GAP + _SWATCH_HEIGHT
    under = max(overhang, swatch) if below else overhang
    over = max(overhang, swatch) if above else overhang
    top = margin + title_size[1] + _GAP + over
    height = min(size[1] - top - margin - under, _HIGHEST_BAR)
    if height < _LOWEST_BAR or size[0] < _SMALLEST_SIZE[0] or size[1] < _SMALLEST_SIZE[1]:
        return [], (0, 0)
    rows = _make_rows(table, height)
    widths = [_get_size(text, label_font)[0] for _, text in rows]
    content = max(title_size[0], _BAR_WIDTH + _GAP + max(widths, default=0))
    corner = (margin + content + _GAP, top + height + under + _GAP)

    anchor = vtkCoordinate()
    anchor.SetCoordinateSystemToNormalizedViewport()
    anchor.SetValue(0, 1, 0)
    ground, _ = _make_rectangles(corner[0], [corner[1]])
    ground.GetProperty().SetColor(1, 1, 1)
    ground.GetProperty().SetOpacity(_GROUND_OPACITY)
    _place(ground, anchor, 0, corner[1])
    bar, mesh = _make_rectangles(_BAR_WIDTH, [1] * height)
    colours = [_get_colour(table, (i + 0.5) / height) for i in range(height)]
    colours = numpy.rint(255 * numpy.array(colours)).astype(numpy.uint8)
    mesh.GetCellData().SetScalars(numpy_to_vtk(colours, deep=True))
    _place(bar, anchor, margin, top + height)
    actors = [ground, bar]
    for colour, y in ((below, top + height + swatch), (above, top - _SWATCH_GAP)):
        if colour:
            block, _ = _make_rectangles(_BAR_WIDTH, [_SWATCH_HEIGHT])
            block.GetProperty().SetColor(colour)
            _place(block, anchor, margin, y)
            actors.append(block)
    actors.append(_make_text(title, title_font))
    _place(actors[-1], anchor, margin, margin)
    for position, text in rows:
        actors.append(_make_text(text, label_font))
        x, y = margin + _BAR_WIDTH + _GAP, top + height - math.floor(position * height + 0.5)
        _place(actors[-1], anchor, x, y)
    return actors, corner

# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The label with the time of a step, as relevo-view has it."""

from __future__ import annotations

from vtkmodules.vtkRenderingCore import vtkTextActor

import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws the text

_FONT_SIZE = 16
_GROUND_OPACITY = 0.4
_MARGIN = 0.98  # share of the picture, from the lower left corner


def make_time_label(time: float) -> vtkTextActor:
    """Return a text in the upper right corner."""
    label = vtkTextActor()
    label.SetInput(f"time {time:g}")
    text = label.GetTextProperty()
    text.SetColor(0.1, 0.1, 0.1)
    text.SetFontSize(_FONT_SIZE)
    text.SetBackgroundColor(1, 1, 1)
    text.SetBackgroundOpacity(_GROUND_OPACITY)
    text.SetJustificationToRight()
    text.SetVerticalJustificationToTop()
    label.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    label.SetPosition(_MARGIN, _MARGIN)
    return label

# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Turns errors and warnings of VTK's objects into those of Python."""

from __future__ import annotations

import re
import sys
import threading
import warnings
from collections.abc import Mapping
from types import FrameType, TracebackType

from vtkmodules.vtkCommonCore import VTK_STRING, vtkLogger, vtkObject, vtkOutputWindow

from ._error import Error
from ._interrupts import Interrupts

# Consequences of other errors, and warnings about data that no one draws.
_NOISE = re.compile(r"Algorithm \w+ ?\(\w+\) returned failure|Could not locate key")


def _strip(text: str | None) -> str:
    """Return a message without class, address and source line.

    VTK passes None if the message is not UTF-8, because it quotes binary data.
    """
    if text is None:
        return "VTK cannot read the data: its message is not text"
    return re.sub(r"^[\w ]+: In .*, line \d+\s+(\w+ \(\w+\): )?", "", text).strip()


def rename(text: str, names: Mapping[str, str]) -> str:
    """Return a message with the caller's names of things, first things first."""
    for name, own in names.items():
        text = text.replace(name, own)
    return text


def warn(text: str) -> None:
    """Issue a warning for the line of the program that called the package."""
    level = 1
    frame: FrameType | None = sys._getframe(0)
    while frame and frame.f_globals.get("__name__", "").startswith("relevo."):
        frame = frame.f_back
        level += 1
    warnings.warn(text, stacklevel=level)


class Messages:
    """Within a `with` block, errors of VTK's objects are raised at the end, not printed.

    Ctrl-C is raised at the end, too. Warnings become Python's warnings. Objects with an observer
    for ErrorEvent report to it instead. Blocks can be nested, and several threads can be in one at
    a time. The outermost block of a thread issues the warnings.

    Programs can switch off VTK's messages, as vedo does. Within a block they are on, because errors
    would be lost.
    """

    _lock = threading.Lock()
    _depth = 0  # blocks that threads are in
    _verbosity = 0  # of standard error, outside of all blocks
    _mode: int = vtkOutputWindow.DEFAULT  # of the output window, outside of all blocks
    _display = 1  # whether VTK has messages, outside of all blocks
    _blocks = threading.local()  # has the attribute `depth` in threads that are in blocks

    def __init__(
        self, error: type[Exception] = Error, names: Mapping[str, str] | None = None
    ) -> None:
        """Raise exceptions of the given type.

        names: what the caller calls things that VTK's objects name otherwise, such as
            {"MaximumLevel": "max_level"}.
        """
        self._error = error
        self._names = names or {}
        self._errors: list[str] = []
        self._warnings: list[str] = []
        self._interrupts = Interrupts()

    def _add_error(self, caller: vtkObject, event: str, text: str | None) -> None:
        self._errors.append(rename(_strip(text), self._names))

    def _add_warning(self, caller: vtkObject, event: str, text: str | None) -> None:
        self._warnings.append(rename(_strip(text), self._names))

    for _function in (_add_error, _add_warning):
        setattr(_function, "CallDataType", VTK_STRING)  # how VTK passes the text

    def __enter__(self) -> Messages:
        self._interrupts.__enter__()
        self._window = vtkOutputWindow.GetInstance()
        with Messages._lock:
            Messages._depth += 1
            if Messages._depth == 1:
                Messages._verbosity = vtkLogger.GetCurrentVerbosityCutoff()
                Messages._mode = self._window.GetDisplayMode()
                Messages._display = vtkObject.GetGlobalWarningDisplay()
                vtkObject.GlobalWarningDisplayOn()
                vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
                self._window.SetDisplayModeToNever()
        self._tags = [self._window.AddObserver("ErrorEvent", self._add_error)]
        depth = getattr(Messages._blocks, "depth", 0)
        Messages._blocks.depth = depth + 1
        if depth == 0:
            self._tags.append(self._window.AddObserver("WarningEvent", self._add_warning))
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        for tag in self._tags:
            self._window.RemoveObserver(tag)
        Messages._blocks.depth -= 1
        with Messages._lock:
            Messages._depth -= 1
            if Messages._depth == 0:
                vtkLogger.SetStderrVerbosity(vtkLogger.ConvertToVerbosity(Messages._verbosity))
                self._window.SetDisplayMode(Messages._mode)
                vtkObject.SetGlobalWarningDisplay(Messages._display)
        self._interrupts.__exit__(kind, value, traceback)
        for text in dict.fromkeys(self._warnings):
            if not _NOISE.match(text):
                warn(text)
        if kind is None and self._errors:
            errors = [text for text in dict.fromkeys(self._errors) if not _NOISE.match(text)]
            raise self._error("\n".join(errors or self._errors[:1]))

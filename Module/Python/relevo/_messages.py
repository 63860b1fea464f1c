# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Turns errors and warnings of VTK's objects into those of Python."""

from __future__ import annotations

import re
import sys
import threading
import warnings
from types import FrameType, TracebackType

from vtkmodules.vtkCommonCore import VTK_STRING, vtkLogger, vtkObject, vtkOutputWindow

from ._error import Error
from ._interrupts import Interrupts

# Consequences of other errors, and warnings about data that no one draws.
_NOISE = re.compile(r"Algorithm \w+ ?\(\w+\) returned failure|Could not locate key")


def _strip(text: str) -> str:
    """Return a message without class, address and source line."""
    return re.sub(r"^[\w ]+: In .*, line \d+\s+(\w+ \(\w+\): )?", "", text).strip()


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
    a time.
    """

    _lock = threading.Lock()
    _depth = 0  # blocks that threads are in
    _verbosity = 0  # of standard error, outside of all blocks
    _mode: int = vtkOutputWindow.DEFAULT  # of the output window, outside of all blocks

    def __init__(self, error: type[Exception] = Error) -> None:
        """Raise exceptions of the given type."""
        self._error = error
        self._errors: list[str] = []
        self._warnings: list[str] = []
        self._interrupts = Interrupts()

    def _add_error(self, caller: vtkObject, event: str, text: str) -> None:
        self._errors.append(_strip(text))

    def _add_warning(self, caller: vtkObject, event: str, text: str) -> None:
        self._warnings.append(_strip(text))

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
                vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
                self._window.SetDisplayModeToNever()
        self._tags = [
            self._window.AddObserver("ErrorEvent", self._add_error),
            self._window.AddObserver("WarningEvent", self._add_warning),
        ]
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        for tag in self._tags:
            self._window.RemoveObserver(tag)
        with Messages._lock:
            Messages._depth -= 1
            if Messages._depth == 0:
                vtkLogger.SetStderrVerbosity(vtkLogger.ConvertToVerbosity(Messages._verbosity))
                self._window.SetDisplayMode(Messages._mode)
        self._interrupts.__exit__(kind, value, traceback)
        for text in dict.fromkeys(self._warnings):
            if not _NOISE.match(text):
                warn(text)
        if kind is None and self._errors:
            errors = [text for text in dict.fromkeys(self._errors) if not _NOISE.match(text)]
            raise self._error("\n".join(errors or self._errors[:1]))

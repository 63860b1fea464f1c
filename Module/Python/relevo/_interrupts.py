# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Delays Ctrl-C until VTK returns, and tells VTK's objects to stop."""

from __future__ import annotations

import signal
import threading
from types import FrameType, TracebackType


class Interrupts:
    """Within a `with` block of the main thread, Ctrl-C is raised at the end.

    VTK ends the program if KeyboardInterrupt is raised in an observer. Long work asks is_stopped().
    Blocks can be nested: the outermost one raises the exception. In other threads, a block has no
    effect, because Python interrupts the main thread only.
    """

    _current: Interrupts | None = None

    def __init__(self) -> None:
        self._exception: BaseException | None = None
        self._is_outermost = False

    @staticmethod
    def is_stopped() -> bool:
        """Return whether work of this thread must stop."""
        current = Interrupts._current
        is_main = threading.current_thread() is threading.main_thread()
        return is_main and current is not None and current._exception is not None

    def _handle(self, number: int, frame: FrameType | None) -> None:
        try:
            self._handler(number, frame)
        except BaseException as exception:
            self._exception = exception

    def __enter__(self) -> Interrupts:
        if threading.current_thread() is threading.main_thread() and not Interrupts._current:
            handler = signal.getsignal(signal.SIGINT)
            if callable(handler):  # otherwise Ctrl-C ends the program, or is ignored
                self._handler = handler
                self._is_outermost = True
                Interrupts._current = self
                signal.signal(signal.SIGINT, self._handle)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if not self._is_outermost:
            return
        if signal.getsignal(signal.SIGINT) == self._handle:
            signal.signal(signal.SIGINT, self._handler)
        Interrupts._current = None
        if self._exception is not None:
            raise self._exception.with_traceback(None) from None

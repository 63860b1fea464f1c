# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes files that replace old ones only when they are complete."""

from __future__ import annotations

import contextlib
import errno
import os
import pathlib
import secrets
import signal
import stat
import threading
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter

if TYPE_CHECKING:
    from ._typing import Path


@contextlib.contextmanager
def _removed_by_signals(name: pathlib.Path) -> Iterator[None]:
    """Remove the file before a signal ends the process."""

    def remove(number: int, _: object) -> None:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(name)
        signal.signal(number, signal.SIG_DFL)
        signal.raise_signal(number)

    old = {}
    if threading.current_thread() is threading.main_thread():
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            if signal.getsignal(number) == signal.SIG_DFL:
                old[number] = signal.signal(number, remove)
    try:
        yield
    finally:
        for number, handler in old.items():
            signal.signal(number, handler)


def write(path: Path, contents: str | bytes | memoryview) -> None:
    """Write bytes, or a text as UTF-8, to a file.

    The contents are written to a temporary file in the same folder, which is renamed when it is
    complete on the disk. An error (OSError) or a signal leaves the old file unchanged; SIGKILL may
    leave the temporary file. For a symbolic link, its target is replaced. Devices and pipes are
    written directly.
    """
    contents = contents.encode() if isinstance(contents, str) else contents
    target = pathlib.Path(path).resolve()
    if target.exists() and not target.is_file():
        target.write_bytes(contents)  # a device; a folder raises an error
        return
    mode = None
    if target.exists():
        with open(target, "ab"):  # raises an error if it is read-only
            mode = stat.S_IMODE(target.stat().st_mode)
    if not target.parent.exists():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(target.parent))
    part = target.with_name(f".{target.stem[:40]}.{secrets.token_hex(4)}.part{target.suffix[:20]}")
    with _removed_by_signals(part):
        try:
            with open(part, "xb") as file:
                if mode is not None:
                    os.chmod(part, mode)
                file.write(contents)
                file.flush()
                os.fsync(file.fileno())
            os.replace(part, target)
        except BaseException:
            with contextlib.suppress(FileNotFoundError):
                part.unlink()
            raise


_WRITERS = {".png": vtkPNGWriter, ".jpg": vtkJPEGWriter, ".jpeg": vtkJPEGWriter}


def is_picture(path: Path) -> bool:
    """Return whether write_picture() supports the extension of a path."""
    return pathlib.Path(path).suffix.lower() in _WRITERS


def write_picture(
    path: Path, source: vtkRenderWindow | vtkImageData, quality: int = 95
) -> None:
    """Write a vtkRenderWindow, which is rendered, or a vtkImageData as a PNG or JPEG file.

    The extension of the path sets the format. The file is replaced as by write(). The quality
    applies to JPEG, from 0 to 100.

    Raises ValueError for another extension and if there is no image.
    """
    extension = pathlib.Path(path).suffix.lower()
    if extension not in _WRITERS:
        raise ValueError(f"{str(path)!r} must end with {', '.join(_WRITERS)}")
    writer: Any = _WRITERS[extension]()
    if extension != ".png":
        writer.SetQuality(quality)
    if isinstance(source, vtkRenderWindow):
        image = vtkWindowToImageFilter()
        image.SetInput(source)
        image.ReadFrontBufferOff()
        writer.SetInputConnection(image.GetOutputPort())
    else:
        writer.SetInputData(source)
    writer.WriteToMemoryOn()
    writer.Write()
    if writer.GetErrorCode() or not writer.GetResult():
        raise ValueError(f"cannot write {str(path)!r}: the image has no pixels, or a type that the format does not support")
    write(path, memoryview(writer.GetResult()))

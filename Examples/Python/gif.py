# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write animated GIF files, which VTK does not, for the scripts in this folder."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import Any

from relevo.files import write
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter

LARGEST_CODE = 4095


def photograph(window: vtkRenderWindow) -> vtkImageData:
    """Render the window and return its pixels."""
    window.Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    picture.ShouldRerenderOff()
    picture.Update()
    image = vtkImageData()
    image.DeepCopy(picture.GetOutput())
    return image


def write_gif(
    filename: str, images: Sequence[vtkImageData], seconds: float, colours: int = 64
) -> None:
    """Write RGB images (vtkImageData) of equal size as an endless loop with up to 256 colours."""
    width, height, _ = images[0].GetDimensions()
    indices, palette = quantize(images, colours)
    bits = max(2, (len(palette) - 1).bit_length())
    contents = bytearray()
    contents.extend(struct.pack("<6sHHBBB", b"GIF89a", width, height, 0xF0 | bits - 1, 0, 0))
    contents.extend(b"".join(palette).ljust(3 << bits, b"\0"))
    contents.extend(b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00")  # loop endlessly
    for frame in range(len(images)):
        rows = [(frame * height + row) * width for row in reversed(range(height))]
        pixels = b"".join(indices[start : start + width] for start in rows)
        contents.extend(struct.pack("<BBBBHBB", 0x21, 0xF9, 4, 4, round(100 * seconds), 0, 0))
        contents.extend(struct.pack("<BHHHHB", 0x2C, 0, 0, width, height, 0))
        contents.extend(bytes([bits]) + blocks(compress(pixels, bits)))
    contents.extend(b"\x3b")
    write(filename, contents)


def quantize(images: Sequence[vtkImageData], colours: int) -> tuple[bytes, list[bytes]]:
    """Return the pixels of all images, bottom row first, as one byte each, and the palette."""
    tower = vtkImageAppend()  # all images share one palette
    tower.SetAppendAxis(1)
    for image in images:
        tower.AddInputData(image)
    quantizer = vtkImageQuantizeRGBToIndex()
    quantizer.SetInputConnection(tower.GetOutputPort())
    quantizer.SetNumberOfColors(colours)
    quantizer.Update()
    table = quantizer.GetLookupTable()
    palette = [
        bytes(round(255 * c) for c in table.GetTableValue(i)[:3])
        for i in range(table.GetNumberOfTableValues())
    ]
    scalars: Any = quantizer.GetOutput().GetPointData().GetScalars()
    return bytes(memoryview(scalars).tolist()), palette


def compress(pixels: bytes, bits: int) -> bytes:
    """Return the pixels in the LZW code of GIF."""
    clear = 1 << bits
    result, buffered, held = bytearray(), 0, 0

    def emit(code: int, length: int) -> None:
        nonlocal buffered, held
        buffered |= code << held
        held += length
        while held >= 8:
            result.append(buffered & 255)
            buffered >>= 8
            held -= 8

    words: dict[tuple[bytes | int, int], Any] = {}
    length = bits + 1
    emit(clear, length)
    word = pixels[0]
    for pixel in pixels[1:]:
        longer = words.get((word, pixel))
        if longer is not None:
            word = longer
            continue
        emit(word, length)
        code = clear + 2 + len(words)
        if code <= LARGEST_CODE:
            words[word, pixel] = code
            # A decoder adds each word one code later, so the code grows one step later too.
            if code == 1 << length:
                length += 1
        else:
            emit(clear, length)
            words, length = {}, bits + 1
        word = pixel
    emit(word, length)
    emit(clear + 1, length)
    emit(0, 7)  # flush the last bits
    return bytes(result)


def blocks(data: bytes) -> bytes:
    """Split data into blocks of up to 255 bytes, ended by an empty block."""
    parts = (data[i : i + 255] for i in range(0, len(data), 255))
    return b"".join(bytes([len(part)]) + part for part in parts) + b"\0"

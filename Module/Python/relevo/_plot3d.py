# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Binary grids of PLOT3D, which have no common extension."""

from __future__ import annotations

import os

import numpy

EXTENSIONS = (".bin", ".grd", ".x", ".xyz")
_MOST_BLOCKS = 10000
_LARGEST_DIMENSION = 100000
_BYTES_OF_POINT = (12, 16, 24, 28)  # floats or doubles, and blanks
_SOLUTIONS = (("xyz.bin", "q.bin"), (".xyz", ".q"), (".x", ".q"))


def _fits(start: bytes, size: int, order: str, markers: bool, blocks: bool) -> bool:
    numbers = numpy.frombuffer(start[: len(start) // 4 * 4], f"{order}u4").astype(numpy.int64)
    place = 1 if markers else 0
    number = 1
    if blocks:
        number = int(numbers[place]) if place < len(numbers) else 0
        place += 3 if markers else 1
    if not 1 <= number <= _MOST_BLOCKS:
        return False
    dimensions = numbers[place : place + 3 * number]
    if len(dimensions) < 3 * number:
        return False
    if dimensions.min() < 1 or dimensions.max() > _LARGEST_DIMENSION:
        return False
    points = int(dimensions.reshape(-1, 3).prod(axis=1).sum())
    head = 12 * number + (4 if blocks else 0)
    if markers:
        head += 8 * (number + 1 + (1 if blocks else 0))
    return points > 1 and any(head + own * points == size for own in _BYTES_OF_POINT)


def is_grid(path: str) -> bool:
    """Return whether a file is exactly as long as the dimensions at its beginning require."""
    try:
        size = os.path.getsize(path)
        with open(path, "rb") as file:
            start = file.read(4 * (3 * _MOST_BLOCKS + 8))
    except OSError:
        return False
    flags = (False, True)
    return any(
        _fits(start, size, order, markers, blocks)
        for order in "<>"
        for markers in flags
        for blocks in flags
    )


def find_solution(path: str) -> str | None:
    """Return the path of the solution of a grid, if the file exists."""
    for own, other in _SOLUTIONS:
        if path.endswith(own):
            solution = path[: -len(own)] + other
            return solution if os.path.exists(solution) else None
    return None

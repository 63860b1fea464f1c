# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers from vectors and tensors, such as the von Mises stress."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkDataObject

import relevo

from . import _results, _work
from ._error import Error


def add_quantity(data: vtkDataObject, name: str | None) -> tuple[vtkDataObject, str | None]:
    """Return a copy of a mesh with the quantity that a name asks for, and its array's name.

    name: a quantity of vtkArrayQuantityFilter, such as "von Mises" or "x of U". The mesh and the
        name are unchanged for others, and if the mesh has an array of that name.
    """
    if not isinstance(name, str):
        return data, name
    quantity = relevo.vtkArrayQuantityFilter()
    quantity.SetInputDataObject(data)
    quantity.SetQuantity(name)
    try:
        _work.update(quantity)
    except Error as error:
        raise ValueError(str(error).replace("the input", "the mesh")) from None
    return quantity.GetOutput(), quantity.GetResultName()


def find_range_of_steps(
    source: Any,
    name: str,
    get_range: Callable[[vtkDataObject, str], tuple[float, float]],
    drawn: tuple[float, float],
) -> tuple[float, float]:
    """Return the range of an array or a quantity over all time steps of a file or an algorithm.

    get_range: returns the range in the data of a step. drawn: the range of the drawn step.
    """
    low, high = drawn
    for data in _results.read_all(source):
        step, array = add_quantity(data, name)
        own = get_range(step, array or name)
        low, high = min(low, own[0]), max(high, own[1])
    return low, high

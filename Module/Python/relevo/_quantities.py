# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers from vectors and tensors, such as the von Mises stress."""

from __future__ import annotations

from vtkmodules.vtkCommonDataModel import vtkDataObject

import relevo

from . import _work
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

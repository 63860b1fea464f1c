// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the numbers of a cell and of its nearest point
 */
#ifndef CellNumbers_h
#define CellNumbers_h

#include "vtkType.h"

#include <string>

class vtkDataSet;

/// "cell 12  point 34", counted from 0, with the point of the cell that is nearest to a place. A
/// mesh with global ids has "element" and "node" with these ids instead.
std::string DescribeCell(vtkDataSet* mesh, vtkIdType cell, const double place[3]);

#endif

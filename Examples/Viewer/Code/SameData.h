// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   compares data sets
 */
#ifndef SameData_h
#define SameData_h

class vtkDataObject;

/// Whether both are data sets of one class with the same points and cells, and the second has all
/// arrays of the first, to the bit.
bool AreSameData(vtkDataObject* first, vtkDataObject* second);

#endif

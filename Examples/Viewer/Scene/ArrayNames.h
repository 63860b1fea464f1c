// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the arrays of a mesh that can colour it, as messages and legends name them
 */
#ifndef ArrayNames_h
#define ArrayNames_h

#include <string>

class vtkPolyData;

/// "'a' of points, 'b' of cells with 3 components", "" for none.
std::string ListArrays(vtkPolyData* mesh);

/// The title of an array in legends: its name, or "name (magnitude)" for several components.
std::string GetArrayTitle(const std::string& name, int numberOfComponents);

#endif

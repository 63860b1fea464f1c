// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   names of a mesh's arrays in messages and legends
 */
#ifndef ArrayNames_h
#define ArrayNames_h

#include "Scene/SceneContent.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkPolyData;

/// "'a' of points, 'b' of cells with 3 components", or an empty string.
std::string ListArrays(vtkPolyData* mesh);

/// The arrays of numbers that a mesh can show.
std::vector<SceneArray> FindArrays(vtkDataSet* mesh);

/// The title of an array in legends: its name, or "name (magnitude)" for several components.
std::string GetArrayTitle(const std::string& name, int numberOfComponents);

#endif

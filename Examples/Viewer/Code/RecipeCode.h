// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds a recipe to the program of a scene
 */
#ifndef RecipeCode_h
#define RecipeCode_h

#include "Code/CodeValue.h"

class SceneCode;
class vtkAdaptiveRefinement;

/// Returns the variable of the recipe. Throws ViewerError for metrics, surfaces and displacements
/// of other classes than those of the viewer.
CodeValue AddRecipeCode(SceneCode& code, vtkAdaptiveRefinement* recipe);

#endif

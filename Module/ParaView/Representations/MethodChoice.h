// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the property Method that Adaptive Refinement and Adaptive Volume share
 *
 * Private to the module.
 */
#ifndef MethodChoice_h
#define MethodChoice_h

class vtkObject;

namespace relevo
{
/// Set the member of a representation. Report an error if the method is none of both.
void SetMethod(vtkObject* representation, int& member, int method);

/// Return the method of vtkAdaptiveRefinementMapper. Methods for volumes stand for ARKFPI.
int GetRefinementMethod(int method);

/// Return whether cells are projected. Methods for refinement stand for ray casting.
bool IsCellProjection(int method);
}

#endif

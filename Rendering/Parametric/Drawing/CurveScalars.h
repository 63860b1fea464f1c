// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   uploads the scalars that colour a mapper's curves
 *
 * Private to the module.
 */
#ifndef CurveScalars_h
#define CurveScalars_h

#include "Changes/Dependencies.h"

#include <string>

class vtkDataSet;
class vtkMapper;
class vtkOpenGLRenderWindow;

namespace relevo
{
class CurveColors;
class CurveMesh;

/// Return the dependencies of colours, without the input.
Dependencies GetScalarSettings(vtkMapper* mapper);

/**
 * Upload colours according to a mapper's settings, for an input with these curves. Return the
 * error, or "".
 */
std::string UploadScalars(vtkOpenGLRenderWindow* window, vtkMapper* mapper, vtkDataSet* input,
  const CurveMesh& curves, CurveColors& colors);
}

#endif

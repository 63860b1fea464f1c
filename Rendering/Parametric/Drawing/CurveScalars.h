// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a mapper colours curves by
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

/// All that colours depend on beside the input.
Dependencies GetScalarSettings(vtkMapper* mapper);

/**
 * Has colours as a mapper is set to, of an input with these curves. Returns what is wrong, "" for
 * nothing.
 */
std::string UploadScalars(vtkOpenGLRenderWindow* window, vtkMapper* mapper, vtkDataSet* input,
  const CurveMesh& curves, CurveColors& colors);
}

#endif

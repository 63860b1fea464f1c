// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementColors
 * @brief   point scalars and their lookup table on the GPU
 *
 * VTK colours the coarse points and interpolates colours; over a refined surface scalars are
 * interpolated first and each refined point is coloured, as a mapper of the refined mesh would.
 * Private to the module.
 */
#ifndef vtkRefinementColors_h
#define vtkRefinementColors_h

#include "vtkRefinementBuffer.h"     // for members
#include "vtkRefinementColorTable.h" // for members

class vtkDataArray;
class vtkScalarsToColors;

namespace relevo
{
class RefinementColors
{
public:
  /**
   * Take point scalars that are mapped through a lookup table (not direct colours). `component` is
   * that of vtkMapper, -1 to leave the choice to the table. False when the table's mapping is not
   * a function of one number: VTK's interpolation of colours then remains.
   */
  bool Upload(
    vtkOpenGLRenderWindow* window, vtkDataArray* scalars, vtkScalarsToColors* table, int component);

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  RefinementBuffer Scalars;
  RefinementColorTable Table;
  bool Magnitude = false;
};
}

#endif

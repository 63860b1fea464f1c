// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementColorTable
 * @brief   a lookup table on the GPU, for glsl/relevoColorTable.glsl
 *
 * Private to the module.
 */
#ifndef vtkRefinementColorTable_h
#define vtkRefinementColorTable_h

#include "vtkRefinementBuffer.h"

#include <array> // for colours

class vtkScalarsToColors;

namespace relevo
{
class RefinementColorTable
{
public:
  /**
   * Sample a table. The shader's values are less `bias` (0 for tables of logarithms).
   */
  bool Upload(vtkOpenGLRenderWindow* window, vtkScalarsToColors* table, double bias);

  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Colors.Deactivate(); }
  vtkTypeInt64 GetMemorySize() const { return this->Colors.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Colors.ReleaseGraphicsResources(window);
  }

  /// The colour and opacity of a value, in [0, 1].
  static std::array<float, 4> GetColor(vtkScalarsToColors* table, double value);

private:
  RefinementBuffer Colors;
  int NumberOfColors = 0;
  bool Log = false;
  float Minimum = 0.0f;
  float Factor = 0.0f;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ColorTable
 * @brief   a lookup table on the GPU, for glsl/relevoColorTable.glsl
 */
#ifndef ColorTable_h
#define ColorTable_h

#include "Buffers/BufferTexture.h"
#include "RelevoRenderingCoreModule.h" // for export macro

#include <array> // for colours
#include <string>

class vtkScalarsToColors;

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT ColorTable
{
public:
  /**
   * Sample a lookup table. `bias` (0 for logarithmic tables) is subtracted from the values in the
   * shader.
   */
  bool Upload(vtkOpenGLRenderWindow* window, vtkScalarsToColors* table, double bias,
    const double dataRange[2], bool whole = false);

  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Colors.Deactivate(); }
  vtkTypeInt64 GetMemorySize() const { return this->Colors.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Colors.ReleaseGraphicsResources(window);
  }

  /// Return whether colours depend on the logarithm of values.
  static bool IsLogarithmic(vtkScalarsToColors* table);

  /// Return why VTK cannot look up values in a table of this range, or an empty string; VTK does
  /// not check it.
  static std::string FindError(vtkScalarsToColors* table, const double range[2]);

  /// Return the colour and opacity of a value, in [0, 1].
  static std::array<float, 4> GetColor(vtkScalarsToColors* table, double value);

private:
  /// Choose the samples: NumberOfColors between Ends. Each whole number gets its own colour unless
  /// there are too many, because a function may have a step at a whole number.
  bool ChooseWhole(const double dataRange[2]);
  void ChooseSamples(vtkScalarsToColors* table, const double dataRange[2]);

  BufferTexture Colors;
  int NumberOfColors = 0;
  double Ends[2] = { 0.0, 0.0 };
  bool Log = false;
  float Minimum = 0.0f;
  float Span = 0.0f;
};
}

#endif

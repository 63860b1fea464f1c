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
   * Sample a table where values are to be looked up. The shader's values are less `bias` (0 for
   * tables of logarithms).
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

  /// Whether colours change with the logarithm of values.
  static bool IsLogarithmic(vtkScalarsToColors* table);

  /// Why VTK cannot look up values in a table of this range, empty where it can: it does not check.
  static std::string FindError(vtkScalarsToColors* table, const double range[2]);

  /// The colour and opacity of a value, in [0, 1].
  static std::array<float, 4> GetColor(vtkScalarsToColors* table, double value);

private:
  /// Set what is sampled: NumberOfColors between Ends. Whole numbers each have their own colour,
  /// unless there are too many: a function may change right at one.
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

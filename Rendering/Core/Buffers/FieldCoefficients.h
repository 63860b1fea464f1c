// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FieldCoefficients
 * @brief   coefficients on the GPU from which a surface evaluates its scalars at every pixel
 *
 * Scalars are numbers with a lookup table, or colours. Private to the modules.
 */
#ifndef FieldCoefficients_h
#define FieldCoefficients_h

#include "Buffers/BufferTexture.h"     // for members
#include "Buffers/FieldColoring.h"     // for member
#include "Buffers/VertexColors.h"      // for members
#include "RelevoRenderingCoreModule.h" // for export macro

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkScalarsToColors;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
/// The scalars of a mapper.
struct FieldScalars
{
  vtkDataArray* Array; // of points
  bool AreColors;
  vtkScalarsToColors* Table;
  int Component; // that of vtkMapper; -1 uses that of the table
  bool ByTexture;
  double NoDataMagnitude; // see NoDataTuples
};

class RELEVORENDERINGCORE_EXPORT FieldCoefficients
{
public:
  /// Upload the coefficients of scalars; NaN stands for no data. Return false if they do not fit on
  /// the GPU.
  bool Upload(
    vtkOpenGLRenderWindow* window, vtkDataArray* coefficients, const FieldScalars& scalars);
  void Clear() { this->Coloring = FieldColoring::NONE; }

  FieldColoring GetColoring() const { return this->Coloring; }
  /// Return whether each coefficient is a single number with a lookup table.
  bool IsNumber() const;
  /// Return the number that has been subtracted from the values.
  double GetBias() const { return this->Numbers.GetBias(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  FieldColoring Coloring = FieldColoring::NONE;
  VertexColors Numbers;
  BufferTexture Colors;
};
}

#endif

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
#include "Changes/Dependencies.h"      // for members
#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkSmartPointer.h"           // for members

#include <functional> // for the numbers

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
  using MakeNumbers = std::function<vtkSmartPointer<vtkDataArray>()>;

  /**
   * Upload the coefficients of scalars that are colours, or the result of makeNumbers(), in which
   * NaN stands for no data. Numbers are made and uploaded again only if `source`, on which they
   * depend, has changed; a change of the lookup table alone does not upload them. Return false if
   * they do not fit on the GPU.
   */
  bool Upload(vtkOpenGLRenderWindow* window, const Dependencies& source,
    const FieldScalars& scalars, vtkDataArray* colors, const MakeNumbers& makeNumbers);
  void Clear() { this->Coloring = FieldColoring::NONE; }

  FieldColoring GetColoring() const { return this->Coloring; }
  /// Return whether each coefficient is a single number with a lookup table.
  bool IsNumber() const;
  /// Return the number that has been subtracted from the values.
  double GetBias() const { return this->Numbers.GetBias(); }

  /// Return how often coefficients were uploaded.
  vtkIdType GetNumberOfUploads() const
  {
    return this->NumberOfColorUploads + this->Numbers.GetNumberOfUploads();
  }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  FieldColoring Coloring = FieldColoring::NONE;
  Dependencies Source; // of Made
  vtkSmartPointer<vtkDataArray> Made;
  VertexColors Numbers;
  BufferTexture Colors;
  vtkIdType NumberOfColorUploads = 0;
};
}

#endif

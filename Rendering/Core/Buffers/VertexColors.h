// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VertexColors
 * @brief   point scalars and their lookup table on the GPU
 *
 * VTK colours the coarse points and interpolates colours; over a refined surface scalars are
 * interpolated first and each refined point is coloured, as a mapper of the refined mesh would. The
 * coarse points themselves keep the colours that VTK gives them. Private to the modules.
 */
#ifndef VertexColors_h
#define VertexColors_h

#include "Buffers/BufferTexture.h"     // for members
#include "Buffers/ColorTable.h"        // for members
#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkType.h"                   // for VTK_VOID

class vtkAbstractArray;
class vtkDataArray;
class vtkScalarsToColors;

namespace relevo
{
/// How points between the coarse ones come to the colours of scalars.
enum ScalarKind
{
  BY_VTK,     // VTK's colours or texture coordinates are interpolated
  BY_VALUE,   // values are interpolated and looked up
  BY_TEXTURE, // values are interpolated, and give the place in VTK's texture of the table
  BY_NEAREST  // from the nearest corner
};

class RELEVORENDERINGCORE_EXPORT VertexColors
{
public:
  /**
   * Take point scalars that are mapped through a lookup table (not direct colours). `component` is
   * that of vtkMapper, -1 to leave the choice to the table. `byTexture` says that VTK colours by a
   * texture. For noDataMagnitude see NoDataTuples. `type` is what they are coefficients of, if they
   * are some. False when they do not fit on the GPU.
   */
  bool Upload(vtkOpenGLRenderWindow* window, vtkAbstractArray* scalars, vtkScalarsToColors* table,
    int component, bool byTexture, double noDataMagnitude, int type = VTK_VOID);

  ScalarKind GetKind() const { return this->Kind; }
  /// Whether some of the values stand for no data.
  bool HasNoData() const { return this->Kind != BY_VTK && !this->NoData.IsEmpty(); }
  /// The number that has been subtracted from all values.
  double GetBias() const { return this->Bias; }
  void Clear() { this->Kind = BY_VTK; }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Components first, first + 1, ...: a number, or a vector whose length counts.
  bool UploadValues(vtkOpenGLRenderWindow* window, vtkDataArray* scalars, int first, int count,
    bool isLength, double range[2]);
  bool UploadNoData(vtkOpenGLRenderWindow* window, vtkDataArray* scalars, double noDataMagnitude);
  void SetCoordinates(vtkScalarsToColors* table);

  BufferTexture Scalars;
  BufferTexture NoData;
  ColorTable Table;
  ScalarKind Kind = BY_VTK;
  int Texels = 0; // per point; 0 for a single number
  bool AreIntegers = false;
  double Bias = 0.0;
  float Coordinates[3] = { 0.0f, 0.0f, 0.0f }; // minimum, 1 / width, log
};
}

#endif

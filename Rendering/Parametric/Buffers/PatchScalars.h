// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatchScalars
 * @brief   what patches are coloured by, as coefficients of their control points, on the GPU
 *
 * Private to the module.
 */
#ifndef PatchScalars_h
#define PatchScalars_h

#include "Buffers/BufferTexture.h" // for members
#include "Buffers/VertexColors.h"  // for members

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkScalarsToColors;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class PatchScalars
{
public:
  /// How coefficients come to colours.
  enum Kinds
  {
    NONE,    // there are none
    TABLE,   // the number is looked up
    TEXTURE, // VTK's texture of the table has them
    COLORS   // they are colours
  };

  struct Source
  {
    vtkPolyData* Mesh;
    vtkDataArray* Scalars; // of points
    bool AreColors;
    vtkScalarsToColors* Table;
    int Component; // vtkMapper's, -1 to leave the choice to the table
    bool ByTexture;
    double NoDataMagnitude; // see NoDataTuples
  };

  /// Take the coefficients of scalars, if there are some. False when they do not fit on the GPU.
  bool Upload(vtkOpenGLRenderWindow* window, const Source& source);

  Kinds GetKind() const { return this->Kind; }
  /// What has been subtracted from numbers.
  double GetBias() const { return this->Numbers.GetBias(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool UploadColors(vtkOpenGLRenderWindow* window, vtkDataArray* nodes, int type);

  Kinds Kind = NONE;
  VertexColors Numbers;
  BufferTexture Colors;
};
}

#endif

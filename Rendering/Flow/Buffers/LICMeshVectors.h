// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICMeshVectors
 * @brief   the vectors of one mesh on the GPU, without no-data values
 *
 * Private to the module's own sources.
 */
#ifndef LICMeshVectors_h
#define LICMeshVectors_h

#include "Buffers/BufferTexture.h"
#include "Changes/Dependencies.h"
#include "Passes/LICArray.h"
#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>

class vtkActor;
class vtkLICSettings;
class vtkMatrix4x4;
class vtkOpenGLCellToVTKCellMap;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexBufferObjectGroup;
class vtkPolyData;
class vtkRenderer;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class LICMeshVectors
{
public:
  /// Use the array that find() returns, if the dependencies have changed.
  void Update(const Dependencies& dependencies, const std::function<LICArray()>& find,
    double noDataMagnitude);

  /// Return whether there are no vectors to draw.
  bool IsEmpty() const { return !this->Prepared; }
  /// Return whether the vectors on the GPU are of cells.
  bool AreOfCells() const { return !this->Cells.IsEmpty(); }
  bool HasPointNormals() const { return this->PointNormals; }

  /// Add the vectors of points to VTK's buffers, and normals of points for surfaces without
  /// normals.
  void CacheArrays(
    vtkOpenGLVertexBufferObjectGroup* buffers, vtkPolyData* input, vtkRenderer* renderer);
  /// Upload the vectors of cells, if they have changed. If they do not fit, return false; there are
  /// no vectors then.
  bool UploadCells(vtkOpenGLRenderWindow* window, vtkOpenGLCellToVTKCellMap* cells);

  /// The view for which vectors are drawn.
  struct View
  {
    vtkRenderer* Renderer;
    vtkActor* Actor;
    vtkMatrix4x4* FromShifted; // for positions in VTK's buffers; nullptr without a shift
    vtkLICSettings* Settings;
    double Longest; // of all vectors of the image
  };
  void SetUniforms(vtkShaderProgram* program, const View& view);
  void Deactivate() { this->Cells.Deactivate(); }

  vtkTypeInt64 GetMemorySize(vtkOpenGLVertexBufferObjectGroup* buffers) const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void SetMatrices(vtkShaderProgram* program, const View& view);

  Dependencies PreparedDependencies;
  bool ArePreparedOfCells = false;
  vtkSmartPointer<vtkFloatArray> Prepared; // nullptr for no vectors
  double Unit = 1.0; // of the vectors on the GPU, whose length is then about 1
  bool PointNormals = false;
  BufferTexture Cells; // vectors of VTK's primitives; empty for vectors of points
  Dependencies CellDependencies;
};
}

#endif

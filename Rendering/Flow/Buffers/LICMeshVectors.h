// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICMeshVectors
 * @brief   the vectors of one mesh on the GPU, without what is no-data
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
  /// Take the array that find() returns, if the dependencies are others.
  void Update(const Dependencies& dependencies, const std::function<LICArray()>& find,
    double noDataMagnitude);

  /// Whether there is something to draw.
  bool IsEmpty() const { return !this->Prepared; }
  /// Whether the vectors on the GPU are of cells.
  bool AreOfCells() const { return !this->Cells.IsEmpty(); }
  bool HasPointNormals() const { return this->PointNormals; }

  /// Give VTK's buffers the vectors of points, and normals of points for surfaces without their
  /// own.
  void CacheArrays(
    vtkOpenGLVertexBufferObjectGroup* buffers, vtkPolyData* input, vtkRenderer* renderer);
  /// Upload the vectors of cells, if they have changed; false, and there are none, if they do not
  /// fit.
  bool UploadCells(vtkOpenGLRenderWindow* window, vtkOpenGLCellToVTKCellMap* cells);

  /// The view that vectors are drawn in.
  struct View
  {
    vtkRenderer* Renderer;
    vtkActor* Actor;
    vtkMatrix4x4* FromShifted; // of positions in VTK's buffers; nullptr where they are not shifted
    vtkLICSettings* Settings;
    double Longest; // of all vectors of the picture
  };
  void SetUniforms(vtkShaderProgram* program, const View& view);
  void Deactivate() { this->Cells.Deactivate(); }

  vtkTypeInt64 GetMemorySize(vtkOpenGLVertexBufferObjectGroup* buffers) const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void SetMatrices(vtkShaderProgram* program, const View& view);

  Dependencies PreparedDependencies;
  bool ArePreparedOfCells = false;
  vtkSmartPointer<vtkFloatArray> Prepared; // nullptr for none
  double Unit = 1.0;                       // of the vectors on the GPU, which then are about 1 long
  bool PointNormals = false;
  BufferTexture Cells; // vectors of VTK's primitives; empty for vectors of points
  Dependencies CellDependencies;
};
}

#endif

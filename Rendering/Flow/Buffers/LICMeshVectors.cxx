// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/LICMeshVectors.h"

#include "OpenGL/RelevoOpenGL.h"
#include "OpenGL/ShaderUniforms.h"
#include "View/WorldView.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLICSettings.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <vector>

namespace relevo
{
void LICMeshVectors::Update(
  const Dependencies& dependencies, const std::function<LICArray()>& find, double noDataMagnitude)
{
  if (!this->PreparedDependencies.Update(dependencies))
  {
    return; // built for another actor
  }
  const LICArray vectors = find();
  this->ArePreparedOfCells = vectors.IsOfCells;
  const double longest = vectors.FindLongest(noDataMagnitude);
  // With a power of two, the shaders' values are bit-identical for all vectors of the image.
  this->Unit = longest > 0.0 ? std::exp2(std::ceil(std::log2(longest))) : 1.0;
  this->Prepared = vectors.Array ? vectors.Prepare(noDataMagnitude, this->Unit) : nullptr;
}

void LICMeshVectors::CacheArrays(
  vtkOpenGLVertexBufferObjectGroup* buffers, vtkPolyData* input, vtkRenderer* renderer)
{
  buffers->CacheDataArray("relevoLICVector",
    this->ArePreparedOfCells ? nullptr : this->Prepared.Get(), renderer, VTK_FLOAT);
  // Linear surfaces have no normals, and VTK's normals depend on lights.
  vtkDataArray* normals = this->Prepared ? input->GetPointData()->GetNormals() : nullptr;
  this->PointNormals = normals && normals->GetNumberOfComponents() == 3 &&
    normals->GetNumberOfTuples() == input->GetNumberOfPoints();
  buffers->CacheDataArray(
    "relevoLICPointNormal", this->PointNormals ? normals : nullptr, renderer, VTK_FLOAT);
}

bool LICMeshVectors::UploadCells(vtkOpenGLRenderWindow* window, vtkOpenGLCellToVTKCellMap* cells)
{
  if (!this->CellDependencies.Update(this->PreparedDependencies))
  {
    return true;
  }
  this->Cells.ReleaseGraphicsResources(window);
  if (!this->Prepared || !this->ArePreparedOfCells)
  {
    return true;
  }
  std::vector<float> values(4 * cells->GetSize());
  for (size_t i = 0; i < cells->GetSize(); ++i)
  {
    this->Prepared->GetTypedTuple(cells->GetValue(i), &values[4 * i]);
  }
  const bool fits = this->Cells.Upload(window, values, 4);
  if (!fits)
  {
    this->Prepared = nullptr;
  }
  return fits;
}

void LICMeshVectors::SetMatrices(vtkShaderProgram* program, const View& view)
{
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> modelView;
  vtkMatrix4x4::Multiply4x4(
    camera->GetModelViewTransformMatrix(), view.Actor->GetMatrix(), modelView);
  double inverse[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      inverse[i][j] = modelView->GetElement(i, j);
    }
  }
  vtkMath::Invert3x3(inverse, inverse);
  dmat3 normals;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      normals[i][j] = inverse[i][j]; // GLM stores matrices by columns, so this transposes
    }
  }
  SetMatrix(program, "relevoLICDirections", dmat3(MakeMatrix(modelView)));
  SetMatrix(program, "relevoLICNormals", normals);
  SetMatrix(program, "relevoLICProjection",
    MakeMatrix(camera->GetProjectionTransformMatrix(view.Renderer->GetTiledAspectRatio(), -1, 1)));
  if (view.FromShifted)
  {
    vtkMatrix4x4::Multiply4x4(modelView, view.FromShifted, modelView);
  }
  SetMatrix(program, "relevoLICFromVertex", MakeMatrix(modelView));
}

void LICMeshVectors::SetUniforms(vtkShaderProgram* program, const View& view)
{
  this->SetMatrices(program, view);
  program->SetUniformf(
    "relevoLICScale", static_cast<float>(view.Longest > 0.0 ? this->Unit / view.Longest : 1.0));
  program->SetUniformf(
    "relevoLICThreshold", static_cast<float>(view.Settings->GetMaskThreshold() / this->Unit));
  program->SetUniformi("relevoLICMaskOnSurface", view.Settings->GetMaskOnSurface());
  int viewport[4];
  vtkOpenGLRenderWindow::SafeDownCast(view.Renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float size[2] = { static_cast<float>(viewport[2]), static_cast<float>(viewport[3]) };
  program->SetUniform2f("relevoLICSize", size);
  this->Cells.Activate(program, "relevoLICCells");
}

vtkTypeInt64 LICMeshVectors::GetMemorySize(vtkOpenGLVertexBufferObjectGroup* buffers) const
{
  vtkTypeInt64 size = this->Cells.GetMemorySize();
  for (const char* name : { "relevoLICVector", "relevoLICPointNormal" })
  {
    if (vtkOpenGLVertexBufferObject* buffer = buffers->GetVBO(name))
    {
      size += static_cast<vtkTypeInt64>(buffer->GetNumberOfTuples()) * buffer->GetStride();
    }
  }
  return size;
}

void LICMeshVectors::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Cells.ReleaseGraphicsResources(window);
  this->CellDependencies.Clear();
}
}

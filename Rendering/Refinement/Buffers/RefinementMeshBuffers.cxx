// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/RefinementMeshBuffers.h"

#include "Mesh/RefinementMesh.h"
#include "Shaders/RefinementShader.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkRefinementSurface.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace relevo
{
namespace
{
// The layout of a point's texels: normal and u; frame of u, frame of v; direction; values.
struct PointLayout
{
  PointLayout(const RefinementMesh& mesh, int shaderValues)
    : Direction(mesh.Frames.empty() ? 1 : 3)
    , Values(this->Direction + (mesh.Directions.empty() ? 0 : 1))
    , Stride(this->Values + (shaderValues > 0 ? 1 : 0))
  {
  }
  int Direction;
  int Values;
  int Stride;
};

void SetSurfaceUniforms(vtkShaderProgram* program, vtkRefinementSurface* surface)
{
  for (const vtkRefinementSurface::Uniform& uniform : surface->GetUniforms())
  {
    const char* name = uniform.Name.c_str();
    const float* values = uniform.Values.data();
    if (!program->IsUniformUsed(name))
    {
      continue;
    }
    switch (uniform.Values.size())
    {
      case 1:
        program->SetUniformf(name, values[0]);
        break;
      case 2:
        program->SetUniform2f(name, values);
        break;
      case 3:
        program->SetUniform3f(name, values);
        break;
      default:
        program->SetUniform4f(name, values);
    }
  }
}
}

RefinementMeshBuffers::RefinementMeshBuffers() = default;
RefinementMeshBuffers::~RefinementMeshBuffers() = default;

bool RefinementMeshBuffers::UploadMesh(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
  vtkRefinementSurface* surface, vtkOpenGLVertexBufferObject* positions)
{
  this->ReleaseFaces(window);
  std::fill_n(this->PositionShift, 3, 0.0);
  std::fill_n(this->PositionScale, 3, 1.0);
  if (positions->GetCoordShiftAndScaleEnabled())
  {
    std::copy_n(positions->GetShift().begin(), 3, this->PositionShift);
    std::copy_n(positions->GetScale().begin(), 3, this->PositionScale);
  }
  const bool uploaded = this->Points.Alias(window, positions) &&
    this->UploadPointData(window, mesh, surface) && this->UploadVectors(window, mesh, surface) &&
    this->UploadSeams(window, mesh) && this->UploadTables(window, mesh);
  this->Error = uploaded ? "" : BufferTexture::GetTooLarge();
  return uploaded;
}

bool RefinementMeshBuffers::UploadSeams(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh)
{
  if (mesh.Seams.empty())
  {
    this->Seams.ReleaseGraphicsResources(window);
    return true;
  }
  return this->Seams.Upload(window, mesh.Seams, 1);
}

// Transform a coordinate from the mesh's points to VTK's vertices.
float RefinementMeshBuffers::GetVertexCoordinate(
  const RefinementMesh& mesh, float x, size_t axis) const
{
  return static_cast<float>(
    (x + (mesh.Origin[axis] - this->PositionShift[axis])) * this->PositionScale[axis]);
}

bool RefinementMeshBuffers::UploadTables(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh)
{
  if (mesh.TableEntries.empty())
  {
    for (BufferTexture* buffer : { &this->TableEntries, &this->TableRecords, &this->TablePoints })
    {
      buffer->ReleaseGraphicsResources(window);
    }
    return true;
  }
  std::vector<int> entries = mesh.TableEntries;
  for (size_t f = 0; f < entries.size(); ++f)
  {
    entries[f] = entries[f] << 3 | mesh.Faces[f].Order;
  }
  std::vector<float> points = mesh.Tables.Points;
  for (size_t i = 0; i < points.size(); ++i)
  {
    const size_t axis = i % 4;
    points[i] = axis < 3 ? this->GetVertexCoordinate(mesh, points[i], axis) : points[i];
  }
  return this->TableEntries.Upload(window, entries, 1) &&
    this->TableRecords.Upload(window, mesh.Tables.Records, 4) &&
    this->TablePoints.Upload(window, points, 4);
}

std::array<BufferTexture*, 7> RefinementMeshBuffers::GetBuffers()
{
  return { &this->Points, &this->PointData, &this->Vectors, &this->Seams, &this->TableEntries,
    &this->TableRecords, &this->TablePoints };
}

bool RefinementMeshBuffers::UseFaces(int representation)
{
  const auto faces = this->FacesOfRepresentations.find(representation);
  this->Faces = faces == this->FacesOfRepresentations.end() ? nullptr : &faces->second;
  return this->Faces != nullptr;
}

bool RefinementMeshBuffers::UploadFaces(vtkOpenGLRenderWindow* window, const RefinementMesh& mesh,
  const std::vector<int>& primitives, int representation)
{
  std::vector<int> faces(4 * mesh.Faces.size());
  for (size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    std::copy_n(mesh.Faces[f].Corners, 3, &faces[4 * f]);
    faces[4 * f + 3] = primitives[f] << 3 | mesh.Faces[f].HiddenEdges;
  }
  this->Faces = &this->FacesOfRepresentations[representation];
  const bool uploaded = this->Faces->Upload(window, faces, 4);
  this->Error = uploaded ? "" : BufferTexture::GetTooLarge();
  return uploaded;
}

void RefinementMeshBuffers::ReleaseFaces(vtkWindow* window)
{
  for (auto& faces : this->FacesOfRepresentations)
  {
    faces.second.ReleaseGraphicsResources(window);
  }
  this->FacesOfRepresentations.clear();
  this->Faces = nullptr;
}

bool RefinementMeshBuffers::UploadPointData(
  vtkOpenGLRenderWindow* window, const RefinementMesh& mesh, vtkRefinementSurface* surface)
{
  this->ShaderValues = surface && !mesh.Values.empty() ? surface->GetNumberOfShaderValues() : 0;
  if (mesh.Normals.empty() && this->ShaderValues == 0)
  {
    this->PointData.ReleaseGraphicsResources(window);
    return true;
  }
  const PointLayout layout(mesh, this->ShaderValues);
  const size_t stride = 4 * static_cast<size_t>(layout.Stride);
  const size_t numberOfPoints = mesh.Points.size() / 3;
  std::vector<float> data(stride * numberOfPoints, 0.0f);
  for (size_t i = 0; i < numberOfPoints; ++i)
  {
    float* point = &data[stride * i];
    if (!mesh.Normals.empty())
    {
      std::copy_n(&mesh.Normals[3 * i], 3, point);
    }
    if (!mesh.Frames.empty())
    {
      std::copy_n(&mesh.Frames[8 * i], 4, point + 4);
      std::copy_n(&mesh.Frames[8 * i + 4], 3, point + 8);
      if (!mesh.TextureCoordinates.empty())
      {
        point[3] = mesh.TextureCoordinates[2 * i];
        point[11] = mesh.TextureCoordinates[2 * i + 1];
      }
    }
    if (!mesh.Directions.empty())
    {
      std::copy_n(&mesh.Directions[3 * i], 3, point + 4 * layout.Direction);
    }
    if (this->ShaderValues > 0)
    {
      std::copy_n(
        mesh.GetValues(static_cast<int>(i)), this->ShaderValues, point + 4 * layout.Values);
    }
  }
  return this->PointData.Upload(window, data, 4);
}

bool RefinementMeshBuffers::UploadVectors(
  vtkOpenGLRenderWindow* window, const RefinementMesh& mesh, vtkRefinementSurface* surface)
{
  if (mesh.Vectors.empty())
  {
    this->Vectors.ReleaseGraphicsResources(window);
    return true;
  }
  // Positions are transformed to VTK's vertices; normals do not change.
  std::vector<float> vectors = mesh.Vectors;
  const int perEdge = mesh.VectorsPerEdge;
  std::vector<bool> isPosition(static_cast<size_t>(mesh.VectorsPerFace));
  for (int k = 0; k < mesh.VectorsPerFace; ++k)
  {
    isPosition[static_cast<size_t>(k)] = k < 3 * perEdge
      ? k % perEdge < surface->GetNumberOfEdgePositions()
      : k - 3 * perEdge < surface->GetNumberOfFacePositions();
  }
  for (size_t v = 0; v < vectors.size() / 3; ++v)
  {
    for (size_t c = 0; isPosition[v % isPosition.size()] && c < 3; ++c)
    {
      vectors[3 * v + c] = this->GetVertexCoordinate(mesh, vectors[3 * v + c], c);
    }
  }
  return this->Vectors.Upload(window, vectors, 3);
}

bool RefinementMeshBuffers::AliasAttributes(vtkOpenGLRenderWindow* window,
  vtkOpenGLVertexBufferObjectGroup* vbos, const std::vector<std::string>& attributes)
{
  for (const std::string& name : attributes)
  {
    vtkOpenGLVertexBufferObject* vbo = vbos->GetVBO(name.c_str());
    if (!vbo)
    {
      continue;
    }
    std::unique_ptr<BufferTexture>& buffer = this->Attributes[name];
    if (!buffer)
    {
      buffer.reset(new BufferTexture);
    }
    if (!buffer->Alias(window, vbo))
    {
      this->Error = BufferTexture::GetTooLarge();
      return false;
    }
  }
  return true;
}

void RefinementMeshBuffers::FillOptions(
  const RefinementMesh& mesh, RefinementShaderOptions& options) const
{
  options.VectorsPerEdge = mesh.VectorsPerEdge;
  options.VectorsPerFace = mesh.VectorsPerFace;
  const PointLayout layout(mesh, this->ShaderValues);
  options.PointStride = layout.Stride;
  options.PointDirection = layout.Direction;
  options.PointValues = layout.Values;
  options.HasNormals = !mesh.Normals.empty();
  options.HasDirections = !mesh.Directions.empty();
  options.HasSeams = !mesh.Seams.empty();
}

void RefinementMeshBuffers::Activate(vtkShaderProgram* program)
{
  if (this->Faces)
  {
    this->Faces->Activate(program, "relevoFaces");
  }
  this->Points.Activate(program, "relevoPoints");
  this->PointData.Activate(program, "relevoPointData");
  this->Vectors.Activate(program, "relevoVectors");
  this->Seams.Activate(program, "relevoSeams");
  this->TableEntries.Activate(program, "relevoTableEntries");
  this->TableRecords.Activate(program, "relevoTableRecords");
  this->TablePoints.Activate(program, "relevoTablePoints");
  for (auto& attribute : this->Attributes)
  {
    attribute.second->Activate(program, GetAttributeSampler(attribute.first));
  }
}

void RefinementMeshBuffers::Deactivate()
{
  if (this->Faces)
  {
    this->Faces->Deactivate();
  }
  for (BufferTexture* buffer : this->GetBuffers())
  {
    buffer->Deactivate();
  }
  for (auto& attribute : this->Attributes)
  {
    attribute.second->Deactivate();
  }
}

void RefinementMeshBuffers::SetUniforms(
  vtkShaderProgram* program, vtkAdaptiveRefinement* recipe) const
{
  if (program->IsUniformUsed("relevoUnitNormals"))
  {
    program->SetUniformi("relevoUnitNormals", recipe->GetMaximumLevel() > 0 ? 1 : 0);
  }
  if (vtkDisplacement* displacement = recipe->GetDisplacement())
  {
    auto setFloat = [program](const char* name, double value)
    {
      if (program->IsUniformUsed(name))
      {
        program->SetUniformf(name, static_cast<float>(value));
      }
    };
    setFloat("relevoDisplacementScale", displacement->GetScale());
    setFloat("relevoDisplacementOffset", displacement->GetOffset());
    if (program->IsUniformUsed("relevoDisplacementDirection"))
    {
      program->SetUniform3f("relevoDisplacementDirection", displacement->GetDirection());
    }
  }
  if (program->IsUniformUsed("relevoPositionScale"))
  {
    program->SetUniform3f("relevoPositionScale", this->PositionScale);
  }
  if (program->IsUniformUsed("relevoPositionShift"))
  {
    program->SetUniform3f("relevoPositionShift", this->PositionShift);
  }
  if (vtkRefinementSurface* surface = recipe->GetSurface())
  {
    SetSurfaceUniforms(program, surface);
  }
}

vtkTypeInt64 RefinementMeshBuffers::GetMemorySize() const
{
  vtkTypeInt64 size = 0;
  for (const auto& faces : this->FacesOfRepresentations)
  {
    size += faces.second.GetMemorySize();
  }
  for (const BufferTexture* buffer : const_cast<RefinementMeshBuffers*>(this)->GetBuffers())
  {
    size += buffer->GetMemorySize();
  }
  return size;
}

void RefinementMeshBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ReleaseFaces(window);
  for (BufferTexture* buffer : this->GetBuffers())
  {
    buffer->ReleaseGraphicsResources(window);
  }
  for (auto& attribute : this->Attributes)
  {
    attribute.second->ReleaseGraphicsResources(window);
  }
  this->Attributes.clear();
}
}

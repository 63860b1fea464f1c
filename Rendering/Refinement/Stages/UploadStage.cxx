// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/UploadStage.h"

#include "Checks/ShouldReport.h"
#include "Mesh/RefinementMesh.h"
#include "Shaders/RefinementShaderOptions.h"
#include "Stages/MethodStage.h"
#include "State/ViewSelection.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDataArray.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"

namespace relevo
{
namespace
{
// The time of VTK's upload is not included: with several actors it changes although the positions
// do not.
Dependencies GetUploadDependencies(
  vtkMTimeType meshTime, vtkMTimeType buildTime, vtkOpenGLVertexBufferObject* positions)
{
  Dependencies dependencies = Dependencies::On(meshTime, buildTime);
  dependencies.AddObject(positions, static_cast<vtkMTimeType>(positions->GetHandle()));
  if (positions->GetCoordShiftAndScaleEnabled())
  {
    for (int i = 0; i < 3; ++i)
    {
      dependencies.Add(positions->GetShift()[i]);
      dependencies.Add(positions->GetScale()[i]);
    }
  }
  return dependencies;
}

std::string DescribeUndrawable(const std::string& error)
{
  return "Cannot draw the input: " + error + ".";
}
}

bool UploadStage::NeedsMesh(
  vtkMTimeType meshTime, vtkMTimeType buildTime, vtkOpenGLVertexBufferObject* positions) const
{
  // With a shift and scale by the camera, VTK moves the positions in its buffer.
  const bool moved = this->Valid && positions &&
    this->UploadDependencies != GetUploadDependencies(meshTime, buildTime, positions);
  return moved || this->UploadTime < meshTime;
}

StageResult UploadStage::UploadMesh(const MeshInput& input)
{
  this->UploadTime.Modified();
  if (!input.Mesh || input.Mesh->Faces.empty() || !input.Positions)
  {
    this->Valid = false;
    return {};
  }
  const Dependencies dependencies =
    GetUploadDependencies(input.MeshTime, input.BuildTime, input.Positions);
  const vtkIdType uploads = this->GetNumberOfScalarUploads();
  const bool hasOtherMesh = !this->Valid || dependencies != this->UploadDependencies;
  if (hasOtherMesh)
  {
    this->UploadDependencies = dependencies;
    this->ColorDependencies.Clear();
    this->Valid = this->UploadPoints(input);
  }
  if (this->ColorDependencies.Update(Dependencies::On(input.ColorTime)))
  {
    this->UploadColors(input);
  }
  if (hasOtherMesh || this->GetNumberOfScalarUploads() != uploads)
  {
    ++this->NumberOfBuilds;
  }
  this->Valid = this->Valid && this->UploadFaces(input);
  StageResult result;
  result.IsValid = this->Valid;
  if (ShouldReport(this->MeshError, this->Valid ? "" : this->Buffers.GetError()))
  {
    result.Errors.push_back(DescribeUndrawable(this->MeshError));
  }
  return result;
}

bool UploadStage::UploadPoints(const MeshInput& input)
{
  return this->Buffers.UploadMesh(
    input.Window, *input.Mesh, input.Recipe->GetSurface(), input.Positions);
}

// The values are uploaded again only if they have changed.
void UploadStage::UploadColors(const MeshInput& input)
{
  this->Colors.Clear();
  this->Field.Clear();
  const double noData = input.Recipe->GetNoDataMagnitude();
  vtkAbstractArray* scalars = input.Scalars ? input.Scalars : input.CellScalars;
  if (scalars &&
    !this->Field.Upload(input.Window, input.Recipe->GetSurface(), input.Input,
      { vtkDataArray::SafeDownCast(scalars), input.AreColors, input.Table, input.Component,
        input.Scalars && input.ByTexture, noData },
      !input.Scalars))
  {
    this->Field.Clear(); // the scalars are interpolated, or those of cells
  }
  if (input.Scalars && !input.AreColors &&
    !this->Colors.Upload(
      input.Window, input.Scalars, input.Table, input.Component, input.ByTexture, noData))
  {
    this->Colors.Clear(); // VTK's colours of the coarse points are used
  }
}

vtkIdType UploadStage::GetNumberOfScalarUploads() const
{
  return this->Colors.GetNumberOfUploads() + this->Field.GetNumberOfUploads();
}

bool UploadStage::UploadFaces(const MeshInput& input)
{
  if (this->Buffers.UseFaces(input.Representation))
  {
    return true;
  }
  // VTK's primitive ids of cells: indices of its cell textures and selections.
  std::vector<int> primitiveOfCell(static_cast<size_t>(input.NumberOfCells), 0);
  for (size_t i = input.CellMap->GetSize(); i-- > 0;)
  {
    primitiveOfCell[input.CellMap->GetValue(i)] = static_cast<int>(i);
  }
  std::vector<int> primitives(input.Mesh->Faces.size());
  for (size_t f = 0; f < primitives.size(); ++f)
  {
    primitives[f] = primitiveOfCell[input.Mesh->Faces[f].Cell];
  }
  return this->Buffers.UploadFaces(input.Window, *input.Mesh, primitives, input.Representation);
}

StageResult UploadStage::UploadHeights(vtkOpenGLRenderWindow* window, vtkDisplacement* displacement)
{
  StageResult result;
  result.IsValid = this->Heights.Upload(window, displacement);
  if (ShouldReport(this->HeightError, result.IsValid ? "" : this->Heights.GetError()))
  {
    result.Errors.push_back(DescribeUndrawable(this->HeightError));
  }
  return result;
}

StageResult UploadStage::UploadSelection(MethodStage& methods, const RefinementDrawing& drawing)
{
  const Dependencies sources =
    Dependencies::On(drawing.Selection->GetGroupsTime(), drawing.ComputeView != nullptr);
  StageResult result;
  for (;;)
  {
    std::map<int, Dependencies>& failures = this->FailedUploads[methods.GetNumber()];
    const auto failure = failures.find(drawing.Slot);
    if (failure == failures.end() || failure->second != sources)
    {
      if (methods.Get().Upload(drawing))
      {
        failures.erase(drawing.Slot);
        return result;
      }
      if (failures.empty())
      {
        const std::string& error = methods.Get().GetError();
        result.Errors.push_back(
          methods.IsDefault() ? DescribeUndrawable(error) : methods.DescribeUnavailable(error));
      }
      failures[drawing.Slot] = sources;
    }
    if (methods.IsDefault())
    {
      result.IsValid = false;
      return result;
    }
    methods.FallBackToDefaultMethod();
  }
}

void UploadStage::ForgetFailures(int method)
{
  this->FailedUploads.erase(method);
}

RefinementComputeState::Targets UploadStage::GetTargets() const
{
  return { this->Buffers.GetFaces(), this->Instances.GetInstances(),
    this->Instances.GetMorphTags() };
}

void UploadStage::FillOptions(const RefinementMesh& mesh, RefinementShaderOptions& options) const
{
  this->Buffers.FillOptions(mesh, options);
  options.HasHoles = this->Heights.HasValidity();
}

void UploadStage::Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program,
  vtkOpenGLVertexBufferObjectGroup* vbos, const std::vector<std::string>& attributes,
  vtkAdaptiveRefinement* recipe)
{
  // VTK may have removed and restored buffers for another actor.
  this->Buffers.AliasAttributes(window, vbos, attributes);
  this->Buffers.Activate(program);
  this->Heights.Activate(program);
  if (this->Field.IsUsed(program))
  {
    this->Field.Activate(program);
  }
  else
  {
    this->Colors.Activate(program);
  }
  this->Buffers.SetUniforms(program, recipe);
}

void UploadStage::Deactivate()
{
  this->Buffers.Deactivate();
  this->Heights.Deactivate();
  this->Colors.Deactivate();
  this->Field.Deactivate();
}

vtkTypeInt64 UploadStage::GetMemorySize() const
{
  return this->Buffers.GetMemorySize() + this->Heights.GetMemorySize() +
    this->Colors.GetMemorySize() + this->Field.GetMemorySize() + this->Patterns.GetMemorySize() +
    this->Instances.GetMemorySize();
}

void UploadStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffers.ReleaseGraphicsResources(window);
  this->Heights.ReleaseGraphicsResources(window);
  this->Colors.ReleaseGraphicsResources(window);
  this->Field.ReleaseGraphicsResources(window);
  this->Patterns.ReleaseGraphicsResources();
  this->Instances.ReleaseGraphicsResources(window);
  this->HeightError.clear();
  this->FailedUploads.clear();
  this->Valid = false;
}
}

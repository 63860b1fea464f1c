// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapperInternals.h"

#include "Cells/MeshScalars.h"
#include "Cells/ScalarChoice.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/ShouldReport.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <vector>

namespace
{
// Whether gradients at points may be needed.
bool IsShaded(vtkVolumeProperty* property)
{
  bool isShaded = false;
  for (int i = 0; i < relevo::MostComponents; ++i)
  {
    isShaded = isShaded || property->GetShade(i) != 0;
  }
  return isShaded;
}

std::string AdviseScalarMode(int association)
{
  return association == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? "Use SetScalarModeToUseCellFieldData()"
    : "Use SetScalarModeToUsePointFieldData()";
}
}

// What was tried and failed is tried anew, and complained about, when something has changed.
bool vtkGPUUnstructuredGridVolumeMapper::UpdateMesh(vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  vtkDataObject* input = this->GetDataObjectInput();
  const relevo::ScalarChoice choice =
    relevo::ChooseScalars(volume->GetProperty(), this->VectorMode, this->VectorComponent);
  const relevo::ArrayChoice array(
    this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName ? this->ArrayName : "");
  const vtkMTimeType time = relevo::GetMeshTime(input);
  const bool areIndependent = volume->GetProperty()->GetIndependentComponents() != 0;
  if (data.MeshInput != input || data.MeshTime != time || !(data.Choice == choice) ||
    data.Array != array || data.HasCorners != (this->Method == CELL_PROJECTION) ||
    (data.NumberOfComponents == relevo::MostComponents && data.AreIndependent != areIndependent))
  {
    data.HasCorners = this->Method == CELL_PROJECTION;
    data.AreIndependent = areIndependent;
    data.MeshInput = input;
    data.MeshTime = time;
    data.Choice = choice;
    data.Array = array;
    data.AreFunctionsTried = false;
    data.HasGradients = IsShaded(volume->GetProperty());
    data.HasMesh = this->BuildMesh(volume, input);
  }
  else if (data.HasMesh && !data.HasCellScalars && !data.HasGradients &&
    IsShaded(volume->GetProperty()))
  {
    data.HasGradients = true;
    data.HasMesh = this->BuildMesh(volume, input);
  }
  return data.HasMesh && data.NumberOfDrawnCells > 0;
}

bool vtkGPUUnstructuredGridVolumeMapper::BuildMesh(vtkVolume* volume, vtkDataObject* input)
{
  this->Internals->NumberOfDrawnCells = 0;
  return relevo::RunWithinMemory(this, "the mesh",
    [&]
    {
      relevo::VolumeCells cells;
      return this->ReadCells(volume, input, cells) && this->UploadMesh(cells);
    });
}

bool vtkGPUUnstructuredGridVolumeMapper::CheckType(vtkDataObject* input)
{
  vtkInternals& data = *this->Internals;
  vtkInformation* port = this->GetInputPortInformation(0);
  if (data.CheckedInput != input)
  {
    data.CheckedInput = input;
    data.TypeProblem.clear();
  }
  if (relevo::ShouldReport(data.TypeProblem, relevo::FindTypeProblem(input, port)))
  {
    vtkErrorMacro(<< data.TypeProblem);
  }
  return relevo::IsOfRequiredType(input, port);
}

bool vtkGPUUnstructuredGridVolumeMapper::ReadCells(
  vtkVolume* volume, vtkDataObject* input, relevo::VolumeCells& cells)
{
  vtkInternals& data = *this->Internals;
  const bool takesAll = data.Choice.Component == relevo::ScalarChoice::All;
  std::vector<relevo::MeshScalars> meshes;
  std::string error;
  std::string leftOut;
  const auto find = [this](vtkDataSet* mesh, int& association)
  {
    int kind = 0;
    vtkDataArray* array = vtkAbstractMapper::GetScalars(
      mesh, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, kind);
    association =
      kind == 1 ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS;
    return kind == 2 ? nullptr : array;
  };
  const bool isByName = this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME && this->ArrayName &&
    this->ScalarMode >= VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  const int association = this->ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
    ? vtkDataObject::FIELD_ASSOCIATION_CELLS
    : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const relevo::ArrayRequest wish = { find, isByName ? this->ArrayName : "", association,
    AdviseScalarMode, takesAll ? relevo::MostComponents : VTK_INT_MAX, "SelectScalarArray()" };
  if (!this->CheckType(input))
  {
    return false;
  }
  if (!relevo::FindMeshScalars(input, wish, meshes, error, leftOut))
  {
    vtkErrorMacro("The input " << error << ".");
    return false;
  }
  const int components = meshes.empty() ? 1 : meshes.front().Array->GetNumberOfComponents();
  if (!meshes.empty() && data.Choice.Component >= components)
  {
    vtkErrorMacro("VectorComponent is " << data.Choice.Component << ", but the array has "
                                        << components << " components.");
    return false;
  }
  data.NumberOfComponents = takesAll ? components : 1;
  const bool areColors =
    takesAll && components == 4 && !volume->GetProperty()->GetIndependentComponents();
  if (data.HasCorners)
  {
    cells.SplitAll();
  }
  bool hasFaults = false;
  for (const relevo::MeshScalars& mesh : meshes)
  {
    relevo::ScalarChoice choice = data.Choice;
    const bool areBytes = areColors && vtkUnsignedCharArray::SafeDownCast(mesh.Array);
    choice.Scale = areBytes ? 1.0 / 255.0 : 1.0;
    for (const std::string& fault : cells.Add(mesh.Mesh, mesh.Array, mesh.AreOfCells, choice))
    {
      hasFaults = true;
      if (!data.IsWarned())
      {
        vtkErrorMacro(<< mesh.Block << fault);
      }
    }
  }
  if (cells.GetNumberOfSolidCells() == 0)
  {
    if (!meshes.empty() && !hasFaults)
    {
      vtkErrorMacro("The input has cells, but none is 3D.");
    }
    return false;
  }
  if (relevo::ShouldReport(data.LeftOut, leftOut))
  {
    vtkWarningMacro(<< leftOut);
  }
  data.HasCellScalars = meshes.front().AreOfCells;
  return true;
}

bool vtkGPUUnstructuredGridVolumeMapper::UploadMesh(const relevo::VolumeCells& cells)
{
  vtkInternals& data = *this->Internals;
  const bool isKnown = data.IsWarned();
  data.WarnedOf = std::make_pair(data.MeshInput, data.MeshTime);
  if (cells.GetNumberOfBadCells() > 0 && !isKnown)
  {
    vtkWarningMacro(<< cells.GetNumberOfBadCells() << " of " << cells.GetNumberOfSolidCells()
                    << " cells have no volume, or points that are not finite; they are left out.");
  }
  relevo::RayCastMesh& mesh = data.Mesh;
  std::string error;
  if (!mesh.Build(cells, data.NumberOfComponents, error, data.HasCorners, data.HasGradients))
  {
    vtkErrorMacro("The input " << error << ".");
    return false;
  }
  if (mesh.NumberOfSharedFaces > 0 && !isKnown)
  {
    vtkWarningMacro(<< mesh.NumberOfSharedFaces
                    << " faces belong to three cells or more; rays may see one cell twice there.");
  }
  data.Projected.ReleaseGraphicsResources(data.GetWindow());
  if (!data.MeshBuffers.Upload(data.GetWindow(), mesh) ||
    (data.HasCorners && !data.Projected.Upload(data.GetWindow(), mesh)))
  {
    vtkErrorMacro("The mesh cannot be drawn: " << relevo::BufferTexture::GetTooLarge() << ".");
    return false;
  }
  data.HasTetrahedra = mesh.GetNumberOfTetrahedra() > 0;
  data.HasCurvedCells = mesh.GetNumberOfCurvedCells() > 0;
  mesh.Release();
  ++data.NumberOfBufferBuilds;
  data.NumberOfDrawnCells = cells.GetNumberOfDrawnCells();
  return true;
}

bool vtkGPUUnstructuredGridVolumeMapper::UpdateFunctions(vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  vtkVolumeProperty* property = volume->GetProperty();
  const vtkMTimeType time = property->GetMTime();
  if (data.FunctionsTime != time || !data.AreFunctionsTried)
  {
    data.FunctionsTime = time;
    data.AreFunctionsTried = true;
    std::string error;
    std::string warning;
    data.HasFunctions = data.Functions.Read(property, data.NumberOfComponents, error, warning);
    if (!data.HasFunctions)
    {
      vtkErrorMacro("The volume property " << error << ".");
      return false;
    }
    if (!warning.empty())
    {
      vtkWarningMacro("The volume property " << warning << ".");
    }
    const relevo::RayCastMesh& mesh = data.Mesh;
    data.HasFunctions = data.FunctionBuffers.Upload(data.GetWindow(), data.Functions,
                          mesh.ScalarLow, mesh.ScalarSize, mesh.Radius) &&
      data.Surfaces.Upload(
        data.GetWindow(), property, data.Functions, mesh.ScalarLow, mesh.ScalarSize);
    if (!data.HasFunctions)
    {
      vtkErrorMacro(
        "The functions of the volume property, with so many nodes or texels, do not fit "
        "into the buffer textures of this OpenGL.");
      return false;
    }
    data.Integrals.ReleaseGraphicsResources(data.GetWindow());
  }
  return data.HasFunctions;
}

// What tables cannot do is exact; it is said when settings have changed.
bool vtkGPUUnstructuredGridVolumeMapper::FindPreIntegrated()
{
  vtkInternals& data = *this->Internals;
  if (this->Integration == EXACT || this->BlendMode != COMPOSITE_BLEND)
  {
    return false;
  }
  if (data.Functions.DependOnOneScalar() && !data.Options.HasSurfaces &&
    data.Options.NumberOfMaterials == 0)
  {
    return true;
  }
  const vtkMTimeType time = std::max(data.FunctionsTime, this->GetMTime());
  if (data.WarningTime != time)
  {
    data.WarningTime = time;
    vtkWarningMacro(
      "Pre-integration takes one component, without gradients, shading and isosurfaces; "
      "integration is exact instead.");
  }
  return false;
}

bool vtkGPUUnstructuredGridVolumeMapper::UpdateTables()
{
  vtkInternals& data = *this->Internals;
  data.IsPreIntegrated = this->FindPreIntegrated();
  if (!data.IsPreIntegrated)
  {
    return true;
  }
  const int component = data.Functions.GetCurves().front().Component;
  relevo::IntegralTable::Settings settings;
  settings.Size = this->TableSize;
  settings.Is2D = this->Integration == PRE_INTEGRATED_2D;
  settings.Longest = data.Mesh.LongestEdge * data.View.GetLargestScale();
  settings.ScalarLow = data.Mesh.ScalarLow[component];
  settings.ScalarSize = data.Mesh.ScalarSize[component];
  if (data.Integrals.Has(settings))
  {
    return true;
  }
  ++data.NumberOfTableBuilds;
  if (!data.Integrals.Upload(data.GetWindow(), data.Functions, settings))
  {
    vtkErrorMacro("This OpenGL has no room for the table of pre-integration.");
    return false;
  }
  return true;
}

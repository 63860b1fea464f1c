// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/MeshLoader.h"

#include "Bezier/SplitCounts.h"
#include "Cells/CellReports.h"
#include "Cells/MeshScalars.h"
#include "Cells/PointAverages.h"
#include "Cells/SharedFaces.h"
#include "Cells/VolumeCells.h"
#include "Checks/InputType.h"
#include "Checks/ShouldReport.h"
#include "Mesh/MeshSignature.h"
#include "Mesh/TetrahedronCorners.h"
#include "Stages/MapperArray.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace relevo
{
namespace
{
Dependencies FindMesh(const MeshRequest& request)
{
  Dependencies mesh;
  mesh.AddObject(request.Input, GetMeshTime(request.Input));
  return mesh;
}

ArrayRequest FindArrayRequest(const MeshRequest& request)
{
  return MakeArrayRequest(
    { request.ScalarMode, request.ArrayAccessMode, request.ArrayId, request.ArrayName },
    request.Choice.Component == ScalarChoice::All);
}
}

MeshLoader::MeshLoader() = default;
MeshLoader::~MeshLoader() = default;

// Four components have different dependencies if they are colours.
Dependencies MeshLoader::FindDependencies(const MeshRequest& request) const
{
  Dependencies now = FindMesh(request);
  now.Add(request.Choice.Component);
  now.Add(request.Choice.Scale);
  now.Add(request.ScalarMode);
  now.Add(request.ArrayAccessMode);
  now.Add(request.ArrayId);
  now.Add(request.ArrayName);
  now.Add(request.HasCorners);
  now.Add(request.ShapeTolerance);
  now.Add(request.FieldTolerance);
  now.Add(request.HasSurfaces && this->AreOfCells);
  now.Add(request.LevelOfDetail);
  now.Add(this->Mesh.NumberOfComponents == MaximumComponents && request.AreIndependent);
  return now;
}

bool MeshLoader::Update(const MeshRequest& request, StageReport& report)
{
  Dependencies now = this->FindDependencies(request);
  const bool isPiece = request.Whole != nullptr;
  const bool isOtherPiece =
    isPiece != this->IsPiece || (isPiece && !(*request.Whole == this->Whole));
  this->IsPiece = isPiece;
  this->Whole = isPiece ? *request.Whole : MeshExtent();
  if (!request.KeepsHostData)
  {
    this->Values.Clear();
    this->Signature.clear();
  }
  const bool hasChanged = this->Known.Update(now) || isOtherPiece;
  const bool lacksGradients = this->HasMesh && !this->Mesh.HasCellScalars && !this->HasGradients;
  if (hasChanged && !isOtherPiece && this->ReplaceValues(request, report))
  {
    return true;
  }
  if (hasChanged || (lacksGradients && request.IsShaded))
  {
    this->HasGradients = request.IsShaded;
    this->HasMesh = false;
    this->NumberOfDrawnCells = 0;
    this->HasMesh = this->Load(request, report);
    this->Known = this->FindDependencies(request);
  }
  return this->IsReady();
}

bool MeshLoader::Load(const MeshRequest& request, StageReport& report)
{
  if (this->Measured == this->FindDependencies(request) && (this->Cells || this->Extent.IsEmpty()))
  {
    return this->LoadMeasured(request, report);
  }
  auto cells = std::make_unique<VolumeCells>();
  std::vector<MeshScalars> meshes;
  this->Signature.clear();
  this->Loaded.reset();
  if (!this->Read(request, *cells, meshes, report) || !this->Upload(request, *cells, report))
  {
    return false;
  }
  if (request.LevelOfDetail > 0.0 && this->Mesh.NumberOfComponents == 1)
  {
    this->Loaded = std::move(cells);
  }
  if (!this->Values.IsEmpty())
  {
    this->Signature = ComputeMeshSignature(meshes);
  }
  return true;
}

// Keep the mesh if only values have changed.
bool MeshLoader::ReplaceValues(const MeshRequest& request, StageReport& report)
{
  if (!this->HasMesh || this->Signature.empty() || this->IsPiece ||
    request.HasCorners != this->HasCorners || request.LevelOfDetail > 0.0 ||
    (request.IsShaded && !this->HasGradients && !this->Mesh.HasCellScalars) ||
    !this->CheckType(request, report))
  {
    return false;
  }
  const int components = this->Mesh.NumberOfComponents;
  StageReport ignored; // a load repeats the messages
  std::vector<MeshScalars> meshes;
  std::string leftOut;
  if (!this->FindScalars(request, ignored, meshes, leftOut) ||
    this->Mesh.NumberOfComponents != components || ComputeMeshSignature(meshes) != this->Signature)
  {
    return false;
  }
  std::vector<ScalarChoice> choices;
  for (const MeshScalars& mesh : meshes)
  {
    choices.push_back(this->FindChoice(request, mesh.Array));
  }
  RayCastMesh& layout = this->Mesh.Layout;
  const bool isReplaced = this->Values.Replace(meshes, choices, components, layout) &&
    this->Mesh.Buffers.UploadScalars(request.Window, layout);
  layout.Release();
  if (!isReplaced)
  {
    return false;
  }
  ++this->NumberOfBuilds;
  ++this->NumberOfValueUploads;
  this->MissingValues.clear();
  if (ShouldReport(this->LeftOut, leftOut))
  {
    report.Warnings.push_back(leftOut);
  }
  if (ShouldReport(this->ReportedAverages, this->Averaged))
  {
    report.Warnings.push_back(this->Averaged);
  }
  return true;
}

bool MeshLoader::LoadMeasured(const MeshRequest& request, StageReport& report)
{
  const std::unique_ptr<VolumeCells> cells = std::move(this->Cells);
  return cells && this->Upload(request, *cells, report);
}

MeshExtent MeshLoader::Measure(const MeshRequest& request, StageReport& report)
{
  if (this->Measured != this->FindDependencies(request))
  {
    this->Extent = MeshExtent();
    this->Cells = std::make_unique<VolumeCells>();
    std::vector<MeshScalars> meshes;
    if (this->Read(request, *this->Cells, meshes, report))
    {
      this->Extent = MeshExtent::Of(*this->Cells, this->Mesh.NumberOfComponents);
    }
    else
    {
      this->Cells.reset();
    }
    this->Measured = this->FindDependencies(request);
  }
  return this->Extent;
}

bool MeshLoader::CheckType(const MeshRequest& request, StageReport& report)
{
  if (this->CheckedInput != request.Input)
  {
    this->CheckedInput = request.Input;
    this->TypeError.clear();
  }
  if (ShouldReport(this->TypeError, FindTypeError(request.Input, request.Port)))
  {
    report.Errors.push_back(this->TypeError);
  }
  return IsOfRequiredType(request.Input, request.Port);
}

bool MeshLoader::FindScalars(const MeshRequest& request, StageReport& report,
  std::vector<MeshScalars>& meshes, std::string& leftOut)
{
  if (!this->CheckType(request, report))
  {
    return false;
  }
  std::string error;
  if (!FindMeshScalars(request.Input, FindArrayRequest(request), meshes, error, leftOut))
  {
    report.Errors.push_back("The input " + error + ".");
    return false;
  }
  const int components = meshes.empty() ? 1 : meshes.front().Array->GetNumberOfComponents();
  if (!meshes.empty() && request.Choice.Component >= components)
  {
    report.Errors.push_back("VectorComponent is " + std::to_string(request.Choice.Component) +
      ", but the array has " + std::to_string(components) + " components.");
    return false;
  }
  const bool takesAll = request.Choice.Component == ScalarChoice::All;
  this->Mesh.NumberOfComponents = takesAll ? components : 1;
  this->AreOfCells = !meshes.empty() && meshes.front().AreOfCells;
  this->Averaged = request.HasSurfaces ? AverageAtPoints(meshes) : "";
  return true;
}

ScalarChoice MeshLoader::FindChoice(const MeshRequest& request, vtkDataArray* array) const
{
  const bool areColors =
    this->Mesh.NumberOfComponents == MaximumComponents && !request.AreIndependent;
  ScalarChoice choice = request.Choice;
  choice.Scale = areColors && vtkUnsignedCharArray::SafeDownCast(array) ? 1.0 / 255.0 : 1.0;
  return choice;
}

bool MeshLoader::Read(const MeshRequest& request, VolumeCells& cells,
  std::vector<MeshScalars>& meshes, StageReport& report)
{
  std::string leftOut;
  if (!this->FindScalars(request, report, meshes, leftOut))
  {
    return false;
  }
  if (request.HasCorners)
  {
    cells.SplitAll();
  }
  // Cells that stay in memory must not depend on the input.
  if (request.LevelOfDetail == 0.0 && !(request.KeepsHostData && request.IsShaded))
  {
    cells.ReadInPlace();
  }
  bool hasErrors = false;
  for (const MeshScalars& mesh : meshes)
  {
    const ScalarChoice choice = this->FindChoice(request, mesh.Array);
    for (const std::string& error : cells.Add(mesh.Mesh, mesh.Array, mesh.AreOfCells, choice))
    {
      hasErrors = true;
      if (this->Reported != FindMesh(request))
      {
        report.Errors.push_back(mesh.GetPrefix() + error);
      }
    }
  }
  cells.ConvertCurved();
  if (cells.GetCounts().GetSum().Solid == 0)
  {
    if (!meshes.empty() && !hasErrors)
    {
      report.Errors.push_back("The input has no 3D cells.");
    }
    return false;
  }
  if (ShouldReport(this->LeftOut, leftOut))
  {
    report.Warnings.push_back(leftOut);
  }
  if (ShouldReport(this->ReportedAverages, this->Averaged))
  {
    report.Warnings.push_back(this->Averaged);
  }
  if (this->Reported != FindMesh(request))
  {
    for (const std::string& warning : DescribeBadCells(cells.GetCounts(), meshes))
    {
      report.Warnings.push_back(warning);
    }
  }
  if (ShouldReport(this->MissingValues, DescribeMissingValues(cells.GetCounts(), meshes)))
  {
    report.Warnings.push_back(this->MissingValues);
  }
  this->Mesh.HasCellScalars = meshes.front().AreOfCells;
  return true;
}

void MeshLoader::SplitCurved(
  const MeshRequest& request, bool isNew, VolumeCells& cells, StageReport& report) const
{
  const MeshExtent extent =
    request.Whole ? *request.Whole : MeshExtent::Of(cells, this->Mesh.NumberOfComponents);
  SplitTolerances tolerances;
  tolerances.Shape = 2.0 * request.ShapeTolerance * extent.GetRadius();
  for (size_t c = 0; c < tolerances.Values.size(); ++c)
  {
    const double range = extent.ScalarHigh[c] - extent.ScalarLow[c];
    tolerances.Values[c] =
      range > 0.0 ? request.FieldTolerance * range : std::numeric_limits<double>::max();
  }
  if (!cells.SplitCurved(tolerances) && isNew)
  {
    report.Warnings.push_back("Curved cells need more linear pieces than supported to meet "
                              "ShapeTolerance and FieldTolerance, so they are drawn coarser.");
  }
}

// Read the cells of the mesh on the graphics card. Return false if their neighbours depend on more
// than the ids of points.
bool MeshLoader::ReadCells(RayCastMesh& mesh)
{
  const RayCastMesh& layout = this->Mesh.Layout;
  if (!this->IsUploaded || layout.IsDiscontinuous || layout.HasHangingFaces ||
    layout.NumberOfSharedFaces > 0)
  {
    return false;
  }
  this->Mesh.Buffers.Download(mesh);
  return FindTetrahedronCorners(mesh);
}

bool MeshLoader::Upload(const MeshRequest& request, VolumeCells& cells, StageReport& report)
{
  const bool isNew = this->Reported.Update(FindMesh(request));
  const bool isCurved = cells.HasCurvedParts();
  const size_t numberOfSharedCurved = isCurved && isNew ? CountSharedFaces(cells) : 0;
  if (isCurved)
  {
    this->SplitCurved(request, isNew, cells, report);
  }
  RayCastMesh& layout = this->Mesh.Layout;
  RayCastMesh known;
  const bool isKnown = !request.Whole && this->ReadCells(known);
  this->IsUploaded = false;
  std::string error;
  if (!layout.Build(cells, this->Mesh.NumberOfComponents, error, request.HasCorners,
        this->HasGradients, request.Whole, isKnown ? &known : nullptr))
  {
    report.Errors.push_back("The input " + error + ".");
    return false;
  }
  const size_t numberOfShared = isCurved ? numberOfSharedCurved : layout.NumberOfSharedFaces;
  if (numberOfShared > 0 && isNew)
  {
    report.Warnings.push_back(DescribeSharedFaces(numberOfShared));
  }
  this->Mesh.Cells.ReleaseGraphicsResources(request.Window);
  if (!this->Mesh.Buffers.Upload(request.Window, layout) ||
    (request.HasCorners && !this->Mesh.Cells.Upload(request.Window, layout)))
  {
    report.Errors.push_back(
      std::string("The mesh cannot be drawn: ") + BufferTexture::GetTooLarge() + ".");
    return false;
  }
  this->Mesh.HasTetrahedra = layout.GetNumberOfTetrahedra() > 0;
  this->Mesh.HasCurvedCells = layout.GetNumberOfCurvedCells() > 0;
  this->Mesh.HasTangledCells = cells.GetCounts().GetSum().Folded > 0;
  this->NumberOfDrawnCells = cells.GetCounts().GetSum().Drawn;
  this->Values.Clear();
  if (request.KeepsHostData && !request.Whole && !isCurved && request.LevelOfDetail == 0.0)
  {
    this->Values.Keep(cells, layout);
  }
  this->IsUploaded = !request.Whole;
  this->HasCorners = request.HasCorners;
  this->NumberOfNeighborSearches += layout.HasKnownNeighbors ? 0 : 1;
  layout.Release();
  ++this->NumberOfBuilds;
  return true;
}

std::unique_ptr<VolumeCells> MeshLoader::TakeCells()
{
  return std::move(this->Loaded);
}

void MeshLoader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Mesh.Buffers.ReleaseGraphicsResources(window);
  this->Mesh.Cells.ReleaseGraphicsResources(window);
  this->HasMesh = false;
  this->IsUploaded = false;
  this->Known.Clear();
}
}

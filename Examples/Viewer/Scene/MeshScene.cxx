// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MeshScene.h"

#include "Code/ColourCode.h"
#include "Code/DataCode.h"
#include "Files/FramePattern.h"
#include "Files/MeshReader.h"
#include "Files/RasterEnd.h"
#include "Legend/ArrayUnit.h"
#include "Scene/ArrayExtremes.h"
#include "Scene/ArrayNames.h"
#include "Scene/CellNumbers.h"
#include "Scene/IntegrationPointActor.h"
#include "Scene/MeshColours.h"
#include "Scene/MeshMapping.h"
#include "Scene/MeshProbe.h"
#include "Scene/MeshSection.h"
#include "Scene/MicroMeshes.h"
#include "Scene/OffscreenWindow.h"
#include "Scene/StreamlineActor.h"
#include "Scene/TimeSteps.h"
#include "Scene/ViewerFlow.h"
#include "Scene/ViewerHair.h"
#include "Scene/ViewerMetric.h"
#include "Scene/ViewerPatches.h"
#include "Scene/VolumeArray.h"
#include "Text/PrintableText.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerText.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkCreaseNormals.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkHeightMap.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkLinearSurface.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementSurface.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{
const double OpacityAround = 0.15; // of a surface with streamlines or points inside

// The mean length of all polygons' edges, in the mesh's units.
double GetMeanEdgeLength(vtkPolyData* mesh)
{
  double sum = 0.0;
  vtkIdType number = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    const vtkIdType size = corners->GetNumberOfIds();
    for (vtkIdType i = 0; size > 2 && i < size; ++i)
    {
      double a[3];
      double b[3];
      mesh->GetPoint(corners->GetId(i), a);
      mesh->GetPoint(corners->GetId((i + 1) % size), b);
      sum += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
      ++number;
    }
  }
  return number > 0 ? sum / number : 0.0;
}

// An option that requires colours by an array, or "".
std::string FindColourOption(const ViewerOptions& options)
{
  return options.Range || options.HasRangeOfAllSteps ? "--range"
    : !options.Palette.empty()                       ? "--palette"
    : options.HasLogColors                           ? "--log"
    : options.BelowColor                             ? "--below"
    : options.AboveColor                             ? "--above"
    : options.HasExtremes                            ? "--extremes"
                                                     : "";
}

// Extends a range by the values of an array, or by their magnitudes.
void AddRange(vtkDataArray* array, std::array<double, 2>& range)
{
  if (array)
  {
    double all[2];
    array->GetFiniteRange(all, array->GetNumberOfComponents() > 1 ? -1 : 0);
    range = { { std::min(range[0], all[0]), std::max(range[1], all[1]) } };
  }
}

// The surface's polygons, and all other points that must fit into the view.
vtkSmartPointer<vtkPolyData> WithPoints(vtkPolyData* surface, vtkDataObject* others)
{
  vtkPoints* added = vtkPointSet::SafeDownCast(others)->GetPoints();
  vtkNew<vtkPoints> points;
  points->DeepCopy(surface->GetPoints());
  points->InsertPoints(points->GetNumberOfPoints(), added->GetNumberOfPoints(), 0, added);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(surface->GetPolys());
  return result;
}
}

//------------------------------------------------------------------------------
MeshScene::MeshScene(const ViewerOptions& options, ViewerMessages& messages)
  : SurfaceScene(options, messages)
  , GivenArray(options.Array)
  , Extremes(this->Renderer)
  , Cut(options.Clip)
{
  this->Steps = std::make_unique<TimeSteps>(options, this->Renderer, messages);
  this->Reader = std::make_unique<MeshReader>(this->Steps->GetFile(), messages);
  const bool isOfCells = this->ReadStep();
  this->TakePatches();
  this->TakeMicroMesh();
  this->ChooseSurface(isOfCells);
  this->CompleteMesh();
  this->ChooseArray();
  this->ChooseVectors();
  this->ReadHeights();
  this->Show(options.MaximumLevel.value_or(this->GetDefaultLevel()), this->MakeSceneMetric());
  this->SetColours();
  this->ShowStreamlines();
  this->ShowIntegrationPoints();
  if (this->Cut.Get())
  {
    this->AddSection();
  }
  this->ShowExtremes();
  ShowPatchEdges(this->Options, this->Mapper);
  this->SetLevelColours();
  if (this->Options.Hairs > 0)
  {
    this->Hair = GrowHair(this->Options, this->GetSurface(), this->Messages);
    this->Renderer->AddActor(this->Hair);
  }
  // The main light is above the viewer's left shoulder. Weaker lights are on the right and behind.
  const int up = options.UpAxis;
  this->SetLights(
    { { { 250.0, 45.0, up }, 0.95 }, { { 150.0, 15.0, up }, 0.45 }, { { 10.0, 40.0, up }, 0.30 } });
  this->ResetView();
}

//------------------------------------------------------------------------------
void MeshScene::ResetView()
{
  this->SetCamera(this->GetSeen(), { 205.0, 20.0, this->Options.UpAxis }, this->GetCentre());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MeshScene::GetSeen()
{
  const vtkSmartPointer<vtkPolyData> surface = this->GetSurface();
  return this->Hair ? WithPoints(surface, this->Hair->GetMapper()->GetInputDataObject(0, 0))
                    : surface;
}

//------------------------------------------------------------------------------
SceneContent MeshScene::GetContent()
{
  SceneContent content;
  content.Arrays = FindArrays(this->Cells);
  content.Array = this->ArrayName;
  content.Times = this->Steps->GetFile().GetTimes();
  content.Step = this->Steps->GetStep();
  content.Range = this->IsColouredByArray() ? this->Range : std::nullopt;
  content.Bounds.emplace();
  this->Mesh->GetBounds(content.Bounds->data());
  for (vtkIdType cell = 0; !content.HasSolidCells && cell < this->Cells->GetNumberOfCells(); ++cell)
  {
    content.HasSolidCells = IsVolumeCell(this->Cells, cell);
  }
  return content;
}

//------------------------------------------------------------------------------
void MeshScene::AddDataCode(SceneCode& code)
{
  DataPreparation preparation;
  preparation.Input = this->Options.Input;
  preparation.Quantity = this->GivenArray;
  preparation.HasPatches = this->Options.IsPatch();
  preparation.HasCreases = this->HasCreases;
  preparation.FeatureAngle = this->Options.FeatureAngle;
  const bool usesCells = this->Section || this->Streamlines;
  AddSurfaceDataCode(code, preparation, this->Mesh, usesCells ? this->Cells.Get() : nullptr);
  if (!this->Options.Imagery.empty())
  {
    AddImageCode(code, this->Options.Imagery, this->Actor->GetTexture()->GetInput());
  }
  if (auto* table = vtkLookupTable::SafeDownCast(this->Colours))
  {
    const auto palette = MakeColourFunction(this->Options, this->Range->data());
    palette->SetVectorModeToMagnitude();
    AddLogColourCode(code, palette, table);
  }
}

//------------------------------------------------------------------------------
OptionNames MeshScene::GetUpdatedOptions()
{
  OptionNames names = this->SurfaceScene::GetUpdatedOptions();
  names.insert({ "--above", "--below", "--clip", "--extremes", "--lic-contrast", "--lic-intensity",
    "--lic-mode", "--lic-phase", "--lic-step-size", "--lic-steps", "--offset", "--palette",
    "--range", "--scale", "--time" });
  return names;
}

//------------------------------------------------------------------------------
bool MeshScene::ApplyOptions(const OptionNames& changed)
{
  const auto has = [&](const char* name) { return changed.count(name) > 0; };
  // Such files choose levels per edge by default.
  const bool choosesRule = this->Options.IsPatch() || this->Options.IsMicroMesh();
  const bool needsColours = !FindColourOption(this->Options).empty();
  if ((choosesRule && (has("--metric") || has("--per-edge"))) ||
    (needsColours && !this->IsColouredByArray()) || this->Hair)
  {
    return false;
  }
  // The range of all time steps is found when a scene is built.
  if (this->Options.HasRangeOfAllSteps &&
    (has("--range") || has("--clip") || has("--scale") || has("--time")))
  {
    return false;
  }
  if (has("--clip") && !this->ApplyCut())
  {
    return false;
  }
  if (!this->Options.Warp.empty() ? has("--scale") || has("--time") : has("--time"))
  {
    this->ApplyStep(has("--time"));
  }
  else if ((has("--scale") || has("--offset")) && !this->Options.Heights.empty())
  {
    this->SetDisplacement();
  }
  if (has("--above") || has("--below") || has("--range") || has("--palette"))
  {
    if (has("--range"))
    {
      this->Range.reset();
    }
    this->UpdateColours();
  }
  if (!this->Options.Vectors.empty())
  {
    UpdateStreaks(this->Options, this->Mapper);
  }
  this->ShowExtremes();
  return this->SurfaceScene::ApplyOptions(changed);
}

//------------------------------------------------------------------------------
void MeshScene::ApplyStep(bool isOtherTime)
{
  const int shown = this->Steps->GetStep();
  const double factor = this->Steps->GetFilter().GetWarp().Factor;
  try
  {
    if (isOtherTime)
    {
      this->Steps->SetStep(this->Steps->GetFile().FindStep(this->Options.Time));
    }
    this->Steps->GetFilter().SetFactor(
      this->Options.Warp.empty() ? 1.0 : this->Options.Scale.value_or(1.0));
    if (!this->Options.CoversAllSteps())
    {
      this->Range.reset();
    }
    this->Reload();
  }
  catch (const ViewerError&)
  {
    this->Steps->GetFilter().SetFactor(factor);
    if (isOtherTime)
    {
      this->Steps->SetStep(shown);
    }
    this->Reload();
    throw;
  }
}

//------------------------------------------------------------------------------
bool MeshScene::ApplyCut()
{
  if (!this->Options.Clip)
  {
    return !this->Cut.Get();
  }
  if (this->Cut.Get())
  {
    this->Cut.Set(*this->Options.Clip);
    this->ShowIntegrationPoints();
    return true;
  }
  this->Cut.Set(*this->Options.Clip);
  this->Range.reset();
  this->UpdateColours(); // values inside of the mesh are visible now
  this->AddSection();
  this->ShowIntegrationPoints();
  return true;
}

//------------------------------------------------------------------------------
MeshScene::~MeshScene() = default;

//------------------------------------------------------------------------------
bool MeshScene::ReadStep()
{
  const bool asItIs =
    (this->Options.Surface && !this->Options.IsPatch()) || !this->Options.MicroMesh.empty();
  const MeshCells cells = asItIs
    ? MeshCells::Flat
    : (this->Options.AsksForPatches() ? MeshCells::Patches : MeshCells::Curved);
  const SurfaceMesh mesh =
    this->Reader->Read(this->Steps->GetStep(), this->Steps->GetFilter(), cells);
  this->Mesh->ShallowCopy(mesh.Data);
  this->Options.Array = this->Steps->GetFilter().GetArray();
  this->Cells = mesh.Cells;
  this->IsOfCells = mesh.IsOfCells;
  if (this->Section)
  {
    this->Section->SetMesh(this->Cells);
  }
  return mesh.IsOfCells;
}

//------------------------------------------------------------------------------
void MeshScene::CompleteMesh()
{
  if (this->HasCreases)
  {
    this->FindCreases();
  }
  const bool isMapped = !this->Options.Heights.empty() || !this->Options.Imagery.empty();
  if (isMapped && !this->Mesh->GetPointData()->GetTCoords())
  {
    AddTextureCoordinates(this->Mesh, this->Options);
  }
}

//------------------------------------------------------------------------------
int MeshScene::GetNumberOfTimeSteps()
{
  return this->Steps->GetNumber();
}

//------------------------------------------------------------------------------
void MeshScene::SetTimeStep(int step)
{
  this->Steps->SetStep(step);
  this->Reload();
}

//------------------------------------------------------------------------------
void MeshScene::Reload()
{
  this->ReadStep();
  this->CompleteMesh();
  this->Probe.reset();
  if (!this->Options.Vectors.empty())
  {
    this->ChooseVectors();
  }
  this->UpdateColours();
  this->ShowStreamlines();
  this->ShowIntegrationPoints();
  this->ShowExtremes();
}

//------------------------------------------------------------------------------
void MeshScene::UpdateColours()
{
  if (this->IsColouredByArray())
  {
    this->ExtendRange();
    CopyColours(MakeColours(this->Options, this->Range->data()), this->Colours);
    ShowIsolines(this->Options, this->Mapper, this->Range->data());
    this->ShowIsolinesOfSection();
  }
}

//------------------------------------------------------------------------------
std::string MeshScene::Change(char key)
{
  const std::string shown = this->Steps->Change(key, [this](int step) { this->SetTimeStep(step); });
  return shown.empty() ? this->MoveCut(key) : shown;
}

//------------------------------------------------------------------------------
std::string MeshScene::MoveCut(char key)
{
  const bool isNew = !this->Cut.Get();
  if (!this->Cut.Move(key, this->Mesh->GetBounds(), this->Renderer))
  {
    return "";
  }
  if (isNew)
  {
    this->UpdateColours(); // values inside of the mesh are visible now
    this->AddSection();
  }
  this->ShowIntegrationPoints();
  this->ShowExtremes();
  return this->Cut.GetOption();
}

//------------------------------------------------------------------------------
void MeshScene::AddSection()
{
  this->Cut.WarnIfEmpty(this->Mesh->GetBounds(), this->Messages);
  this->Mapper->AddClippingPlane(this->Cut.Get());
  if (!this->IsSolid())
  {
    this->Messages.Warn(this->Options.Input + " has no 3D cells, so the cut is hollow");
    return;
  }
  this->Section = std::make_unique<MeshSection>(this->Cut.Get(), this->Renderer, this->Messages);
  this->Section->SetMesh(this->Cells);
  this->Section->SetColours(this->Mapper, this->Actor->GetProperty());
  this->ShowIsolinesOfSection();
}

//------------------------------------------------------------------------------
void MeshScene::ShowIsolinesOfSection()
{
  const bool hasLines =
    this->Section && this->Options.Isolines > 0 && this->IsColouredByArray() && this->HasPointArray;
  if (hasLines && (*this->Range)[1] > (*this->Range)[0])
  {
    this->Section->SetIsolines(this->ArrayName, this->GetArray()->GetNumberOfComponents() > 1,
      ((*this->Range)[1] - (*this->Range)[0]) / this->Options.Isolines, this->Range->data());
  }
}

//------------------------------------------------------------------------------
bool MeshScene::IsSolid() const
{
  for (vtkIdType cell = 0; cell < this->Cells->GetNumberOfCells(); ++cell)
  {
    if (IsVolumeCell(this->Cells, cell))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void MeshScene::ShowStreamlines()
{
  if (this->Options.Streamlines.empty())
  {
    return;
  }
  if (!this->Streamlines)
  {
    this->Streamlines = std::make_unique<StreamlineActor>(this->Renderer, this->Messages);
    this->Actor->GetProperty()->SetOpacity(this->IsSolid() ? OpacityAround : 1.0);
  }
  this->Streamlines->Trace(this->Options, this->Cells);
  if (this->IsColouredByArray())
  {
    this->Streamlines->SetColours(this->ArrayName, this->Colours);
  }
}

//------------------------------------------------------------------------------
void MeshScene::ShowIntegrationPoints()
{
  vtkPolyData* points = this->Steps->GetFilter().GetIntegrationPoints();
  if (!points)
  {
    return;
  }
  if (!this->IntegrationPoints)
  {
    this->IntegrationPoints = std::make_unique<IntegrationPointActor>(this->Renderer);
    this->Actor->GetProperty()->SetOpacity(this->IsSolid() ? OpacityAround : 1.0);
  }
  this->IntegrationPoints->SetPoints(points, this->Cells);
  this->IntegrationPoints->Cut(this->Cut.Get());
  this->IntegrationPoints->SetColours(this->Steps->GetFilter().GetPointArray(), this->Colours);
}

//------------------------------------------------------------------------------
void MeshScene::ShowExtremes()
{
  this->Extremes.Clear();
  if (!this->Options.HasExtremes)
  {
    return;
  }
  vtkDataSet* shown = this->Cut.Get() ? this->Cells.Get() : this->Mesh.Get();
  const auto extremes = FindExtremes(shown, this->ArrayName, this->HasPointArray, this->Cut.Get());
  if (extremes)
  {
    MarkExtremes(*extremes, this->HasPointArray, this->Cells, this->Extremes);
  }
}

//------------------------------------------------------------------------------
void MeshScene::TakePatches()
{
  const bool hasPatches = HasPatches(this->Mesh);
  if (this->Options.AsksForPatches() && !hasPatches)
  {
    throw ViewerError(this->Options.Input +
      " is not an unstructured grid, which --surface patch, --isolines and --patch-edges require");
  }
  if (hasPatches)
  {
    this->Options.Surface = ViewerOptions::SurfaceType::Patch;
    this->Options.FeatureAngle.reset(); // cells define their normals
    this->Options.PerEdge |= this->Options.GetMetric() == ViewerOptions::MetricType::Error;
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MeshScene::EncodeStep(const std::string& file)
{
  std::string report;
  const auto micro = EncodeMicroMesh(this->Options,
    { this->Mesh, this->Cells, this->Steps->GetFilter().GetArray() }, file, this->Messages, report);
  this->MicroMeshReport += (this->MicroMeshReport.empty() ? "" : "\n") + report;
  return micro;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MeshScene::EncodeSteps()
{
  const std::string& file = this->Options.MicroMesh;
  const int number = this->Steps->GetNumber();
  if (!IsFramePattern(file))
  {
    const auto micro = this->EncodeStep(file);
    if (number > 1)
    {
      this->MicroMeshReport += "\nThis is one of " + std::to_string(number) +
        " time steps. For all of them, use a name such as " +
        std::filesystem::path(file).stem().string() + "%04d.rmm";
    }
    return micro;
  }
  if (number == 0)
  {
    throw ViewerError(
      this->Options.Input + " has no time steps, which --micromesh " + file + " would number");
  }
  vtkSmartPointer<vtkPolyData> micro;
  for (int step = 0; step < number; ++step)
  {
    if (step != this->Steps->GetStep())
    {
      this->Steps->SetStep(step);
      this->ReadStep();
    }
    micro = this->EncodeStep(MakeFrameName(file, static_cast<std::size_t>(step)));
  }
  return micro;
}

//------------------------------------------------------------------------------
void MeshScene::TakeMicroMesh()
{
  if (!this->Options.MicroMesh.empty())
  {
    this->Mesh->ShallowCopy(this->EncodeSteps());
    this->Options.FeatureAngle.reset(); // the encoder has used it
  }
  else if (IsMicroMesh(this->Mesh) && !this->Options.Surface)
  {
    this->MicroMeshReport = DescribeMicroMesh(this->Mesh);
  }
  if (!this->MicroMeshReport.empty())
  {
    // The cells under the mouse are those of the micro-mesh, not of the dense mesh.
    this->Cells = this->Mesh;
    this->IsOfCells = false;
    this->Options.Surface = ViewerOptions::SurfaceType::MicroMesh;
    this->Options.PerEdge |= this->Options.GetMetric() == ViewerOptions::MetricType::Error;
  }
}

//------------------------------------------------------------------------------
void MeshScene::ChooseSurface(bool isOfCells)
{
  if (!this->Options.Surface && isOfCells)
  {
    // Linear cells are flat, and nothing indicates that they should be curved.
    this->Options.Surface = ViewerOptions::SurfaceType::Linear;
  }
  // For other surfaces, normals are used unchanged.
  this->HasCreases =
    !this->Options.IsPatch() && (!this->Options.Surface || this->Options.FeatureAngle);
}

//------------------------------------------------------------------------------
void MeshScene::FindCreases()
{
  vtkNew<vtkCreaseNormals> normals;
  this->Messages.Observe(normals, "finding creases");
  normals->SetInputData(this->Mesh);
  if (this->Options.FeatureAngle)
  {
    normals->SetFeatureAngle(*this->Options.FeatureAngle);
    normals->KeepCoarseFlatOff();
  }
  normals->Update();
  this->Messages.Check();
  this->Mesh->ShallowCopy(normals->GetOutput());
  if (!this->Options.Surface)
  {
    const bool isFlat = vtkLinearSurface::SafeDownCast(normals->GetFittingSurface());
    this->Options.Surface =
      isFlat ? ViewerOptions::SurfaceType::Linear : ViewerOptions::SurfaceType::PNTriangle;
    std::ostringstream text;
    text << "surface: curved through the mesh's points (--surface pn), with "
         << normals->GetNumberOfCreases() << " creases of more than " << normals->GetFeatureAngle()
         << " degrees; --surface linear draws flat faces";
    this->CurvedBy = isFlat ? std::string() : text.str();
  }
}

//------------------------------------------------------------------------------
void MeshScene::Report()
{
  if (!this->CurvedBy.empty())
  {
    std::cout << this->CurvedBy << std::endl;
  }
  if (!this->MicroMeshReport.empty())
  {
    std::cout << this->MicroMeshReport << std::endl;
  }
  this->ReportWarp();
  vtkDataArray* array = this->IsColouredByArray() ? this->GetArray() : nullptr;
  if (array && (array->GetNumberOfComponents() == 6 || array->GetNumberOfComponents() == 9))
  {
    const std::string name = ToPrintable(this->ArrayName);
    std::cout << "array: colours show the magnitude of the tensor '" << name
              << "', which is not the von Mises stress; --array 'von Mises of " << name
              << "' shows that" << std::endl;
  }
  if (this->Steps->GetFilter().IsAverage() && this->Options.IntegrationPoints.empty())
  {
    const std::string name = ToPrintable(this->ArrayName);
    std::cout << "array: colours show the averages of cells; --integration-points '" << name
              << "' also shows the values at integration points" << std::endl;
  }
  const bool isGrey = this->ArrayName.empty() && this->Options.Imagery.empty() &&
    this->Options.Color == ViewerOptions::ColorType::Own && this->Options.Export.empty() &&
    this->Options.Capture.empty();
  const std::string list = isGrey ? ListArrays(this->Mesh) : "";
  if (!list.empty())
  {
    std::cout << "arrays: " << ToPrintable(list) << "; --array NAME colours by one" << std::endl;
  }
}

//------------------------------------------------------------------------------
void MeshScene::ReportWarp()
{
  const double visible = 0.005; // share of the diagonal
  vtkDataArray* moves = this->Options.Warp.empty()
    ? nullptr
    : this->Mesh->GetPointData()->GetArray(this->Options.Warp.c_str());
  if (!moves)
  {
    return;
  }
  double range[2];
  GetLengthRange(moves, range);
  const double share = range[1] / this->Mesh->GetLength();
  if (share > 0.0 && share * std::abs(this->Steps->GetFilter().GetWarp().Factor) < visible)
  {
    std::cout << std::setprecision(2) << "warp: points are moved by at most "
              << 100.0 * share * std::abs(this->Steps->GetFilter().GetWarp().Factor)
              << " % of the diagonal; --scale " << std::setprecision(1) << 0.05 / share
              << " makes that 5 %" << std::endl;
  }
}

//------------------------------------------------------------------------------
void MeshScene::ChooseArray()
{
  if (this->Options.Array.empty())
  {
    this->Options.Array = this->Options.Streamlines; // colours are their lengths
  }
  vtkPointData* points = this->Mesh->GetPointData();
  vtkCellData* cells = this->Mesh->GetCellData();
  const char* name = this->Options.Array.c_str();
  vtkDataArray* ofPoints =
    this->Options.Array.empty() ? points->GetScalars() : points->GetArray(name);
  vtkDataArray* ofCells = this->Options.Array.empty() ? cells->GetScalars() : cells->GetArray(name);
  if (!this->Options.Array.empty() && !ofPoints && !ofCells)
  {
    const std::string list = ListArrays(this->Mesh);
    throw ViewerError(this->Options.Input + " has no array of numbers '" + name + "'" +
      (list.empty() ? "; it has no arrays" : "; its arrays are " + list));
  }
  vtkDataArray* array = ofPoints ? ofPoints : ofCells;
  if (array && array->GetNumberOfTuples() > 0)
  {
    if (!array->GetName())
    {
      array->SetName("Scalars");
    }
    this->ArrayName = array->GetName();
    this->HasPointArray = ofPoints != nullptr;
  }
}

//------------------------------------------------------------------------------
void MeshScene::ChooseVectors()
{
  if (this->Options.Vectors.empty())
  {
    return;
  }
  bool isOfPoints = false;
  this->Vectors = FindVectors(this->Options, this->Mesh, isOfPoints);
  MarkNoData(this->Vectors);
  SetVectorArray(this->Mapper, this->Vectors, isOfPoints);
  // Colours by the vectors' lengths are most useful with streaks.
  if (this->Options.Array.empty())
  {
    this->ArrayName = this->Options.Vectors;
    this->HasPointArray = isOfPoints;
  }
}

//------------------------------------------------------------------------------
void MeshScene::ReadHeights()
{
  if (this->Options.Heights.empty())
  {
    return;
  }
  vtkNew<vtkHeightMap> heights;
  this->Messages.Observe(heights, "reading heights");
  this->Messages.Observe(this->Displacement);
  heights->SetFileName(this->Options.Heights.c_str());
  if (this->Options.NoDataValue)
  {
    heights->SetNoDataValue(*this->Options.NoDataValue);
  }
  {
    const ReadingGuard guard({ this->Options.Heights });
    CheckRasterEnd(this->Options.Heights, this->Messages);
    FitIntoTexture(heights, "");
    heights->Update();
  }
  this->Messages.Check();
  this->Displacement->SetHeightMap(heights);
  this->SetDisplacement();
  if (this->Options.FillNoData)
  {
    this->Displacement->SetNoDataPolicyToFill();
  }
  this->Recipe->SetDisplacement(this->Displacement);
}

//------------------------------------------------------------------------------
void MeshScene::SetDisplacement()
{
  double range[2];
  this->Displacement->GetHeightMap()->GetRange(range);
  this->Displacement->SetOffset(0.0);
  if (this->Options.Scale)
  {
    this->Displacement->SetScale(*this->Options.Scale);
  }
  else
  {
    // The default scale makes heights visible, and puts the lowest point on the surface.
    const double relief = range[1] - range[0];
    const double scale = relief > 0.0 ? 0.05 * this->Mesh->GetLength() / relief : 0.0;
    this->Displacement->SetScale(scale);
    this->Displacement->SetOffset(-scale * range[0]);
  }
  if (this->Options.Offset)
  {
    this->Displacement->SetOffset(*this->Options.Offset);
  }
}

//------------------------------------------------------------------------------
bool MeshScene::IsAsItIs() const
{
  // More triangles in the same plane do not change the picture, except for colours by level.
  const ViewerOptions& options = this->Options;
  const bool hasLevels = options.Metric || options.Pixels || options.Budget > 0 ||
    options.WholeSegments || options.PerEdge || options.Color != ViewerOptions::ColorType::Own;
  return options.GetSurface() == ViewerOptions::SurfaceType::Linear && options.Heights.empty() &&
    options.Vectors.empty() && !hasLevels;
}

//------------------------------------------------------------------------------
int MeshScene::GetDefaultLevel()
{
  if (this->IsAsItIs())
  {
    return 0;
  }
  // Levels by edge length or error on the screen are limited anyway.
  using Metric = ViewerOptions::MetricType;
  const Metric metric = this->Options.GetMetric();
  if ((metric == Metric::ScreenEdge || metric == Metric::Error || metric == Metric::Height) &&
    !this->Options.IsFlowMetric())
  {
    return 7;
  }
  // Otherwise choose edges of about the same length for a typical edge when the whole mesh is
  // visible.
  const double pixels = this->Options.Zoom *
    std::max(this->Options.Size[0], this->Options.Size[1]) * GetMeanEdgeLength(this->Mesh) /
    this->Mesh->GetLength();
  if (!(pixels > 0.0)) // NaN if all points coincide
  {
    return 0;
  }
  const double level = std::ceil(std::log2(pixels / ViewerOptions::DefaultPixels));
  return static_cast<int>(std::min(std::max(level, 0.0), 7.0));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDepthTagMetric> MeshScene::MakeSceneMetric()
{
  const bool isOfVectors = this->Vectors && this->Options.Array.empty();
  auto metric = MakeMetric(this->Options, this->Mesh,
    isOfVectors || this->HasPointArray ? this->ArrayName : std::string());
  this->Messages.Observe(metric);
  return metric;
}

//------------------------------------------------------------------------------
void MeshScene::SetColours()
{
  vtkProperty* property = this->Actor->GetProperty();
  property->SetColor(0.80, 0.78, 0.74);
  property->SetAmbient(0.12);
  property->SetDiffuse(0.80);
  property->SetSpecular(0.18);
  property->SetSpecularPower(30.0);
  property->SetInterpolationToPhong();
  this->Mapper->ScalarVisibilityOff();
  const std::string option = FindColourOption(this->Options);
  if (!option.empty() && (this->ArrayName.empty() || !this->Options.Imagery.empty()))
  {
    throw ViewerError(option + " requires colours by an array" +
      (this->Options.Imagery.empty() ? ", and " + this->Options.Input + " has none"
                                     : ", not a picture (--image)"));
  }
  if (!this->Options.Imagery.empty())
  {
    property->SetColor(1.0, 1.0, 1.0);
    this->SetTexture(ReadImage(this->Options.Imagery, this->Messages));
  }
  // A picture has precedence over scalars that were not requested.
  else if (!this->ArrayName.empty())
  {
    this->SetArrayColours();
  }
}

//------------------------------------------------------------------------------
vtkDataArray* MeshScene::GetArray()
{
  vtkDataSetAttributes* data = this->HasPointArray
    ? static_cast<vtkDataSetAttributes*>(this->Mesh->GetPointData())
    : this->Mesh->GetCellData();
  return data->GetArray(this->ArrayName.c_str());
}

//------------------------------------------------------------------------------
void MeshScene::SetArrayColours()
{
  vtkDataArray* array = this->GetArray();
  this->HasPointArray ? this->Mapper->SetScalarModeToUsePointFieldData()
                      : this->Mapper->SetScalarModeToUseCellFieldData();
  this->Mapper->SelectColorArray(this->ArrayName.c_str());
  this->Mapper->ScalarVisibilityOn();
  // Bytes with three or more components are colours.
  if (array->GetDataType() == VTK_UNSIGNED_CHAR && array->GetNumberOfComponents() >= 3)
  {
    return;
  }
  this->Options.CoversAllSteps() && this->GetNumberOfTimeSteps() > 0 ? this->ExtendRangeByAllSteps()
                                                                     : this->ExtendRange();
  array = this->GetArray(); // that of the step which is read last
  this->Colours = MakeColours(this->Options, this->Range->data());
  this->Mapper->SetLookupTable(this->Colours);
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Mapper->InterpolateScalarsBeforeMappingOn();
  ShowIsolines(this->Options, this->Mapper, this->Range->data());
  if (this->Options.Color == ViewerOptions::ColorType::Own)
  {
    const std::string& name = this->Options.IntegrationPoints.empty()
      ? this->ArrayName
      : this->Steps->GetFilter().GetPointArray();
    this->AddLegend(
      this->Colours, GetArrayTitle(name, array->GetNumberOfComponents()), GetArrayUnit(array), 5);
  }
}

//------------------------------------------------------------------------------
bool MeshScene::IsColouredByArray() const
{
  return this->Colours != nullptr;
}

//------------------------------------------------------------------------------
void MeshScene::ExtendRange()
{
  if (this->Options.Range)
  {
    this->Range = this->Options.Range;
    return;
  }
  vtkDataArray* array = this->GetArray();
  if (!array)
  {
    throw ViewerError(this->Options.Input + " has no array '" + this->ArrayName + "' with " +
      this->Steps->GetOption());
  }
  std::array<double, 2> range;
  array == this->Vectors
    ? GetLengthRange(array, range.data())
    : array->GetFiniteRange(range.data(), array->GetNumberOfComponents() > 1 ? -1 : 0);
  const bool showsInside = this->Cut.Get() || !this->Options.Streamlines.empty();
  if (showsInside && array != this->Vectors)
  {
    this->AddRangeOfCells(range);
  }
  if (vtkPolyData* points = this->Steps->GetFilter().GetIntegrationPoints())
  {
    AddRange(
      points->GetPointData()->GetArray(this->Steps->GetFilter().GetPointArray().c_str()), range);
  }
  CheckRange(this->Options, this->ArrayName, range.data());
  if (this->Range)
  {
    range = { { std::min(range[0], (*this->Range)[0]), std::max(range[1], (*this->Range)[1]) } };
  }
  this->Range = range;
}

//------------------------------------------------------------------------------
void MeshScene::AddRangeOfCells(std::array<double, 2>& range)
{
  vtkDataSetAttributes* data = this->HasPointArray
    ? static_cast<vtkDataSetAttributes*>(this->Cells->GetPointData())
    : this->Cells->GetCellData();
  AddRange(data->GetArray(this->ArrayName.c_str()), range);
}

//------------------------------------------------------------------------------
void MeshScene::ExtendRangeByAllSteps()
{
  const int shown = this->Steps->GetStep();
  for (int step = 0; step < this->GetNumberOfTimeSteps(); ++step)
  {
    this->Steps->SetStep(step);
    this->ReadStep();
    if (!this->Options.Vectors.empty())
    {
      this->ChooseVectors();
    }
    this->ExtendRange();
  }
  this->Steps->SetStep(shown);
  this->ReadStep();
  this->CompleteMesh();
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> MeshScene::GetCentre()
{
  if (!this->Options.Center)
  {
    return std::nullopt;
  }
  const std::vector<double>& place = *this->Options.Center;
  return { { { place[0], place[1], place[2] } } };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MeshScene::GetSurface()
{
  const vtkIdType maximumNumberOfCells = 100000;
  int level = 3;
  while (level > 0 && (this->Mesh->GetNumberOfCells() << (2 * level)) > maximumNumberOfCells)
  {
    --level;
  }
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(level);
  recipe->SetSurface(this->Recipe->GetSurface());
  recipe->SetDisplacement(this->Recipe->GetDisplacement());
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  this->Messages.Observe(filter, "measuring");
  filter->SetInputData(this->Mesh);
  filter->SetRefinement(recipe);
  filter->Update();
  this->Messages.Check();
  if (filter->GetOutput()->GetNumberOfCells() == 0)
  {
    throw ViewerError(this->Options.Input + ": every triangle is degenerate or has no heights");
  }
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
std::string MeshScene::Describe(const double point[3], double resolution)
{
  std::string text = "x " + FormatNumber(point[0], resolution) + "  y " +
    FormatNumber(point[1], resolution) + "  z " + FormatNumber(point[2], resolution);
  std::vector<double> values;
  const vtkIdType cell = this->FindCell(point, resolution, values);
  if (cell >= 0)
  {
    text += "\n" + DescribeCell(this->Cells, cell, point);
  }
  if (!values.empty())
  {
    text += "\n" + this->ArrayName;
    for (double value : values)
    {
      std::ostringstream number;
      number << std::setprecision(4) << value;
      text += " " + number.str();
    }
  }
  return text;
}

//------------------------------------------------------------------------------
vtkIdType MeshScene::FindCell(const double point[3], double resolution, std::vector<double>& values)
{
  const double nearby = 4.0; // pixels
  const vtkIdType cut = this->Section
    ? this->Section->Find(point, nearby * resolution, this->ArrayName, this->HasPointArray, values)
    : -1;
  if (cut >= 0)
  {
    return cut;
  }
  if (!this->Probe)
  {
    this->Probe = std::make_unique<MeshProbe>(this->Mesh, this->Recipe,
      this->ArrayName.empty() ? nullptr : this->GetArray(), this->HasPointArray);
  }
  const vtkIdType face = this->Probe->Find(point, this->Renderer, values);
  // In a file of a surface, this array has ids of another mesh.
  vtkDataArray* cells =
    this->IsOfCells ? this->Mesh->GetCellData()->GetArray("vtkOriginalCellIds") : nullptr;
  return cells && face >= 0 ? static_cast<vtkIdType>(cells->GetComponent(face, 0)) : face;
}

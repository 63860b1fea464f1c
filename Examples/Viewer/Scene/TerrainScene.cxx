// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainScene.h"

#include "Code/DataCode.h"
#include "Files/MeshPoints.h"
#include "Files/RasterEnd.h"
#include "Files/ViewerFile.h"
#include "Options/Palettes.h"
#include "Scene/OffscreenWindow.h"
#include "Scene/ReliefMetric.h"
#include "Scene/SourceGround.h"
#include "Scene/TerrainCamera.h"
#include "Scene/TerrainColours.h"
#include "Scene/TerrainPlace.h"
#include "Scene/ViewerMetric.h"
#include "Text/ReadingGuard.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkFloatArray.h"
#include "vtkHeightField.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSMPTools.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace
{
const int Up = 2;
const char* const HeightName = "Height";
}

//------------------------------------------------------------------------------
TerrainScene::TerrainScene(const ViewerOptions& options, ViewerMessages& messages)
  : SurfaceScene(options, messages)
{
  this->Messages.Observe(this->Source, "reading");
  this->ReadTerrain();
  this->MakeDisplacedMesh();
  this->Recipe->SetDisplacement(this->Source->GetDisplacement());
  // Fewer triangles.
  this->Options.PerEdge |= options.GetMetric() == ViewerOptions::MetricType::Height;
  this->Show(options.MaximumLevel.value_or(this->GetDefaultLevel()), this->MakeSceneMetric());
  this->SetColours();
  this->SetLevelColours();
  // Light from the north-west, as on maps, and weaker light from the other side.
  this->SetLights({ { { 315.0, 40.0, Up }, 1.0 }, { { 160.0, 50.0, Up }, 0.35 } });
  this->ResetView();
}

//------------------------------------------------------------------------------
TerrainScene::~TerrainScene() = default;

//------------------------------------------------------------------------------
void TerrainScene::ResetView()
{
  // The camera is slightly west of south.
  this->SetCamera(this->DisplacedMesh, { 192.0, 38.0, Up },
    FindCentre(this->Options, *this->Ground, this->Messages));
  this->KeepAboveGround();
}

//------------------------------------------------------------------------------
void TerrainScene::AddDataCode(SceneCode& code)
{
  if (ReliefMetric::SafeDownCast(this->Recipe->GetMetric()))
  {
    throw ViewerError("a program cannot draw " + this->Options.Input +
      " with this metric yet; use --metric height or curvature, or save a session");
  }
  AddSavedDataCode(code, this->Mesh, "mesh");
}

//------------------------------------------------------------------------------
bool TerrainScene::ApplyOptions(const OptionNames& changed)
{
  const bool isDone = this->SurfaceScene::ApplyOptions(changed);
  this->KeepAboveGround(); // the levels near the camera may have changed
  return isDone;
}

//------------------------------------------------------------------------------
void TerrainScene::ReadTerrain()
{
  this->Source->SetFileName(this->Options.Input.c_str());
  if (!this->Options.Imagery.empty())
  {
    this->Source->SetImageryFileName(this->Options.Imagery.c_str());
    this->Source->SetImageryBands(
      this->Options.ImageryBands[0], this->Options.ImageryBands[1], this->Options.ImageryBands[2]);
  }
  if (this->Options.Resolution)
  {
    this->Source->SetResolution(*this->Options.Resolution);
  }
  // Measured triangles should have their corners on samples.
  this->Source->SetAlignToSamples(
    !this->Options.UniformLevel && this->Options.GetMetric() == ViewerOptions::MetricType::Height);
  if (this->Options.FillNoData)
  {
    this->Source->SetNoDataPolicyToFill();
  }
  if (this->Options.NoDataValue)
  {
    this->Source->SetNoDataValue(*this->Options.NoDataValue);
  }
  this->Source->SetExaggeration(this->Options.Exaggeration.value_or(1.0));
  std::vector<std::string> files = { this->Options.Input };
  if (!this->Options.Imagery.empty())
  {
    files.push_back(this->Options.Imagery);
  }
  {
    const ReadingGuard guard(files);
    CheckRasterEnd(this->Options.Input, this->Messages);
    FitIntoTexture(this->Source->GetHeightMap(), this->Options.Imagery.c_str());
    this->Source->SetMaximumImagerySize(this->Source->GetMaximumDimension());
    this->Source->Update();
  }
  this->CheckReading();
  // Removes the corners of faces that were left out.
  this->Mesh->ShallowCopy(DropUnusedPoints(this->Source->GetOutput()));
  if (this->Mesh->GetNumberOfCells() == 0)
  {
    throw ViewerError(this->Options.Input + " has no terrain to draw");
  }
  this->Ground = std::make_unique<SourceGround>(this->Source, this->Mesh);
  this->ChooseExaggeration();
  this->CheckBudget();
}

//------------------------------------------------------------------------------
void TerrainScene::CheckReading()
{
  try
  {
    this->Messages.Check();
  }
  catch (const ViewerError& error)
  {
    const std::string text = error.what();
    const bool isOfInput =
      text == this->Source->GetHeightMap()->GetErrorMessage() && CanRead(this->Options.Input);
    throw ViewerError(isOfInput ? ExplainRasterError(this->Options.Input, text) : text);
  }
}

//------------------------------------------------------------------------------
void TerrainScene::ChooseExaggeration()
{
  double bounds[6];
  this->Mesh->GetBounds(bounds);
  TerrainShape shape;
  this->Source->GetHeightMap()->GetRange(shape.Range);
  shape.Width = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  shape.Relief =
    std::abs(this->Source->GetDisplacement()->GetScale()) * (shape.Range[1] - shape.Range[0]);
  shape.HasCoordinateSystem = this->Ground->HasCoordinateSystem();
  shape.CountsSamples = this->CountsTexels();
  this->Source->SetExaggeration(FindExaggeration(this->Options, shape, this->ExaggeratedBy));
}

//------------------------------------------------------------------------------
bool TerrainScene::CountsTexels()
{
  const double middle[3] = { 0.0, 0.0, 0.0 };
  double map[3];
  const int* size = this->Source->GetHeightMap()->GetFullDimensions();
  return !*this->Source->GetCoordinateSystem() && this->Source->TerrainToMap(middle, map) &&
    map[0] == 0.5 * size[0] && map[1] == 0.5 * size[1];
}

//------------------------------------------------------------------------------
void TerrainScene::CheckBudget()
{
  const vtkIdType coarse = this->Mesh->GetNumberOfCells();
  const int budget = this->Options.Budget;
  if (budget == 0 || budget >= coarse)
  {
    return;
  }
  const double factor = std::sqrt(static_cast<double>(budget) / static_cast<double>(coarse));
  const int resolution = static_cast<int>(factor * this->Source->GetResolution());
  this->Messages.Warn("--budget " + std::to_string(budget) + " is less than the " +
    std::to_string(coarse) + " coarse triangles, which are always drawn where they are in view; " +
    "use --resolution " + std::to_string(std::max(resolution, 1)) + " for fewer");
}

//------------------------------------------------------------------------------
void TerrainScene::Report()
{
  if (!this->ExaggeratedBy.empty())
  {
    std::cout << this->ExaggeratedBy << std::endl;
  }
}

//------------------------------------------------------------------------------
void TerrainScene::AddHeights(vtkPolyData* mesh)
{
  vtkHeightField* heights = this->Source->GetHeightMap();
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  vtkNew<vtkFloatArray> values;
  values->SetName(HeightName);
  values->SetNumberOfValues(numberOfPoints);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        values->SetValue(i,
          static_cast<float>(
            heights->GetHeight(coordinates->GetComponent(i, 0), coordinates->GetComponent(i, 1))));
      }
    });
  mesh->GetPointData()->AddArray(values);
}

//------------------------------------------------------------------------------
void TerrainScene::MakeDisplacedMesh()
{
  vtkDisplacement* displacement = this->Source->GetDisplacement();
  this->DisplacedMesh->ShallowCopy(this->Mesh);
  this->AddHeights(this->DisplacedMesh);
  vtkDataArray* heights = this->DisplacedMesh->GetPointData()->GetArray(HeightName);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(this->Mesh->GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    point[2] += displacement->GetOffset() + displacement->GetScale() * heights->GetComponent(i, 0);
    points->SetPoint(i, point);
  }
  this->DisplacedMesh->SetPoints(points);
  this->DisplacedMesh->GetPointData()->SetNormals(nullptr); // they belong to the flat mesh
}

//------------------------------------------------------------------------------
void TerrainScene::AddExportedData(vtkPolyData* mesh)
{
  this->AddHeights(mesh);
}

//------------------------------------------------------------------------------
void TerrainScene::KeepAboveGround()
{
  // These metrics give the highest levels near the camera, or levels that morph to them.
  using Metric = ViewerOptions::MetricType;
  const Metric metric = this->Options.GetMetric();
  const bool isFine =
    (metric == Metric::Distance || metric == Metric::ScreenEdge || metric == Metric::Height) &&
    this->Options.Budget == 0;
  const int highest = this->Recipe->GetMaximumLevel();
  const int lowest = this->Options.UniformLevel ? highest : isFine ? std::max(highest - 1, 0) : 0;
  this->Ground->SetLevels(lowest, highest);
  this->Camera = std::make_unique<TerrainCamera>(this->Renderer, *this->Ground);
  this->Camera->Update();
}

//------------------------------------------------------------------------------
int TerrainScene::GetDefaultLevel()
{
  const int highest = 7;
  // The level of the height map's spacing. A picture that cannot be navigated needs nothing finer
  // than its pixels.
  int size[2];
  this->Source->GetHeightMap()->GetDimensions(size);
  const int texels = std::max(size[0], size[1]);
  const int squares = std::min(this->Source->GetResolution(), texels);
  int segments = texels;
  if (!this->Options.Output.empty() && this->Options.Export.empty())
  {
    const double pixels =
      this->Options.Zoom * std::max(this->Options.Size[0], this->Options.Size[1]);
    segments = static_cast<int>(std::min<double>(segments, std::ceil(pixels)));
  }
  int level = static_cast<int>(std::ceil(std::log2(static_cast<double>(segments) / squares)));
  // The distance metric gives the highest level only to edges that touch the camera, and the error
  // of heights only to edges that need it.
  using Metric = ViewerOptions::MetricType;
  const Metric metric = this->Options.GetMetric();
  if (metric == Metric::Distance || metric == Metric::Height)
  {
    ++level;
  }
  return std::min(std::max(level, 0), highest);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDepthTagMetric> TerrainScene::MakeSceneMetric()
{
  const auto own = MakeMetric(this->Options, this->DisplacedMesh, HeightName);
  this->Messages.Observe(own);
  if (own->IsDisplacementDependent())
  {
    return own; // evaluates the displaced surface
  }
  auto metric = vtkSmartPointer<ReliefMetric>::New();
  metric->SetMetric(own);
  metric->SetRelief(this->DisplacedMesh);
  return metric;
}

//------------------------------------------------------------------------------
void TerrainScene::SetColours()
{
  vtkSmartPointer<vtkImageData> image = this->Source->GetImagery();
  const bool isPhotograph = image != nullptr;
  if (!isPhotograph)
  {
    std::array<double, 2> range;
    this->Source->GetHeightMap()->GetRange(range.data());
    const auto colours =
      MakePalette(this->Options.Palette.empty() ? "relief" : this->Options.Palette,
        this->Options.Range.value_or(range));
    image = MakeHypsometricTint(this->Source->GetHeightMap(), colours);
    if (!this->Options.IsColoredByLevel())
    {
      this->AddLegend(colours, HeightName, GetHeightUnit(*this->Ground), 5);
    }
  }
  else if (this->Options.Stretch)
  {
    image = StretchContrast(image);
  }
  this->SetTexture(image);

  // Photographs contain shadows.
  vtkProperty* property = this->Actor->GetProperty();
  property->SetAmbient(isPhotograph ? 0.30 : 0.15);
  property->SetDiffuse(isPhotograph ? 0.80 : 0.85);
  property->SetInterpolationToPhong();
}

//------------------------------------------------------------------------------
std::string TerrainScene::GetUnit()
{
  return this->Ground->HasCoordinateSystem() ? "m" : "";
}

//------------------------------------------------------------------------------
std::string TerrainScene::Describe(const double point[3], double resolution)
{
  return DescribePlace(*this->Ground, point, resolution);
}

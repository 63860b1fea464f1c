// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainScene.h"

#include "Files/FileEnd.h"
#include "Files/MeshPoints.h"
#include "Files/MeshReader.h"
#include "Files/ViewerFile.h"
#include "Scene/OffscreenWindow.h"
#include "Scene/ReliefMetric.h"
#include "Scene/TerrainCamera.h"
#include "Scene/TerrainColours.h"
#include "Scene/TerrainProbe.h"
#include "Scene/ViewerMetric.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerText.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
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
#include "vtkScalarsToColors.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{
const int Up = 2;
const char* const HeightName = "Height";

// "86.925E"
std::string ToText(double degrees, char positive, char negative)
{
  std::ostringstream text;
  text << std::setprecision(9) << std::abs(degrees) << (degrees < 0.0 ? negative : positive);
  return text.str();
}
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
  if (options.Tolerance && !options.WholeSegments)
  {
    this->Options.WholeSegments = true;
  }
  this->Show(options.MaximumLevel.value_or(this->GetDefaultLevel()), this->MakeReliefMetric());
  this->SetColours();
  this->SetLevelColours();
  // Light from the north-west, as on maps, and weaker light from the other side.
  this->SetLights({ { { 315.0, 40.0, Up }, 1.0 }, { { 160.0, 50.0, Up }, 0.35 } });
  // The camera is slightly west of south.
  this->SetCamera(this->DisplacedMesh, { 192.0, 38.0, Up }, this->GetCentre());
  this->KeepAboveGround();
}

//------------------------------------------------------------------------------
TerrainScene::~TerrainScene() = default;

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
  this->CheckExaggeration();
  this->CheckBudget();
  this->Probe = std::make_unique<TerrainProbe>(this->Mesh, this->Source->GetHeightMap());
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
    throw ViewerError(isOfInput ? this->ExplainReading(text) : text);
  }
}

//------------------------------------------------------------------------------
void TerrainScene::CheckExaggeration()
{
  // A higher terrain would be a needle without visible detail.
  const double maximumHeights = 100.0; // per width
  double bounds[6];
  this->Mesh->GetBounds(bounds);
  const double width = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  double range[2];
  this->Source->GetHeightMap()->GetRange(range);
  const double relief =
    std::abs(this->Source->GetDisplacement()->GetScale()) * (range[1] - range[0]);
  // Larger values are missing-data markers.
  const double highestHeights = 1e6;
  if (!this->Options.Exaggeration && !*this->Source->GetCoordinateSystem() &&
    relief < highestHeights * width)
  {
    this->ChooseExaggeration(relief, width);
    return;
  }
  const double exaggeration = this->Source->GetExaggeration();
  if (relief > maximumHeights * width)
  {
    std::ostringstream message;
    message << std::setprecision(3) << this->Options.Input << ": --exaggeration " << exaggeration
            << " makes the terrain " << relief / width << " times as high as wide, but at most "
            << maximumHeights << " times is allowed; use at most --exaggeration "
            << std::abs(exaggeration) * maximumHeights * width / relief
            << ". The heights range from " << range[0] << " to " << range[1]
            << ": if one of these is a missing value, name it with --no-data-value";
    throw ViewerError(message.str());
  }
}

//------------------------------------------------------------------------------
void TerrainScene::ChooseExaggeration(double heights, double width)
{
  const double maximumHeights = 1.0; // per width
  const double chosenHeights = 0.2;
  if (heights <= maximumHeights * width)
  {
    return;
  }
  // Two digits are easy to read and to change.
  std::ostringstream digits;
  digits << std::setprecision(2) << chosenHeights * width / heights;
  this->Source->SetExaggeration(std::stod(digits.str()));
  std::ostringstream message;
  message << std::setprecision(3) << this->Options.Input << ": --exaggeration " << digits.str()
          << " is chosen, because "
          << (this->CountsTexels()
                 ? "there is no georeference (texels are taken as 1 m wide)"
                 : "there is no coordinate system (coordinates are taken as metres)")
          << " and the heights in metres would be " << heights / width << " times the width";
  this->ExaggeratedBy = message.str();
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
std::string TerrainScene::ExplainReading(const std::string& text)
{
  // GDAL opens Exodus files as netCDF. Other files may be meshes in a format without a reader.
  const std::string advice = AdviseFormat(this->Options.Input, GetMeshFormats());
  const bool isExodus = advice.find("Exodus") != std::string::npos;
  const bool isUnknown = text.find("recogni") != std::string::npos && !advice.empty();
  return isExodus || isUnknown
    ? "Cannot read " + this->Options.Input + ": it cannot be read as a height map" + advice + "."
    : text;
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
  const bool isFine = (metric == Metric::Distance || metric == Metric::ScreenEdge ||
                        (metric == Metric::Height && !this->Options.Tolerance)) &&
    this->Options.Budget == 0;
  const int highest = this->Recipe->GetMaximumLevel();
  const int lowest = this->Options.UniformLevel ? highest : isFine ? std::max(highest - 1, 0) : 0;
  this->Camera = std::make_unique<TerrainCamera>(
    this->Renderer, *this->Probe, this->Source->GetDisplacement(), lowest, highest);
  this->Camera->Update();
}

//------------------------------------------------------------------------------
int TerrainScene::GetDefaultLevel()
{
  const int highest = 7;
  if (this->Options.Tolerance)
  {
    return highest;
  }
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
vtkSmartPointer<vtkDepthTagMetric> TerrainScene::MakeReliefMetric()
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
    const auto colours = MakeHeightColours(this->Source->GetHeightMap()->GetRange());
    image = MakeHypsometricTint(this->Source->GetHeightMap(), colours);
    if (this->Options.Color == ViewerOptions::ColorType::Own)
    {
      this->AddLegend(colours, HeightName, this->GetHeightUnit(), 5);
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
std::optional<std::array<double, 3>> TerrainScene::GetCentre()
{
  if (this->Options.CenterDegrees)
  {
    return this->FindDegrees(*this->Options.CenterDegrees);
  }
  if (!this->Options.Center)
  {
    return std::nullopt;
  }
  const std::vector<double>& place = *this->Options.Center;
  if (place.size() == 3)
  {
    return { { { place[0], place[1], place[2] } } };
  }
  std::ostringstream text;
  text << place[0] << "," << place[1];
  if (this->IsInRaster(place[0], place[1]))
  {
    this->Messages.Warn("--center " + text.str() +
      " is taken as metres from the raster's centre; for degrees, use --center " +
      ToText(place[0], 'E', 'W') + "," + ToText(place[1], 'N', 'S'));
  }
  return this->FindGround(place[0], place[1], text.str());
}

//------------------------------------------------------------------------------
bool TerrainScene::IsInRaster(double longitude, double latitude)
{
  const double degrees[3] = { longitude, latitude, 0.0 };
  double place[3];
  double height;
  return this->Source->IsGeographic() && this->Source->MapToTerrain(degrees, place) &&
    this->Probe->GetHeight(place[0], place[1], height);
}

//------------------------------------------------------------------------------
std::array<double, 3> TerrainScene::FindDegrees(const std::array<double, 2>& degrees)
{
  const double geographic[3] = { degrees[0], degrees[1], 0.0 };
  double place[3];
  if (!*this->Source->GetCoordinateSystem())
  {
    throw ViewerError(this->Options.Input +
      " has no coordinate system, so --center cannot be in degrees; give X,Y in texels from its "
      "centre");
  }
  const std::string text = ToText(degrees[0], 'E', 'W') + "," + ToText(degrees[1], 'N', 'S');
  if (!this->Source->GeographicToTerrain(geographic, place))
  {
    throw ViewerError(this->Options.Input + " has no height at --center " + text +
      ", which is too far away; write degrees as 86.925E,27.988N");
  }
  return this->FindGround(place[0], place[1], text);
}

//------------------------------------------------------------------------------
std::array<double, 3> TerrainScene::FindGround(double x, double y, const std::string& text)
{
  double height;
  if (!this->Probe->GetHeight(x, y, height))
  {
    double bounds[6];
    this->Mesh->GetBounds(bounds);
    std::ostringstream message;
    message << this->Options.Input << " has no height at --center " << text
            << "; its x ranges from " << bounds[0] << " to " << bounds[1] << ", its y from "
            << bounds[2] << " to " << bounds[3] << ". Give X,Y in "
            << (*this->Source->GetCoordinateSystem()
                   ? "metres from its centre, degrees such as 86.925E,27.988N"
                   : "texels from its centre")
            << ", or X,Y,Z for a point without terrain";
    throw ViewerError(message.str());
  }
  vtkDisplacement* displacement = this->Source->GetDisplacement();
  return { { x, y, displacement->GetOffset() + displacement->GetScale() * height } };
}

//------------------------------------------------------------------------------
std::string TerrainScene::GetUnit()
{
  return *this->Source->GetCoordinateSystem() ? "m" : "";
}

//------------------------------------------------------------------------------
std::string TerrainScene::GetHeightUnit()
{
  if (this->GetUnit().empty() || this->Source->GetExaggeration() == 0.0)
  {
    return "";
  }
  const double metres =
    this->Source->GetDisplacement()->GetScale() / this->Source->GetExaggeration();
  const auto isUnit = [=](double length) { return std::abs(metres - length) < 1e-5 * length; };
  return isUnit(1.0) ? "m" : isUnit(0.3048) ? "ft" : "";
}

//------------------------------------------------------------------------------
std::string TerrainScene::Describe(const double point[3], double resolution)
{
  const std::string unit = this->GetUnit().empty() ? "" : " " + this->GetUnit();
  std::string text = "x " + FormatNumber(point[0], resolution) + unit + "  y " +
    FormatNumber(point[1], resolution) + unit;
  double height;
  if (this->Probe->GetHeight(point[0], point[1], height))
  {
    const std::string heightUnit = this->GetHeightUnit();
    text +=
      "  height " + FormatNumber(height, resolution) + (heightUnit.empty() ? "" : " " + heightUnit);
  }
  double map[3];
  if (this->Source->TerrainToMap(point, map))
  {
    const double metresInDegree = 111320.0;
    const bool isGeographic = this->Source->IsGeographic();
    const bool isKnown = *this->Source->GetCoordinateSystem();
    const double exactness = isGeographic ? resolution / metresInDegree : resolution;
    text += std::string(isGeographic ? "\nlongitude "
                : isKnown            ? "\neast "
                                     : "\ncolumn ") +
      FormatNumber(map[0], exactness) +
      (isGeographic ? "  latitude "
          : isKnown ? "  north "
                    : "  row ") +
      FormatNumber(map[1], exactness);
  }
  return text;
}

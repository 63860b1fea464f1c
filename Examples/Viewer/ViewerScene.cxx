// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerScene.h"

#include "ViewerLegend.h"
#include "ViewerMetric.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementView.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkScalarBarActor.h"
#include "vtkTerrainSource.h"
#include "vtkTexture.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <vector>

namespace
{
// Colours over the range of heights, in the manner of relief maps: green lowlands to white summits.
vtkSmartPointer<vtkImageData> MakeHypsometricTint(vtkHeightField* heights)
{
  const int largestTexture = 4096;
  vtkNew<vtkColorTransferFunction> tint;
  tint->AddRGBPoint(0.00, 0.27, 0.47, 0.29);
  tint->AddRGBPoint(0.20, 0.53, 0.64, 0.39);
  tint->AddRGBPoint(0.40, 0.83, 0.79, 0.55);
  tint->AddRGBPoint(0.60, 0.70, 0.55, 0.37);
  tint->AddRGBPoint(0.80, 0.58, 0.49, 0.44);
  tint->AddRGBPoint(1.00, 0.97, 0.97, 0.97);
  const int numberOfColours = 256;
  std::vector<double> colours(3 * numberOfColours);
  tint->GetTable(0.0, 1.0, numberOfColours, colours.data());

  int size[2];
  double range[2];
  heights->GetDimensions(size);
  heights->GetRange(range);
  size[0] = std::min(size[0], largestTexture);
  size[1] = std::min(size[1], largestTexture);
  const double toColour = range[1] > range[0] ? (numberOfColours - 1) / (range[1] - range[0]) : 0.0;

  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  vtkSMPTools::For(0, size[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < size[0]; ++column)
        {
          const double height = heights->GetHeight((column + 0.5) / size[0], (row + 0.5) / size[1]);
          const int index = static_cast<int>(std::lround(toColour * (height - range[0])));
          const double* colour = &colours[3 * std::min(std::max(index, 0), numberOfColours - 1)];
          unsigned char* pixel = pixels + 3 * (row * size[0] + column);
          std::transform(colour, colour + 3, pixel,
            [](double value) { return static_cast<unsigned char>(std::lround(255.0 * value)); });
        }
      }
    });
  return image;
}

// Each band from its darkest to its 98th percentile, as raw satellite bands are usually shown. The
// terrain source's grey, where the imagery does not reach, stays.
vtkSmartPointer<vtkImageData> StretchContrast(vtkImageData* image)
{
  const unsigned char nothing[3] = { 128, 128, 128 };
  auto stretched = vtkSmartPointer<vtkImageData>::New();
  stretched->DeepCopy(image);
  auto* begin = static_cast<unsigned char*>(stretched->GetScalarPointer());
  auto* end = begin + 3 * stretched->GetNumberOfPoints();

  std::array<std::array<vtkIdType, 256>, 3> histograms{};
  vtkIdType numberOfPixels = 0;
  for (const unsigned char* pixel = begin; pixel != end; pixel += 3)
  {
    if (!std::equal(pixel, pixel + 3, nothing))
    {
      ++numberOfPixels;
      for (int band = 0; band < 3; ++band)
      {
        ++histograms[band][pixel[band]];
      }
    }
  }

  std::array<std::array<unsigned char, 256>, 3> tables;
  for (int band = 0; band < 3; ++band)
  {
    const auto percentile = [&](double percent)
    {
      vtkIdType count = 0;
      int value = 0;
      while (value < 255 && (count += histograms[band][value]) < 0.01 * percent * numberOfPixels)
      {
        ++value;
      }
      return value;
    };
    const int low = percentile(0.1);
    const int high = std::max(percentile(98.0), low + 1);
    for (int value = 0; value < 256; ++value)
    {
      tables[band][value] =
        static_cast<unsigned char>(std::min(std::max(255 * (value - low) / (high - low), 0), 255));
    }
  }

  for (unsigned char* pixel = begin; pixel != end; pixel += 3)
  {
    if (!std::equal(pixel, pixel + 3, nothing))
    {
      for (int band = 0; band < 3; ++band)
      {
        pixel[band] = tables[band][pixel[band]];
      }
    }
  }
  return stretched;
}

void AddLight(vtkRenderer* renderer, double azimuth, double elevation, double intensity)
{
  const double a = vtkMath::RadiansFromDegrees(azimuth);
  const double e = vtkMath::RadiansFromDegrees(elevation);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e));
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}
}

//------------------------------------------------------------------------------
ViewerScene::ViewerScene(const ViewerOptions& options, ViewerMessages& messages)
  : Options(options)
  , Messages(messages)
{
  this->Messages.Observe(this->Source, "reading");
  this->Messages.Observe(this->Recipe);
  this->Messages.Observe(this->Mapper, "refining");

  this->ReadTerrain();
  this->Recipe->SetMaximumLevel(options.MaximumLevel.value_or(this->GetDefaultLevel()));
  this->Recipe->SetDisplacement(this->Source->GetDisplacement());
  this->SetLevels();

  this->Mapper->SetInputData(this->Mesh);
  this->Mapper->SetRefinement(this->Recipe);
  this->Mapper->SetTargetNumberOfTriangles(options.Budget);
  this->Actor->SetMapper(this->Mapper);
  if (options.Wireframe)
  {
    this->Actor->GetProperty()->SetRepresentationToWireframe();
  }
  this->SetColours();
  this->SetLevelColours();
  this->SetLights();
  this->Renderer->AddActor(this->Actor);
  this->SetCamera();
}

//------------------------------------------------------------------------------
ViewerScene::~ViewerScene() = default;

//------------------------------------------------------------------------------
void ViewerScene::ReadTerrain()
{
  this->Source->SetFileName(this->Options.HeightMap.c_str());
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
  if (this->Options.FillNoData)
  {
    this->Source->SetNoDataPolicyToFill();
  }
  this->Source->SetExaggeration(this->Options.Exaggeration);
  this->Source->Update();
  this->Messages.Check();
  this->Mesh->ShallowCopy(this->Source->GetOutput());
  if (this->Mesh->GetNumberOfCells() == 0)
  {
    throw ViewerError(this->Options.HeightMap + " has no terrain to draw");
  }

  // The coarse mesh as the displacement moves it: what the camera and the metrics look at.
  vtkDisplacement* displacement = this->Source->GetDisplacement();
  vtkHeightField* heights = displacement->GetHeightMap();
  vtkDataArray* coordinates = this->Mesh->GetPointData()->GetTCoords();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(this->Mesh->GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    point[2] += displacement->GetOffset() +
      displacement->GetScale() *
        heights->GetHeight(coordinates->GetComponent(i, 0), coordinates->GetComponent(i, 1));
    points->SetPoint(i, point);
  }
  this->DisplacedMesh->ShallowCopy(this->Mesh);
  this->DisplacedMesh->SetPoints(points);
  this->DisplacedMesh->GetPointData()->SetNormals(nullptr); // those of the flat mesh
}

//------------------------------------------------------------------------------
int ViewerScene::GetDefaultLevel()
{
  // As fine as the height map; a picture that nobody can walk into needs nothing below its pixels.
  int size[2];
  this->Source->GetHeightMap()->GetDimensions(size);
  const int texels = std::max(size[0], size[1]);
  const int squares = std::min(this->Source->GetResolution(), texels);
  int segments = texels;
  if (!this->Options.Output.empty() && this->Options.Export.empty())
  {
    segments = std::min(segments, std::max(this->Options.Size[0], this->Options.Size[1]));
  }
  int level = static_cast<int>(std::ceil(std::log2(static_cast<double>(segments) / squares)));
  // Only what touches the camera gets the full level of the distance metric.
  if (this->Options.Metric == ViewerOptions::MetricType::Distance)
  {
    ++level;
  }
  return std::min(std::max(level, 0), 7);
}

//------------------------------------------------------------------------------
void ViewerScene::SetLevels()
{
  this->Recipe->SetMetric(MakeMetric(this->Options, this->DisplacedMesh, this->Messages));
  if (this->Options.PerEdge)
  {
    this->Recipe->SetLevelRuleToPerEdge();
  }
  if (this->Options.WholeSegments)
  {
    this->Recipe->SetSegmentPolicyToWholeNumbers();
  }
  if (!this->Options.Geomorphing)
  {
    this->Recipe->GeomorphingOff();
  }
}

//------------------------------------------------------------------------------
void ViewerScene::SetLevelColours()
{
  std::string title = "Level";
  switch (this->Options.Color)
  {
    case ViewerOptions::ColorType::Terrain:
      return;
    case ViewerOptions::ColorType::Level:
      this->Mapper->SetColorModeToLevel();
      break;
    case ViewerOptions::ColorType::Pattern:
      this->Mapper->SetColorModeToPattern();
      title = "Pattern";
      break;
    case ViewerOptions::ColorType::Metric:
      this->Mapper->SetColorModeToMetric();
      title = "Metric";
      break;
  }
  this->Actor->SetTexture(nullptr);
  if (auto legend = MakeLegend(this->Mapper, title, this->Options.Size[1]))
  {
    this->Renderer->AddViewProp(legend);
  }
}

//------------------------------------------------------------------------------
void ViewerScene::SetColours()
{
  vtkSmartPointer<vtkImageData> image = this->Source->GetImagery();
  const bool isPhotograph = image != nullptr;
  if (!isPhotograph)
  {
    image = MakeHypsometricTint(this->Source->GetDisplacement()->GetHeightMap());
  }
  else if (this->Options.Stretch)
  {
    image = StretchContrast(image);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOff();
  texture->EdgeClampOn();
  this->Actor->SetTexture(texture);

  // A photograph has shadows of its own.
  vtkProperty* property = this->Actor->GetProperty();
  property->SetAmbient(isPhotograph ? 0.30 : 0.15);
  property->SetDiffuse(isPhotograph ? 0.80 : 0.85);
  property->SetInterpolationToPhong();
}

//------------------------------------------------------------------------------
void ViewerScene::SetLights()
{
  // From the north-west, as on maps, and a little from the other side.
  this->Renderer->AutomaticLightCreationOff();
  AddLight(this->Renderer, 315.0, 40.0, 1.0);
  AddLight(this->Renderer, 160.0, 50.0, 0.35);
  this->Renderer->GradientBackgroundOn();
  this->Renderer->SetBackground(0.86, 0.90, 0.94);
  this->Renderer->SetBackground2(0.42, 0.58, 0.78);
}

//------------------------------------------------------------------------------
void ViewerScene::SetCamera()
{
  const double azimuth = vtkMath::RadiansFromDegrees(192.0); // from a little west of south
  const double elevation = vtkMath::RadiansFromDegrees(38.0);
  // Share of the picture that the terrain may take up; a legend wants its own.
  const double filled = this->Options.Color == ViewerOptions::ColorType::Terrain ? 0.94 : 0.82;
  const double forward[3] = { -std::sin(azimuth) * std::cos(elevation),
    -std::cos(azimuth) * std::cos(elevation), -std::sin(elevation) };
  const double vertical[3] = { 0.0, 0.0, 1.0 };
  double right[3];
  double up[3];
  vtkMath::Cross(forward, vertical, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, up);

  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double tanY = filled * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  const double tanX = tanY * this->Options.Size[0] / this->Options.Size[1];

  // The nearest position from which every point is inside the four planes of the view: a point
  // (x, y, z) along right, up and forward needs |x - X| <= tanX (z - Z), |y - Y| <= tanY (z - Z).
  double limits[4];
  std::fill_n(limits, 4, -std::numeric_limits<double>::infinity());
  vtkPoints* points = this->DisplacedMesh->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    const double x = vtkMath::Dot(point, right);
    const double y = vtkMath::Dot(point, up);
    const double z = vtkMath::Dot(point, forward);
    limits[0] = std::max(limits[0], x - tanX * z);
    limits[1] = std::max(limits[1], -x - tanX * z);
    limits[2] = std::max(limits[2], y - tanY * z);
    limits[3] = std::max(limits[3], -y - tanY * z);
  }
  const double X = 0.5 * (limits[0] - limits[1]);
  const double Y = 0.5 * (limits[2] - limits[3]);
  const double Z = -0.5 * std::max((limits[0] + limits[1]) / tanX, (limits[2] + limits[3]) / tanY);
  double centre[3];
  points->GetData()->Modified();
  this->DisplacedMesh->GetCenter(centre);
  const double distance = vtkMath::Dot(centre, forward) - Z;
  double position[3];
  double focus[3];
  for (int i = 0; i < 3; ++i)
  {
    position[i] = X * right[i] + Y * up[i] + Z * forward[i];
    focus[i] = position[i] + distance * forward[i];
  }
  camera->SetPosition(position);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(vertical);
  this->Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void ViewerScene::Export(const std::string& fileName)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  this->Messages.Observe(filter, "refining");
  filter->SetInputData(this->Mesh);
  filter->SetRefinement(this->Recipe);
  filter->SetCamera(this->Renderer->GetActiveCamera());
  filter->SetViewportSize(this->Options.Size[0], this->Options.Size[1]);
  // Nothing moves in a file: every vertex in its own place.
  const int geomorphing = this->Recipe->GetGeomorphing();
  this->Recipe->GeomorphingOff();
  filter->Update();
  this->Recipe->SetGeomorphing(geomorphing);
  this->Messages.Check();

  vtkNew<vtkXMLPolyDataWriter> writer;
  this->Messages.Observe(writer, "writing");
  writer->SetInputData(filter->GetOutput());
  writer->SetFileName(fileName.c_str());
  const bool isWritten = writer->Write() == 1;
  this->Messages.Check();
  if (!isWritten)
  {
    throw ViewerError("cannot write " + fileName);
  }
}

//------------------------------------------------------------------------------
void ViewerScene::PrintStatistics(vtkRenderWindow* window, std::ostream& stream)
{
  using Clock = std::chrono::steady_clock;
  const int numberOfFrames = 5;
  // A camera that moves, though hardly: levels are chosen anew for every frame.
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double position = camera->GetViewAngle();
  std::vector<double> milliseconds;
  window->Render();
  for (int i = 0; i < numberOfFrames; ++i)
  {
    camera->SetViewAngle(position * (1.0 + 1e-6 * (i + 1)));
    window->WaitForCompletion();
    const auto start = Clock::now();
    window->Render();
    window->WaitForCompletion();
    milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  camera->SetViewAngle(position);
  window->Render();
  this->Messages.Check();
  std::sort(milliseconds.begin(), milliseconds.end());

  stream << std::fixed << std::setprecision(1) << "coarse faces: " << this->Mesh->GetNumberOfCells()
         << "\n"
         << "culled faces: " << this->Mapper->GetNumberOfCulledFaces() << "\n"
         << "drawn triangles: " << this->Mapper->GetNumberOfDrawnTriangles() << "\n"
         << "patterns: " << this->Mapper->GetNumberOfUsedPatterns() << "\n"
         << "draw calls: " << this->Mapper->GetNumberOfDrawCalls() << "\n"
         << "graphics memory: " << this->Mapper->GetGraphicsMemorySize() / 1048576.0 << " MiB\n"
         << "selection time: " << 1000.0 * this->Mapper->GetSelectionTime() << " ms\n"
         << "frame time: " << milliseconds[numberOfFrames / 2] << " ms" << std::endl;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/PyramidScene.h"

#include "Files/FlightFile.h"
#include "Files/RasterEnd.h"
#include "Options/Palettes.h"
#include "Scene/FlightCheck.h"
#include "Scene/GlobeCamera.h"
#include "Scene/PassiveObserver.h"
#include "Scene/PyramidGround.h"
#include "Scene/TerrainCamera.h"
#include "Scene/TerrainExport.h"
#include "Scene/TerrainPlace.h"
#include "Scene/ViewerStatistics.h"
#include "Text/ReadingGuard.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainContourLabels.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <utility>
#include <vector>

namespace
{
const int Vertical = 2;
const double ColorOfWalls[3] = { 0.85, 0.74, 0.58 };
const vtkTypeInt64 MiB = 1 << 20;
// The index of smaller rasters is built in a moment.
const long long SmallRaster = 1 << 24; // samples
const int FadingDelay = 20;            // milliseconds, while new tiles become visible
const int WaitingDelay = 200;          // milliseconds, while nothing changes
}

//------------------------------------------------------------------------------
std::unique_ptr<PyramidScene> PyramidScene::Open(
  const ViewerOptions& options, ViewerMessages& messages)
{
  std::unique_ptr<PyramidScene> scene;
  std::string error = options.Input + " has no terrain to draw: all heights are missing values";
  bool isReady = false;
  try
  {
    const ReadingGuard guard(options.Imagery.empty()
        ? std::vector<std::string>{ options.Input }
        : std::vector<std::string>{ options.Input, options.Imagery });
    CheckRasterEnd(options.Input, messages);
    vtkNew<vtkTerrainPyramid> pyramid;
    messages.Observe(pyramid, "indexing");
    pyramid->SetFileName(options.Input.c_str());
    if (pyramid->Update())
    {
      scene.reset(new PyramidScene(options, messages, pyramid));
      isReady = scene->HasTerrain();
    }
    messages.Check();
  }
  catch (const ViewerError& reported)
  {
    isReady = false;
    error = reported.what();
  }
  if (isReady)
  {
    scene->Show();
    return scene;
  }
  if (!options.TiledBy.empty())
  {
    throw ViewerError(ExplainRasterError(options.Input, error));
  }
  return nullptr;
}

//------------------------------------------------------------------------------
PyramidScene::PyramidScene(
  const ViewerOptions& options, ViewerMessages& messages, vtkTerrainPyramid* pyramid)
  : ViewerScene(options, messages)
  , Pyramid(pyramid)
{
  int size[2];
  pyramid->GetDimensions(size);
  this->IsSmall = static_cast<long long>(size[0]) * size[1] <= SmallRaster;
  messages.Observe(this->Mapper);
  this->Mapper->SetPyramid(pyramid);
  if (options.Globe)
  {
    this->Mapper->SetFrameToGeocentric();
  }
  if (!options.Imagery.empty())
  {
    this->Mapper->SetImageryFileName(options.Imagery.c_str());
  }
}

//------------------------------------------------------------------------------
PyramidScene::~PyramidScene() = default;

//------------------------------------------------------------------------------
void PyramidScene::ResetView()
{
  if (!this->Options.Globe)
  {
    this->SetCamera();
  }
}

//------------------------------------------------------------------------------
SceneContent PyramidScene::GetContent()
{
  SceneContent content;
  if (this->Colours)
  {
    content.Range.emplace();
    std::array<double, 2> range;
    this->Pyramid->GetRange(range.data());
    content.Range = this->Options.Range.value_or(range);
  }
  return content;
}

//------------------------------------------------------------------------------
SceneFigures PyramidScene::GetFigures()
{
  return { { "triangles", static_cast<double>(this->Mapper->GetNumberOfDrawnTriangles()) },
    { "error-px", this->Mapper->GetScreenSpaceErrorInUse() },
    { "memory", static_cast<double>(this->Mapper->GetResidentMemorySize()) } };
}

//------------------------------------------------------------------------------
OptionNames PyramidScene::GetUpdatedOptions()
{
  // On a globe, the directions of lights and views are local.
  if (this->Options.Globe)
  {
    return { "--contours", "--error", "--palette", "--range", "--wireframe" };
  }
  OptionNames names = this->ViewerScene::GetUpdatedOptions();
  names.insert({ "--contours", "--error", "--palette", "--range", "--wireframe" });
  return names;
}

//------------------------------------------------------------------------------
bool PyramidScene::ApplyOptions(const OptionNames& changed)
{
  if (changed.count("--palette") || changed.count("--range"))
  {
    using Type = ViewerOptions::ColorType;
    if (!this->Colours || this->Options.SeaLevel ||
      (this->Options.Color != Type::Own && this->Options.Color != Type::Height))
    {
      return false;
    }
    this->Colours->ShallowCopy(this->MakeColoursOfHeights());
    this->Colours->SetNanColor(0.75, 0.75, 0.75);
    this->HasEstimates = !this->Options.Range && !this->Pyramid->IsErrorKnown();
  }
  this->Mapper->SetScreenSpaceError(this->Options.Error.value_or(1.0));
  this->Mapper->SetContourInterval(this->Options.Contours.value_or(0.0));
  this->Options.Wireframe ? this->Actor->GetProperty()->SetRepresentationToWireframe()
                          : this->Actor->GetProperty()->SetRepresentationToSurface();
  return this->ViewerScene::ApplyOptions(changed);
}

//------------------------------------------------------------------------------
bool PyramidScene::HasTerrain()
{
  const bool isWindow = this->Options.Output.empty() && this->Options.Export.empty();
  if (!this->Pyramid->IsErrorKnown() && !this->IsSmall)
  {
    this->Messages.Tell(this->Options.Input + ": building the index, which reads the file once" +
      (isWindow ? ". Until it is complete, --error is an estimate" : ""));
    this->Messages.ShowNotes();
  }
  const bool mustWait = this->IsSmall || !isWindow;
  return (!mustWait || this->Pyramid->WaitForIndex()) &&
    vtkBoundingBox(this->Mapper->GetBounds()).IsValid();
}

//------------------------------------------------------------------------------
void PyramidScene::Show()
{
  this->Ground = std::make_unique<PyramidGround>(this->Pyramid);
  this->ChooseExaggeration();
  this->SetBase();
  this->WarnOfData();
  this->Mapper->SetScreenSpaceError(this->Options.Error.value_or(1.0));
  if (this->Options.Memory)
  {
    // Heights for queries have a share.
    const vtkTypeInt64 bytes = *this->Options.Memory * MiB;
    const vtkTypeInt64 queries = std::min(bytes / 8, 64 * MiB);
    this->Pyramid->SetMemoryLimit(queries);
    this->Mapper->SetMemoryLimit(bytes - queries);
  }
  this->Mapper->SetContourInterval(this->Options.Contours.value_or(0.0));
  this->SetColours();
  this->Actor->SetMapper(this->Mapper);
  if (this->Options.Wireframe)
  {
    this->Actor->GetProperty()->SetRepresentationToWireframe();
  }
  this->Renderer->AddActor(this->Actor);
  if (this->Options.ContourLabels)
  {
    vtkNew<vtkTerrainContourLabels> labels;
    labels->SetActor(this->Actor);
    this->Renderer->AddViewProp(labels);
  }
  AddPassiveObserver(this->Mapper, vtkCommand::StartEvent,
    [this](void*)
    {
      this->HasMore = false;
      this->UpdateColours();
    });
  AddPassiveObserver(
    this->Mapper, vtkCommand::UpdateEvent, [this](void*) { this->HasMore = true; });
  // Light from the north-west, as on maps, and weaker light from the other side.
  std::vector<ViewerLamp> lamps = { { { 315.0, 40.0, Vertical }, 1.0 },
    { { 160.0, 50.0, Vertical }, 0.35 } };
  if (this->Options.Base)
  {
    lamps.push_back({ { 0.0, -90.0, Vertical }, 0.4 }); // for the bottom
  }
  this->SetLights(std::move(lamps));
  if (this->Options.Globe)
  {
    this->SetGlobeCamera();
  }
  else
  {
    this->SetCamera();
  }
}

//------------------------------------------------------------------------------
void PyramidScene::SetBase()
{
  if (!this->Options.Base)
  {
    return;
  }
  double range[2];
  this->Pyramid->GetRange(range);
  if (this->Pyramid->IsErrorKnown() && *this->Options.Base >= range[0])
  {
    std::ostringstream text;
    text << this->Options.Input << ": --base is " << *this->Options.Base
         << ", but it must be below the terrain, whose lowest height is " << range[0];
    throw ViewerError(text.str());
  }
  this->Messages.Name("BaseHeight", "--base");
  this->Mapper->SetBaseHeight(*this->Options.Base);
  this->Mapper->UseBaseOn();
  this->Actor->GetProperty()->SetColor(ColorOfWalls[0], ColorOfWalls[1], ColorOfWalls[2]);
}

//------------------------------------------------------------------------------
void PyramidScene::ChooseExaggeration()
{
  TerrainShape shape;
  this->Pyramid->GetRange(shape.Range);
  const std::array<double, 4> extent = this->Ground->GetExtent();
  shape.Width = std::max(extent[1] - extent[0], extent[3] - extent[2]);
  shape.Relief = this->Options.Exaggeration.value_or(1.0) * this->Ground->GetVerticalUnit() *
    (shape.Range[1] - shape.Range[0]);
  shape.HasCoordinateSystem = this->Ground->HasCoordinateSystem();
  shape.CountsSamples = this->Ground->CountsSamples();
  const double exaggeration = FindExaggeration(this->Options, shape, this->ExaggeratedBy);
  this->Mapper->SetExaggeration(exaggeration);
  this->Ground->SetExaggeration(exaggeration);
}

//------------------------------------------------------------------------------
void PyramidScene::WarnOfData()
{
  this->Messages.Name("set it as ImageryFileName", "use --imagery");
  this->Messages.Name("gdal_translate -a_nodata", "--no-data-value");
  for (const std::string& warning : { std::string(this->Pyramid->GetLocationWarning()),
         std::string(this->Pyramid->GetSampleWarning()) })
  {
    if (!warning.empty())
    {
      this->Messages.Warn(this->Options.Input + this->Messages.Rename(warning));
    }
  }
}

//------------------------------------------------------------------------------
void PyramidScene::SetColours()
{
  using Type = ViewerOptions::ColorType;
  if (!this->Options.Imagery.empty())
  {
    // Photographs contain shadows.
    this->Actor->GetProperty()->SetAmbient(0.30);
    this->Actor->GetProperty()->SetDiffuse(0.80);
    return;
  }
  std::array<double, 2> range{};
  std::string title = "Height";
  std::string unit = GetHeightUnit(*this->Ground);
  std::string palette;
  switch (this->Options.Color)
  {
    case Type::Slope:
      this->Mapper->SetColorModeToSlope();
      title = "Slope";
      unit = "degrees";
      range = { { 0.0, 90.0 } };
      palette = "heat";
      break;
    case Type::Aspect:
      this->Mapper->SetColorModeToAspect();
      title = "Aspect";
      unit = "degrees from north";
      range = { { 0.0, 360.0 } };
      palette = "cyclic";
      break;
    case Type::Hillshade:
      this->Mapper->SetColorModeToHillshade();
      return;
    default:
      this->Mapper->SetColorModeToElevation();
  }
  const auto colours = palette.empty()
    ? this->MakeColoursOfHeights()
    : MakePalette(this->Options.Palette.empty() ? palette : this->Options.Palette,
        this->Options.Range.value_or(range));
  colours->SetNanColor(0.75, 0.75, 0.75); // aspects of plains
  this->Mapper->SetLookupTable(colours);
  this->AddLegend(this->Mapper->GetLegendLookupTable(), title, unit, 5, this->Options.SeaLevel);
  // Estimates are replaced once the index is complete.
  this->HasEstimates = title == "Height" && !this->Options.Range && !this->Pyramid->IsErrorKnown();
  this->Colours = colours;
  // The colours of angles must be recognized on dark sides, too.
  const double ambient = title == "Height" ? 0.15 : 0.5;
  this->Actor->GetProperty()->SetAmbient(ambient);
  this->Actor->GetProperty()->SetDiffuse(1.0 - ambient);
}

//------------------------------------------------------------------------------
void PyramidScene::UpdateColours()
{
  if (this->HasEstimates && this->Pyramid->IsErrorKnown())
  {
    this->HasEstimates = false;
    this->Colours->ShallowCopy(this->MakeColoursOfHeights());
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> PyramidScene::MakeColoursOfHeights()
{
  std::array<double, 2> range;
  this->Pyramid->GetRange(range.data());
  range = this->Options.Range.value_or(range);
  if (this->Options.SeaLevel)
  {
    const double seaLevel = *this->Options.SeaLevel;
    this->Mapper->UseSeaLevelOn();
    this->Mapper->SetSeaLevel(seaLevel);
    this->Mapper->SetWaterLookupTable(
      MakePalette("water", { { std::min(range[0], seaLevel), seaLevel } }));
    range = { { seaLevel, std::max(range[1], seaLevel) } };
  }
  return MakePalette(this->Options.Palette.empty() ? "relief" : this->Options.Palette, range);
}

//------------------------------------------------------------------------------
void PyramidScene::SetCamera()
{
  const auto centre = FindCentre(this->Options, *this->Ground, this->Messages);
  vtkNew<vtkPoints> outline;
  outline->SetDataTypeToDouble();
  this->Ground->AddOutline(outline);
  if (this->Options.Base)
  {
    const double* bounds = this->Mapper->GetBounds();
    for (int corner = 0; corner < 4; ++corner)
    {
      outline->InsertNextPoint(bounds[corner % 2], bounds[2 + corner / 2], bounds[4]);
    }
  }
  this->FitView(outline, { 192.0, 38.0, Vertical }); // slightly west of south
  if (centre)
  {
    MoveFocus(this->Renderer, *centre);
  }
  else if (this->Options.Zoom != 1.0)
  {
    // Moves closer to the surface, but not into it.
    const auto place =
      this->Ground->FindFirst(this->Renderer->GetActiveCamera(), this->Mapper->GetBounds());
    if (place)
    {
      this->Renderer->GetActiveCamera()->SetFocalPoint(place->data());
    }
  }
  this->Zoom();
  auto camera = std::make_unique<TerrainCamera>(this->Renderer, *this->Ground);
  this->GroundCamera = camera.get();
  this->Camera = std::move(camera);
  this->Camera->Update();
}

//------------------------------------------------------------------------------
std::string PyramidScene::GetUnit()
{
  return this->Ground->HasCoordinateSystem() ? "m" : "";
}

//------------------------------------------------------------------------------
std::string PyramidScene::Describe(const double point[3], double resolution)
{
  if (this->Options.Globe)
  {
    double geographic[3];
    double place[2];
    return this->Mapper->WorldToGeographic(point, geographic) &&
        this->Ground->FromDegrees(geographic, place)
      ? DescribePlace(
          *this->Ground, std::array<double, 3>{ { place[0], place[1], 0.0 } }.data(), resolution)
      : "";
  }
  return DescribePlace(*this->Ground, point, resolution);
}

//------------------------------------------------------------------------------
void PyramidScene::Export(const std::string& fileName)
{
  ExportTerrain(
    this->Options, this->Mapper, this->Renderer->GetActiveCamera(), fileName, this->Messages);
}

//------------------------------------------------------------------------------
void PyramidScene::Report()
{
  if (!this->ExaggeratedBy.empty())
  {
    std::cout << this->ExaggeratedBy << std::endl;
  }
}

//------------------------------------------------------------------------------
void PyramidScene::Draw(vtkRenderWindow* window)
{
  const bool isWindow = window->GetInteractor() != nullptr;
  if (!isWindow || this->IsSmall)
  {
    this->Mapper->SetLoadingModeToComplete();
  }
  if (this->Options.Statistics)
  {
    this->PrintStatistics(window);
  }
  else
  {
    window->Render();
    this->Messages.Check();
  }
  if (isWindow)
  {
    this->Mapper->SetLoadingModeToBackground();
  }
  ++this->NumberOfPictures;
  this->NumberOfEmptyPictures += this->Mapper->GetNumberOfDrawnTriangles() == 0 ? 1 : 0;
  this->LargestError = std::max(this->LargestError, this->Mapper->GetScreenSpaceErrorInUse());
}

//------------------------------------------------------------------------------
void PyramidScene::CheckPictures()
{
  const std::string empty = std::to_string(this->NumberOfEmptyPictures);
  const std::string all = std::to_string(this->NumberOfPictures);
  const bool isFlight = !this->Options.Flight.empty();
  if (isFlight && this->NumberOfEmptyPictures == this->NumberOfPictures)
  {
    throw ViewerError(this->Options.Flight + ": none of the " + all +
      " positions sees the terrain of " + this->Options.Input +
      "; check longitudes, latitudes, headings and pitches");
  }
  if (isFlight && this->NumberOfEmptyPictures > 0)
  {
    this->Messages.Warn(this->Options.Flight + ": " + empty + " of " + all +
      " pictures show no terrain of " + this->Options.Input);
  }
  const double requested = this->Mapper->GetScreenSpaceError();
  if (this->LargestError > requested * (1.0 + 1e-6))
  {
    std::ostringstream text;
    text << std::setprecision(3) << this->Options.Input << ": the error is " << this->LargestError
         << " pixels, but --error is " << requested << "; a larger --memory reduces the error";
    this->Messages.Warn(text.str());
  }
}

//------------------------------------------------------------------------------
void PyramidScene::PrintStatistics(vtkRenderWindow* window)
{
  const double milliseconds = MeasureFrame(this->Renderer, window, this->Messages);
  std::cout << "drawn triangles: " << this->Mapper->GetNumberOfDrawnTriangles() << "\n"
            << std::fixed << std::setprecision(3)
            << "error: " << this->Mapper->GetScreenSpaceErrorInUse() << " pixels\n"
            << std::setprecision(1)
            << "terrain memory: " << this->Mapper->GetResidentMemorySize() / 1048576.0 << " MiB\n"
            << "frame time: " << milliseconds << " ms" << std::endl;
}

//------------------------------------------------------------------------------
std::optional<int> PyramidScene::GetFrameDelay()
{
  if (!this->HasMore)
  {
    return std::nullopt;
  }
  double progress = this->Pyramid->GetIndexProgress();
  this->Pyramid->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  const double error = this->Mapper->GetScreenSpaceErrorInUse();
  const vtkTypeInt64 memory = this->Mapper->GetResidentMemorySize();
  const bool isSame = error == this->LastError && memory == this->LastMemory;
  this->LastError = error;
  this->LastMemory = memory;
  return isSame ? WaitingDelay : FadingDelay;
}

//------------------------------------------------------------------------------
bool PyramidScene::FindDirections(const std::array<double, 3>& geographic,
  std::array<double, 3>& place, std::array<std::array<double, 3>, 3>& directions)
{
  const double step = 1e-5; // degrees
  const auto convert = [&](double latitude, double height, std::array<double, 3>& point)
  {
    const double moved[3] = { geographic[0], geographic[1] + latitude, geographic[2] + height };
    return this->Mapper->GeographicToWorld(moved, point.data());
  };
  // Near a pole, the step must not cross it.
  const double side = geographic[1] > 0.0 ? -step : step;
  std::array<double, 3> north;
  std::array<double, 3> up;
  if (!convert(0.0, 0.0, place) || !convert(side, 0.0, north) || !convert(0.0, 1.0, up))
  {
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    north[i] = side > 0.0 ? north[i] - place[i] : place[i] - north[i];
    up[i] -= place[i];
  }
  vtkMath::Normalize(up.data());
  std::array<double, 3> east;
  vtkMath::Cross(north.data(), up.data(), east.data());
  vtkMath::Normalize(east.data());
  vtkMath::Cross(up.data(), east.data(), north.data());
  directions = { { east, north, up } };
  return true;
}

//------------------------------------------------------------------------------
void PyramidScene::SetGlobeCamera()
{
  double middle[2] = { 0.0, 0.0 };
  std::array<double, 2> degrees;
  if (!this->Ground->ToRaster(middle, degrees.data()) ||
    (!this->Ground->IsGeographic() && !this->Ground->ToDegrees(middle, degrees.data())))
  {
    throw ViewerError(this->Options.Input + " has no coordinate system; --globe needs one");
  }
  degrees = this->Options.CenterDegrees.value_or(degrees);
  const auto ground = FindCentre(this->Options, *this->Ground, this->Messages);
  const double height = ground ? (*ground)[2] / this->Mapper->GetExaggeration() : 0.0;
  std::array<double, 3> focus;
  std::array<std::array<double, 3>, 3> directions;
  if (!this->FindDirections({ { degrees[0], degrees[1], height } }, focus, directions))
  {
    throw ViewerError(this->Options.Input + " has no coordinate system; --globe needs one");
  }
  const auto turn = [&](const std::array<double, 3>& vector)
  {
    std::array<double, 3> turned{};
    for (int i = 0; i < 3; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        turned[i] += vector[axis] * directions[axis][i];
      }
    }
    return turned;
  };
  vtkLightCollection* lights = this->Renderer->GetLights();
  lights->InitTraversal();
  while (vtkLight* light = lights->GetNextItem())
  {
    const double* from = light->GetPosition();
    light->SetPosition(turn({ { from[0], from[1], from[2] } }).data());
  }
  const vtkBoundingBox box(this->Mapper->GetBounds());
  if (!this->Options.CenterDegrees)
  {
    box.GetCenter(focus.data());
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const std::array<double, 2> view =
    this->Options.View.value_or(std::array<double, 2>{ { 180.0, 60.0 } });
  const double elevation = std::clamp(view[1], -89.9999, 89.9999);
  const std::array<double, 3> away =
    turn(ViewerDirection{ view[0], elevation, Vertical }.GetVector());
  const double half = vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle());
  // A region is seen as large as on a map, the whole globe as a sphere.
  const std::array<double, 4> extent = this->Ground->GetExtent();
  const double region = 0.5 * std::hypot(extent[1] - extent[0], extent[3] - extent[2]);
  const double distance = std::min(region, 0.55 * box.GetMaxLength()) / std::sin(half);
  camera->SetPosition(
    focus[0] + distance * away[0], focus[1] + distance * away[1], focus[2] + distance * away[2]);
  camera->SetFocalPoint(focus.data());
  camera->SetViewUp(directions[2].data());
  this->Zoom();
  auto aboveGround = std::make_unique<GlobeCamera>(this->Renderer, this->Mapper);
  this->EarthCamera = aboveGround.get();
  this->Camera = std::move(aboveGround);
  this->Camera->Update();
}

//------------------------------------------------------------------------------
void PyramidScene::CheckFlight(const std::vector<FlightPosition>& positions)
{
  if (this->Ground->HasCoordinateSystem())
  {
    CheckFlightPositions(
      this->Options.Flight, positions, this->Options.Input, this->Pyramid, this->Messages);
  }
}

//------------------------------------------------------------------------------
void PyramidScene::LookFrom(const FlightPosition& position)
{
  std::array<double, 3> eye;
  std::array<std::array<double, 3>, 3> directions;
  if (!this->FindDirections(
        { { position.Longitude, position.Latitude, position.Height } }, eye, directions))
  {
    throw ViewerError(this->Options.Flight + ", line " + std::to_string(position.Line) + ": " +
      this->Options.Input + " has no coordinates at this longitude and latitude");
  }
  const auto& [east, north, up] = directions;
  const double heading = vtkMath::RadiansFromDegrees(position.Heading);
  const double pitch = vtkMath::RadiansFromDegrees(position.Pitch);
  // The near plane depends on the distance of the focal point.
  double distance = vtkBoundingBox(this->Mapper->GetBounds()).GetDiagonalLength();
  if (this->Options.Globe)
  {
    const double degrees[2] = { position.Longitude, position.Latitude };
    double place[2];
    double height = 0.0;
    const bool isOver = this->Ground->FromDegrees(degrees, place) &&
      this->Ground->GetHeight(place[0], place[1], height);
    const double ground = isOver ? this->Ground->GetVerticalUnit() * height : 0.0;
    distance = std::max(1.0, std::abs(position.Height - ground));
  }
  std::array<double, 3> focus;
  std::array<double, 3> top;
  for (int i = 0; i < 3; ++i)
  {
    const double ahead = std::sin(heading) * east[i] + std::cos(heading) * north[i];
    focus[i] = eye[i] + distance * (std::cos(pitch) * ahead + std::sin(pitch) * up[i]);
    top[i] = std::cos(pitch) * up[i] - std::sin(pitch) * ahead;
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focus.data());
  camera->SetViewUp(top.data());
  if (this->GroundCamera)
  {
    this->GroundCamera->StayInPlace();
  }
  if (this->EarthCamera)
  {
    this->EarthCamera->StayInPlace();
  }
  this->Renderer->ResetCameraClippingRange();
}

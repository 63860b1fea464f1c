// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainExport.h"

#include "Files/ViewerExport.h"
#include "Text/ViewerMessages.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
const int VerticalAxis = 2;
const vtkTypeInt64 BytesPerMiB = 1 << 20;
const int LargestPicture = 8192;    // pixels per side; most programs draw textures of this size
const double LargestRounding = 0.1; // as a share of the tolerance

// The messages of the class name its methods.
void NameExportOptions(const std::string& input, ViewerMessages& messages)
{
  const std::string advice = "Crop it (gdal_translate -projwin) or use a larger --tolerance";
  messages.Name("The region", input);
  messages.Name("a MaximumError of", "--tolerance");
  messages.Name("Choose a smaller region or a larger error", advice);
  messages.Name("For full detail, raise MaximumImagerySize",
    "For full detail, export parts of the raster (gdal_translate -projwin)");
}

// The rounding of floats in bounds around the origin, at most.
double BoundRounding(const double bounds[6], const std::array<double, 3>& origin)
{
  double squares = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    const double distance = std::abs(bounds[i] - origin[i / 2]);
    squares = std::max(squares, distance * distance);
  }
  return 0.5 * std::sqrt(3.0 * squares) * std::numeric_limits<float>::epsilon();
}

void SetOptions(vtkTerrainMeshSource* source, const ViewerOptions& options, vtkCamera* camera,
  double rounding, bool hasPicture)
{
  if (options.Globe)
  {
    source->SetFrameToGeocentric();
  }
  if (options.Memory)
  {
    source->SetMemoryLimit(*options.Memory * BytesPerMiB);
  }
  if (options.Tolerance)
  {
    // Positions move along slopes by about the same distance.
    source->SetMaximumError(
      *options.Tolerance - std::min(2.0 * rounding, LargestRounding * *options.Tolerance));
  }
  else
  {
    source->SetCamera(camera);
    source->SetViewportSize(options.Size);
    source->SetScreenSpaceError(options.Error.value_or(1.0));
  }
  source->SetUseBase(options.Base.has_value());
  source->SetBaseHeight(options.Base.value_or(0.0));
  if (hasPicture)
  {
    source->SetImageryFileName(options.Imagery.c_str());
    source->SetMaximumImagerySize(LargestPicture);
  }
}

// The name in quotation marks that WKT begins with.
std::string GetSystemName(const std::string& wkt)
{
  const std::size_t begin = wkt.find('"');
  return begin == std::string::npos ? ""
                                    : wkt.substr(begin + 1, wkt.find('"', begin + 1) - begin - 1);
}

std::string JoinNumbers(const double* numbers, int count)
{
  std::ostringstream text;
  text << std::setprecision(12);
  for (int i = 0; i < count; ++i)
  {
    text << (i == 0 ? "" : ", ") << numbers[i];
  }
  return text.str();
}

// Two digits are enough for an error; it is rounded up.
std::string RoundUpError(double error)
{
  if (!(error > 0.0))
  {
    return "0";
  }
  const double unit = std::pow(10.0, std::floor(std::log10(error)) - 1.0);
  std::ostringstream text;
  text << std::setprecision(3) << std::ceil(error / unit) * unit;
  return text.str();
}

std::string DescribeFrame(
  const ViewerOptions& options, vtkTerrainPyramid* pyramid, const ExportedMesh& mesh)
{
  const std::string name = GetSystemName(pyramid->GetCoordinateSystem());
  if (options.Globe)
  {
    const bool isMoved = mesh.Origin != std::array<double, 3>{ { 0.0, 0.0, 0.0 } };
    return "metres from the centre of the ellipsoid of " + name +
      ", z to the north pole, x to longitude 0" +
      (isMoved ? "; the origin of the file is at " + JoinNumbers(mesh.Origin.data(), 3) : "");
  }
  vtkDataArray* origin = mesh.Mesh->GetFieldData()->GetArray("Origin");
  double center[3];
  origin->GetTuple(0, center);
  return (name.empty() ? "x to the right, y upwards" : "metres, x east, y north") +
    std::string(", z up; (0, 0) is at ") + JoinNumbers(center, 2) +
    (name.empty() ? " of the raster" : " in " + name);
}

// The largest distance of a position from its floats.
double FindRounding(const ExportedMesh& mesh)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < mesh.Mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh.Mesh->GetPoint(i, point);
    double squares = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double position = point[axis] - mesh.Origin[axis];
      const double distance = position - static_cast<double>(static_cast<float>(position));
      squares += distance * distance;
    }
    largest = std::max(largest, squares);
  }
  return std::sqrt(largest);
}

std::string DescribeError(
  const ViewerOptions& options, vtkTerrainMeshSource* source, const std::string& unit)
{
  return options.Tolerance ? "at most " + RoundUpError(source->GetMaximumErrorInUse()) + unit +
      " above or below the raster"
                           : "in this view at most " +
      RoundUpError(source->GetScreenSpaceErrorInUse()) + " pixels above or below the raster";
}

// Writes a mesh with comments that describe it.
void WriteTerrainMesh(const ViewerOptions& options, vtkTerrainMeshSource* source,
  ExportedMesh& mesh, const std::string& fileName, ViewerMessages& messages)
{
  vtkTerrainPyramid* pyramid = source->GetPyramid();
  const bool hasFloats = HasFloats(fileName);
  const std::string unit = *pyramid->GetCoordinateSystem() ? " m" : "";
  const std::string frame = DescribeFrame(options, pyramid, mesh);
  const std::string error = DescribeError(options, source, unit);
  mesh.Comments = { error, "coordinates: " + frame };
  WriteMesh(mesh, fileName, messages);
  std::cout << fileName << ": " << mesh.Mesh->GetNumberOfCells() << " triangles, " << error
            << "\ncoordinates: " << frame << "\n";
  const double rounding = hasFloats ? FindRounding(mesh) : 0.0;
  if (hasFloats)
  {
    std::cout << "rounding of coordinates to floats: at most " << RoundUpError(rounding) << unit
              << "\n";
  }
  if (mesh.Picture)
  {
    const int* size = mesh.Picture->GetDimensions();
    std::cout << "picture: " << size[0] << " x " << size[1] << " pixels\n";
  }
  std::cout << std::flush;
  if (options.Tolerance && rounding > LargestRounding * *options.Tolerance)
  {
    messages.Warn("floats round the coordinates in " + fileName + " by up to " +
      RoundUpError(rounding) + unit + "; a .vtp file has doubles");
  }
}
}

//------------------------------------------------------------------------------
void ExportTerrain(const ViewerOptions& options, vtkTerrainMapper* mapper, vtkCamera* camera,
  const std::string& fileName, ViewerMessages& messages)
{
  const bool hasPicture = !options.Imagery.empty() && CanHavePicture(fileName);
  const bool hasFloats = HasFloats(fileName);
  ExportedMesh mesh;
  mesh.UpAxis = VerticalAxis;
  double bounds[6];
  mapper->GetBounds(bounds);
  for (int axis = 0; options.Globe && hasFloats && axis < 3; ++axis)
  {
    mesh.Origin[axis] = std::round(0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]));
  }
  if (!options.Imagery.empty() && !hasPicture)
  {
    messages.Warn(
      fileName + " is written without the picture of --image; .glb and .obj files contain it");
  }
  NameExportOptions(options.Input, messages);
  vtkNew<vtkTerrainMeshSource> source;
  messages.Observe(source, "refining");
  source->SetPyramid(mapper->GetPyramid());
  source->SetExaggeration(mapper->GetExaggeration());
  SetOptions(
    source, options, camera, hasFloats ? BoundRounding(bounds, mesh.Origin) : 0.0, hasPicture);
  source->Update();
  messages.Check();
  mesh.Mesh = source->GetOutput();
  if (mesh.Mesh->GetNumberOfCells() == 0)
  {
    throw ViewerError(options.Input +
      (options.Tolerance ? " has no terrain to export" : " has no terrain in this view"));
  }
  if (hasPicture)
  {
    mesh.Picture = source->GetImagery();
  }
  WriteTerrainMesh(options, source, mesh, fileName, messages);
}

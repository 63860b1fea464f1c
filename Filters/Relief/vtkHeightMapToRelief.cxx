// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightMapToRelief.h"

#include "Arrays/ImageExtents.h"
#include "Changes/LatestTime.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Data/Relief.h"
#include "Data/ReliefColors.h"
#include "Data/ReliefNormals.h"
#include "Data/TerrainTexels.h"
#include "Geodesy/TerrainFrame.h"
#include "Raster/RasterDescription.h"
#include "vtkFloatArray.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkHeightMapToRelief);

namespace
{
constexpr double LargestExaggeration = VTK_FLOAT_MAX;
constexpr int MaximumTexels = 64; // per sample and direction

// Returns heights, NaN where data is missing. Returns an empty vector if `goesOn`, which receives
// the progress, returns false.
std::vector<double> ReadTexels(vtkHeightField* heights, const relevo::TerrainTexels& texels,
  const int texelSize[2], const std::function<bool(double)>& goesOn)
{
  int size[2];
  heights->GetDimensions(size);
  const float* samples = heights->GetSamples();
  const unsigned char* validity = heights->GetValidity();
  const auto getHeight = [&](int column, int row)
  {
    const auto uv = texels.GetParameters(column, row);
    // The sample that contains the texel.
    const int i = uv ? std::min(static_cast<int>(uv->x * size[0]), size[0] - 1) : -1;
    const int j = uv ? std::min(static_cast<int>(uv->y * size[1]), size[1] - 1) : -1;
    const std::size_t sample = static_cast<std::size_t>(j) * size[0] + i;
    if (!uv || (validity && !validity[sample]))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return texels.AreSamples() ? samples[sample] : heights->GetHeight(uv->x, uv->y);
  };
  std::vector<double> result(static_cast<std::size_t>(texelSize[0]) * texelSize[1]);
  constexpr int rowsAtOnce = 64;
  for (int first = 0; first < texelSize[1]; first += rowsAtOnce)
  {
    if (!goesOn(static_cast<double>(first) / texelSize[1]))
    {
      return {};
    }
    vtkSMPTools::For(first, std::min(first + rowsAtOnce, texelSize[1]),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int row = static_cast<int>(begin); row < end; ++row)
        {
          for (int column = 0; column < texelSize[0]; ++column)
          {
            result[static_cast<std::size_t>(row) * texelSize[0] + column] = getHeight(column, row);
          }
        }
      });
  }
  return result;
}

// Returns depths below the highest point, which defines the relief's plane.
vtkSmartPointer<vtkFloatArray> MakeDepths(
  const std::vector<double>& heights, double top, double scale)
{
  auto depths = vtkSmartPointer<vtkFloatArray>::New();
  depths->SetName(relevo::Relief::GetDepthName());
  depths->SetNumberOfTuples(static_cast<vtkIdType>(heights.size()));
  std::transform(heights.begin(), heights.end(), depths->GetPointer(0),
    [=](double height) { return static_cast<float>(top - scale * height); });
  return depths;
}

double FindTop(const std::vector<double>& heights, double scale)
{
  double top = -std::numeric_limits<double>::infinity();
  for (double height : heights)
  {
    top = height == height ? std::max(top, scale * height) : top; // ignores NaN
  }
  return std::isfinite(top) ? top : 0.0;
}

std::string MakeColors(
  vtkImageData* imagery, const relevo::TerrainTexels& texels, vtkImageData* output)
{
  const int* size = imagery->GetDimensions();
  vtkDataArray* given = imagery->GetPointData()->GetScalars();
  if (size[2] != 1 || !given || given->GetNumberOfTuples() != imagery->GetNumberOfPoints())
  {
    return "The imagery must have n x m x 1 points with their colours as point scalars.";
  }
  std::string error;
  const auto colors = relevo::ConvertColors(given, error);
  if (!colors)
  {
    return error;
  }
  const int* texelSize = output->GetDimensions();
  const relevo::ColorSampler sampler(colors, size, texelSize);
  auto result = vtkSmartPointer<vtkUnsignedCharArray>::New();
  result->SetName(relevo::Relief::GetColorName());
  result->SetNumberOfComponents(colors->GetNumberOfComponents());
  result->SetNumberOfTuples(output->GetNumberOfPoints());
  vtkSMPTools::For(0, texelSize[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        for (int column = 0; column < texelSize[0]; ++column)
        {
          const vtkIdType texel = static_cast<vtkIdType>(row) * texelSize[0] + column;
          const auto uv = texels.GetParameters(column, row);
          sampler.Sample(uv ? *uv : relevo::dvec2(0.5),
            result->GetPointer(texel * result->GetNumberOfComponents()));
        }
      }
    });
  output->GetPointData()->SetScalars(result);
  return "";
}
}

vtkHeightMapToRelief::vtkHeightMapToRelief() = default;

vtkHeightMapToRelief::~vtkHeightMapToRelief() = default;

vtkCxxSetSmartPointerMacro(vtkHeightMapToRelief, HeightMap, vtkHeightField);

vtkHeightField* vtkHeightMapToRelief::GetHeightMap()
{
  return this->HeightMap;
}

void vtkHeightMapToRelief::SetExaggeration(double exaggeration)
{
  relevo::SetInRange(this, "Exaggeration", this->Exaggeration, exaggeration, -LargestExaggeration,
    LargestExaggeration);
}

void vtkHeightMapToRelief::SetTexelsPerSample(int texels)
{
  relevo::SetInRange(this, "TexelsPerSample", this->TexelsPerSample, texels, 1, MaximumTexels);
}

vtkMTimeType vtkHeightMapToRelief::GetMTime()
{
  return relevo::GetLatestTime(this->Superclass::GetMTime(), { this->HeightMap });
}

int vtkHeightMapToRelief::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

std::string vtkHeightMapToRelief::ReadHeights()
{
  if (!this->HeightMap)
  {
    return "There is no height map: call SetHeightMap().";
  }
  if (!this->HeightMap->Update())
  {
    const std::string reason = this->HeightMap->GetErrorMessage();
    return "The height map could not be read" + (reason.empty() ? "." : ": " + reason);
  }
  return "";
}

// The size depends on the heights, so they are read here.
int vtkHeightMapToRelief::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const std::string error = this->ReadHeights();
  if (!error.empty())
  {
    vtkImageData::GetData(outputVector)->Initialize();
    vtkErrorMacro(<< error);
    return 0;
  }
  int size[2];
  this->HeightMap->GetDimensions(size);
  relevo::SetImageSize(outputVector->GetInformationObject(0), size[0] * this->TexelsPerSample,
    size[1] * this->TexelsPerSample);
  return 1;
}

// Requests the whole imagery.
int vtkHeightMapToRelief::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  relevo::RequestWholeExtent(inputVector[0]->GetInformationObject(0));
  return 1;
}

int vtkHeightMapToRelief::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  std::string error = this->ReadHeights();
  const auto build = [&]
  { error = error.empty() ? this->Build(vtkImageData::GetData(inputVector[0]), output) : error; };
  if (!relevo::FitsMemory(build))
  {
    error = "Not enough memory for the relief.";
  }
  if (!error.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< error);
    return 0;
  }
  return 1;
}

std::string vtkHeightMapToRelief::Build(vtkImageData* imagery, vtkImageData* output)
{
  int size[2];
  this->HeightMap->GetDimensions(size);
  relevo::Georeference location;
  location.SetSize(size[0], size[1]);
  double scale = this->Exaggeration;
  auto* map = vtkHeightMap::SafeDownCast(this->HeightMap);
  if (map)
  {
    if (!map->UpdateInformation())
    {
      return "The height map could not be read: " + std::string(map->GetErrorMessage());
    }
    location = map->Describe().Location;
    scale *= map->Describe().VerticalUnit;
    const std::string error = map->GetImageData() ? "" : relevo::FindLocationError(location);
    if (!error.empty())
    {
      return map->GetFileName() + error;
    }
  }
  const relevo::TerrainFrame frame(location);
  const relevo::TerrainTexels texels(frame, size, this->TexelsPerSample);
  const int texelSize[2] = { size[0] * this->TexelsPerSample, size[1] * this->TexelsPerSample };
  const std::vector<double> heights = ReadTexels(this->HeightMap, texels, texelSize,
    [this](double share)
    {
      this->UpdateProgress(share);
      return !relevo::IsAborted(this);
    });
  if (heights.empty())
  {
    return ""; // aborted
  }
  const double top = FindTop(heights, scale);
  const auto depths = MakeDepths(heights, top, scale);
  output->SetDimensions(texelSize[0], texelSize[1], 1);
  output->GetPointData()->AddArray(depths);
  relevo::dmat4 matrix = texels.GetMatrix();
  matrix[2].z = -1.0;
  matrix[3].z = top;
  relevo::Relief::Describe(output, relevo::ReliefProjection::Parallel, matrix);
  if (imagery)
  {
    const std::string error = MakeColors(imagery, texels, output);
    if (!error.empty())
    {
      return error;
    }
  }
  else
  {
    output->GetPointData()->SetScalars(relevo::MakeDepthColors(depths));
  }
  relevo::Relief relief;
  const std::string error = relief.Read(output);
  if (error.empty() && this->ComputeNormals)
  {
    output->GetPointData()->SetNormals(relevo::ComputeReliefNormals(relief));
  }
  return error;
}

void vtkHeightMapToRelief::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HeightMap: " << this->HeightMap << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "TexelsPerSample: " << this->TexelsPerSample << "\n";
  os << indent << "ComputeNormals: " << (this->ComputeNormals ? "On" : "Off") << "\n";
}

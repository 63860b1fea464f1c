// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceLineIntegralConvolution.h"

#include "Arrays/VectorData.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Image/ForwardedSettings.h"
#include "Image/LICPassSettings.h"
#include "Image/LICStretch.h"
#include "Noise/SolidNoise.h"
#include "Surface/SurfaceConvolution.h"
#include "Surface/SurfaceField.h"
#include "Surface/SurfaceTexels.h"
#include "Surface/SurfaceVectors.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace
{
constexpr int LargestTexture = 16384;

double FindMeanEdge(const relevo::SurfaceVectors& vectors)
{
  const relevo::SurfaceTriangles& surface = vectors.GetTriangles();
  double sum = 0.0;
  for (const auto& edge : vectors.GetEdges().GetEdges())
  {
    double a[3];
    double b[3];
    surface.GetPoint(edge.MergedPoints[0], a);
    surface.GetPoint(edge.MergedPoints[1], b);
    sum += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
  }
  return sum / std::max(vectors.GetEdges().GetNumberOfEdges(), 1);
}

// Returns the range of values at points that are not masked.
relevo::vec2 FindRange(vtkFloatArray* values, vtkUnsignedCharArray* mask)
{
  relevo::vec2 range(1.0f, 0.0f);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    if (!mask->GetValue(i))
    {
      range.x = std::min(range.x, values->GetValue(i));
      range.y = std::max(range.y, values->GetValue(i));
    }
  }
  return range;
}

// Creates the texels if a texture is requested. Returns an error as a sentence, or "".
std::string MakeTexels(const int size[2], const relevo::SurfaceTriangles& surface,
  vtkPolyData* input, std::unique_ptr<relevo::SurfaceTexels>& texels)
{
  if (size[0] == 0)
  {
    return {};
  }
  vtkDataArray* coordinates = input->GetPointData()->GetTCoords();
  if (!coordinates || coordinates->GetNumberOfComponents() < 2 ||
    coordinates->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    return "The input has no texture coordinates, which TextureSize requires.";
  }
  texels = std::make_unique<relevo::SurfaceTexels>(size, surface, coordinates);
  return texels->GetNumberOfCoveredTexels() > 0
    ? ""
    : "No texel of the " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " texture has its centre in a triangle of the texture coordinates. Raise TextureSize.";
}

vtkSmartPointer<vtkUnsignedCharArray> MakeBytes(const char* name, vtkIdType size)
{
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetName(name);
  bytes->SetNumberOfTuples(size);
  return bytes;
}
}

vtkStandardNewMacro(vtkSurfaceLineIntegralConvolution);

vtkSurfaceLineIntegralConvolution::vtkSurfaceLineIntegralConvolution()
  : LICSettings(vtkSmartPointer<vtkLICSettings>::New())
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::VECTORS);
}

vtkSurfaceLineIntegralConvolution::~vtkSurfaceLineIntegralConvolution() = default;

int vtkSurfaceLineIntegralConvolution::FillOutputPortInformation(
  int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

int vtkSurfaceLineIntegralConvolution::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int* size = this->TextureSize;
  const int extent[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, size[0] > 0 && size[1] > 0 ? 0 : -1 };
  vtkInformation* texture = outputVector->GetInformationObject(1);
  texture->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(texture, VTK_UNSIGNED_CHAR, 1);
  return 1;
}

int vtkSurfaceLineIntegralConvolution::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkImageData* texture = vtkImageData::GetData(outputVector, 1);
  texture->Initialize();
  const std::string error = relevo::FindContrastError(this->LICSettings);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  const relevo::SurfaceField field =
    relevo::FindSurfaceField(input, this->GetInputArrayInformation(0));
  if (!field.Vectors)
  {
    vtkErrorMacro("The input " << field.Error << ".");
    return 0;
  }
  bool complete = false;
  if (!relevo::FitsMemory([&] { complete = this->Run(input, field, output, texture); }))
  {
    vtkErrorMacro("Not enough memory for " << input->GetNumberOfCells() << " cells and "
                                           << this->TextureSize[0] << " x " << this->TextureSize[1]
                                           << " texels.");
  }
  if (!complete)
  {
    output->Initialize();
    texture->Initialize();
  }
  return complete || relevo::IsAborted(this) ? 1 : 0;
}

bool vtkSurfaceLineIntegralConvolution::Run(
  vtkPolyData* input, const relevo::SurfaceField& field, vtkPolyData* output, vtkImageData* texture)
{
  const relevo::SurfaceVectors vectors(
    input, field.Vectors, field.IsCellData, this->LICSettings->GetNoDataMagnitude());
  const relevo::SurfaceTriangles& surface = vectors.GetTriangles();
  if (surface.GetTriangles().empty())
  {
    vtkErrorMacro("The input has no polygons.");
    return false;
  }
  std::unique_ptr<relevo::SurfaceTexels> texels;
  const std::string error = MakeTexels(this->TextureSize, surface, input, texels);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }

  const double grainSize = this->GrainSize > 0.0 ? this->GrainSize : FindMeanEdge(vectors);
  const double unit = this->LICSettings->GetNormalizeVectors() ? 1.0 : vectors.GetLongest();
  const relevo::LICKernel kernel = relevo::MakeLICKernel(this->LICSettings,
    this->StepSize > 0.0 ? this->StepSize * unit : this->LICSettings->GetStepSize() * grainSize);
  const relevo::SolidNoise noise(grainSize, this->LICSettings->GetNoiseGeneratorSeed());
  const relevo::SurfaceConvolution convolution(vectors, noise, kernel);

  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  const auto mask = MakeBytes("LICMask", numberOfPoints);
  this->MaskPoints(input, field, vectors, mask);
  vtkNew<vtkFloatArray> values;
  values->SetName("LIC");
  values->SetNumberOfTuples(numberOfPoints);
  const bool complete = this->ForParts(numberOfPoints, 0.1, texels ? 0.5 : 1.0,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        double x[3];
        surface.GetPoint(point, x);
        values->SetValue(point,
          mask->GetValue(point) ? noise.GetValue(x)
                                : convolution.GetValueAt(surface.GetMergedPoint(point)));
      }
    });
  if (!complete)
  {
    return false;
  }

  std::function<float(float)> contrast = [](float value) { return value; };
  if (this->LICSettings->EnhancesLICContrast())
  {
    const relevo::vec2 range = FindRange(values, mask);
    const relevo::vec2 factors(
      static_cast<float>(this->LICSettings->GetLowLICContrastEnhancementFactor()),
      static_cast<float>(this->LICSettings->GetHighLICContrastEnhancementFactor()));
    contrast = [=](float value) { return relevo::licStretch(value, range, factors); };
    for (vtkIdType point = 0; point < numberOfPoints; ++point)
    {
      if (!mask->GetValue(point))
      {
        values->SetValue(point, contrast(values->GetValue(point)));
      }
    }
  }
  if (texels && !this->ConvolveTexels(*texels, vectors, convolution, contrast, texture))
  {
    return false;
  }
  output->ShallowCopy(input);
  output->GetPointData()->AddArray(mask);
  output->GetPointData()->SetScalars(values);
  return true;
}

void vtkSurfaceLineIntegralConvolution::MaskPoints(vtkPolyData* input,
  const relevo::SurfaceField& field, const relevo::SurfaceVectors& vectors,
  vtkUnsignedCharArray* mask)
{
  const relevo::SurfaceTriangles& surface = vectors.GetTriangles();
  const double noData = this->LICSettings->GetNoDataMagnitude();
  const double threshold = this->LICSettings->GetMaskThreshold();
  const auto isMasked = [&](vtkIdType tuple)
  {
    double v[3];
    field.Vectors->GetTuple(tuple, v);
    return !relevo::IsVectorData(v, 3, noData) || vtkMath::Norm(v) <= threshold;
  };
  vtkSMPTools::For(0, input->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        bool masked = true;
        surface.ForEachTriangleIndex(surface.GetMergedPoint(point),
          [&](vtkIdType triangle)
          {
            masked = masked &&
              (vectors.IsBlocked(static_cast<int>(triangle)) ||
                isMasked(field.IsCellData ? surface.GetCell(triangle) : point));
          });
        mask->SetValue(point, masked ? 1 : 0);
      }
    });
}

bool vtkSurfaceLineIntegralConvolution::ConvolveTexels(const relevo::SurfaceTexels& texels,
  const relevo::SurfaceVectors& vectors, const relevo::SurfaceConvolution& convolution,
  const std::function<float(float)>& contrast, vtkImageData* texture)
{
  const auto values = MakeBytes("LIC", texels.GetNumberOfTexels());
  const bool complete = this->ForParts(texels.GetNumberOfTexels(), 0.5, 1.0,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType texel = begin; texel < end; ++texel)
      {
        const int triangle = texels.GetTriangle(texel);
        if (triangle >= 0)
        {
          const float value = convolution.GetValueInside(triangle, texels.GetWeights(texel));
          values->SetValue(texel,
            static_cast<unsigned char>(
              std::lround(255.0f * (vectors.IsBlocked(triangle) ? value : contrast(value)))));
        }
      }
    });
  if (!complete)
  {
    return false;
  }
  const std::vector<vtkIdType> nearest = texels.FindNearestCovered();
  for (vtkIdType texel = 0; texel < texels.GetNumberOfTexels(); ++texel)
  {
    values->SetValue(texel, values->GetValue(nearest[texel]));
  }
  texture->SetExtent(0, this->TextureSize[0] - 1, 0, this->TextureSize[1] - 1, 0, 0);
  texture->GetPointData()->SetScalars(values);
  return true;
}

// Works in parallel. Splits the work into parts to report progress and check for an abort.
bool vtkSurfaceLineIntegralConvolution::ForParts(vtkIdType size, double shareFrom, double shareTo,
  const std::function<void(vtkIdType, vtkIdType)>& work)
{
  constexpr int parts = 20;
  for (int part = 0; part < parts; ++part)
  {
    this->UpdateProgress(shareFrom + (shareTo - shareFrom) * part / parts);
    if (relevo::IsAborted(this))
    {
      return false;
    }
    vtkSMPTools::For(part * size / parts, (part + 1) * size / parts, work);
  }
  return true;
}

//------------------------------------------------------------------------------
// Settings

relevoLICSettingsMacro(vtkSurfaceLineIntegralConvolution);

vtkMTimeType vtkSurfaceLineIntegralConvolution::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->LICSettings->GetMTime());
}

relevoForwardMacro(vtkSurfaceLineIntegralConvolution, NumberOfSteps, int);
relevoForwardMacro(vtkSurfaceLineIntegralConvolution, NormalizeVectors, bool);
relevoForwardMacro(vtkSurfaceLineIntegralConvolution, NoiseGeneratorSeed, int);
relevoForwardMacro(vtkSurfaceLineIntegralConvolution, LowLICContrastEnhancementFactor, double);
relevoForwardMacro(vtkSurfaceLineIntegralConvolution, HighLICContrastEnhancementFactor, double);
relevoForwardMacro(vtkSurfaceLineIntegralConvolution, MaskThreshold, double);
relevoForwardMacro(vtkSurfaceLineIntegralConvolution, NoDataMagnitude, double);
relevoForwardMacro(vtkSurfaceLineIntegralConvolution, OrientedLIC, bool);
relevoForwardMacro(vtkSurfaceLineIntegralConvolution, Phase, double);
relevoForwardGreyContrastMacro(vtkSurfaceLineIntegralConvolution);

void vtkSurfaceLineIntegralConvolution::SetStepSize(double size)
{
  relevo::SetInRange(this, "StepSize", this->StepSize, size, 0.0, relevo::LargestDouble);
}

void vtkSurfaceLineIntegralConvolution::SetGrainSize(double size)
{
  relevo::SetInRange(this, "GrainSize", this->GrainSize, size, 0.0, relevo::LargestDouble);
}

void vtkSurfaceLineIntegralConvolution::SetTextureSize(int width, int height)
{
  int(&size)[2] = this->TextureSize;
  const bool isNone = width == 0 && height == 0;
  if (!isNone && (std::min(width, height) < 1 || std::max(width, height) > LargestTexture))
  {
    vtkErrorMacro("TextureSize must be 0 x 0 or from 1 x 1 to "
      << LargestTexture << " x " << LargestTexture << ", got " << width << " x " << height << ".");
  }
  else if (size[0] != width || size[1] != height)
  {
    size[0] = width;
    size[1] = height;
    this->Modified();
  }
}

void vtkSurfaceLineIntegralConvolution::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StepSize: " << this->StepSize << "\n";
  os << indent << "GrainSize: " << this->GrainSize << "\n";
  os << indent << "TextureSize: " << this->TextureSize[0] << " x " << this->TextureSize[1] << "\n";
  os << indent << "LICSettings:\n";
  this->LICSettings->PrintSelf(os, indent.GetNextIndent());
}

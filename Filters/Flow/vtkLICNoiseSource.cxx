// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLICNoiseSource.h"

#include "Noise/GrainNoise.h"
#include "Noise/NoiseHash.h"
#include "Noise/NoiseRanges.h"
#include "Noise/PerlinNoise.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
constexpr double LargestSmoothing = 100.0;
}

vtkStandardNewMacro(vtkLICNoiseSource);

vtkLICNoiseSource::vtkLICNoiseSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkLICNoiseSource::~vtkLICNoiseSource() = default;

std::string vtkLICNoiseSource::FindError() const
{
  const auto isShare = [](double value) { return value >= 0.0 && value <= 1.0; };
  std::ostringstream error;
  if (this->NoiseType < NOISE_TYPE_UNIFORM || this->NoiseType > NOISE_TYPE_PERLIN)
  {
    error << "NoiseType " << this->NoiseType << " is none of UNIFORM (0), GAUSSIAN (1), PERLIN (2)";
  }
  else if (this->NoiseTextureSize < relevo::SmallestNoiseTexture ||
    this->NoiseTextureSize > relevo::LargestNoiseTexture)
  {
    error << "NoiseTextureSize " << this->NoiseTextureSize << " is outside ["
          << relevo::SmallestNoiseTexture << ", " << relevo::LargestNoiseTexture << "]";
  }
  else if (this->NoiseGrainSize < 1 || this->NoiseGrainSize >= this->NoiseTextureSize)
  {
    error << "NoiseGrainSize " << this->NoiseGrainSize << " is not at least 1 and less than "
          << "NoiseTextureSize, " << this->NoiseTextureSize;
  }
  else if (!isShare(this->MinNoiseValue) || !isShare(this->MaxNoiseValue) ||
    this->MinNoiseValue >= this->MaxNoiseValue)
  {
    error << "MinNoiseValue " << this->MinNoiseValue << " and MaxNoiseValue " << this->MaxNoiseValue
          << " are not 0 <= min < max <= 1";
  }
  else if (this->NumberOfNoiseLevels < relevo::FewestNoiseLevels)
  {
    error << "NumberOfNoiseLevels " << this->NumberOfNoiseLevels << " is less than "
          << relevo::FewestNoiseLevels;
  }
  else if (!isShare(this->ImpulseNoiseProbability) || !isShare(this->ImpulseNoiseBackgroundValue))
  {
    error << "ImpulseNoiseProbability " << this->ImpulseNoiseProbability
          << " or ImpulseNoiseBackgroundValue " << this->ImpulseNoiseBackgroundValue
          << " is outside [0, 1]";
  }
  else if (!(this->GaussianNoiseSmoothing >= 0.0 &&
             this->GaussianNoiseSmoothing <= LargestSmoothing))
  {
    error << "GaussianNoiseSmoothing " << this->GaussianNoiseSmoothing << " is outside [0, "
          << LargestSmoothing << "]";
  }
  return error.str();
}

int vtkLICNoiseSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  const int last = std::min(std::max(this->NoiseTextureSize, 1), relevo::LargestNoiseTexture) - 1;
  const int extent[6] = { 0, last, 0, last, 0, 0 };
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkLICNoiseSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  const std::string error = this->FindError();
  if (!error.empty())
  {
    vtkErrorMacro(<< error << ".");
    return 0;
  }

  const int size = this->NoiseTextureSize;
  const std::vector<float> image = this->MakeUnitNoise();
  this->UpdateProgress(0.8);
  vtkNew<vtkFloatArray> noise;
  noise->SetName("Noise");
  noise->SetNumberOfTuples(static_cast<vtkIdType>(size) * size);
  this->MapToLevels(image, noise->GetPointer(0));
  output->SetDimensions(size, size, 1);
  output->GetPointData()->SetScalars(noise);
  return 1;
}

std::vector<float> vtkLICNoiseSource::MakeUnitNoise() const
{
  switch (this->NoiseType)
  {
    case NOISE_TYPE_UNIFORM:
      return relevo::MakeUniformNoise(
        this->NoiseTextureSize, this->NoiseGrainSize, this->NoiseGeneratorSeed);
    case NOISE_TYPE_GAUSSIAN:
      return relevo::MakeGaussianNoise(this->NoiseTextureSize, this->NoiseGrainSize,
        this->GaussianNoiseSmoothing, this->NoiseGeneratorSeed);
    default:
      return relevo::MakePerlinNoise(
        this->NoiseTextureSize, this->NoiseGrainSize, this->NoiseGeneratorSeed);
  }
}

void vtkLICNoiseSource::MapToLevels(const std::vector<float>& image, float* noise) const
{
  const int size = this->NoiseTextureSize;
  const int grainSize = this->NoiseType == NOISE_TYPE_PERLIN ? 1 : this->NoiseGrainSize;
  const double width = this->MaxNoiseValue - this->MinNoiseValue;
  const double highest = this->NumberOfNoiseLevels - 1;
  for (std::size_t i = 0; i < image.size(); ++i)
  {
    const int column = static_cast<int>(i % size) / grainSize;
    const int row = static_cast<int>(i / size) / grainSize;
    const relevo::uvec4 hash =
      relevo::noiseHash(column, row, relevo::IMPULSE_STREAM, this->NoiseGeneratorSeed);
    const double level = std::min(std::max(std::floor(image[i] * (highest + 1.0)), 0.0), highest);
    noise[i] = static_cast<float>(relevo::noiseUniform(hash.x) < this->ImpulseNoiseProbability
        ? this->MinNoiseValue + width * level / highest
        : this->ImpulseNoiseBackgroundValue);
  }
}

void vtkLICNoiseSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NoiseType: " << this->NoiseType << "\n";
  os << indent << "NoiseTextureSize: " << this->NoiseTextureSize << "\n";
  os << indent << "NoiseGrainSize: " << this->NoiseGrainSize << "\n";
  os << indent << "MinNoiseValue: " << this->MinNoiseValue << "\n";
  os << indent << "MaxNoiseValue: " << this->MaxNoiseValue << "\n";
  os << indent << "GaussianNoiseSmoothing: " << this->GaussianNoiseSmoothing << "\n";
  os << indent << "NumberOfNoiseLevels: " << this->NumberOfNoiseLevels << "\n";
  os << indent << "ImpulseNoiseProbability: " << this->ImpulseNoiseProbability << "\n";
  os << indent << "ImpulseNoiseBackgroundValue: " << this->ImpulseNoiseBackgroundValue << "\n";
  os << indent << "NoiseGeneratorSeed: " << this->NoiseGeneratorSeed << "\n";
}

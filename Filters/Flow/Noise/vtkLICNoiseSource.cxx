// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLICNoiseSource.h"

#include "Arrays/ImageExtents.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
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

void vtkLICNoiseSource::SetNoiseType(int type)
{
  relevo::SetChoice(this, "NoiseType", this->NoiseType, type,
    { "NOISE_TYPE_UNIFORM", "NOISE_TYPE_GAUSSIAN", "NOISE_TYPE_PERLIN" });
}

void vtkLICNoiseSource::SetNoiseTextureSize(int length)
{
  relevo::SetInRange(this, "NoiseTextureSize", this->NoiseTextureSize, length,
    relevo::SmallestNoiseTexture, relevo::LargestNoiseTexture);
}

void vtkLICNoiseSource::SetNoiseGrainSize(int length)
{
  relevo::SetInRange(
    this, "NoiseGrainSize", this->NoiseGrainSize, length, 1, relevo::LargestNoiseTexture - 1);
}

void vtkLICNoiseSource::SetMinNoiseValue(double value)
{
  relevo::SetInRange(this, "MinNoiseValue", this->MinNoiseValue, value, 0.0, 1.0);
}

void vtkLICNoiseSource::SetMaxNoiseValue(double value)
{
  relevo::SetInRange(this, "MaxNoiseValue", this->MaxNoiseValue, value, 0.0, 1.0);
}

void vtkLICNoiseSource::SetGaussianNoiseSmoothing(double deviation)
{
  relevo::SetInRange(
    this, "GaussianNoiseSmoothing", this->GaussianNoiseSmoothing, deviation, 0.0, LargestSmoothing);
}

void vtkLICNoiseSource::SetNumberOfNoiseLevels(int levels)
{
  relevo::SetInRange(this, "NumberOfNoiseLevels", this->NumberOfNoiseLevels, levels,
    relevo::FewestNoiseLevels, VTK_INT_MAX);
}

void vtkLICNoiseSource::SetImpulseNoiseProbability(double probability)
{
  relevo::SetInRange(
    this, "ImpulseNoiseProbability", this->ImpulseNoiseProbability, probability, 0.0, 1.0);
}

void vtkLICNoiseSource::SetImpulseNoiseBackgroundValue(double value)
{
  relevo::SetInRange(
    this, "ImpulseNoiseBackgroundValue", this->ImpulseNoiseBackgroundValue, value, 0.0, 1.0);
}

std::string vtkLICNoiseSource::FindError() const
{
  std::ostringstream error;
  if (this->NoiseGrainSize >= this->NoiseTextureSize)
  {
    error << "NoiseGrainSize must be less than NoiseTextureSize, got " << this->NoiseGrainSize
          << " and " << this->NoiseTextureSize << ".";
  }
  else if (this->MinNoiseValue >= this->MaxNoiseValue)
  {
    error << "MinNoiseValue must be less than MaxNoiseValue, got " << this->MinNoiseValue << " and "
          << this->MaxNoiseValue << ".";
  }
  return error.str();
}

int vtkLICNoiseSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  relevo::SetImageSize(information, this->NoiseTextureSize, this->NoiseTextureSize);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkLICNoiseSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  this->ErrorMessage = this->FindError();
  if (!this->ErrorMessage.empty())
  {
    vtkErrorMacro(<< this->ErrorMessage);
    return 0;
  }

  return relevo::RequestWithinMemory(this, outputVector, "the noise",
    [&]
    {
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
    });
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

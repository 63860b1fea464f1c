// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLICNoiseSource.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRefinementMathematics.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relevo
{
#include "glsl/relevoNoiseHash.glsl"
}

namespace
{
constexpr int LargestSize = 16384;

// Of VTK's noise image.
constexpr float GaussianMean = 0.41f;
constexpr float GaussianDeviation = 0.154f;

// Which random numbers of a place: one stream for its value, one for whether it has one, one for
// each octave.
enum Streams : int
{
  VALUE,
  IMPULSE,
  OCTAVES
};

relevo::uvec4 Hash(int column, int row, int stream, int seed)
{
  return relevo::noiseHash(relevo::ivec4(column, row, stream, seed));
}

// Of the standard normal distribution, as a sum of eight uniform numbers (Irwin and Hall): all
// operations are exact, so that processors agree.
float Gaussian(const relevo::uvec4& hash)
{
  unsigned int sum = 0;
  for (int i = 0; i < 4; ++i)
  {
    sum += (hash[i] >> 16) + (hash[i] & 0xffffu);
  }
  return (static_cast<float>(sum) / 65536.0f - 4.0f) * 1.2247449f;
}

float GrainValue(int type, int column, int row, int seed)
{
  const relevo::uvec4 hash = Hash(column, row, VALUE, seed);
  return type == vtkLICNoiseSource::NOISE_TYPE_GAUSSIAN
    ? GaussianMean + GaussianDeviation * Gaussian(hash)
    : relevo::noiseUniform(hash.x);
}

float Fade(float t)
{
  return t * t * t * (t * (6.0f * t - 15.0f) + 10.0f);
}

// The gradient of a lattice point times the offset from it: along an axis or a diagonal.
float Slope(const relevo::uvec4& hash, const relevo::vec2& offset)
{
  constexpr float Root2 = 1.41421356f;
  const float x = hash.x & 1u ? offset.x : -offset.x;
  const float y = hash.y & 1u ? offset.y : -offset.y;
  return hash.z & 1u ? x + y : Root2 * (hash.w & 1u ? x : y);
}

// Gradient noise at p, in units of a lattice that repeats after n points.
float GradientNoise(const relevo::vec2& p, int n, int octave, int seed)
{
  const relevo::ivec2 cell(relevo::floor(p));
  const relevo::vec2 offset = p - relevo::vec2(cell);
  float corners[2][2];
  for (int j = 0; j < 2; ++j)
  {
    for (int i = 0; i < 2; ++i)
    {
      const relevo::uvec4 hash = Hash((cell.x + i) % n, (cell.y + j) % n, OCTAVES + octave, seed);
      corners[j][i] = Slope(hash, offset - relevo::vec2(i, j));
    }
  }
  const float fade = Fade(offset.x);
  return relevo::mix(relevo::mix(corners[0][0], corners[0][1], fade),
    relevo::mix(corners[1][0], corners[1][1], fade), Fade(offset.y));
}

// Octaves of gradient noise; about 0.
float PerlinNoise(int column, int row, int size, int grainSize, int seed)
{
  float sum = 0.0f;
  float height = 1.0f;
  int n = std::max(1, (2 * size + grainSize) / (2 * grainSize));
  for (int octave = 0; octave == 0 || 2 * n <= size; ++octave, n *= 2, height *= 0.5f)
  {
    const float scale = static_cast<float>(n) / static_cast<float>(size);
    const relevo::vec2 p = scale * (relevo::vec2(column, row) + 0.5f);
    sum += height * GradientNoise(p, n, octave, seed);
  }
  return sum;
}

// Replaces every value by f(column, row, value).
template <typename Function>
void ForEachTexel(vtkFloatArray* values, int size, Function&& f)
{
  vtkSMPTools::For(0, size,
    [=, &f](vtkIdType begin, vtkIdType end)
    {
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        float* value = values->GetPointer(static_cast<vtkIdType>(row) * size);
        for (int column = 0; column < size; ++column)
        {
          value[column] = f(column, row, value[column]);
        }
      }
    });
}
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
  else if (this->NoiseTextureSize < 2 || this->NoiseTextureSize > LargestSize)
  {
    error << "NoiseTextureSize " << this->NoiseTextureSize << " is outside [2, " << LargestSize
          << "]";
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
  else if (this->NumberOfNoiseLevels < 2)
  {
    error << "NumberOfNoiseLevels " << this->NumberOfNoiseLevels << " is less than 2";
  }
  else if (!isShare(this->ImpulseNoiseProbability) || !isShare(this->ImpulseNoiseBackgroundValue))
  {
    error << "ImpulseNoiseProbability " << this->ImpulseNoiseProbability
          << " or ImpulseNoiseBackgroundValue " << this->ImpulseNoiseBackgroundValue
          << " is outside [0, 1]";
  }
  return error.str();
}

int vtkLICNoiseSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  const int last = std::min(std::max(this->NoiseTextureSize, 1), LargestSize) - 1;
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
  output->SetDimensions(size, size, 1);
  vtkNew<vtkFloatArray> noise;
  noise->SetName("Noise");
  noise->SetNumberOfTuples(static_cast<vtkIdType>(size) * size);
  this->FillUnitNoise(noise);
  this->UpdateProgress(0.6);
  this->MapToLevels(noise);
  output->GetPointData()->SetScalars(noise);
  return 1;
}

void vtkLICNoiseSource::FillUnitNoise(vtkFloatArray* noise)
{
  const int size = this->NoiseTextureSize;
  const int grainSize = this->NoiseGrainSize;
  const int seed = this->NoiseGeneratorSeed;
  if (this->NoiseType != NOISE_TYPE_PERLIN)
  {
    const int type = this->NoiseType;
    ForEachTexel(noise, size,
      [=](int column, int row, float)
      { return GrainValue(type, column / grainSize, row / grainSize, seed); });
    return;
  }
  ForEachTexel(noise, size,
    [=](int column, int row, float) { return PerlinNoise(column, row, size, grainSize, seed); });
  const float* begin = noise->GetPointer(0);
  const auto range = std::minmax_element(begin, begin + noise->GetNumberOfTuples());
  const float low = *range.first;
  const float width = std::max(*range.second - low, 1e-6f);
  ForEachTexel(noise, size, [=](int, int, float value) { return (value - low) / width; });
}

void vtkLICNoiseSource::MapToLevels(vtkFloatArray* noise)
{
  const int grainSize = this->NoiseType == NOISE_TYPE_PERLIN ? 1 : this->NoiseGrainSize;
  const int seed = this->NoiseGeneratorSeed;
  const double low = this->MinNoiseValue;
  const double width = this->MaxNoiseValue - low;
  const double highest = this->NumberOfNoiseLevels - 1;
  const double probability = this->ImpulseNoiseProbability;
  const float background = static_cast<float>(this->ImpulseNoiseBackgroundValue);
  ForEachTexel(noise, this->NoiseTextureSize,
    [=](int column, int row, float value)
    {
      const relevo::uvec4 hash = Hash(column / grainSize, row / grainSize, IMPULSE, seed);
      if (relevo::noiseUniform(hash.x) >= probability)
      {
        return background;
      }
      const double level = std::floor(static_cast<double>(value) * (highest + 1.0));
      return static_cast<float>(low + width * std::min(std::max(level, 0.0), highest) / highest);
    });
}

void vtkLICNoiseSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NoiseType: " << this->NoiseType << "\n";
  os << indent << "NoiseTextureSize: " << this->NoiseTextureSize << "\n";
  os << indent << "NoiseGrainSize: " << this->NoiseGrainSize << "\n";
  os << indent << "MinNoiseValue: " << this->MinNoiseValue << "\n";
  os << indent << "MaxNoiseValue: " << this->MaxNoiseValue << "\n";
  os << indent << "NumberOfNoiseLevels: " << this->NumberOfNoiseLevels << "\n";
  os << indent << "ImpulseNoiseProbability: " << this->ImpulseNoiseProbability << "\n";
  os << indent << "ImpulseNoiseBackgroundValue: " << this->ImpulseNoiseBackgroundValue << "\n";
  os << indent << "NoiseGeneratorSeed: " << this->NoiseGeneratorSeed << "\n";
}

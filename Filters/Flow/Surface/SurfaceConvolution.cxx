// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceConvolution.h"

namespace relevo
{
SurfaceConvolution::SurfaceConvolution(
  const SurfaceVectors& vectors, const SolidNoise& noise, const LICKernel& kernel)
  : Vectors(vectors)
  , Noise(noise)
  , Kernel(kernel)
{
  const ivec2 reach = licReach(kernel);
  for (int way = 0; way < 2; ++way)
  {
    for (int k = 0; k <= reach[way]; ++k)
    {
      this->Weights[way].push_back(licWeight(static_cast<float>(way ? k : -k), kernel));
    }
  }
}

template <typename Begin>
float SurfaceConvolution::Convolve(const double start[3], const Begin& begin) const
{
  const float noise = this->Noise.GetValue(start);
  double weights = this->Weights[0][0];
  double sum = weights * noise;
  for (int way = 0; way < 2; ++way)
  {
    SurfaceStreamline line(this->Vectors, way == 1, this->Kernel.Normalized);
    begin(line);
    for (std::size_t k = 1; k < this->Weights[way].size(); ++k)
    {
      if (!line.Advance(this->Kernel.StepSize))
      {
        break;
      }
      const double weight = this->Weights[way][k];
      sum += weight * this->Noise.GetValue(line.GetPosition().data());
      weights += weight;
    }
  }
  const float value = weights > 0.0 ? static_cast<float>(sum / weights) : noise;
  return licRestoreContrast(value, SolidNoise::Mean, this->Kernel);
}

float SurfaceConvolution::GetValueAt(vtkIdType mergedPoint) const
{
  double start[3];
  this->Vectors.GetTriangles().GetPoint(mergedPoint, start);
  return this->Convolve(start, [=](SurfaceStreamline& line) { line.StartAt(mergedPoint); });
}

float SurfaceConvolution::GetValueInside(int triangle, const SurfaceVectors::Weights& weights) const
{
  const SurfaceVectors::Vector start = this->Vectors.GetPosition(triangle, weights);
  return this->Convolve(
    start.data(), [&](SurfaceStreamline& line) { line.StartInside(triangle, weights); });
}
}

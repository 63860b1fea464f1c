// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/VectorRaster.h"

#include "Arrays/VectorData.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/PointBlanking.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Adapts one component to the interpolation functions for heights.
struct ComponentSampler
{
  size_t index(ivec2 texel) const { return static_cast<size_t>(texel.y) * this->Size.x + texel.x; }
  float heightTexel(ivec2 texel) const
  {
    return this->Samples[this->index(texel) * this->NumberOfComponents + this->Component];
  }
  float validTexel(ivec2 texel) const { return this->Validity[this->index(texel)] ? 1.0f : 0.0f; }
  ivec2 heightSize() const { return this->Size; }

#include "glsl/relevoHeight.glsl"

  ivec2 Size;
  const float* Samples;
  const unsigned char* Validity;
  int NumberOfComponents;
  int Component;
};
}

bool VectorRaster::SetImage(
  vtkImageData* image, vtkDataArray* array, double noDataMagnitude, std::string& error)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  const vtkIdType size = static_cast<vtkIdType>(dimensions[0]) * dimensions[1];
  if (dimensions[0] < 1 || dimensions[1] < 1 || dimensions[2] != 1)
  {
    error = "it has " + std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) +
      " x " + std::to_string(dimensions[2]) + " points, but n x m x 1 are needed";
    return false;
  }
  if (array->GetNumberOfTuples() != size)
  {
    error = "the array has " + std::to_string(array->GetNumberOfTuples()) +
      " tuples, but there are " + std::to_string(size) + " points";
    return false;
  }
  this->Size[0] = dimensions[0];
  this->Size[1] = dimensions[1];
  this->NumberOfComponents = array->GetNumberOfComponents();
  this->Samples.assign(static_cast<std::size_t>(size) * this->NumberOfComponents, 0.0f);
  this->Validity.assign(size, 0);
  const PointBlanking blanking(image);
  for (vtkIdType i = 0; i < size; ++i)
  {
    double vector[3] = { 0.0, 0.0, 0.0 };
    array->GetTuple(i, vector);
    if (IsVectorData(vector, 3, noDataMagnitude) && !blanking.IsHidden(i))
    {
      this->Validity[i] = 1;
      std::copy_n(vector, this->NumberOfComponents, &this->Samples[i * this->NumberOfComponents]);
    }
  }
  return true;
}

bool VectorRaster::Sample(double u, double v, double vector[3]) const
{
  ComponentSampler sampler = { ivec2(this->Size[0], this->Size[1]), this->Samples.data(),
    this->Validity.data(), this->NumberOfComponents, 0 };
  const vec2 uv(u, v);
  if (!(u == u && v == v) || !sampler.heightValid(uv))
  {
    return false;
  }
  const vec2 position = sampler.heightPosition(uv);
  const ivec2 corner = ivec2(floor(position));
  vector[2] = 0.0;
  for (; sampler.Component < this->NumberOfComponents; ++sampler.Component)
  {
    vector[sampler.Component] = sampler.heightBetween(corner, position - vec2(corner));
  }
  return true;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoRaySum.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>

bool RelevoRaySum::Cut(const RelevoRay& ray, double& begin, double& end) const
{
  if (!ray.CutBox(0.0, 1.0, begin, end))
  {
    return false;
  }
  if (this->Clip)
  {
    this->Clip(ray, begin, end);
  }
  return begin < end;
}

RelevoColor RelevoRaySum::Composite(const RelevoRay& ray) const
{
  RelevoColor seen = {};
  double begin;
  double end;
  if (!this->Cut(ray, begin, end))
  {
    return seen;
  }
  const double step = (end - begin) / this->Count;
  const auto add = [&seen](const RelevoColor& color, double alpha)
  {
    const double light = (1.0 - seen[3]) * alpha;
    for (int c = 0; c < 3; ++c)
    {
      seen[c] += light * color[c];
    }
    seen[3] += light;
  };
  for (int i = 0; i < this->Count; ++i)
  {
    const RelevoPoint at = ray.At(begin + (i + 0.5) * step);
    const double first = this->Values.empty() ? 0.0 : this->Scalar(ray.At(begin + i * step));
    const double last = this->Values.empty() ? 0.0 : this->Scalar(ray.At(begin + (i + 1) * step));
    for (size_t j = 0; j < this->Values.size(); ++j)
    {
      const double value = this->Values[first < last ? j : this->Values.size() - 1 - j];
      if ((first < value) != (last < value))
      {
        const RelevoColor surface = this->Surface(ray, at);
        add(surface, surface[3]);
      }
    }
    if (this->Optics)
    {
      const RelevoColor optics = this->Optics(ray, at);
      add(optics, 1.0 - std::exp(-optics[3] * step));
    }
  }
  return seen;
}

RelevoColor RelevoRaySum::Add(const RelevoRay& ray) const
{
  RelevoColor sum = {};
  double begin;
  double end;
  const double step = this->Cut(ray, begin, end) ? (end - begin) / this->Count : 0.0;
  for (int i = 0; i < this->Count && step > 0.0; ++i)
  {
    const RelevoColor optics = this->Optics(ray, ray.At(begin + (i + 0.5) * step));
    for (int c = 0; c < 4; ++c)
    {
      sum[c] += step * optics[3] * (c < 3 ? optics[c] : 1.0);
    }
  }
  for (double& value : sum)
  {
    value = std::min(value, 1.0);
  }
  return sum;
}

bool RelevoRaySum::Measure(const RelevoRay& ray, double& low, double& high, double& mean) const
{
  double begin;
  double end;
  if (!this->Cut(ray, begin, end))
  {
    return false;
  }
  low = high = this->Scalar(ray.At(begin));
  mean = 0.0;
  for (int i = 0; i <= this->Count; ++i)
  {
    const double scalar = this->Scalar(ray.At(begin + (end - begin) * i / this->Count));
    low = std::min(low, scalar);
    high = std::max(high, scalar);
    mean += scalar * (i == 0 || i == this->Count ? 0.5 : 1.0) / this->Count;
  }
  return true;
}

std::vector<RelevoColor> MakePicture(
  vtkCamera* camera, int width, int height, const std::function<RelevoColor(const RelevoRay&)>& get)
{
  std::vector<RelevoColor> picture;
  for (int i = 0; i < width * height; ++i)
  {
    picture.push_back(get(RelevoRay(camera, i % width, i / width, width, height)));
  }
  return picture;
}

RelevoColor MapScalar(vtkVolumeProperty* property, double scalar, int component)
{
  RelevoColor color;
  property->GetRGBTransferFunction(component)->GetColor(scalar, color.data());
  color[3] = property->GetScalarOpacity(component)->GetValue(scalar);
  return color;
}

RelevoColor Premultiply(const RelevoColor& color)
{
  return { { color[0] * color[3], color[1] * color[3], color[2] * color[3], color[3] } };
}

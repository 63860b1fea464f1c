// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Image/LICPasses.h"

#include "Image/LICField.h"
#include "Image/LICFilters.h"
#include "Image/LICStretch.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

namespace
{
// Parts of each pass, between which the watch is called.
constexpr int NumberOfPortions = 16;

// Cost of a filter pass in steps of convolution.
constexpr double FilterCost = 1.0;

double Cost(const relevo::LICKernel& kernel)
{
  const relevo::ivec2 reach = relevo::licReach(kernel);
  return reach.x + reach.y + 1.0;
}
}

namespace relevo
{
LICPasses::LICPasses(
  const LICPlane& plane, const LICVectors& vectors, const LICPassSettings& settings)
  : Plane(plane)
  , Vectors(vectors)
  , Settings(settings)
{
}

bool LICPasses::Run(std::vector<float>& image, const Watch& watch)
{
  const LICKernel& first = this->Settings.Kernel;
  const LICKernel second = licSecondKernel(first);
  const bool enhanced = this->Settings.Enhanced;
  const bool stretched = this->Settings.Stretched;
  const int smoothings = this->Settings.NumberOfSmoothings;
  this->ProgressWatch = watch;
  this->Done = 0.0;
  this->Total = Cost(first) + (enhanced ? FilterCost + Cost(second) : 0.0) +
    (enhanced && stretched ? FilterCost : 0.0) + (stretched ? FilterCost : 0.0) +
    2.0 * FilterCost * smoothings;

  bool running = this->Convolve(image, first);
  if (enhanced)
  {
    running = running && (!stretched || this->Stretch(image, vec2(0.0f))) && this->Sharpen(image) &&
      this->Convolve(image, second);
  }
  for (int i = 0; i < smoothings; ++i)
  {
    running = running && this->Smooth(image, ivec2(1, 0)) && this->Smooth(image, ivec2(0, 1));
  }
  return running && (!stretched || this->Stretch(image, this->Settings.StretchFactors));
}

// Replaces pixels that are not masked by f(pixel). The image is not changed before all are
// computed.
template <typename Function>
bool LICPasses::ReplaceUnmasked(std::vector<float>& image, double cost, Function&& f)
{
  std::vector<float> result(image);
  const unsigned char* mask = this->Vectors.GetMask().data();
  const int columns = this->Plane.Columns;
  const int rows = this->Plane.Rows;
  const int portion = (rows + NumberOfPortions - 1) / NumberOfPortions;
  for (int first = 0; first < rows; first += portion)
  {
    const int last = std::min(first + portion, rows);
    vtkSMPTools::For(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int row = static_cast<int>(begin); row < end; ++row)
        {
          const vtkIdType start = static_cast<vtkIdType>(row) * columns;
          for (int column = 0; column < columns; ++column)
          {
            if (!mask[start + column])
            {
              result[start + column] = f(ivec2(column, row));
            }
          }
        }
      });
    if (!this->ProgressWatch((this->Done + cost * last / rows) / this->Total))
    {
      return false;
    }
  }
  this->Done += cost;
  image.swap(result);
  return true;
}

bool LICPasses::Convolve(std::vector<float>& image, const LICKernel& kernel)
{
  LICField field{ this->Plane.Columns, this->Plane.Rows, this->Vectors.GetPadded().data(),
    image.data() };
  return this->ReplaceUnmasked(image, Cost(kernel),
    [&](ivec2 pixel)
    {
      const float value = field.licConvolve(vec2(pixel) + 0.5f, kernel);
      return licRestoreContrast(value, this->Settings.NoiseMean, kernel);
    });
}

bool LICPasses::Sharpen(std::vector<float>& image)
{
  LICFilters filters{ this->Plane, this->Vectors.GetMask().data(), image.data() };
  return this->ReplaceUnmasked(
    image, FilterCost, [&](ivec2 pixel) { return filters.licHighPass(pixel); });
}

bool LICPasses::Smooth(std::vector<float>& image, ivec2 direction)
{
  LICFilters filters{ this->Plane, this->Vectors.GetMask().data(), image.data() };
  return this->ReplaceUnmasked(
    image, FilterCost, [&](ivec2 pixel) { return filters.licSmooth(pixel, direction); });
}

bool LICPasses::Stretch(std::vector<float>& image, vec2 factors)
{
  const std::vector<unsigned char>& mask = this->Vectors.GetMask();
  vec2 range(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < image.size(); ++i)
  {
    if (!mask[i])
    {
      range = vec2(std::min(range.x, image[i]), std::max(range.y, image[i]));
    }
  }
  const LICFilters filters{ this->Plane, mask.data(), image.data() };
  return this->ReplaceUnmasked(image, FilterCost,
    [&](ivec2 pixel) { return licStretch(filters.licValue(pixel), range, factors); });
}
}

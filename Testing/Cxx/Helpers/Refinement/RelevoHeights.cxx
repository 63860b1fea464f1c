// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoHeights.h"

#include "vtkMath.h"

#include <cmath>
#include <random>

RelevoHeights* RelevoHeights::New()
{
  RelevoHeights* result = new RelevoHeights;
  result->InitializeObjectBase();
  return result;
}

void RelevoHeights::Fill(
  int width, int height, const std::function<double(double, double)>& function)
{
  this->Dimensions[0] = width;
  this->Dimensions[1] = height;
  this->Samples.resize(static_cast<size_t>(width) * height);
  this->Validity.clear();
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      this->Samples[static_cast<size_t>(y) * width + x] =
        static_cast<float>(function((x + 0.5) / width, (y + 0.5) / height));
    }
  }
  this->Modified();
}

void RelevoHeights::FillRandom(int width, int height, unsigned int seed)
{
  std::mt19937 random(seed);
  this->Fill(width, height, [&random](double, double) { return random() / 4294967296.0; });
}

void RelevoHeights::Punch(const std::function<bool(int, int)>& isHole)
{
  this->Validity.assign(this->Samples.size(), 1);
  for (size_t i = 0; i < this->Samples.size(); ++i)
  {
    this->Validity[i] =
      isHole(static_cast<int>(i) % this->Dimensions[0], static_cast<int>(i) / this->Dimensions[0])
      ? 0
      : 1;
  }
  this->Modified();
}

void RelevoHeights::FillWaves()
{
  this->Fill(64, 64,
    [](double u, double v)
    { return std::sin(4 * vtkMath::Pi() * u) * std::sin(3 * vtkMath::Pi() * v); });
}

void RelevoHeights::FillWavesWithHoles()
{
  this->Fill(48, 40, [](double u, double v) { return std::sin(9 * u) * std::cos(7 * v); });
  this->Punch([](int x, int y)
    { return (x - 20) * (x - 20) + (y - 15) * (y - 15) < 60 || (x > 30 && x < 34 && y > 10); });
}

bool RelevoHeights::Update()
{
  if (this->Samples.empty())
  {
    vtkErrorMacro("No heights.");
  }
  return !this->Samples.empty();
}

void RelevoHeights::GetDimensions(int dimensions[2])
{
  dimensions[0] = this->Dimensions[0];
  dimensions[1] = this->Dimensions[1];
}

void RelevoHeights::GetRange(double range[2])
{
  range[0] = 1e300;
  range[1] = -1e300;
  for (size_t i = 0; i < this->Samples.size(); ++i)
  {
    if (this->Validity.empty() || this->Validity[i])
    {
      range[0] = std::min<double>(range[0], this->Samples[i]);
      range[1] = std::max<double>(range[1], this->Samples[i]);
    }
  }
}

const unsigned char* RelevoHeights::GetValidity()
{
  return this->Validity.empty() ? nullptr : this->Validity.data();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLICNoiseSource promises: the noise follows the settings alone, tiles seamlessly, and does not
// depend on the number of threads. Each setting has the documented effect, and values out of range
// are errors.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkLICNoiseSource.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <limits>
#include <set>

namespace
{
RelevoGrey Run(vtkLICNoiseSource* source)
{
  source->Update();
  return GreyOf(ValuesOf(source->GetOutput()), source->GetOutput()->GetDimensions()[0]);
}

// Correlation of pixels that are `columns` and `rows` apart. Indices wrap around at the borders.
double Correlation(const RelevoGrey& image, int columns, int rows)
{
  const RelevoMoments moments = MomentsOf(image.Values);
  double sum = 0.0;
  for (int row = 0; row < image.Rows; ++row)
  {
    for (int column = 0; column < image.Columns; ++column)
    {
      sum += (image.At(column, row) - moments.Mean) *
        (image.At((column + columns) % image.Columns, (row + rows) % image.Rows) - moments.Mean);
    }
  }
  return sum / image.Values.size() / std::pow(moments.StandardDeviation, 2.0);
}

void TestDistributions(RelevoCheck& check)
{
  vtkNew<vtkLICNoiseSource> source;
  const RelevoGrey gaussian = Run(source);
  vtkImageData* image = source->GetOutput();
  CHECK(image->GetDimensions()[0] == 200 && image->GetDimensions()[1] == 200);
  CHECK_EQUAL(image->GetScalarType(), VTK_FLOAT);
  CHECK_EQUAL(image->GetNumberOfScalarComponents(), 1);
  CHECK_EQUAL(std::string(image->GetPointData()->GetScalars()->GetName()), "Noise");
  // VTK's noise image has the same mean.
  CHECK_NEAR(MomentsOf(gaussian.Values).Mean, 0.329, 0.005);
  CHECK_NEAR(MomentsOf(gaussian.Values).StandardDeviation, 0.127, 0.003);
  // A normal distribution has these shares within one and two standard deviations.
  for (const auto& expected : { std::array<double, 2>{ 1.0, 0.6827 }, { 2.0, 0.9545 } })
  {
    const auto within = std::count_if(gaussian.Values.begin(), gaussian.Values.end(),
      [&](double value) { return std::abs(value - 0.329) < expected[0] * 0.127; });
    CHECK_NEAR(within / 40000.0, expected[1], 0.015);
  }
  // A Gaussian filter with a standard deviation of 1 leaves the correlation exp(-d^2 / 4).
  CHECK_NEAR(Correlation(gaussian, 1, 0), 0.779, 0.03);
  CHECK_NEAR(Correlation(gaussian, 0, 1), 0.779, 0.03);
  CHECK_NEAR(Correlation(gaussian, 1, 1), 0.607, 0.03);
  CHECK_NEAR(Correlation(gaussian, 5, 3), 0.0, 0.03);

  source->SetGaussianNoiseSmoothing(0.0);
  const RelevoGrey white = Run(source);
  CHECK_NEAR(MomentsOf(white.Values).Mean, 0.329, 0.003);
  CHECK_NEAR(MomentsOf(white.Values).StandardDeviation, 0.127, 0.002);
  CHECK_NEAR(Correlation(white, 1, 0), 0.0, 0.02);
  CHECK_NEAR(Correlation(white, 0, 1), 0.0, 0.02);

  source->SetNoiseTypeToUniform();
  source->SetMinNoiseValue(0.25);
  source->SetMaxNoiseValue(0.75);
  const RelevoGrey uniform = Run(source);
  CHECK_NEAR(MomentsOf(uniform.Values).Mean, 0.5, 0.003);
  CHECK_NEAR(MomentsOf(uniform.Values).StandardDeviation, 0.5 / std::sqrt(12.0), 0.002);
  CHECK_NEAR(Correlation(uniform, 1, 0), 0.0, 0.02);
  CHECK_NEAR(Correlation(uniform, 0, 1), 0.0, 0.02);
  CHECK_EQUAL(*std::min_element(uniform.Values.begin(), uniform.Values.end()), 0.25);
  CHECK_EQUAL(*std::max_element(uniform.Values.begin(), uniform.Values.end()), 0.75);
}

void TestGrains(RelevoCheck& check)
{
  for (int type : { 0, 1 })
  {
    CHECK_CASE(type);
    vtkNew<vtkLICNoiseSource> source;
    source->SetNoiseType(type);
    source->SetNoiseTextureSize(50);
    source->SetNoiseGrainSize(4);
    source->SetImpulseNoiseProbability(0.5);
    const RelevoGrey image = Run(source);
    bool same = image.Columns == 50 && image.Rows == 50;
    std::set<double> values;
    for (int row = 0; same && row < 50; ++row)
    {
      for (int column = 0; column < 50; ++column)
      {
        same = same && image.At(column, row) == image.At(column / 4 * 4, row / 4 * 4);
        values.insert(image.At(column, row));
      }
    }
    CHECK(same);
    CHECK_GREATER(values.size(), 30);
  }
}

void TestPerlin(RelevoCheck& check)
{
  vtkNew<vtkLICNoiseSource> source;
  source->SetNoiseTypeToPerlin();
  source->SetNoiseTextureSize(128);
  source->SetNumberOfNoiseLevels(10000);
  source->SetNoiseGrainSize(32);
  const RelevoGrey image = Run(source);
  CHECK_EQUAL(*std::min_element(image.Values.begin(), image.Values.end()), 0.0);
  CHECK_NEAR(*std::max_element(image.Values.begin(), image.Values.end()), 0.8, 1e-6);
  // The noise is smooth on the scale of its period, also across the borders.
  CHECK_GREATER(Correlation(image, 2, 0), 0.8);
  CHECK_GREATER(Correlation(image, 0, 2), 0.8);
  CHECK_LESS(std::abs(Correlation(image, 64, 40)), 0.4);
  double acrossBorders = 0.0;
  double inside = 0.0;
  for (int i = 0; i < 128; ++i)
  {
    acrossBorders += std::abs(image.At(127, i) - image.At(0, i)) / 256.0;
    acrossBorders += std::abs(image.At(i, 127) - image.At(i, 0)) / 256.0;
    inside += std::abs(image.At(71, i) - image.At(72, i)) / 256.0;
    inside += std::abs(image.At(i, 71) - image.At(i, 72)) / 256.0;
  }
  CHECK_LESS(acrossBorders, 2.0 * inside);
  // Shorter periods give more detail, and every period works.
  source->SetNoiseGrainSize(8);
  CHECK_LESS(Correlation(Run(source), 2, 0), 0.8);
  for (int grainSize : { 1, 2, 5, 100, 127 })
  {
    CHECK_CASE(grainSize);
    source->SetNoiseGrainSize(grainSize);
    const RelevoMoments moments = MomentsOf(Run(source).Values);
    CHECK_GREATER(moments.StandardDeviation, 0.05);
    CHECK_GREATER(moments.Mean, 0.2);
    CHECK_LESS(moments.Mean, 0.6);
  }
}

void TestLevelsAndImpulses(RelevoCheck& check)
{
  for (int type : { 0, 1, 2 })
  {
    CHECK_CASE(type);
    vtkNew<vtkLICNoiseSource> source;
    source->SetNoiseType(type);
    source->SetNumberOfNoiseLevels(5);
    source->SetNoiseGrainSize(3);
    const RelevoGrey image = Run(source);
    const std::set<double> values(image.Values.begin(), image.Values.end());
    CHECK_EQUAL(values.size(), 5);
    for (double value : values)
    {
      CHECK_NEAR(std::remainder(value, 0.2), 0.0, 1e-6);
    }

    source->SetNumberOfNoiseLevels(256);
    source->SetMinNoiseValue(0.5);
    source->SetImpulseNoiseProbability(0.1);
    source->SetImpulseNoiseBackgroundValue(0.125);
    const RelevoGrey impulses = Run(source);
    const auto background = std::count(impulses.Values.begin(), impulses.Values.end(), 0.125);
    CHECK_NEAR(background / 40000.0, 0.9, 0.02);
    CHECK(std::all_of(impulses.Values.begin(), impulses.Values.end(),
      [](double value) { return value == 0.125 || value >= 0.5; }));
    source->SetImpulseNoiseProbability(0.0);
    const RelevoGrey none = Run(source);
    CHECK_EQUAL(std::count(none.Values.begin(), none.Values.end(), 0.125), 40000);
  }
}

void TestSeeds(RelevoCheck& check)
{
  for (int type : { 0, 1, 2 })
  {
    vtkNew<vtkLICNoiseSource> source;
    source->SetNoiseType(type);
    source->SetNoiseGrainSize(type == 2 ? 9 : 1);
    std::vector<RelevoGrey> images;
    for (int seed : { 1, 2, 0, -5, std::numeric_limits<int>::max() })
    {
      source->SetNoiseGeneratorSeed(seed);
      images.push_back(Run(source));
    }
    for (std::size_t i = 0; i < images.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        const RelevoMoments a = MomentsOf(images[i].Values);
        const RelevoMoments b = MomentsOf(images[j].Values);
        double sum = 0.0;
        for (std::size_t k = 0; k < images[i].Values.size(); ++k)
        {
          sum += (images[i].Values[k] - a.Mean) * (images[j].Values[k] - b.Mean);
        }
        CHECK_NEAR(
          sum / images[i].Values.size() / (a.StandardDeviation * b.StandardDeviation), 0.0, 0.2);
      }
    }
    // The same seed gives the same noise with any number of threads.
    source->SetNoiseGeneratorSeed(1);
    const std::string backend = vtkSMPTools::GetBackend();
    for (const char* other : { "Sequential", "STDThread" })
    {
      CHECK_CASE(other);
      CHECK(vtkSMPTools::SetBackend(other));
      source->Modified();
      CHECK_EQUAL(Run(source).Values, images[0].Values);
    }
    vtkSMPTools::SetBackend(backend.c_str());
  }
}

// Compares single values with those of pcg4d, computed by an implementation in another language.
// They are the same on every machine.
void TestNumbers(RelevoCheck& check)
{
  vtkNew<vtkLICNoiseSource> source;
  source->SetNoiseTypeToUniform();
  source->SetMaxNoiseValue(1.0);
  source->SetNumberOfNoiseLevels(256);
  const RelevoGrey image = Run(source);
  const int expected[4] = { 141, 107, 142, 178 };
  for (int i = 0; i < 4; ++i)
  {
    CHECK_NEAR(255.0 * image.At(3 * i, 7 * i), expected[i], 1e-3);
  }
}

using Change = std::function<void(vtkLICNoiseSource*)>;

void TestError(RelevoCheck& check, const Change& spoil, const char* words)
{
  vtkNew<vtkLICNoiseSource> source;
  source->Update();
  spoil(source);
  RelevoErrors errors(source);
  RelevoErrors executiveErrors(source->GetExecutive());
  source->Update();
  CHECK(errors.Said(words));
  CHECK_EQUAL(source->GetOutput()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(source->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
}

// A value out of range is reported at once and leaves the noise unchanged.
void TestRefusal(RelevoCheck& check, const Change& spoil, const char* words)
{
  vtkNew<vtkLICNoiseSource> source;
  source->Update();
  const vtkMTimeType time = source->GetMTime();
  RelevoErrors errors(source);
  spoil(source);
  CHECK(errors.Said(words) && source->GetMTime() == time);
  source->Update();
  CHECK(errors.None() && source->GetOutput()->GetNumberOfPoints() == 200 * 200);
}

void TestErrors(RelevoCheck& check)
{
  using Source = vtkLICNoiseSource;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int type : { -1, 3 })
  {
    TestRefusal(
      check, [=](Source* s) { s->SetNoiseType(type); }, "NoiseType");
  }
  for (int size : { 1, 0, -7, 16385, std::numeric_limits<int>::max() })
  {
    TestRefusal(
      check, [=](Source* s) { s->SetNoiseTextureSize(size); }, "NoiseTextureSize");
  }
  for (int size : { 0, -1, 16384 })
  {
    TestRefusal(
      check, [=](Source* s) { s->SetNoiseGrainSize(size); }, "NoiseGrainSize");
  }
  for (double value : { -0.1, 1.1, nan })
  {
    TestRefusal(
      check, [=](Source* s) { s->SetMinNoiseValue(value); }, "MinNoiseValue");
  }
  for (double value : { -0.1, 1.1, nan })
  {
    TestRefusal(
      check, [=](Source* s) { s->SetMaxNoiseValue(value); }, "MaxNoiseValue");
  }
  for (int levels : { 1, 0, -2 })
  {
    TestRefusal(
      check, [=](Source* s) { s->SetNumberOfNoiseLevels(levels); }, "NumberOfNoiseLevels");
  }
  for (double value : { -0.1, 1.1, nan })
  {
    TestRefusal(
      check, [=](Source* s) { s->SetImpulseNoiseProbability(value); }, "ImpulseNoiseProbability");
    TestRefusal(
      check, [=](Source* s) { s->SetImpulseNoiseBackgroundValue(value); },
      "ImpulseNoiseBackgroundValue");
  }
  for (double value : { -0.1, 101.0, nan })
  {
    TestRefusal(
      check, [=](Source* s) { s->SetGaussianNoiseSmoothing(value); }, "Smoothing");
  }
  // Settings that contradict each other are reported when the noise is generated.
  for (int size : { 200, 201 })
  {
    TestError(
      check, [=](Source* s) { s->SetNoiseGrainSize(size); }, "less than NoiseTextureSize");
  }
  for (double value : { 0.8, 0.9 })
  {
    TestError(
      check, [=](Source* s) { s->SetMinNoiseValue(value); }, "less than MaxNoiseValue");
  }
  TestError(
    check, [=](Source* s) { s->SetMaxNoiseValue(0.0); }, "less than MaxNoiseValue, got 0 and 0.");
}
}

int TestLICNoiseSource(int, char*[])
{
  RelevoCheck check;
  TestDistributions(check);
  TestGrains(check);
  TestPerlin(check);
  TestLevelsAndImpulses(check);
  TestSeeds(check);
  TestNumbers(check);
  TestErrors(check);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Images of vector fields and of noise, for the tests of line integral convolution.
#ifndef RelevoFlowImages_h
#define RelevoFlowImages_h

#include "RelevoOrientation.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLineIntegralConvolution.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

// A vector at a place; images have places in samples, their first sample at (0.5, 0.5).
using RelevoField = std::function<void(double x, double y, double* vector)>;

// Fields of places about (0, 0), with their singular points inside the circle of radius 1.
struct RelevoNamedField
{
  std::string Name;
  RelevoField Field;
  std::vector<std::array<double, 2>> Singularities;
};

inline std::vector<RelevoNamedField> MakeNamedFields()
{
  const auto uniform = [](double, double, double* v)
  {
    v[0] = std::cos(0.3);
    v[1] = std::sin(0.3);
  };
  const auto vortex = [](double x, double y, double* v)
  {
    v[0] = -y;
    v[1] = x;
  };
  const auto saddle = [](double x, double y, double* v)
  {
    v[0] = x;
    v[1] = -y;
  };
  // A source and a sink.
  const auto dipole = [](double x, double y, double* v)
  {
    v[0] = v[1] = 0.0;
    for (double sign : { 1.0, -1.0 })
    {
      const double dx = x + 0.5 * sign;
      const double scale = sign / (dx * dx + y * y + 1e-9);
      v[0] += scale * dx;
      v[1] += scale * y;
    }
  };
  return { { "uniform", uniform, {} }, { "vortex", vortex, { { { 0.0, 0.0 } } } },
    { "saddle", saddle, { { { 0.0, 0.0 } } } },
    { "dipole", dipole, { { { -0.5, 0.0 } }, { { 0.5, 0.0 } } } } };
}

// An image with the vectors (vx, vy, 0) as its active vectors "Flow".
inline vtkSmartPointer<vtkImageData> MakeFlowImage(int columns, int rows, const RelevoField& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Flow");
  vectors->SetNumberOfComponents(3);
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      double vector[3] = { 0.0, 0.0, 0.0 };
      field(column + 0.5, row + 0.5, vector);
      vectors->InsertNextTuple(vector);
    }
  }
  image->GetPointData()->SetVectors(vectors);
  return image;
}

inline RelevoField MakeUniformField(double vx, double vy)
{
  return [=](double, double, double* vector)
  {
    vector[0] = vx;
    vector[1] = vy;
  };
}

// Uniform noise in [0, 1].
inline vtkSmartPointer<vtkImageData> MakeNoiseImage(int columns, int rows, unsigned int seed = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::mt19937 random(seed);
  float* value = static_cast<float*>(image->GetScalarPointer());
  std::generate_n(value, image->GetNumberOfPoints(),
    [&] { return static_cast<float>(random() >> 8) / 16777216.0f; });
  return image;
}

// The values of an image's array, by default of its scalars; empty if there is none.
inline std::vector<double> ValuesOf(vtkImageData* image, const char* name = nullptr)
{
  vtkDataArray* array =
    name ? image->GetPointData()->GetArray(name) : image->GetPointData()->GetScalars();
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

// The result of a filter, empty if it has none.
inline std::vector<double> RunLIC(vtkLineIntegralConvolution* filter)
{
  filter->Update();
  return ValuesOf(filter->GetOutput(), "LIC");
}

inline RelevoGrey GreyOf(const std::vector<double>& values, int columns)
{
  RelevoGrey grey(columns, static_cast<int>(values.size() / columns));
  grey.Values = values;
  return grey;
}

// The largest difference; infinite if the sizes differ.
inline double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = a.size() == b.size() ? 0.0 : VTK_DOUBLE_MAX;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

struct RelevoMoments
{
  double Mean = 0.0;
  double StandardDeviation = 0.0;
};

inline RelevoMoments MomentsOf(const std::vector<double>& values)
{
  RelevoMoments moments;
  for (double value : values)
  {
    moments.Mean += value / values.size();
  }
  for (double value : values)
  {
    moments.StandardDeviation += std::pow(value - moments.Mean, 2.0) / values.size();
  }
  moments.StandardDeviation = std::sqrt(moments.StandardDeviation);
  return moments;
}

#endif

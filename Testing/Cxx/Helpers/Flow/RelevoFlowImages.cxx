// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoFlowImages.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <random>

std::vector<RelevoNamedField> MakeNamedFields()
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

vtkSmartPointer<vtkImageData> MakeFlowImage(int columns, int rows, const RelevoField& field)
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

RelevoField MakeUniformField(double vx, double vy)
{
  return [=](double, double, double* vector)
  {
    vector[0] = vx;
    vector[1] = vy;
  };
}

vtkSmartPointer<vtkImageData> MakeNoiseImage(int columns, int rows, unsigned int seed)
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

std::vector<double> ValuesOf(vtkImageData* image, const char* name)
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

std::vector<double> RunLIC(vtkLineIntegralConvolution* filter)
{
  filter->Update();
  return ValuesOf(filter->GetOutput(), "LIC");
}

RelevoGrey GreyOf(const std::vector<double>& values, int columns)
{
  RelevoGrey grey(columns, static_cast<int>(values.size() / columns));
  grey.Values = values;
  return grey;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = a.size() == b.size() ? 0.0 : VTK_DOUBLE_MAX;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

RelevoMoments MomentsOf(const std::vector<double>& values)
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

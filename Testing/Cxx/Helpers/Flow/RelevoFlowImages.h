// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Images of vector fields and of noise, for the tests of line integral convolution.
#ifndef RelevoFlowImages_h
#define RelevoFlowImages_h

#include "RelevoOrientation.h"

#include "vtkImageData.h"
#include "vtkLineIntegralConvolution.h"
#include "vtkSmartPointer.h"

#include <functional>
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

std::vector<RelevoNamedField> MakeNamedFields();

// An image with the vectors (vx, vy, 0) as its active vectors "Flow".
vtkSmartPointer<vtkImageData> MakeFlowImage(int columns, int rows, const RelevoField& field);

RelevoField MakeUniformField(double vx, double vy);

// Uniform noise in [0, 1].
vtkSmartPointer<vtkImageData> MakeNoiseImage(int columns, int rows, unsigned int seed = 1);

// The values of an image's array, by default of its scalars; empty if there is none.
std::vector<double> ValuesOf(vtkImageData* image, const char* name = nullptr);

// The result of a filter, empty if it has none.
std::vector<double> RunLIC(vtkLineIntegralConvolution* filter);

RelevoGrey GreyOf(const std::vector<double>& values, int columns);

// The largest difference; infinite if the sizes differ.
double LargestDifference(const std::vector<double>& a, const std::vector<double>& b);

struct RelevoMoments
{
  double Mean = 0.0;
  double StandardDeviation = 0.0;
};

RelevoMoments MomentsOf(const std::vector<double>& values);

#endif

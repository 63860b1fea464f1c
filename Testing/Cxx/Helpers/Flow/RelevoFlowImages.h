// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Images of vector fields and of noise for the tests of line integral convolution.
#ifndef RelevoFlowImages_h
#define RelevoFlowImages_h

#include "RelevoOrientation.h"

#include "vtkImageData.h"
#include "vtkLineIntegralConvolution.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

// The vector at a position. Image positions are in samples; the first sample is at (0.5, 0.5).
using RelevoField = std::function<void(double x, double y, double* vector)>;

// Fields around (0, 0) whose singular points lie within the circle of radius 1.
struct RelevoNamedField
{
  std::string Name;
  RelevoField Field;
  std::vector<std::array<double, 2>> Singularities;
};

std::vector<RelevoNamedField> MakeNamedFields();

// An image with the active vectors "Flow", (vx, vy, 0).
vtkSmartPointer<vtkImageData> MakeFlowImage(int columns, int rows, const RelevoField& field);

RelevoField MakeUniformField(double vx, double vy);

// Uniform noise in [0, 1].
vtkSmartPointer<vtkImageData> MakeNoiseImage(int columns, int rows, unsigned int seed = 1);

// Values of an image's array, or of its scalars without a name. Empty if there is no such array.
std::vector<double> ValuesOf(vtkImageData* image, const char* name = nullptr);

// The filter's result; empty if there is none.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures the directions of lines in a grey image by its structure tensor (Bigun and Granlund,
// 1987), and their deviation from a field.
#ifndef RelevoOrientation_h
#define RelevoOrientation_h

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <vector>

// An image of real numbers. (column, row) counts from the lower left corner, and rows follow each
// other.
struct RelevoGrey
{
  RelevoGrey(int columns, int rows);
  double& At(int column, int row);
  double At(int column, int row) const;

  int Columns;
  int Rows;
  std::vector<double> Values;
};

class RelevoOrientation
{
public:
  // Scales in pixels: standard deviations of the Gaussians for the gradients and for smoothing the
  // tensor.
  explicit RelevoOrientation(
    const RelevoGrey& image, double gradientScale = 1.0, double tensorScale = 3.0);

  int GetColumns() const { return this->XX.Columns; }
  int GetRows() const { return this->XX.Rows; }

  // Direction of the lines in radians from the x axis, modulo pi.
  double GetAngle(int column, int row) const;

  // Returns 1 if all gradients are parallel, and 0 if no direction dominates.
  double GetCoherence(int column, int row) const;

private:
  static std::vector<double> Gaussian(double scale);

  static std::vector<double> GaussianDerivative(double scale);

  // Correlates with weights along (stepX, stepY). Values beyond the border repeat the border.
  static RelevoGrey Filter(
    const RelevoGrey& image, const std::vector<double>& weights, int stepX, int stepY);
  static RelevoGrey FilterRows(const RelevoGrey& image, const std::vector<double>& weights);
  static RelevoGrey FilterColumns(const RelevoGrey& image, const std::vector<double>& weights);

  RelevoGrey XX;
  RelevoGrey YY;
  RelevoGrey XY;
};

// Angles between lines and vectors in degrees, in [0, 90].
struct RelevoDeviations
{
  double Median = 90.0;
  double Percentile95 = 90.0;
  std::size_t Count = 0;
};

std::ostream& operator<<(std::ostream& os, const RelevoDeviations& deviations);

// Measures pixels for which field(column, row, vector) returns true. The field sets the vector, two
// doubles.
template <typename Field>
RelevoDeviations MeasureDeviations(const RelevoOrientation& orientation, Field&& field)
{
  std::vector<double> angles;
  for (int row = 0; row < orientation.GetRows(); ++row)
  {
    for (int column = 0; column < orientation.GetColumns(); ++column)
    {
      double vector[2];
      if (field(column, row, vector))
      {
        const double difference =
          orientation.GetAngle(column, row) - std::atan2(vector[1], vector[0]);
        angles.push_back(
          vtkMath::DegreesFromRadians(std::abs(std::remainder(difference, vtkMath::Pi()))));
      }
    }
  }
  RelevoDeviations deviations;
  deviations.Count = angles.size();
  if (!angles.empty())
  {
    std::sort(angles.begin(), angles.end());
    deviations.Median = angles[angles.size() / 2];
    deviations.Percentile95 = angles[angles.size() * 95 / 100];
  }
  return deviations;
}

#endif

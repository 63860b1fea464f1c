// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves figures.md: the lines of vtkLineIntegralConvolution follow the field with default settings
// and with enhanced contrast. Mean and contrast match VTK's surface LIC.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include <iostream>
#include <map>
#include <string>

namespace
{
constexpr int Columns = 512;
constexpr int Rows = 384;

// Coordinate relative to the image's centre. The lower and upper borders are at -1 and 1.
double Place(double sample, int number)
{
  return (sample - 0.5 * number) / (0.5 * Rows);
}

vtkSmartPointer<vtkImageData> MakeImage(const RelevoField& field)
{
  return MakeFlowImage(Columns, Rows,
    [&](double x, double y, double* v) { field(Place(x, Columns), Place(y, Rows), v); });
}

// Measures deviations away from borders and singular points.
RelevoDeviations Measure(const std::vector<double>& lic, const RelevoNamedField& field)
{
  return MeasureDeviations(RelevoOrientation(GreyOf(lic, Columns)),
    [&](int column, int row, double* vector)
    {
      const double x = Place(column + 0.5, Columns);
      const double y = Place(row + 0.5, Rows);
      field.Field(x, y, vector);
      bool counts = std::abs(x) < 1.25 && std::abs(y) < 0.9;
      for (const auto& singularity : field.Singularities)
      {
        counts = counts && std::hypot(x - singularity[0], y - singularity[1]) > 0.1;
      }
      return counts;
    });
}

// Standard deviations of the grey values that vtkSurfaceLICMapper of ParaView 5.11 gives for these
// fields.
const std::map<std::string, double> DeviationsOfVTK = { { "uniform", 0.0800 }, { "vortex", 0.0868 },
  { "saddle", 0.0861 }, { "dipole", 0.0883 } };
}

int TestLineIntegralConvolutionDirections(int, char*[])
{
  RelevoCheck check;
  for (const RelevoNamedField& field : MakeNamedFields())
  {
    vtkNew<vtkLineIntegralConvolution> filter;
    filter->SetInputData(MakeImage(field.Field));
    const std::vector<double> lic = RunLIC(filter);
    const RelevoDeviations deviations = Measure(lic, field);
    const RelevoMoments moments = MomentsOf(lic);
    std::cout << field.Name << ": " << deviations << "; mean " << moments.Mean << ", deviation "
              << moments.StandardDeviation << "\n";
    CHECK_GREATER(deviations.Count, 100000);
    CHECK_LESS_EQUAL(deviations.Median, 1.5);
    CHECK_LESS_EQUAL(deviations.Percentile95, 4.5);
    // The deviation is within 5 % of that of VTK's surface LIC with default settings.
    const double deviation = DeviationsOfVTK.at(field.Name);
    CHECK_NEAR(moments.Mean, 0.33, 0.05 * 0.33);
    CHECK_NEAR(moments.StandardDeviation, deviation, 0.05 * deviation);

    filter->SetEnhanceContrastToLIC();
    const std::vector<double> enhanced = RunLIC(filter);
    CHECK_LESS_EQUAL(Measure(enhanced, field).Median, 1.5);
    CHECK_LESS_EQUAL(Measure(enhanced, field).Percentile95, 4.5);
    CHECK_GREATER(MomentsOf(enhanced).StandardDeviation, 1.5 * moments.StandardDeviation);

    // Negative control: compared with the perpendicular field, lines deviate by 90 degrees.
    RelevoNamedField across = field;
    across.Field = [&](double x, double y, double* v)
    {
      double along[2];
      field.Field(x, y, along);
      v[0] = -along[1];
      v[1] = along[0];
    };
    CHECK_GREATER(Measure(lic, across).Median, 85.0);
  }

  // Without the second pass, VTK's deviations are 1.6 and 6 degrees.
  vtkNew<vtkLineIntegralConvolution> plain;
  const RelevoNamedField vortex = MakeNamedFields()[1];
  plain->SetInputData(MakeImage(vortex.Field));
  plain->EnhancedLICOff();
  const RelevoDeviations deviations = Measure(RunLIC(plain), vortex);
  std::cout << "plain " << vortex.Name << ": " << deviations << "\n";
  CHECK_LESS_EQUAL(deviations.Median, 3.0);
  CHECK_LESS_EQUAL(deviations.Percentile95, 9.0);
  return check.GetResult();
}

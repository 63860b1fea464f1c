// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Lines of vtkLineIntegralConvolution run as the field does, at its defaults and when the contrast
// is enhanced, with the mean and the contrast of VTK's surface LIC.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include <iostream>
#include <map>
#include <string>

namespace
{
constexpr int Columns = 512;
constexpr int Rows = 384;

// Places about (0, 0); the lower and the upper border at -1 and 1.
double Place(double sample, int number)
{
  return (sample - 0.5 * number) / (0.5 * Rows);
}

vtkSmartPointer<vtkImageData> MakeImage(const RelevoField& field)
{
  return MakeFlowImage(Columns, Rows,
    [&](double x, double y, double* v) { field(Place(x, Columns), Place(y, Rows), v); });
}

// Away from the border and from singular points.
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

// What vtkSurfaceLICMapper of ParaView 5.11 makes of the fields: standard deviations of the greys.
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
    // Within 5 % of the surface LIC's of VTK at its defaults.
    const double deviation = DeviationsOfVTK.at(field.Name);
    CHECK_NEAR(moments.Mean, 0.33, 0.05 * 0.33);
    CHECK_NEAR(moments.StandardDeviation, deviation, 0.05 * deviation);

    filter->SetEnhanceContrastToLIC();
    const std::vector<double> enhanced = RunLIC(filter);
    CHECK_LESS_EQUAL(Measure(enhanced, field).Median, 1.5);
    CHECK_LESS_EQUAL(Measure(enhanced, field).Percentile95, 4.5);
    CHECK_GREATER(MomentsOf(enhanced).StandardDeviation, 1.5 * moments.StandardDeviation);

    // The measure tells: across the field, lines are 90 degrees away.
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

  // Without its second pass: VTK's has 1.6 and 6 degrees.
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

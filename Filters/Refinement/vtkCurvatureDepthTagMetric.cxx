// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCurvatureDepthTagMetric.h"

#include "Core/RefinementMathematics.h"
#include "Core/SettingChecks.h"
#include "Mesh/SurfaceTriangles.h"
#include "Metrics/DiscreteCurvature.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
#include "glsl/relevoMetrics.glsl"
}

namespace
{
constexpr double FlatAngle = 1e-3; // radians
}

struct vtkCurvatureDepthTagMetric::vtkInternals
{
  relevo::GeometryStamp Of{};
  relevo::DiscreteCurvature Curvature;

  const relevo::DiscreteCurvature& Update(vtkPolyData* mesh)
  {
    const relevo::GeometryStamp stamp = relevo::MakeGeometryStamp(mesh);
    if (this->Of != stamp)
    {
      this->Curvature = relevo::ComputeDiscreteCurvature(mesh);
      this->Of = stamp;
    }
    return this->Curvature;
  }

  const std::vector<double>& GetValues(int type) const
  {
    return type == MEAN ? this->Curvature.Mean : this->Curvature.Gaussian;
  }

  // The thresholds when nothing else is asked for.
  void GetAutomaticThresholds(int type, const double quantiles[2], double thresholds[2]) const
  {
    std::fill_n(thresholds, 2, 0.0);
    std::vector<double> magnitudes;
    magnitudes.reserve(this->Curvature.Places.size());
    for (vtkIdType place : this->Curvature.Places)
    {
      magnitudes.push_back(std::abs(this->GetValues(type)[place]));
    }
    if (magnitudes.empty() || this->Curvature.AreaOfPlace <= 0.0)
    {
      return;
    }
    for (int i = 0; i < 2; ++i)
    {
      if (quantiles[i] > 0.0)
      {
        const auto quantile = magnitudes.begin() +
          static_cast<std::ptrdiff_t>(quantiles[i] * static_cast<double>(magnitudes.size() - 1));
        std::nth_element(magnitudes.begin(), quantile, magnitudes.end());
        thresholds[i] = *quantile;
      }
    }
    const double flat = FlatAngle / std::sqrt(this->Curvature.AreaOfPlace);
    thresholds[1] = std::max(thresholds[1], type == MEAN ? flat : flat * flat);
  }
};

vtkStandardNewMacro(vtkCurvatureDepthTagMetric);

vtkCurvatureDepthTagMetric::vtkCurvatureDepthTagMetric()
  : Internals(new vtkInternals)
{
}

vtkCurvatureDepthTagMetric::~vtkCurvatureDepthTagMetric() = default;

void vtkCurvatureDepthTagMetric::SetCurvatureType(int type)
{
  relevo::SetChoice(this, "CurvatureType", this->CurvatureType, type, { "GAUSSIAN", "MEAN" });
}

const char* vtkCurvatureDepthTagMetric::GetCurvatureTypeAsString()
{
  return this->CurvatureType == MEAN ? "Mean" : "Gaussian";
}

void vtkCurvatureDepthTagMetric::SetMinimumCurvature(double curvature)
{
  relevo::SetInRange(this, "MinimumCurvature", this->MinimumCurvature, curvature, 0.0,
    static_cast<double>(VTK_FLOAT_MAX));
}

void vtkCurvatureDepthTagMetric::SetMaximumCurvature(double curvature)
{
  relevo::SetInRange(this, "MaximumCurvature", this->MaximumCurvature, curvature, 0.0,
    static_cast<double>(VTK_FLOAT_MAX));
}

void vtkCurvatureDepthTagMetric::SetQuantiles(double low, double high)
{
  if (!(low >= 0.0 && low < high && high <= 1.0))
  {
    vtkErrorMacro("Quantiles must be 0 <= low < high <= 1, got " << low << " and " << high << ".");
    return;
  }
  if (this->Quantiles[0] != low || this->Quantiles[1] != high)
  {
    this->Quantiles[0] = low;
    this->Quantiles[1] = high;
    this->Modified();
  }
}

void vtkCurvatureDepthTagMetric::ComputeCurvatures(vtkPolyData* mesh, vtkDoubleArray* curvatures)
{
  this->Internals->Update(mesh);
  const std::vector<double>& values = this->Internals->GetValues(this->CurvatureType);
  curvatures->SetName(this->CurvatureType == MEAN ? "Mean_Curvature" : "Gauss_Curvature");
  curvatures->SetNumberOfComponents(1);
  curvatures->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), curvatures->GetPointer(0));
  curvatures->Modified();
}

bool vtkCurvatureDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const relevo::RefinementView&, int maximumLevel, vtkFloatArray* tags)
{
  if (this->MinimumCurvature > this->MaximumCurvature)
  {
    vtkErrorMacro("MinimumCurvature " << this->MinimumCurvature << " is above MaximumCurvature "
                                      << this->MaximumCurvature << ".");
    return false;
  }
  this->Internals->Update(mesh);
  const std::vector<double>& values = this->Internals->GetValues(this->CurvatureType);
  double thresholds[2] = { this->MinimumCurvature, this->MaximumCurvature };
  if (this->MaximumCurvature == 0.0)
  {
    this->Internals->GetAutomaticThresholds(this->CurvatureType, this->Quantiles, thresholds);
  }
  const auto narrow = [](double curvature)
  { return static_cast<float>(std::min<double>(curvature, VTK_FLOAT_MAX)); };
  const float low = narrow(thresholds[0]);
  const float high = narrow(thresholds[1]);
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  float* levels = tags->GetPointer(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        levels[id] = relevo::rangeLevel(narrow(std::abs(values[id])), low, high, maximumLevel);
      }
    });
  tags->Modified();
  return true;
}

void vtkCurvatureDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CurvatureType: " << this->GetCurvatureTypeAsString() << "\n";
  os << indent << "MinimumCurvature: " << this->MinimumCurvature << "\n";
  os << indent << "MaximumCurvature: " << this->MaximumCurvature << "\n";
  os << indent << "Quantiles: (" << this->Quantiles[0] << ", " << this->Quantiles[1] << ")\n";
}

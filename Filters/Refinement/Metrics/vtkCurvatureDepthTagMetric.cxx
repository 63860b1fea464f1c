// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCurvatureDepthTagMetric.h"

#include "Arrays/GhostCells.h"
#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Levels/LevelFunctions.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceTriangles.h"
#include "Metrics/CollectOnce.h"
#include "Metrics/DiscreteCurvature.h"
#include "Metrics/DisplacedSurface.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Metrics/SurfaceShape.h"
#include "Parallel/PieceReduction.h"
#include "Points/MergedPoints.h"
#include "View/RefinementView.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
constexpr double FlatAngle = 1e-3; // radians

const std::vector<double>& GetValues(const relevo::DiscreteCurvature& curvature, int type)
{
  return type == vtkCurvatureDepthTagMetric::MEAN ? curvature.Mean : curvature.Gaussian;
}

// Computes the automatic thresholds from the curvatures of points with a mean area.
std::vector<double> GetAutomaticThresholds(
  std::vector<double> magnitudes, double areaOfPlace, int type, const double quantiles[2])
{
  std::vector<double> thresholds(2, 0.0);
  if (magnitudes.empty() || !(areaOfPlace > 0.0) || !std::isfinite(areaOfPlace))
  {
    return thresholds;
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
  const double flat = FlatAngle / std::sqrt(areaOfPlace);
  const bool isMean = type == vtkCurvatureDepthTagMetric::MEAN;
  thresholds[1] = std::max(thresholds[1], isMean ? flat : flat * flat);
  return thresholds;
}

// The level at which a surface of this curvature has the same distance from its triangles as a
// surface of the high curvature at the highest level. The distance is proportional to the curvature
// and to the square of the edge length. A Gaussian curvature is a product of two curvatures.
float GetDisplacedLevel(float x, float low, float high, int maximumLevel, int type)
{
  if (!(x > low))
  {
    return 0.0f;
  }
  const double octaves = type == vtkCurvatureDepthTagMetric::MEAN ? 0.5 : 0.25;
  const double level = x < high ? maximumLevel + octaves * std::log2(x / double{ high })
                                : static_cast<double>(maximumLevel);
  return static_cast<float>(std::max(level, 0.0));
}

class CurvatureEvaluator : public relevo::MetricEvaluator
{
public:
  CurvatureEvaluator(
    vtkCurvatureDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    double thresholds[2] = { this->Metric->GetMinimumCurvature(),
      this->Metric->GetMaximumCurvature() };
    if (thresholds[0] > thresholds[1])
    {
      vtkErrorWithObjectMacro(this->Metric.Get(),
        "MinimumCurvature " << thresholds[0] << " is above MaximumCurvature " << thresholds[1]
                            << ".");
      return false;
    }
    const bool isDisplaced = view.Displaced != nullptr;
    const relevo::DiscreteCurvature& curvature = this->GetCurvature(view);
    const int type = this->Metric->GetCurvatureType();
    const std::vector<double>& values = GetValues(curvature, type);
    if (thresholds[1] == 0.0)
    {
      const std::vector<double> automatic = this->GetNumbers(view);
      std::copy(automatic.begin(), automatic.end(), thresholds);
    }
    const auto narrow = [](double value)
    { return static_cast<float>(std::min<double>(value, VTK_FLOAT_MAX)); };
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
          const float value = narrow(std::abs(values[id]));
          levels[id] = isDisplaced ? GetDisplacedLevel(value, low, high, maximumLevel, type)
                                   : relevo::rangeLevel(value, low, high, maximumLevel);
        }
      });
    tags->Modified();
    return true;
  }

protected:
  // Computes the automatic thresholds.
  std::vector<double> ComputeNumbers(
    const relevo::RefinementView& view, const relevo::PieceReduction& pieces) override
  {
    if (this->Metric->GetMaximumCurvature() > 0.0)
    {
      return {};
    }
    relevo::SurfaceShape& shape = relevo::GetShape(this->GetMesh());
    const int type = this->Metric->GetCurvatureType();
    const relevo::DiscreteCurvature& curvature = this->GetCurvature(view);
    const relevo::SurfaceTriangles& surface = *shape.GetTriangles();
    const relevo::GhostCells ghosts(this->GetMesh().GetPolyData());
    std::vector<vtkIdType> places;
    std::vector<double> magnitudes;
    magnitudes.reserve(curvature.MergedPoints.size());
    for (vtkIdType place : curvature.MergedPoints)
    {
      bool isOwn = false;
      surface.ForEachTriangleIndex(
        place, [&](vtkIdType t) { isOwn = isOwn || !ghosts.Has(surface.GetCell(t)); });
      if (isOwn)
      {
        places.push_back(place);
        magnitudes.push_back(std::abs(GetValues(curvature, type)[place]));
      }
    }
    magnitudes = relevo::CollectOnce(pieces, std::move(magnitudes),
      [&](std::size_t i)
      {
        double x[3];
        surface.GetPoint(places[i], x);
        return relevo::HashPoint(x);
      });
    std::vector<double> area(1, this->GetArea());
    pieces.Add(area);
    const double areaOfPlace = area[0] / static_cast<double>(magnitudes.size());
    return GetAutomaticThresholds(
      std::move(magnitudes), areaOfPlace, type, this->Metric->GetQuantiles());
  }

private:
  // Returns the curvature of the displaced surface if there is one, otherwise that of the mesh.
  const relevo::DiscreteCurvature& GetCurvature(const relevo::RefinementView& view)
  {
    if (!view.Displaced)
    {
      this->Displaced = {};
      this->DisplacedDependencies.Clear();
      return relevo::GetShape(this->GetMesh()).GetCurvature();
    }
    vtkPolyData* mesh = this->GetMesh().GetPolyData();
    relevo::Dependencies dependencies = relevo::Dependencies::On(this->GetMesh().GetTime());
    dependencies.AddObject(mesh);
    view.Displaced->AddTo(dependencies);
    if (this->DisplacedDependencies.Update(dependencies))
    {
      this->Displaced = view.Displaced->ComputeCurvature(mesh, this->GetMesh().GetWhole());
    }
    return this->Displaced;
  }

  // Ignores ghost cells.
  double GetArea()
  {
    const relevo::SurfaceNormals& normals = relevo::GetShape(this->GetMesh()).GetNormals();
    const relevo::GhostCells ghosts(this->GetMesh().GetPolyData());
    double area = 0.0;
    for (std::size_t t = 0; t < normals.GetAreaVectors().size(); ++t)
    {
      const vtkIdType cell = normals.GetTriangles().GetCell(static_cast<vtkIdType>(t));
      area += ghosts.Has(cell) ? 0.0 : 0.5 * glm::length(normals.GetAreaVectors()[t]);
    }
    return area;
  }

  vtkSmartPointer<vtkCurvatureDepthTagMetric> Metric;
  relevo::DiscreteCurvature Displaced;
  relevo::Dependencies DisplacedDependencies;
};
}

vtkStandardNewMacro(vtkCurvatureDepthTagMetric);

vtkCurvatureDepthTagMetric::vtkCurvatureDepthTagMetric() = default;
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
  const relevo::DiscreteCurvature curvature =
    relevo::ComputeDiscreteCurvature(relevo::SurfaceTriangles(mesh));
  const std::vector<double>& values = GetValues(curvature, this->CurvatureType);
  curvatures->SetName(this->CurvatureType == MEAN ? "Mean_Curvature" : "Gauss_Curvature");
  curvatures->SetNumberOfComponents(1);
  curvatures->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), curvatures->GetPointer(0));
  curvatures->Modified();
}

std::unique_ptr<relevo::MetricEvaluator> vtkCurvatureDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<CurvatureEvaluator>(this, mesh);
}

void vtkCurvatureDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CurvatureType: " << this->GetCurvatureTypeAsString() << "\n";
  os << indent << "MinimumCurvature: " << this->MinimumCurvature << "\n";
  os << indent << "MaximumCurvature: " << this->MaximumCurvature << "\n";
  os << indent << "Quantiles: (" << this->Quantiles[0] << ", " << this->Quantiles[1] << ")\n";
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDistanceDepthTagMetric.h"

#include "Arrays/GhostCells.h"
#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Levels/TriangleTags.h"
#include "Mesh/PatchArrays.h"
#include "Metrics/FunctionEvaluator.h"
#include "Metrics/MetricFrame.h"
#include "Parallel/PieceReduction.h"
#include "View/RefinementView.h"
#include "relevoDistanceMetric.h"
#include "relevoMetricView.h"
#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace relevo
{
struct DistanceFunctions : MetricParameters
{
  using MetricParameters::MetricParameters;
#include "glsl/Metrics/relevoMetricView.glsl"

#include "glsl/Metrics/relevoDistanceMetric.glsl"
};
}

namespace
{
using glm::dmat3;
using glm::dvec3;
using relevo::DistanceFunctions;

// In units of the bounding box's diagonal. A camera that shows a whole mesh (vtkRenderer's
// ResetCamera) is about two diagonals away.
constexpr double AutomaticDistance = 3.0;
constexpr double ShortestReference = 0.01; // pixels
constexpr double LongestReference = 1e6;

// The lengths of the sides of a mesh's triangles, up to a scale, cached until the mesh or its shape
// changes.
class SideLengths
{
public:
  // Returns their sum and number.
  const std::vector<double>& Get(relevo::MetricMesh& mesh, const relevo::Placement& placement)
  {
    const bool changed = this->LengthDependencies.Update(relevo::Dependencies::On(mesh.GetTime()));
    if (changed || !placement.HasShape(this->Shape))
    {
      this->Shape = placement.GetShape();
      this->Compute(*mesh.GetTriangles(), relevo::GhostCells(mesh.GetPolyData()));
    }
    return this->Lengths;
  }

private:
  void Compute(const relevo::SurfaceTriangles& surface, const relevo::GhostCells& ghosts)
  {
    this->Lengths.assign(2, 0.0);
    for (std::size_t t = 0; t < surface.GetTriangles().size(); ++t)
    {
      if (ghosts.Has(surface.GetCell(static_cast<vtkIdType>(t))))
      {
        continue;
      }
      const relevo::SurfaceTriangles::Triangle& triangle = surface.GetTriangles()[t];
      dvec3 corners[3];
      for (int corner = 0; corner < 3; ++corner)
      {
        surface.GetPoint(triangle[corner], &corners[corner][0]);
      }
      for (int corner = 0; corner < 3; ++corner)
      {
        const dvec3 side = corners[(corner + 1) % 3] - corners[corner];
        this->Lengths[0] += std::sqrt(std::max(glm::dot(side, this->Shape * side), 0.0));
        this->Lengths[1] += 1.0;
      }
    }
  }

  std::vector<double> Lengths{ 0.0, 0.0 };
  relevo::Dependencies LengthDependencies; // except the shape, which is compared with a tolerance
  dmat3 Shape{ 0.0 };
};

class DistanceEvaluator : public relevo::FunctionEvaluator<DistanceFunctions>
{
public:
  DistanceEvaluator(
    vtkDistanceDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : FunctionEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool GetShader(const relevo::RefinementView& view, int maximumLevel, const double origin[3],
    relevo::MetricShader& shader) override;
  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;
  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override;

protected:
  // Computes the mean length of the triangles' sides, up to a scale.
  std::vector<double> ComputeNumbers(
    const relevo::RefinementView& view, const relevo::PieceReduction& pieces) override
  {
    if (this->Metric->GetMaximumDistance() > 0.0 || this->Metric->GetReferenceLength() == 0.0)
    {
      return {};
    }
    std::vector<double> lengths = this->Sides.Get(this->GetMesh(), relevo::Placement(view));
    pieces.Add(lengths);
    return { lengths[1] > 0.0 && std::isfinite(lengths[0]) ? lengths[0] / lengths[1] : 0.0 };
  }

private:
  bool CheckView(const relevo::RefinementView& view);
  double GetFarthest(const relevo::RefinementView& view, const relevo::Placement& placement);
  bool MeasuresControlPoints()
  {
    return this->Metric->GetMeasure() == vtkDistanceDepthTagMetric::CONTROL_POINTS;
  }
  // Otherwise points are measured, which are the control points of control polygons.
  bool MeasuresTriangles()
  {
    vtkPolyData* mesh = this->GetMesh().GetPolyData();
    return this->Metric->GetMeasure() == vtkDistanceDepthTagMetric::CENTROIDS ||
      (this->MeasuresControlPoints() &&
        (mesh->GetNumberOfLines() == 0 || relevo::PatchArrays::AreOn(mesh)));
  }
  bool ComputeLevels(const relevo::RefinementView& view, int maximumLevel);
  void LevelCentroids(const relevo::MetricShader& shader);
  bool UpdatePatches();
  void LevelPatches(const relevo::MetricShader& shader);

  vtkSmartPointer<vtkDistanceDepthTagMetric> Metric;
  SideLengths Sides;
  std::vector<float> Levels; // of triangles
  relevo::PatchArrays Patches;
  relevo::Dependencies PatchDependencies;
};

bool DistanceEvaluator::CheckView(const relevo::RefinementView& view)
{
  if (!view.Camera)
  {
    vtkErrorWithObjectMacro(
      this->Metric.Get(), "There is no camera to measure distances from: call SetCamera().");
    return false;
  }
  const double* x = view.Camera->GetPosition();
  if (!std::isfinite(x[0] + x[1] + x[2]))
  {
    vtkErrorWithObjectMacro(this->Metric.Get(),
      "The camera's position (" << x[0] << ", " << x[1] << ", " << x[2] << ") is not finite.");
    return false;
  }
  if (this->Metric->GetReferenceLength() > 0.0 && this->Metric->GetMaximumDistance() == 0.0 &&
    !(relevo::GetPixelsAtUnitDistance(view) > 0.0))
  {
    vtkErrorWithObjectMacro(this->Metric.Get(),
      "The viewport has no pixels: it is " << view.ViewportSize[0] << " x " << view.ViewportSize[1]
                                           << ".");
    return false;
  }
  return true;
}

double DistanceEvaluator::GetFarthest(
  const relevo::RefinementView& view, const relevo::Placement& placement)
{
  if (this->Metric->GetMaximumDistance() > 0.0)
  {
    return this->Metric->GetMaximumDistance();
  }
  const double pixels = this->Metric->GetReferenceLength();
  return pixels > 0.0
    ? placement.GetScale() * this->GetNumbers(view)[0] / pixels *
      relevo::GetPixelsAtUnitDistance(view)
    : AutomaticDistance * placement.GetDiagonal(relevo::GetShape(this->GetMesh()).GetCornerBox());
}

bool DistanceEvaluator::GetShader(const relevo::RefinementView& view, int maximumLevel,
  const double origin[3], relevo::MetricShader& shader)
{
  if (!this->CheckView(view))
  {
    return false;
  }
  const relevo::Placement placement(view);
  shader.Source =
    this->MeasuresTriangles() ? "" : std::string(relevoMetricView) + relevoDistanceMetric;
  shader.TagsPoints = true;
  shader.Data = nullptr;
  dvec3 camera;
  view.Camera->GetPosition(&camera[0]);
  relevo::MetricFrame frame(shader, placement, camera, origin, maximumLevel);
  frame.SetUnit(this->GetFarthest(view, placement));
  const bool isProjected = this->Metric->GetFallOff() == vtkDistanceDepthTagMetric::PROJECTED_SIZE;
  frame.SetOwn(isProjected ? 1.0 : 0.0);
  return true;
}

bool DistanceEvaluator::ComputeLevels(const relevo::RefinementView& view, int maximumLevel)
{
  const relevo::LocalPoints& points = relevo::GetShape(this->GetMesh()).GetPoints();
  relevo::MetricShader shader;
  if ((this->MeasuresControlPoints() && !this->UpdatePatches()) ||
    !this->GetShader(view, maximumLevel, points.Origin, shader))
  {
    return false;
  }
  this->Levels.resize(this->GetMesh().GetTriangles()->GetTriangles().size());
  if (this->MeasuresControlPoints())
  {
    this->LevelPatches(shader);
  }
  else
  {
    this->LevelCentroids(shader);
  }
  return true;
}

void DistanceEvaluator::LevelCentroids(const relevo::MetricShader& shader)
{
  const relevo::LocalPoints& points = relevo::GetShape(this->GetMesh()).GetPoints();
  const auto& triangles = this->GetMesh().GetTriangles()->GetTriangles();
  const float* x = points.Coordinates.data();
  vtkSMPTools::For(0, static_cast<vtkIdType>(triangles.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      DistanceFunctions functions(shader);
      for (vtkIdType t = begin; t < end; ++t)
      {
        glm::vec3 sum(0.0f);
        for (vtkIdType corner : triangles[t])
        {
          sum += glm::vec3(x[3 * corner], x[3 * corner + 1], x[3 * corner + 2]);
        }
        const glm::vec4 value = functions.metricValue(sum / 3.0f, glm::vec4(0.0f));
        this->Levels[t] = functions.metricTag(functions.metricPointMeasure(value));
      }
    });
}

bool DistanceEvaluator::UpdatePatches()
{
  vtkPolyData* mesh = this->GetMesh().GetPolyData();
  std::string error;
  if (this->PatchDependencies.Update(relevo::PatchArrays::GetDependencies(mesh)) &&
    !this->Patches.Take(mesh, error))
  {
    this->PatchDependencies.Clear();
    vtkErrorWithObjectMacro(
      this->Metric.Get(), "Cannot measure distances to control points: " << error << ".");
    return false;
  }
  return true;
}

// All triangles of a patch have the level of its nearest control point.
void DistanceEvaluator::LevelPatches(const relevo::MetricShader& shader)
{
  const double* start = relevo::GetShape(this->GetMesh()).GetPoints().Origin;
  const dvec3 origin(start[0], start[1], start[2]);
  std::vector<float> levels(static_cast<std::size_t>(this->Patches.GetNumberOfPatches()));
  vtkSMPTools::For(0, this->Patches.GetNumberOfPatches(),
    [&](vtkIdType begin, vtkIdType end)
    {
      DistanceFunctions functions(shader);
      for (int i = static_cast<int>(begin); i < end; ++i)
      {
        const relevo::Patch patch = this->Patches.GetPatch(i);
        float level = 0.0f;
        for (int k = 0; k < patch.GetNumberOfPoints(); ++k)
        {
          const dvec3 point(this->Patches.GetPoint(patch.FirstPoint + k));
          const glm::vec4 value = functions.metricValue(glm::vec3(point - origin), glm::vec4(0.0f));
          level = std::max(level, functions.metricTag(functions.metricPointMeasure(value)));
        }
        levels[i] = level;
      }
    });
  const relevo::SurfaceTriangles& surface = *this->GetMesh().GetTriangles();
  for (std::size_t t = 0; t < this->Levels.size(); ++t)
  {
    const vtkIdType cell = surface.GetCell(static_cast<vtkIdType>(t));
    this->Levels[t] = levels[this->Patches.GetPatchId(cell)];
  }
}

bool DistanceEvaluator::ComputeTags(
  const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->MeasuresTriangles())
  {
    return this->TagPoints(view, maximumLevel, tags);
  }
  if (!this->ComputeLevels(view, maximumLevel))
  {
    return false;
  }
  relevo::TagPointsByTriangles(*this->GetMesh().GetTriangles(), this->Levels.data(), tags);
  return true;
}

bool DistanceEvaluator::ComputeEdgeTags(
  const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->MeasuresTriangles())
  {
    return this->FunctionEvaluator::ComputeEdgeTags(view, maximumLevel, tags);
  }
  if (!this->ComputeLevels(view, maximumLevel))
  {
    return false;
  }
  relevo::TagEdgesByTriangles(*this->GetMesh().GetEdges(), this->Levels.data(), tags);
  return true;
}
}

vtkStandardNewMacro(vtkDistanceDepthTagMetric);

vtkDistanceDepthTagMetric::vtkDistanceDepthTagMetric() = default;
vtkDistanceDepthTagMetric::~vtkDistanceDepthTagMetric() = default;

void vtkDistanceDepthTagMetric::SetFallOff(int fallOff)
{
  relevo::SetChoice(this, "FallOff", this->FallOff, fallOff, { "LINEAR", "PROJECTED_SIZE" });
}

const char* vtkDistanceDepthTagMetric::GetFallOffAsString()
{
  return this->FallOff == PROJECTED_SIZE ? "ProjectedSize" : "Linear";
}

void vtkDistanceDepthTagMetric::SetMeasure(int measure)
{
  relevo::SetChoice(
    this, "Measure", this->Measure, measure, { "VERTICES", "CENTROIDS", "CONTROL_POINTS" });
}

const char* vtkDistanceDepthTagMetric::GetMeasureAsString()
{
  const char* const names[] = { "Vertices", "Centroids", "ControlPoints" };
  return names[this->Measure];
}

void vtkDistanceDepthTagMetric::SetMaximumDistance(double distance)
{
  relevo::SetInRange(this, "MaximumDistance", this->MaximumDistance, distance, 0.0,
    static_cast<double>(VTK_FLOAT_MAX));
}

void vtkDistanceDepthTagMetric::SetReferenceLength(double pixels)
{
  if (pixels != 0.0 && !(pixels >= ShortestReference && pixels <= LongestReference))
  {
    vtkErrorMacro("ReferenceLength must be in [" << ShortestReference << ", " << LongestReference
                                                 << "] pixels, or 0 to use MaximumDistance, got "
                                                 << pixels << ".");
    return;
  }
  if (this->ReferenceLength != pixels)
  {
    this->ReferenceLength = pixels;
    this->Modified();
  }
}

std::unique_ptr<relevo::MetricEvaluator> vtkDistanceDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<DistanceEvaluator>(this, mesh);
}

void vtkDistanceDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FallOff: " << this->GetFallOffAsString() << "\n";
  os << indent << "Measure: " << this->GetMeasureAsString() << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "ReferenceLength: " << this->ReferenceLength << "\n";
}

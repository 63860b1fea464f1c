// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSilhouetteDepthTagMetric.h"

#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Mesh/SurfaceNormals.h"
#include "Metrics/ContourTags.h"
#include "Metrics/FunctionEvaluator.h"
#include "Metrics/MetricFrame.h"
#include "View/RefinementView.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include "relevoMetricView.h"
#include "relevoSilhouetteMetric.h"

#include <memory>
#include <string>
#include <vector>

namespace relevo
{
struct SilhouetteFunctions : MetricParameters
{
  using MetricParameters::MetricParameters;
#include "glsl/Metrics/relevoMetricView.glsl"

#include "glsl/Metrics/relevoSilhouetteMetric.glsl"
};
}

namespace
{
using glm::dvec3;

constexpr double NarrowestContour = 0.001;

// The normals of points for relevoSilhouetteMetric.glsl: those of the mesh, or those of the
// adjacent triangles if there are none.
class PointNormals
{
public:
  void Update(relevo::MetricMesh& mesh)
  {
    vtkDataArray* normals = mesh.GetPolyData()->GetPointData()->GetNormals();
    relevo::Dependencies dependencies = relevo::Dependencies::On(mesh.GetTime());
    dependencies.AddObject(normals);
    if (this->DataDependencies.Update(dependencies))
    {
      this->Build(normals, relevo::GetShape(mesh).GetNormals());
    }
  }

  const std::shared_ptr<const std::vector<float>>& GetData() const { return this->Data; }

private:
  void Build(vtkDataArray* normals, const relevo::SurfaceNormals& surface)
  {
    const vtkIdType numberOfPoints = surface.GetTriangles().GetNumberOfPoints();
    if (normals &&
      (normals->GetNumberOfComponents() != 3 || normals->GetNumberOfTuples() != numberOfPoints))
    {
      normals = nullptr;
    }
    const auto data =
      std::make_shared<std::vector<float>>(4 * static_cast<std::size_t>(numberOfPoints));
    this->Data = data;
    vtkSMPTools::For(0, numberOfPoints,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType point = begin; point < end; ++point)
        {
          dvec3 normal(0.0);
          if (normals)
          {
            normals->GetTuple(point, &normal[0]);
            normal = relevo::UnitOrZero(normal);
          }
          if (normal == dvec3(0.0))
          {
            const vtkIdType place = surface.GetTriangles().GetMergedPoint(point);
            normal = relevo::UnitOrZero(surface.GetAreaVectorAt(place));
          }
          float* datum = data->data() + 4 * point;
          for (int c = 0; c < 3; ++c)
          {
            datum[c] = static_cast<float>(normal[c]);
          }
          datum[3] = normal != dvec3(0.0) ? 1.0f : 0.0f;
        }
      });
  }

  std::shared_ptr<const std::vector<float>> Data;
  relevo::Dependencies DataDependencies;
};

class SilhouetteEvaluator : public relevo::FunctionEvaluator<relevo::SilhouetteFunctions>
{
public:
  SilhouetteEvaluator(
    vtkSilhouetteDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : FunctionEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool GetShader(const relevo::RefinementView& view, int maximumLevel, const double origin[3],
    relevo::MetricShader& shader) override
  {
    relevo::Eye eye;
    std::string error;
    if (!eye.Set(view, error))
    {
      vtkErrorWithObjectMacro(this->Metric.Get(), << error << ".");
      return false;
    }
    const relevo::Placement placement(view);
    relevo::MetricFrame frame(shader, placement, eye.GetPosition(), origin, maximumLevel);
    const double diagonal = placement.GetDiagonal(relevo::GetShape(this->GetMesh()).GetPointBox());
    frame.SetUnit(diagonal > 0.0 ? diagonal : 1.0);
    frame.SetDirections(eye);
    frame.SetOwn(this->Metric->GetContourWidth());
    shader.TagsPoints = !this->IsContour();
    shader.Source.clear();
    shader.Data = nullptr;
    if (shader.TagsPoints)
    {
      shader.Source = std::string(relevoMetricView) + relevoSilhouetteMetric;
      this->Normals.Update(this->GetMesh());
      shader.Data = this->Normals.GetData();
    }
    return true;
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->IsContour() ? this->Contour.TagPoints(*this, view, maximumLevel, tags)
                             : this->TagPoints(view, maximumLevel, tags);
  }

  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->IsContour() ? this->Contour.TagEdges(*this, view, maximumLevel, tags)
                             : this->FunctionEvaluator::ComputeEdgeTags(view, maximumLevel, tags);
  }

private:
  bool IsContour() { return this->Metric->GetCriterion() == vtkSilhouetteDepthTagMetric::CONTOUR; }

  vtkSmartPointer<vtkSilhouetteDepthTagMetric> Metric;
  PointNormals Normals;
  relevo::ContourTags Contour;
};
}

vtkStandardNewMacro(vtkSilhouetteDepthTagMetric);

vtkSilhouetteDepthTagMetric::vtkSilhouetteDepthTagMetric() = default;
vtkSilhouetteDepthTagMetric::~vtkSilhouetteDepthTagMetric() = default;

void vtkSilhouetteDepthTagMetric::SetCriterion(int criterion)
{
  relevo::SetChoice(this, "Criterion", this->Criterion, criterion, { "NORMAL_ANGLE", "CONTOUR" });
}

const char* vtkSilhouetteDepthTagMetric::GetCriterionAsString()
{
  return this->Criterion == CONTOUR ? "Contour" : "NormalAngle";
}

void vtkSilhouetteDepthTagMetric::SetContourWidth(double width)
{
  relevo::SetInRange(this, "ContourWidth", this->ContourWidth, width, NarrowestContour, 1.0);
}

std::unique_ptr<relevo::MetricEvaluator> vtkSilhouetteDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<SilhouetteEvaluator>(this, mesh);
}

void vtkSilhouetteDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Criterion: " << this->GetCriterionAsString() << "\n";
  os << indent << "ContourWidth: " << this->ContourWidth << "\n";
}

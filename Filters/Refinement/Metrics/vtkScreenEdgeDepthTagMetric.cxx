// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScreenEdgeDepthTagMetric.h"

#include "Checks/SettingChecks.h"
#include "Metrics/FunctionEvaluator.h"
#include "Metrics/MetricFrame.h"
#include "View/RefinementView.h"
#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include "relevoMetricView.h"
#include "relevoScreenEdgeMetric.h"

#include <cmath>
#include <string>

namespace relevo
{
struct ScreenEdgeFunctions : MetricParameters
{
  using MetricParameters::MetricParameters;
#include "glsl/Metrics/relevoMetricView.glsl"

#include "glsl/Metrics/relevoScreenEdgeMetric.glsl"
};
}

namespace
{
using glm::dmat4;

constexpr double SmallestReferenceLength = 0.01;
constexpr double LargestReferenceLength = 1e6;

// The rows of a matrix.
enum Rows
{
  X,
  Y,
  BEYOND_NEAR_PLANE,
  W
};

// Returns the matrix from world coordinates to the rows of relevoScreenEdgeMetric.glsl, with x and
// y in `pixels`.
dmat4 MakeScreenMatrix(vtkCamera* camera, const int size[2], double pixels)
{
  const double aspect = static_cast<double>(size[0]) / size[1];
  dmat4 matrix =
    relevo::MakeMatrix(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0));
  for (int column = 0; column < 4; ++column)
  {
    glm::dvec4& c = matrix[column];
    c[X] *= 0.5 * size[0] / pixels;
    c[Y] *= 0.5 * size[1] / pixels;
    c[BEYOND_NEAR_PLANE] =
      camera->GetParallelProjection() ? (column == 3 ? 1.0 : 0.0) : c[2] + c[W];
  }
  return matrix;
}

// The length of a world unit at a distance of 1, in units of the x and y of this matrix.
double GetScale(const dmat4& screen)
{
  const dmat4 rows = glm::transpose(screen);
  return std::max(glm::length(glm::dvec3(rows[X])), glm::length(glm::dvec3(rows[Y])));
}

class ScreenEdgeEvaluator : public relevo::FunctionEvaluator<relevo::ScreenEdgeFunctions>
{
public:
  ScreenEdgeEvaluator(
    vtkScreenEdgeDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : FunctionEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool GetShader(const relevo::RefinementView& view, int maximumLevel, const double origin[3],
    relevo::MetricShader& shader) override;

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    return this->TagPointsByEdges(view, maximumLevel, tags);
  }

private:
  bool CheckView(const relevo::RefinementView& view, relevo::Eye& eye);

  vtkSmartPointer<vtkScreenEdgeDepthTagMetric> Metric;
};

bool ScreenEdgeEvaluator::CheckView(const relevo::RefinementView& view, relevo::Eye& eye)
{
  const int* size = view.ViewportSize;
  if (size[0] < 1 || size[1] < 1)
  {
    vtkErrorWithObjectMacro(this->Metric.Get(),
      "The viewport has no pixels: it is " << size[0] << " x " << size[1] << ".");
    return false;
  }
  std::string error;
  if (!eye.Set(view, error))
  {
    vtkErrorWithObjectMacro(this->Metric.Get(), << error << ".");
    return false;
  }
  const glm::dmat3 directions(relevo::MakeMatrix(view.Camera->GetViewTransformMatrix()));
  // The determinant is 1 unless the camera is invalid or its view is sheared.
  if (!(std::abs(glm::determinant(directions)) > 1e-9))
  {
    vtkErrorWithObjectMacro(this->Metric.Get(),
      "The camera's view-up is parallel to its view direction, or its view transform is singular.");
    return false;
  }
  return true;
}

bool ScreenEdgeEvaluator::GetShader(const relevo::RefinementView& view, int maximumLevel,
  const double origin[3], relevo::MetricShader& shader)
{
  relevo::Eye eye;
  if (!this->CheckView(view, eye))
  {
    return false;
  }
  shader.Source = std::string(relevoMetricView) + relevoScreenEdgeMetric;
  shader.TagsPoints = false;
  shader.Data = nullptr;
  const relevo::Placement placement(view);
  relevo::MetricFrame frame(shader, placement, eye.GetPosition(), origin, maximumLevel);
  const dmat4 screen =
    MakeScreenMatrix(view.Camera, view.ViewportSize, this->Metric->GetReferenceLength());
  if (this->Metric->GetMeasure() == vtkScreenEdgeDepthTagMetric::PROJECTED_LENGTH)
  {
    frame.SetMatrix(screen * placement.ModelToWorld);
    frame.SetOwn(0.0);
    return true;
  }
  // Units of the mesh keep squares in the range of floats.
  const double unit = placement.GetDiagonal(relevo::GetShape(this->GetMesh()).GetPointBox());
  const double scale = GetScale(screen) * (view.Camera->GetParallelProjection() ? unit : 1.0);
  frame.SetUnit(unit);
  frame.SetDirections(eye);
  frame.SetOwn(scale * scale);
  return true;
}
}

vtkStandardNewMacro(vtkScreenEdgeDepthTagMetric);

vtkScreenEdgeDepthTagMetric::vtkScreenEdgeDepthTagMetric() = default;
vtkScreenEdgeDepthTagMetric::~vtkScreenEdgeDepthTagMetric() = default;

void vtkScreenEdgeDepthTagMetric::SetReferenceLength(double pixels)
{
  relevo::SetInRange(this, "ReferenceLength", this->ReferenceLength, pixels,
    SmallestReferenceLength, LargestReferenceLength);
}

void vtkScreenEdgeDepthTagMetric::SetMeasure(int measure)
{
  relevo::SetChoice(
    this, "Measure", this->Measure, measure, { "PROJECTED_LENGTH", "SPHERE_DIAMETER" });
}

std::unique_ptr<relevo::MetricEvaluator> vtkScreenEdgeDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<ScreenEdgeEvaluator>(this, mesh);
}

void vtkScreenEdgeDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReferenceLength: " << this->ReferenceLength << "\n";
  os << indent << "Measure: " << this->Measure << "\n";
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDistanceDepthTagMetric.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkMetricEvaluation.h"
#include "vtkMetricFrame.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRefinementView.h"

#include "relevoDistanceMetric.h"
#include "relevoMetricView.h"

#include <cmath>
#include <string>

namespace relevo
{
struct DistanceFunctions : MetricParameters
{
  using MetricParameters::MetricParameters;
#include "glsl/relevoMetricView.glsl"

#include "glsl/relevoDistanceMetric.glsl"
};
}

namespace
{
// In units of the bounding box's diagonal; a camera that shows a whole mesh (vtkRenderer's
// ResetCamera) is about two of them away.
constexpr double AutomaticDistance = 3.0;
}

struct vtkDistanceDepthTagMetric::vtkInternals : relevo::MetricEvaluation<relevo::DistanceFunctions>
{
};

vtkStandardNewMacro(vtkDistanceDepthTagMetric);

vtkDistanceDepthTagMetric::vtkDistanceDepthTagMetric()
  : Internals(new vtkInternals)
{
}

vtkDistanceDepthTagMetric::~vtkDistanceDepthTagMetric() = default;

void vtkDistanceDepthTagMetric::SetMaximumDistance(double distance)
{
  if (!(distance >= 0.0 && distance <= VTK_FLOAT_MAX))
  {
    vtkErrorMacro("MaximumDistance " << distance
                                     << " is not a distance: give a finite number of world units, "
                                        "or 0 for automatic.");
    return;
  }
  if (this->MaximumDistance != distance)
  {
    this->MaximumDistance = distance;
    this->Modified();
  }
}

bool vtkDistanceDepthTagMetric::GetShader(vtkPolyData* mesh, const vtkRefinementView& view,
  int maximumLevel, const double origin[3], relevo::MetricShader& shader)
{
  if (!view.Camera)
  {
    vtkErrorMacro("There is no camera to measure distances from.");
    return false;
  }
  glm::dvec3 camera;
  view.Camera->GetPosition(&camera[0]);
  if (!std::isfinite(camera[0] + camera[1] + camera[2]))
  {
    vtkErrorMacro("The camera's position (" << camera[0] << ", " << camera[1] << ", " << camera[2]
                                            << ") is not finite.");
    return false;
  }
  static const std::string source = std::string(relevoMetricView) + relevoDistanceMetric;
  shader.Source = source.c_str();
  shader.TagsPoints = true;
  shader.Data = nullptr;
  const relevo::Placement placement(view);
  relevo::MetricFrame frame(shader, placement, camera, origin, maximumLevel);
  frame.SetUnit(this->MaximumDistance > 0.0 ? this->MaximumDistance
                                            : AutomaticDistance * placement.GetDiagonal(mesh));
  frame.SetOwn(0.0);
  return true;
}

bool vtkDistanceDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  return this->Internals->TagPoints(this, mesh, view, maximumLevel, tags);
}

bool vtkDistanceDepthTagMetric::ComputeEdgeTags(vtkPolyData* mesh, const vtkRefinementView& view,
  int maximumLevel, const relevo::SurfaceEdges& edges, vtkFloatArray* tags)
{
  return this->Internals->TagEdges(this, mesh, view, maximumLevel, edges, tags);
}

void vtkDistanceDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
}

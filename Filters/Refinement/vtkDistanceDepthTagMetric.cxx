// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDistanceDepthTagMetric.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementMathematics.h"
#include "vtkRefinementView.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceEdges.h"
#include "vtkWorldView.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
#include "glsl/relevoMetrics.glsl"
}

namespace
{
// In units of the bounding box's diagonal; a camera that shows a whole mesh (vtkRenderer's
// ResetCamera) is about two of them away.
constexpr double AutomaticDistance = 3.0;
}

vtkStandardNewMacro(vtkDistanceDepthTagMetric);

vtkDistanceDepthTagMetric::vtkDistanceDepthTagMetric() = default;
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

bool vtkDistanceDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel, vtkFloatArray* tags)
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

  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(numberOfPoints);
  if (numberOfPoints == 0)
  {
    return true;
  }

  const relevo::Placement placement(view);
  const double farthest = this->MaximumDistance > 0.0
    ? this->MaximumDistance
    : AutomaticDistance * placement.GetDiagonal(mesh);
  const float farthestFloat = static_cast<float>(std::min<double>(farthest, VTK_FLOAT_MAX));
  vtkPoints* points = mesh->GetPoints();
  float* levels = tags->GetPointer(0);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        glm::dvec3 point;
        points->GetPoint(id, &point[0]);
        const double x = glm::distance(placement.GetPoint(point), camera);
        levels[id] = relevo::distanceLevel(
          static_cast<float>(std::min<double>(x, VTK_FLOAT_MAX)), farthestFloat, maximumLevel);
      }
    });
  tags->Modified();
  return true;
}

bool vtkDistanceDepthTagMetric::ComputeEdgeTags(vtkPolyData* mesh, const vtkRefinementView& view,
  int maximumLevel, const relevo::SurfaceEdges& edges, vtkFloatArray* tags)
{
  vtkNew<vtkFloatArray> pointTags;
  if (!this->ComputeTags(mesh, view, maximumLevel, pointTags))
  {
    return false;
  }
  const float* ofPoints = pointTags->GetPointer(0);
  relevo::TagEdges(edges, tags,
    [&](int edge)
    {
      const int* places = edges.GetEdges()[edge].Places;
      return std::max(ofPoints[places[0]], ofPoints[places[1]]);
    });
  return true;
}

void vtkDistanceDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
}

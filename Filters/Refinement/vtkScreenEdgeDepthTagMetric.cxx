// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScreenEdgeDepthTagMetric.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRefinementMathematics.h"
#include "vtkRefinementView.h"
#include "vtkSurfaceEdges.h"
#include "vtkWorldView.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace relevo
{
#include "glsl/relevoMetrics.glsl"
}

namespace
{
using glm::dmat4;
using glm::dvec2;
using glm::dvec4;

constexpr double ShortestReference = 0.01;
constexpr double LongestReference = 1e6;

// Measures edges in pixels.
class Screen
{
public:
  bool Set(const vtkRefinementView& view, std::string& error)
  {
    const int* size = view.ViewportSize;
    if (size[0] < 1 || size[1] < 1)
    {
      error = "The viewport has no pixels: it is " + std::to_string(size[0]) + " x " +
        std::to_string(size[1]);
      return false;
    }
    relevo::Eye eye;
    if (!eye.Set(view, error))
    {
      return false;
    }
    const glm::dmat3 directions(relevo::MakeMatrix(view.Camera->GetViewTransformMatrix()));
    // 1 unless the camera is broken or its view sheared.
    if (!(std::abs(glm::determinant(directions)) > 1e-9))
    {
      error = "The camera's view-up is along its view direction, or its view is flat";
      return false;
    }
    const double aspect = static_cast<double>(size[0]) / size[1];
    this->ToClip =
      relevo::MakeMatrix(view.Camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)) *
      relevo::MakeMatrix(view.ModelToWorld);
    this->CutsAtNearPlane = !view.Camera->GetParallelProjection();
    this->PixelsPerUnit = 0.5 * dvec2(size[0], size[1]);
    return true;
  }

  double GetLength(const glm::dvec3& from, const glm::dvec3& to) const
  {
    dvec4 a = this->ToClip * dvec4(from, 1.0);
    dvec4 b = this->ToClip * dvec4(to, 1.0);
    if (this->CutsAtNearPlane && !Cut(a, b))
    {
      return 0.0;
    }
    return glm::length((dvec2(b) / b.w - dvec2(a) / a.w) * this->PixelsPerUnit);
  }

private:
  // Keeps the part of an edge that is beyond the near plane, where z + w is 0 and w positive.
  static bool Cut(dvec4& a, dvec4& b)
  {
    const double beyondA = a.z + a.w;
    const double beyondB = b.z + b.w;
    if (!(beyondA > 0.0 || beyondB > 0.0))
    {
      return false;
    }
    const dvec4 crossing = glm::mix(a, b, beyondA / (beyondA - beyondB));
    if (!(beyondA > 0.0))
    {
      a = crossing;
    }
    else if (!(beyondB > 0.0))
    {
      b = crossing;
    }
    return a.w > 0.0 && b.w > 0.0;
  }

  dmat4 ToClip{ 1.0 };
  dvec2 PixelsPerUnit{ 0.0 };
  bool CutsAtNearPlane = true;
};
}

struct vtkScreenEdgeDepthTagMetric::vtkInternals
{
  relevo::SurfaceEdges Edges;
};

vtkStandardNewMacro(vtkScreenEdgeDepthTagMetric);

vtkScreenEdgeDepthTagMetric::vtkScreenEdgeDepthTagMetric()
  : Internals(new vtkInternals)
{
}

vtkScreenEdgeDepthTagMetric::~vtkScreenEdgeDepthTagMetric() = default;

void vtkScreenEdgeDepthTagMetric::SetReferenceLength(double pixels)
{
  if (!(pixels >= ShortestReference && pixels <= LongestReference))
  {
    vtkErrorMacro("ReferenceLength " << pixels << " is no length of segments: give "
                                     << ShortestReference << " to " << LongestReference
                                     << " pixels.");
    return;
  }
  if (this->ReferenceLength != pixels)
  {
    this->ReferenceLength = pixels;
    this->Modified();
  }
}

bool vtkScreenEdgeDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  relevo::SurfaceEdges& edges = this->Internals->Edges;
  edges.Update(mesh);
  vtkNew<vtkFloatArray> edgeTags;
  if (!this->ComputeEdgeTags(mesh, view, maximumLevel, edges, edgeTags))
  {
    return false;
  }
  edges.TagPoints(edgeTags->GetPointer(0), tags);
  return true;
}

bool vtkScreenEdgeDepthTagMetric::ComputeEdgeTags(vtkPolyData*, const vtkRefinementView& view,
  int maximumLevel, const relevo::SurfaceEdges& edges, vtkFloatArray* tags)
{
  Screen screen;
  std::string error;
  if (!screen.Set(view, error))
  {
    vtkErrorMacro(<< error << ".");
    return false;
  }
  const float reference = static_cast<float>(this->ReferenceLength);
  relevo::TagEdges(edges, tags,
    [&](int edge)
    {
      glm::dvec3 ends[2];
      for (int end = 0; end < 2; ++end)
      {
        edges.GetTriangles().GetPoint(edges.GetEdges()[edge].Places[end], &ends[end][0]);
      }
      const double length = screen.GetLength(ends[0], ends[1]);
      return relevo::lengthLevel(
        static_cast<float>(std::min<double>(length, VTK_FLOAT_MAX)), reference, maximumLevel);
    });
  return true;
}

void vtkScreenEdgeDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReferenceLength: " << this->ReferenceLength << "\n";
}

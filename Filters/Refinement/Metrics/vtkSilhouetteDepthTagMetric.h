// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSilhouetteDepthTagMetric
 * @brief   refine the silhouette of a surface
 *
 * There are two criteria. With v the unit vector from a point to the eye, in world coordinates, and
 * n the unit normal at the point, the criterion NORMAL_ANGLE, the default, is (Nellmeldin 2013,
 * "Desarrollo de algoritmos de teselacion adaptativa en GPU", eq. 13, after Boubekeur and Alexa
 * 2008):
 *
 *     level = MaximumLevel * (1 - |n . v|)
 *
 * It is 0 where the surface faces the eye or faces away from it, and MaximumLevel where the surface
 * is seen edge-on. The normals are the point normals of the mesh. If there are none, or if one is
 * zero or not finite, the area-weighted mean normal of the triangles at the point is used. With the
 * rule PER_EDGE, an edge has the larger level of its two ends, and MaximumLevel if one of them
 * faces the eye and the other faces away.
 *
 * The criterion CONTOUR follows the silhouetteness of edges by Dyken, Reimers and Seland 2008
 * ("Real-time GPU silhouette refinement using adaptively blended Bezier patches"): 1 where one
 * triangle faces the eye and the other faces away, with a continuous fall-off to 0. The fall-off
 * differs from the paper, so that ContourWidth is the cosine of an angle. With n1 and n2 the unit
 * normals of the two triangles of an edge, v at its midpoint, f1 = n1 . v and f2 = n2 . v, the
 * level of the edge is
 *
 *     level = MaximumLevel                                           if f1 f2 <= 0
 *     level = MaximumLevel * max(0, 1 - min(|f1|, |f2|) / ContourWidth)      otherwise
 *
 * With the rule PER_VERTEX, a point has the largest level of its edges. Edges of one triangle, or
 * of more than two, are always on the contour. Adjacent triangles with opposite winding are treated
 * as if their winding matched. Coincident points are merged.
 *
 * With a parallel camera, v is the same everywhere. A point or an edge's midpoint at the eye has
 * MaximumLevel. Non-finite points, and points with neither triangles nor a normal, have level 0.
 *
 * The metric depends on the view. Computing tags fails with an error if there is no camera or if
 * its position is its focal point.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkViewDependentDepthTagMetric
 */
#ifndef vtkSilhouetteDepthTagMetric_h
#define vtkSilhouetteDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkSilhouetteDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkSilhouetteDepthTagMetric* New();
  vtkTypeMacro(vtkSilhouetteDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The criteria for the silhouette.
   */
  enum Criteria
  {
    NORMAL_ANGLE = 0,
    CONTOUR = 1
  };

  //@{
  /**
   * Set the criterion for the silhouette: NORMAL_ANGLE (0, the default) or CONTOUR (1). Other
   * values are rejected with an error.
   */
  void SetCriterion(int criterion);
  vtkGetMacro(Criterion, int);
  void SetCriterionToNormalAngle() { this->SetCriterion(NORMAL_ANGLE); }
  void SetCriterionToContour() { this->SetCriterion(CONTOUR); }
  //@}

  /**
   * Return the criterion as "NormalAngle" or "Contour".
   */
  const char* GetCriterionAsString();

  //@{
  /**
   * Set the cosine of the angle between normal and view at which the level reaches 0 with the
   * criterion CONTOUR, 0.001 to 1. The default of 0.25 means that the level reaches 0 at 14.5
   * degrees from the contour. Values out of range are rejected with an error.
   */
  void SetContourWidth(double width);
  vtkGetMacro(ContourWidth, double);
  //@}

  bool IsViewDependent() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkSilhouetteDepthTagMetric();
  ~vtkSilhouetteDepthTagMetric() override;

  int Criterion = NORMAL_ANGLE;
  double ContourWidth = 0.25;

private:
  vtkSilhouetteDepthTagMetric(const vtkSilhouetteDepthTagMetric&) = delete;
  void operator=(const vtkSilhouetteDepthTagMetric&) = delete;
};

#endif

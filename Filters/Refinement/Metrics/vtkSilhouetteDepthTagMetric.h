// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSilhouetteDepthTagMetric
 * @brief   refines the outline of what is seen
 *
 * With v the unit vector from a point to the eye, in world coordinates, one of two criteria:
 *
 * NORMAL_ANGLE, the default (Nellmeldin 2013, "Desarrollo de algoritmos de teselacion adaptativa en
 * GPU", eq. 13, after Boubekeur and Alexa 2008), with n the unit normal at the point:
 *
 *     level = MaximumLevel * (1 - |n . v|)
 *
 * 0 where the surface faces the eye, or faces away from it as the inside of an open surface does,
 * and MaximumLevel where it is seen edge-on. The normals are the mesh's own point normals; where
 * there are none, or one is zero or not finite, the mean of the normals of the triangles at the
 * point, weighted by area. By the rule PER_EDGE an edge has the larger level of its two ends, and
 * MaximumLevel where one of them faces the eye and the other away from it.
 *
 * CONTOUR (after the silhouetteness of edges by Dyken, Reimers and Seland 2008, "Real-time GPU
 * silhouette refinement using adaptively blended Bezier patches": 1 where one triangle faces the
 * eye and the other away, and falling continuously to 0; how it falls is this class's own, so that
 * ContourWidth is the cosine of an angle), with n1, n2 the unit normals of the two triangles of an
 * edge, v taken at its midpoint, and f1 = n1 . v, f2 = n2 . v:
 *
 *     level = MaximumLevel                                           if f1 f2 <= 0
 *     level = MaximumLevel * max(0, 1 - min(|f1|, |f2|) / ContourWidth)      otherwise
 *
 * for every edge, and of a point, by the rule PER_VERTEX, the largest over its edges. An edge of
 * one triangle, or of more than two, is always a contour. Triangles that wind against each other
 * are treated as if they did not; points at the same coordinates are one point.
 *
 * With a parallel camera v is the same everywhere. A point or edge's midpoint at the eye itself has
 * MaximumLevel, a point of no triangle and without a normal, or one
 * that is not finite, level 0.
 *
 * The metric depends on the view: no camera, or one whose position is its focal point, is an error
 * when tags are computed.
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
   * The criteria to choose from.
   */
  enum Criteria
  {
    NORMAL_ANGLE = 0,
    CONTOUR = 1
  };

  //@{
  /**
   * What makes the outline: NORMAL_ANGLE (0, the default) or CONTOUR (1). Another value is an error
   * and changes nothing.
   */
  void SetCriterion(int criterion);
  vtkGetMacro(Criterion, int);
  void SetCriterionToNormalAngle() { this->SetCriterion(NORMAL_ANGLE); }
  void SetCriterionToContour() { this->SetCriterion(CONTOUR); }
  //@}

  /**
   * "NormalAngle" or "Contour".
   */
  const char* GetCriterionAsString();

  //@{
  /**
   * Cosine of the angle between normal and view from which on the level is 0 with the criterion
   * CONTOUR, 0.001 to 1; default 0.25: refinement fades within 14.5 degrees from the contour.
   * Another value is an error and changes nothing.
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

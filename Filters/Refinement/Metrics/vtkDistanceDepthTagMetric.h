// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDistanceDepthTagMetric
 * @brief   refine what is near the camera
 *
 * With x the distance from the camera's position, in world coordinates (the actor's matrix is
 * applied to the mesh), and d = MaximumDistance, the depth-tag depends on FallOff:
 *
 *     LINEAR (default)     level = MaximumLevel * (1 - x / d)
 *     PROJECTED_SIZE       level = log2(d / x)
 *
 * It is clamped to [0, MaximumLevel], and 0 where x exceeds d.
 *
 * LINEAR is the tessellation level T = 64 - 63 x / d_max of Nellmeldin 2013 ("Desarrollo de
 * algoritmos de teselacion adaptativa en GPU", eq. 1), with its range [1, 64] mapped linearly to
 * [0, MaximumLevel]. An edge has 2^level segments, so segments shorten geometrically towards the
 * camera. PROJECTED_SIZE keeps the segments of edges of equal length equally long on the screen: at
 * half the distance an edge appears twice as long, and its level is higher by one.
 *
 * d can be derived from ReferenceLength, the requested length of segments in pixels. With s the
 * mean length of the triangles' sides in the world, h the height of the viewport in pixels and a
 * the camera's view angle,
 *
 *     d = s / ReferenceLength * h / (2 tan(a / 2))
 *
 * is the distance at which such a side, seen from the front, is ReferenceLength pixels long (the
 * polygon size from which d_max of eq. 1 is chosen). With PROJECTED_SIZE, segments then have this
 * length if MaximumLevel allows. If the camera measures its view angle horizontally, h is the width
 * of the viewport. The view angle is also used with a parallel camera, although its image does not
 * shrink with the distance.
 *
 * Measure selects the points that x is measured to. With VERTICES, they are the points of the mesh.
 * With CENTROIDS, they are the centroids of the triangles (polygons are split into fans), and a
 * point has the largest level of its triangles. With the rule PER_EDGE, an edge has the level of
 * its nearer end or of its nearer triangle.
 *
 * CONTROL_POINTS is for surfaces from vtkPatchSurfaceFilter. All triangles of a patch use the
 * smallest distance to its control points, as in Nellmeldin 2013 for curves, and points and edges
 * get levels as with CENTROIDS. Line cells are control polygons of curves: each of their points
 * uses its own distance, and the curve takes the largest level. Meshes of triangles without patches
 * are an error.
 *
 * This metric ignores the projected size of faces and the resolution of a height map. A view of a
 * whole terrain can get more triangles than the height map has samples. vtkScreenEdgeDepthTagMetric
 * creates only as many triangles as the image needs.
 *
 * The metric depends on the view. Computing tags fails with an error if there is no camera, if its
 * position is not finite, or if ReferenceLength is used with a viewport without pixels. Non-finite
 * points have level 0.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkCurvatureDepthTagMetric
 */
#ifndef vtkDistanceDepthTagMetric_h
#define vtkDistanceDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkDistanceDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkDistanceDepthTagMetric* New();
  vtkTypeMacro(vtkDistanceDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How levels decrease with the distance.
   */
  enum FallOffs
  {
    LINEAR = 0,
    PROJECTED_SIZE = 1
  };

  /**
   * The points that the distance is measured to.
   */
  enum Measures
  {
    VERTICES = 0,
    CENTROIDS = 1,
    CONTROL_POINTS = 2
  };

  //@{
  /**
   * Set how levels decrease with the distance: LINEAR (0, the default) or PROJECTED_SIZE (1). Other
   * values are rejected with an error.
   */
  void SetFallOff(int fallOff);
  vtkGetMacro(FallOff, int);
  void SetFallOffToLinear() { this->SetFallOff(LINEAR); }
  void SetFallOffToProjectedSize() { this->SetFallOff(PROJECTED_SIZE); }
  //@}

  /**
   * Return the fall-off as "Linear" or "ProjectedSize".
   */
  const char* GetFallOffAsString();

  //@{
  /**
   * Set the points that the distance is measured to: VERTICES (0, the default), CENTROIDS (1) of
   * triangles, or CONTROL_POINTS (2) of patches and curves. Other values are rejected with an
   * error.
   */
  void SetMeasure(int measure);
  vtkGetMacro(Measure, int);
  void SetMeasureToVertices() { this->SetMeasure(VERTICES); }
  void SetMeasureToCentroids() { this->SetMeasure(CENTROIDS); }
  void SetMeasureToControlPoints() { this->SetMeasure(CONTROL_POINTS); }
  //@}

  /**
   * Return the measure as "Vertices", "Centroids" or "ControlPoints".
   */
  const char* GetMeasureAsString();

  //@{
  /**
   * Set the distance from the camera beyond which nothing is refined, in world units. With 0, the
   * default, it is derived from ReferenceLength. If that is 0 too, it is three times the diagonal
   * of the faces' bounding box in world units, so that a view of the whole mesh is refined
   * moderately and close-ups are refined more. Values that are negative or not finite as floats are
   * rejected with an error.
   */
  void SetMaximumDistance(double distance);
  vtkGetMacro(MaximumDistance, double);
  //@}

  //@{
  /**
   * Set the requested length of a segment in pixels, 0.01 to 1e6, from which the distance is
   * derived if MaximumDistance is 0. The default of 0 means none. Values out of range are rejected
   * with an error.
   */
  void SetReferenceLength(double pixels);
  vtkGetMacro(ReferenceLength, double);
  //@}

  bool IsViewDependent() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkDistanceDepthTagMetric();
  ~vtkDistanceDepthTagMetric() override;

  int FallOff = LINEAR;
  int Measure = VERTICES;
  double MaximumDistance = 0.0;
  double ReferenceLength = 0.0;

private:
  vtkDistanceDepthTagMetric(const vtkDistanceDepthTagMetric&) = delete;
  void operator=(const vtkDistanceDepthTagMetric&) = delete;
};

#endif

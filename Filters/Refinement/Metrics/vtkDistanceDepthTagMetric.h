// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDistanceDepthTagMetric
 * @brief   refines what is near the camera
 *
 * With x the distance from the camera's position, in world coordinates (the actor's matrix is
 * applied to the mesh), and d = MaximumDistance, the depth-tag is by FallOff
 *
 *     LINEAR (default)     level = MaximumLevel * (1 - x / d)
 *     PROJECTED_SIZE       level = log2(d / x)
 *
 * clamped to [0, MaximumLevel], and 0 where x exceeds d.
 *
 * The first is the tessellation level T = 64 - 63 x / d_max of Nellmeldin 2013 ("Desarrollo de
 * algoritmos de teselacion adaptativa en GPU", eq. 1), its range [1, 64] mapped linearly to
 * [0, MaximumLevel]: as an edge has 2^level segments, its segments shorten geometrically towards
 * the camera. The second keeps the segments of an edge of a given length equally long on the
 * screen: what is half as far away appears twice as large, and has one level more.
 *
 * d can be derived from a wanted length of segments in pixels, ReferenceLength: with s the mean
 * length of the triangles' sides in the world, h the height of the viewport in pixels and a the
 * camera's view angle,
 *
 *     d = s / ReferenceLength * h / (2 tan(a / 2))
 *
 * is the distance from which such a side, seen from the front, appears as long as ReferenceLength
 * (the polygon size that d_max of eq. 1 is chosen by). With PROJECTED_SIZE segments then have this
 * length, as long as MaximumLevel allows. Under a camera that measures its angle across the
 * viewport h is the width. A parallel camera, whose picture does not shrink with the distance, is
 * taken by its view angle all the same.
 *
 * x is measured by Measure to the points themselves, or to the centroids of the triangles (the
 * triangle fans of polygons): a point then has the largest level of the triangles at it. By the
 * rule PER_EDGE an edge has the level of its end that is nearer to the camera, or of the nearer of
 * its triangles.
 *
 * CONTROL_POINTS, of a surface from vtkPatchSurfaceFilter: x is the least distance to the control
 * points of a patch, for all its triangles, which then have levels as by centroids. So is it in
 * Nellmeldin 2013 for curves: of line cells, which are control polygons, each point is measured to
 * itself, and the curve takes the largest level. A mesh of triangles that are no patches is an
 * error.
 *
 * Levels do not know how large a face is on the screen, nor how dense a height map is: a whole
 * terrain in view can have more triangles than its height map has samples.
 * vtkScreenEdgeDepthTagMetric makes as many as the picture needs.
 *
 * The metric depends on the view: without a camera it is an error, and so is a camera whose
 * position is not finite, or ReferenceLength with a viewport without pixels. A point that is not
 * finite gets level 0.
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
   * How levels fall with the distance.
   */
  enum FallOffs
  {
    LINEAR = 0,
    PROJECTED_SIZE = 1
  };

  /**
   * What the distance is measured to.
   */
  enum Measures
  {
    VERTICES = 0,
    CENTROIDS = 1,
    CONTROL_POINTS = 2
  };

  //@{
  /**
   * How levels fall with the distance: LINEAR (0, the default) or PROJECTED_SIZE (1). Another value
   * is an error and changes nothing.
   */
  void SetFallOff(int fallOff);
  vtkGetMacro(FallOff, int);
  void SetFallOffToLinear() { this->SetFallOff(LINEAR); }
  void SetFallOffToProjectedSize() { this->SetFallOff(PROJECTED_SIZE); }
  //@}

  /**
   * "Linear" or "ProjectedSize".
   */
  const char* GetFallOffAsString();

  //@{
  /**
   * What the distance is measured to: VERTICES (0, the default), CENTROIDS (1) of triangles, or
   * CONTROL_POINTS (2) of patches and curves. Another value is an error and changes nothing.
   */
  void SetMeasure(int measure);
  vtkGetMacro(Measure, int);
  void SetMeasureToVertices() { this->SetMeasure(VERTICES); }
  void SetMeasureToCentroids() { this->SetMeasure(CENTROIDS); }
  void SetMeasureToControlPoints() { this->SetMeasure(CONTROL_POINTS); }
  //@}

  /**
   * "Vertices", "Centroids" or "ControlPoints".
   */
  const char* GetMeasureAsString();

  //@{
  /**
   * Distance from the camera, in world units, from which on nothing is refined. 0, the default,
   * means automatic: by ReferenceLength, or, where that is 0 too, three times the diagonal of the
   * faces' bounding box in world units, so that a view of the whole mesh refines it moderately and
   * a closer one more. A negative or infinite value is an error and changes nothing.
   */
  void SetMaximumDistance(double distance);
  vtkGetMacro(MaximumDistance, double);
  //@}

  //@{
  /**
   * Wanted length of a segment in pixels, 0.01 to 1e6, that the distance is derived from where
   * MaximumDistance is 0; or 0, the default: none. Another value is an error and changes nothing.
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

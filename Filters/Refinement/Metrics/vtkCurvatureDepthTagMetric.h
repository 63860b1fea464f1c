// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCurvatureDepthTagMetric
 * @brief   refines where a surface is strongly curved
 *
 * With k the absolute value of the discrete Gaussian or mean curvature at a point, and the
 * thresholds low = MinimumCurvature and high = MaximumCurvature, the depth-tag is
 *
 *     level = MaximumLevel * (k - low) / (high - low)
 *
 * clamped: 0 at the low threshold and below, MaximumLevel at the high one and above, linear
 * between. The metric does not depend on the view.
 *
 * Where a recipe displaces the mesh by a height map, k is measured on the displaced surface: each
 * face is sampled with 2^MaximumLevel segments on an edge, but at least 4 and at most 16, and k at
 * a point is the mean over the faces at it, weighted by their areas. Relief between the points
 * counts then. The distance of a surface from its triangles grows with k and with the square of
 * their edges, so the depth-tag is
 *
 *     level = MaximumLevel + log2(k / high) / 2          (mean curvature)
 *     level = MaximumLevel + log2(k / high) / 4          (Gaussian curvature)
 *
 * clamped to [0, MaximumLevel], and 0 where k does not exceed low. Where no recipe is known, as in
 * vtkDepthTagFilter, k is that of the mesh.
 *
 * Curvatures are those of Meyer, Desbrun, Schroeder and Barr 2002 ("Discrete
 * differential-geometry operators for triangulated 2-manifolds"), with their mixed Voronoi area:
 * Gaussian K = (2 pi - sum of the angles at the point) / A_mixed (eq. 9), mean H = half the length
 * of the cotangent Laplacian (eq. 8). Polygons are taken as the fans that VTK's mappers draw,
 * strips as their triangles. Points at the same coordinates count as one, so seams of texture
 * coordinates and split normals are not borders. A point on a border of the surface, or on an edge
 * of more than two triangles, has no closed ring of triangles to measure: it takes the mean of its
 * neighbours, ring by ring from the nearest points that have one (0 where there are none).
 * Curvatures are finite for any mesh: triangles of no area or with a point that is not finite are
 * left out, and a point without triangles has curvature 0.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkDistanceDepthTagMetric vtkCurvatures
 */
#ifndef vtkCurvatureDepthTagMetric_h
#define vtkCurvatureDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

class vtkDoubleArray;

class RELEVOFILTERSREFINEMENT_EXPORT vtkCurvatureDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkCurvatureDepthTagMetric* New();
  vtkTypeMacro(vtkCurvatureDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The curvatures to choose from.
   */
  enum CurvatureTypes
  {
    GAUSSIAN = 0,
    MEAN = 1
  };

  //@{
  /**
   * Which curvature is measured: GAUSSIAN (0, the default; it is 0 on surfaces that can be
   * unrolled, such as cylinders and straight ridges) or MEAN (1). Another value is an error and
   * changes nothing.
   */
  void SetCurvatureType(int type);
  vtkGetMacro(CurvatureType, int);
  //@}

  /**
   * Measure the Gaussian curvature, in 1/length^2.
   */
  void SetCurvatureTypeToGaussian() { this->SetCurvatureType(GAUSSIAN); }

  /**
   * Measure the mean curvature, in 1/length.
   */
  void SetCurvatureTypeToMean() { this->SetCurvatureType(MEAN); }

  /**
   * "Gaussian" or "Mean".
   */
  const char* GetCurvatureTypeAsString();

  //@{
  /**
   * Absolute curvature up to which the level is 0, in the mesh's own units (Gaussian 1/length^2,
   * mean 1/length); default 0. A negative or infinite value is an error and changes nothing; a
   * minimum above the maximum is an error when tags are computed.
   */
  void SetMinimumCurvature(double curvature);
  vtkGetMacro(MinimumCurvature, double);
  //@}

  //@{
  /**
   * Absolute curvature from which on the level is MaximumLevel, in the mesh's own units (Gaussian
   * 1/length^2, mean 1/length).
   *
   * With both thresholds 0, the default, they are automatic, from Quantiles. A negative or infinite
   * value is an error and changes nothing.
   */
  void SetMaximumCurvature(double curvature);
  vtkGetMacro(MaximumCurvature, double);
  //@}

  //@{
  /**
   * The automatic thresholds, as fractions of the mesh's points: `low` of them have an absolute
   * curvature that does not exceed the low threshold, `high` of them one that does not exceed the
   * high one; default (0, 0.95). A low of 0 stands for the curvature 0. The high threshold is no
   * less than the curvature of a surface which turns by 0.001 radians over the mean area of a
   * point, so that the rounding of flat points is not refined. Values other than
   * 0 <= low < high <= 1 are an error and change nothing.
   */
  void SetQuantiles(double low, double high);
  void SetQuantiles(const double quantiles[2]) { this->SetQuantiles(quantiles[0], quantiles[1]); }
  vtkGetVector2Macro(Quantiles, double);
  //@}

  /**
   * Fill `curvatures` with the chosen curvature of every point of `mesh`, with its sign: mean
   * curvature is positive where the surface bends away from its normal, as a sphere with outward
   * normals does. The array gets one component and vtkCurvatures' name, "Gauss_Curvature" or
   * "Mean_Curvature".
   */
  void ComputeCurvatures(vtkPolyData* mesh, vtkDoubleArray* curvatures);

  bool IsViewDependent() override { return false; }
  bool IsDisplacementDependent() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkCurvatureDepthTagMetric();
  ~vtkCurvatureDepthTagMetric() override;

  int CurvatureType = GAUSSIAN;
  double MinimumCurvature = 0.0;
  double MaximumCurvature = 0.0;
  double Quantiles[2] = { 0.0, 0.95 };

private:
  vtkCurvatureDepthTagMetric(const vtkCurvatureDepthTagMetric&) = delete;
  void operator=(const vtkCurvatureDepthTagMetric&) = delete;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCurvatureDepthTagMetric
 * @brief   refine where a surface is strongly curved
 *
 * With k the absolute value of the discrete Gaussian or mean curvature at a point, and the
 * thresholds low = MinimumCurvature and high = MaximumCurvature, the depth-tag is
 *
 *     level = MaximumLevel * (k - low) / (high - low)
 *
 * It is clamped: 0 at and below the low threshold, MaximumLevel at and above the high threshold,
 * and linear between them. The metric does not depend on the view.
 *
 * If a recipe displaces the mesh by a height map, k is measured on the displaced surface, so that
 * relief between the points is included. Each edge of a face is sampled with 2^MaximumLevel
 * segments, at least 4 and at most 16. k at a point is the area-weighted mean over its faces. The
 * distance between a surface and its triangles grows with k and with the square of the edge length.
 * The depth-tag is therefore
 *
 *     level = MaximumLevel + log2(k / high) / 2          (mean curvature)
 *     level = MaximumLevel + log2(k / high) / 4          (Gaussian curvature)
 *
 * clamped to [0, MaximumLevel], and 0 where k does not exceed low. Without a recipe, as in
 * vtkDepthTagFilter, k is measured on the mesh.
 *
 * Curvatures are computed as in Meyer, Desbrun, Schroeder and Barr 2002 ("Discrete
 * differential-geometry operators for triangulated 2-manifolds"), with their mixed Voronoi area.
 * The Gaussian curvature is K = (2 pi - sum of the angles at the point) / A_mixed (eq. 9). The mean
 * curvature H is half the length of the cotangent Laplacian (eq. 8). Polygons are split into
 * triangle fans as VTK's mappers do, and strips into triangles. Coincident points are merged, so
 * that seams of texture coordinates and split normals are not borders. Points on a border of the
 * surface, or on an edge of more than two triangles, have no closed ring of triangles. They take
 * the mean of their neighbours, ring by ring from the nearest points with a curvature, or 0 if
 * there are none. Curvatures are always finite. Triangles without area or with non-finite points
 * are skipped, and points without triangles have curvature 0.
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
   * The types of curvature.
   */
  enum CurvatureTypes
  {
    GAUSSIAN = 0,
    MEAN = 1
  };

  //@{
  /**
   * Set the type of curvature: GAUSSIAN (0, the default) or MEAN (1). Gaussian curvature is 0 on
   * surfaces that can be unrolled, such as cylinders and straight ridges. Other values are rejected
   * with an error.
   */
  void SetCurvatureType(int type);
  vtkGetMacro(CurvatureType, int);
  //@}

  /**
   * Set the type to Gaussian curvature, in 1/length^2.
   */
  void SetCurvatureTypeToGaussian() { this->SetCurvatureType(GAUSSIAN); }

  /**
   * Set the type to mean curvature, in 1/length.
   */
  void SetCurvatureTypeToMean() { this->SetCurvatureType(MEAN); }

  /**
   * Return the type as "Gaussian" or "Mean".
   */
  const char* GetCurvatureTypeAsString();

  //@{
  /**
   * Set the absolute curvature at and below which the level is 0, in units of the mesh (Gaussian
   * 1/length^2, mean 1/length). The default is 0. Values that are negative or not finite as floats
   * are rejected with an error. A minimum above the maximum is an error when tags are computed.
   */
  void SetMinimumCurvature(double curvature);
  vtkGetMacro(MinimumCurvature, double);
  //@}

  //@{
  /**
   * Set the absolute curvature at and above which the level is MaximumLevel, in units of the mesh
   * (Gaussian 1/length^2, mean 1/length). Values that are negative or not finite as floats are
   * rejected with an error.
   *
   * The default is 0. If both thresholds are 0, they are computed from Quantiles.
   */
  void SetMaximumCurvature(double curvature);
  vtkGetMacro(MaximumCurvature, double);
  //@}

  //@{
  /**
   * Set the quantiles for automatic thresholds, as fractions of the mesh's points. The absolute
   * curvature does not exceed the low threshold at the fraction `low` of the points, and does not
   * exceed the high threshold at the fraction `high`. The default is (0, 0.95). A `low` of 0 gives
   * a threshold of 0. The high threshold is at least the curvature of a surface that turns by 0.001
   * radians over the mean area of a point, so that rounding errors of flat surfaces are not
   * refined. Values that do not satisfy 0 <= low < high <= 1 are rejected with an error.
   */
  void SetQuantiles(double low, double high);
  void SetQuantiles(const double quantiles[2]) { this->SetQuantiles(quantiles[0], quantiles[1]); }
  vtkGetVector2Macro(Quantiles, double);
  //@}

  /**
   * Fill `curvatures` with the signed curvature of each point of `mesh`. Mean curvature is positive
   * where the surface bends away from its normal, as on a sphere with outward normals. The array
   * gets one component and the name used by vtkCurvatures, "Gauss_Curvature" or "Mean_Curvature".
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

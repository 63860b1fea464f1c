// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFieldVariationDepthTagMetric
 * @brief   refine where a point or cell array varies
 *
 * This metric extends the metric for vector fields of Nellmeldin 2013 ("Desarrollo de algoritmos de
 * teselacion adaptativa en GPU", section 9: the variation of the field) to any array. The variation
 * x of an edge is a number in [0, 1], computed from two values a and b. For a point array, they are
 * the values at the edge's two points; of coincident points, the one with the lowest id is used.
 * For a cell array, they are the values of the cells on both sides, and x is 0 on the border of the
 * surface.
 *
 *     one component:         x = |a - b| / (largest - smallest value of the surface)
 *     several (a vector):    x = max(angle(a, b) / 180 degrees,
 *                                    | |a| - |b| | / longest vector of the surface)
 *
 * A vector shorter than 1e-6 of the longest vector has no direction, and its angle to other vectors
 * is 0. With the thresholds low = MinimumVariation and high = MaximumVariation, and the largest x
 * of the edges at the point, the depth-tag of a point is
 *
 *     level = MaximumLevel * (x - low) / (high - low)
 *
 * clamped to [0, MaximumLevel]. With the rule PER_EDGE, the tag of an edge uses the x of that edge.
 * Missing values do not vary. These are NaN, infinite numbers, and vectors with a component of at
 * least NoDataMagnitude, such as -1e9. If all values of the array are missing or equal, all levels
 * are 0. Points without triangles have level 0. The metric does not depend on the view.
 *
 * Computing tags fails with an error if ArrayName is empty, if the mesh has no numeric array of
 * that name, or if the number of tuples does not match.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkCurvatureDepthTagMetric
 */
#ifndef vtkFieldVariationDepthTagMetric_h
#define vtkFieldVariationDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"

#include <string> // for ArrayName

class RELEVOFILTERSREFINEMENT_EXPORT vtkFieldVariationDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkFieldVariationDepthTagMetric* New();
  vtkTypeMacro(vtkFieldVariationDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the array, with any number of components. If the mesh has no such point array,
   * the cell array of that name is used. An empty name, the default, is an error when tags are
   * computed.
   */
  void SetArrayName(const char* name);
  const char* GetArrayName() { return this->ArrayName.c_str(); }
  //@}

  //@{
  /**
   * Set the variation at and below which the level is 0, in [0, 1]. The default is 0. Values out of
   * range are rejected with an error. A minimum above the maximum is an error when tags are
   * computed.
   */
  void SetMinimumVariation(double variation);
  vtkGetMacro(MinimumVariation, double);
  //@}

  //@{
  /**
   * Set the variation at and above which the level is MaximumLevel, in [0, 1]. The default is 0. If
   * both thresholds are 0, the maximum is automatic: 95 % of the edges do not exceed it, and it is
   * at least 1e-6. Values out of range are rejected with an error.
   */
  void SetMaximumVariation(double variation);
  vtkGetMacro(MaximumVariation, double);
  //@}

  //@{
  /**
   * Set the magnitude at and above which vectors are missing values ("no data"): a vector is a
   * missing value if a component has at least this absolute value. The default is 1e8. Arrays of
   * one component are not affected. Values of 0 or less are rejected with an error.
   */
  void SetNoDataMagnitude(double magnitude);
  vtkGetMacro(NoDataMagnitude, double);
  //@}

  bool IsViewDependent() override { return false; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkFieldVariationDepthTagMetric();
  ~vtkFieldVariationDepthTagMetric() override;

  std::string ArrayName;
  double MinimumVariation = 0.0;
  double MaximumVariation = 0.0;
  double NoDataMagnitude = 1e8;

private:
  vtkFieldVariationDepthTagMetric(const vtkFieldVariationDepthTagMetric&) = delete;
  void operator=(const vtkFieldVariationDepthTagMetric&) = delete;
};

#endif

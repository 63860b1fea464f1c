// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFieldVariationDepthTagMetric
 * @brief   refines where a point or cell array varies
 *
 * The metric for vector fields of Nellmeldin 2013 ("Desarrollo de algoritmos de teselacion
 * adaptativa en GPU", section 9: the variation of the field), for any array. The variation x of an
 * edge is a number in [0, 1], of the values a and b
 *
 * - of its two points, for a point array (of points at the same coordinates, that of the lowest
 * id);
 * - of the cells of its two triangles, for a cell array; 0 on the border of the surface:
 *
 *     one component:         x = |a - b| / (largest - smallest value of the surface)
 *     several (a vector):    x = max(angle(a, b) / 180 degrees,
 *                                    | |a| - |b| | / longest vector of the surface)
 *
 * A vector shorter than 1e-6 of the longest has no direction: its angle to others is 0. With the
 * thresholds low = MinimumVariation and high = MaximumVariation the depth-tag of a point is, with
 * the largest x of the edges at the point,
 *
 *     level = MaximumLevel * (x - low) / (high - low)
 *
 * clamped to [0, MaximumLevel]; by the rule PER_EDGE the tag of an edge uses its own x. Values that
 * are NaN or infinite make no variation, nor do vectors without data: with a component of at least
 * NoDataMagnitude, as -1e9. An array of nothing else has level 0 everywhere, as a constant one has.
 * A point without triangles has level 0. The metric does not depend on the view.
 *
 * Errors when tags are computed: no ArrayName; no array of numbers of that name in the mesh; one
 * with another number of tuples than points or cells.
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
   * Name of the array, of the points if they have it, else of the cells; any number of components.
   * Empty, the default, is an error when tags are computed.
   */
  void SetArrayName(const char* name);
  const char* GetArrayName() { return this->ArrayName.c_str(); }
  //@}

  //@{
  /**
   * Variation up to which the level is 0, in [0, 1]; default 0. Another value is an error and
   * changes nothing; a minimum above the maximum is an error when tags are computed.
   */
  void SetMinimumVariation(double variation);
  vtkGetMacro(MinimumVariation, double);
  //@}

  //@{
  /**
   * Variation from which on the level is MaximumLevel, in [0, 1]. With both thresholds 0, the
   * default, it is automatic: the variation that 95 % of the edges do not exceed, but no less than
   * 1e-6. Another value is an error and changes nothing.
   */
  void SetMaximumVariation(double variation);
  vtkGetMacro(MaximumVariation, double);
  //@}

  //@{
  /**
   * A vector stands for "no data" if the absolute value of a component is at least this; more than
   * 0, default 1e8. In arrays of one component all values are data. Another value is an error and
   * changes nothing.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinement
 * @brief   the recipe: how deep a coarse mesh is refined, and to what
 *
 * A recipe names the levels (a metric, or an array of depth-tags), the surface that refined points
 * lie on and the displacement that moves them. vtkAdaptiveRefinementFilter evaluates it on the
 * CPU into a vtkPolyData, vtkAdaptiveRefinementMapper on the GPU without storing anything: same
 * recipe, same triangles, same points to float accuracy.
 *
 * @sa vtkAdaptiveRefinementFilter vtkAdaptiveRefinementMapper vtkDepthTagMetric
 * vtkRefinementSurface vtkDisplacement
 */
#ifndef vtkAdaptiveRefinement_h
#define vtkAdaptiveRefinement_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for members

#include <string> // for DepthTagArrayName

class vtkDepthTagMetric;
class vtkDisplacement;
class vtkRefinementPatternTable;
class vtkRefinementSurface;

class RELEVOFILTERSREFINEMENT_EXPORT vtkAdaptiveRefinement : public vtkObject
{
public:
  static vtkAdaptiveRefinement* New();
  vtkTypeMacro(vtkAdaptiveRefinement, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The highest level of an edge, 0 to 7, default 5: an edge has at most 2^level segments. A value
   * outside is an error and changes nothing.
   */
  void SetMaximumLevel(int level);
  int GetMaximumLevel();
  //@}

  //@{
  /**
   * Name of the point array of depth-tags, one float level per point, default "DepthTag". Where
   * the mesh has it, it wins over the metric. An edge takes the mean of its two points' tags,
   * rounded half up and clamped to [0, MaximumLevel]. NaN is an error.
   */
  void SetDepthTagArrayName(const char* name);
  const char* GetDepthTagArrayName();
  //@}

  //@{
  /**
   * How deep each point shall be refined. Neither metric nor array: MaximumLevel everywhere.
   */
  void SetMetric(vtkDepthTagMetric* metric);
  vtkDepthTagMetric* GetMetric();
  //@}

  //@{
  /**
   * The surface that refined points lie on; none means linear.
   */
  void SetSurface(vtkRefinementSurface* surface);
  vtkRefinementSurface* GetSurface();
  //@}

  //@{
  /**
   * What moves the refined points; none by default.
   */
  void SetDisplacement(vtkDisplacement* displacement);
  vtkDisplacement* GetDisplacement();
  //@}

  /**
   * The patterns, shared by all that evaluate this recipe.
   */
  vtkRefinementPatternTable* GetPatternTable();

  /**
   * Latest change of the recipe or of any of its parts.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkAdaptiveRefinement();
  ~vtkAdaptiveRefinement() override;

  std::string DepthTagArrayName = "DepthTag";
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  vtkSmartPointer<vtkRefinementSurface> Surface;
  vtkSmartPointer<vtkDisplacement> Displacement;
  vtkSmartPointer<vtkRefinementPatternTable> PatternTable;

private:
  vtkAdaptiveRefinement(const vtkAdaptiveRefinement&) = delete;
  void operator=(const vtkAdaptiveRefinement&) = delete;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthTagMetric
 * @brief   how deep each point of a mesh shall be refined
 *
 * A metric gives every point a depth-tag: a float level in [0, MaximumLevel], MaximumLevel where
 * refinement is wanted most. An edge takes the mean of its two points' tags, rounded half up, and
 * is split into 2^level segments (Lenz 2009, eqs. 3.1 to 3.3).
 *
 * @sa vtkAdaptiveRefinement vtkDepthTagFilter
 */
#ifndef vtkDepthTagMetric_h
#define vtkDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"

class vtkFloatArray;
class vtkPolyData;
struct vtkRefinementView;

class RELEVOFILTERSREFINEMENT_EXPORT vtkDepthTagMetric : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkDepthTagMetric, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether the tags depend on the camera, so that they must be computed anew when it moves.
   */
  virtual bool IsViewDependent() = 0;

  /**
   * Whether the tags depend on where the mesh stands in the world, so that they must be computed
   * anew when its actor moves. What depends on the view does.
   */
  virtual bool IsPlacementDependent() { return this->IsViewDependent(); }

  /**
   * Fill `tags` with one level per point of `mesh`, each finite and in [0, maximumLevel].
   * Returns false, after an ErrorEvent of this object, when the metric cannot be evaluated
   * (no camera for a view-dependent metric, a missing array, absurd parameters).
   */
  virtual bool ComputeTags(
    vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel, vtkFloatArray* tags) = 0;

protected:
  vtkDepthTagMetric();
  ~vtkDepthTagMetric() override;

private:
  vtkDepthTagMetric(const vtkDepthTagMetric&) = delete;
  void operator=(const vtkDepthTagMetric&) = delete;
};

#endif

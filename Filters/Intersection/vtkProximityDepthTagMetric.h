// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkProximityDepthTagMetric
 * @brief   refine in and near boxes, for example where objects may touch
 *
 * Let x be the distance of the centroid of a triangle from the nearest box, and d = Distance, both
 * in world coordinates, after the actor's matrix. The level of the triangle is
 *
 *     5                       x = 0: in a box or on its border
 *     log2(24 - 23 x / d)     0 < x <= d
 *     0                       beyond
 *
 * but at most MaximumLevel, so set MaximumLevel to 5 or more. An edge has 32 segments inside of a
 * box, and from 24 to 1 near it, linear in the distance (Nellmeldin 2013, "Desarrollo de algoritmos
 * de teselacion adaptativa en GPU", intersection of objects). Polygons are split into fans of
 * triangles. A point has the largest level of its triangles. With the rule PER_EDGE, an edge has
 * the largest level of its triangles.
 *
 * The level is 0 if there are no boxes or a triangle is not finite. The metric depends on the
 * actor's matrix, but not on the view. It searches a tree of boxes in parallel and is fast for
 * thousands of boxes.
 *
 * @sa vtkContactScene vtkDistanceDepthTagMetric vtkRegionDepthTagMetric
 */
#ifndef vtkProximityDepthTagMetric_h
#define vtkProximityDepthTagMetric_h

#include "RelevoFiltersIntersectionModule.h" // for export macro
#include "vtkDepthTagMetric.h"
#include "vtkSmartPointer.h" // for members

#include <array>  // for members
#include <vector> // for members

class vtkLookupTable;

class RELEVOFILTERSINTERSECTION_EXPORT vtkProximityDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkProximityDepthTagMetric* New();
  vtkTypeMacro(vtkProximityDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Add a box in world coordinates: xmin, xmax, ymin, ymax, zmin, zmax. It may be flat. A box that
   * is not finite, or has a minimum above its maximum, is an error and is not added.
   */
  void AddBox(const double bounds[6]);

  /**
   * Remove all boxes.
   */
  void RemoveAllBoxes();

  /**
   * Return the number of boxes.
   */
  int GetNumberOfBoxes();

  /**
   * Get the box with the given index, starting at 0. An index out of range is an error and does not
   * change `bounds`.
   */
  void GetBox(int index, double bounds[6]);

  //@{
  /**
   * Set the distance from the nearest box, in world units, beyond which the level is 0; at least 0.
   * With 0 (default), only the inside of boxes is refined. Another value is an error and changes
   * nothing.
   */
  void SetDistance(double distance);
  vtkGetMacro(Distance, double);
  //@}

  /**
   * Return colours for levels from 0 to 5, for vtkAdaptiveRefinementMapper::SetLevelLookupTable():
   * red inside, shades of orange up to Distance, blue beyond. You can modify the table; each metric
   * has a separate one.
   */
  vtkLookupTable* GetLookupTable();

  bool IsViewDependent() override { return false; }
  bool IsPlacementDependent() override { return true; }
  bool IsAbsolute() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkProximityDepthTagMetric();
  ~vtkProximityDepthTagMetric() override;

  double Distance = 0.0;

private:
  vtkProximityDepthTagMetric(const vtkProximityDepthTagMetric&) = delete;
  void operator=(const vtkProximityDepthTagMetric&) = delete;

  std::vector<std::array<double, 6>> Boxes;
  vtkSmartPointer<vtkLookupTable> LookupTable;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkProximityDepthTagMetric
 * @brief   refines what is in boxes or near them, such as where objects may meet
 *
 * With x the distance of a triangle's centroid from the nearest box, and d = Distance, both in
 * world coordinates (the actor's matrix is applied to the mesh), a triangle has the level
 *
 *     5                       x = 0: in a box, or on its border
 *     log2(24 - 23 x / d)     0 < x <= d
 *     0                       beyond
 *
 * but at most MaximumLevel, which is therefore to be 5 or more: 32 segments inside, then 24 down to
 * 1, linear in the segments (Nellmeldin 2013, "Desarrollo de algoritmos de teselacion adaptativa en
 * GPU", intersection of objects). Polygons count as their fans of triangles. A point has the
 * largest level of the triangles at it; by the rule PER_EDGE an edge that of the triangles beside
 * it.
 *
 * Without boxes, and for triangles that are not finite, the level is 0. The metric does not depend
 * on the view, but on where the actor's matrix puts the mesh. A tree of the boxes is searched by
 * all processors, so that there may be thousands of them.
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
   * Add a box in world coordinates: xmin, xmax, ymin, ymax, zmin, zmax. It may be flat. One that is
   * not finite, or has a minimum above its maximum, is an error and adds nothing.
   */
  void AddBox(const double bounds[6]);

  /**
   * Remove all boxes.
   */
  void RemoveAllBoxes();

  /**
   * How many boxes have been added.
   */
  int GetNumberOfBoxes();

  /**
   * The box added as number `index`, counted from 0. An index that there is not is an error and
   * leaves `bounds` as they are.
   */
  void GetBox(int index, double bounds[6]);

  //@{
  /**
   * Distance from the nearest box, in world units, from which on nothing is refined; at least 0.
   * 0, the default: only what is in a box is. Another value is an error and changes nothing.
   */
  void SetDistance(double distance);
  vtkGetMacro(Distance, double);
  //@}

  /**
   * Colours of levels from 0 to 5, for SetLevelLookupTable() of vtkAdaptiveRefinementMapper: red
   * inside, shades of orange up to Distance, blue beyond. The metric's own, to be changed at will.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRegionDepthTagMetric
 * @brief   refine a region of interest
 *
 * The region is where ImplicitFunction is 0 or less. Without a function, it is the ball of Radius
 * around Center, for example around a picked point. The region is in world coordinates: the actor's
 * matrix is applied to the points of the mesh. With d the distance of a point from the region, the
 * depth-tag is
 *
 *     level = MaximumLevel * (3 t^2 - 2 t^3),    t = 1 - d / FallOff, clamped to [0, 1]
 *
 * It is MaximumLevel in the region, 0 at a distance of FallOff or more, and changes smoothly
 * between (the region of interest of Nellmeldin 2013, "Desarrollo de algoritmos de teselacion
 * adaptativa en GPU", section 9). With the rule PER_EDGE, d is the smallest distance of the edge's
 * two ends and its midpoint.
 *
 * The distance from the ball is exact. For a function f it is f / |grad f| (Taubin 1991). This is
 * exact for planes and distance functions, and approximate near the border of other functions. The
 * level is 0 at points outside where the gradient is 0, and where f is NaN. Only one thread at a
 * time evaluates the function, also if filters in several threads share the metric. Do not use the
 * same function in a second metric in that case.
 *
 * The metric does not depend on the view, but on the actor's matrix. Non-finite points have level
 * 0. If the region does not reach the mesh, all levels are 0. If neither ImplicitFunction nor
 * Radius is set, computing tags fails with an error.
 *
 * @sa vtkDepthTagFilter vtkAdaptiveRefinement vtkImplicitFunction vtkCompositeDepthTagMetric
 */
#ifndef vtkRegionDepthTagMetric_h
#define vtkRegionDepthTagMetric_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkDepthTagMetric.h"
#include "vtkSmartPointer.h" // for ImplicitFunction

#include <mutex> // for ImplicitFunction

class vtkImplicitFunction;

class RELEVOFILTERSREFINEMENT_EXPORT vtkRegionDepthTagMetric : public vtkDepthTagMetric
{
public:
  static vtkRegionDepthTagMetric* New();
  vtkTypeMacro(vtkRegionDepthTagMetric, vtkDepthTagMetric);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the implicit function that is 0 or less in the region, in world coordinates. None, the
   * default, means the ball of Radius around Center.
   */
  void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction();
  //@}

  //@{
  /**
   * Set the centre of the ball, in world coordinates. The default is (0, 0, 0). Non-finite values
   * are rejected with an error.
   */
  void SetCenter(double x, double y, double z);
  void SetCenter(const double center[3]) { this->SetCenter(center[0], center[1], center[2]); }
  vtkGetVector3Macro(Center, double);
  //@}

  //@{
  /**
   * Set the radius of the ball, in world units. The default is 0: there is no ball. Values that are
   * negative or not finite as floats are rejected with an error.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  //@}

  //@{
  /**
   * Set the distance from the region at which the level reaches 0, in world units. The default of 0
   * means a tenth of the diagonal of the faces' bounding box. Values that are negative or not
   * finite as floats are rejected with an error.
   */
  void SetFallOff(double distance);
  vtkGetMacro(FallOff, double);
  //@}

  /**
   * Return the time of the latest change of the metric or the function.
   */
  vtkMTimeType GetMTime() override;

  bool IsViewDependent() override { return false; }
  bool IsPlacementDependent() override { return true; }
#ifndef __VTK_WRAP__
  std::unique_ptr<relevo::MetricEvaluator> NewEvaluator(
    const std::shared_ptr<relevo::MetricMesh>& mesh) override;
#endif

protected:
  vtkRegionDepthTagMetric();
  ~vtkRegionDepthTagMetric() override;

  vtkSmartPointer<vtkImplicitFunction> ImplicitFunction;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 0.0;
  double FallOff = 0.0;

private:
  std::mutex FunctionMutex; // locked while the function is evaluated
  vtkRegionDepthTagMetric(const vtkRegionDepthTagMetric&) = delete;
  void operator=(const vtkRegionDepthTagMetric&) = delete;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRegionDepthTagMetric
 * @brief   refines a region of interest
 *
 * The region is where ImplicitFunction is 0 or less, or, without one, the ball of Radius around
 * Center, such as a picked point. It lies in world coordinates: the actor's matrix is applied to
 * the mesh's points. With d the distance of a point from the region, the depth-tag is
 *
 *     level = MaximumLevel * (3 t^2 - 2 t^3),    t = 1 - d / FallOff, clamped to [0, 1]
 *
 * MaximumLevel inside and at the border, 0 from FallOff on, smooth between (the region of interest
 * of Nellmeldin 2013, "Desarrollo de algoritmos de teselacion adaptativa en GPU", section 9). By
 * the rule PER_EDGE, d of an edge is the least of its two ends and its midpoint.
 *
 * For the ball d is exact. For a function f it is f / |grad f| (Taubin 1991), exact for planes and
 * functions that are distances, and near the border of others; where the gradient is 0 outside, or
 * the function is not a number, the level is 0. A function is asked by one thread at a time, also
 * where filters in several threads share the metric; do not give it to a second metric then.
 *
 * The metric does not depend on the view, but on where the actor's matrix puts the mesh. A point
 * that is not finite has level 0. A region that the mesh does not reach is none: level 0
 * everywhere. Neither ImplicitFunction nor Radius is an error when tags are computed.
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
   * The region, in world coordinates: where this function is 0 or less. None, the default: the ball
   * of Radius around Center.
   */
  void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction();
  //@}

  //@{
  /**
   * The middle of the ball, in world coordinates; default (0, 0, 0). A value that is not finite is
   * an error and changes nothing.
   */
  void SetCenter(double x, double y, double z);
  void SetCenter(const double center[3]) { this->SetCenter(center[0], center[1], center[2]); }
  vtkGetVector3Macro(Center, double);
  //@}

  //@{
  /**
   * The radius of the ball, in world units. 0, the default, means there is no ball. A negative or
   * infinite value is an error and changes nothing.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  //@}

  //@{
  /**
   * Distance from the region, in world units, at which the level has fallen to 0. 0, the default,
   * means automatic: a tenth of the diagonal of the faces' bounding box. A negative or infinite
   * value is an error and changes nothing.
   */
  void SetFallOff(double distance);
  vtkGetMacro(FallOff, double);
  //@}

  /**
   * Includes the function's time.
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
  std::mutex FunctionMutex; // held while the function is asked
  vtkRegionDepthTagMetric(const vtkRegionDepthTagMetric&) = delete;
  void operator=(const vtkRegionDepthTagMetric&) = delete;
};

#endif

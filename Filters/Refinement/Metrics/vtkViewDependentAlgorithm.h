// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewDependentAlgorithm
 * @brief   a filter whose result may depend on a view: a camera, an actor's matrix and a viewport
 *
 * The superclass of filters that evaluate a vtkDepthTagMetric. A change of the camera or of the
 * matrix counts only where the metric depends on it.
 *
 * @sa vtkAdaptiveRefinementFilter vtkDepthTagFilter vtkAdaptiveCurveFilter
 */
#ifndef vtkViewDependentAlgorithm_h
#define vtkViewDependentAlgorithm_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

class vtkCamera;
class vtkMatrix4x4;

namespace relevo
{
struct RefinementView;
}

class RELEVOFILTERSREFINEMENT_EXPORT vtkViewDependentAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkViewDependentAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The camera for metrics that depend on the view, and that ribbons of curves face, in world
   * coordinates. Default: none.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Width and height of the viewport in pixels, for metrics that depend on the view; default
   * (300, 300). Less than 1 is an error and changes nothing.
   */
  void SetViewportSize(int width, int height);
  void SetViewportSize(const int size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, int);
  //@}

  //@{
  /**
   * From the input's coordinates to the camera's world (an actor's matrix); none means identity.
   */
  void SetModelToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetModelToWorld();
  //@}

protected:
  vtkViewDependentAlgorithm();
  ~vtkViewDependentAlgorithm() override;

  relevo::RefinementView MakeView() const;

  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkMatrix4x4> ModelToWorld;
  int ViewportSize[2] = { 300, 300 };

private:
  vtkViewDependentAlgorithm(const vtkViewDependentAlgorithm&) = delete;
  void operator=(const vtkViewDependentAlgorithm&) = delete;
};

#endif

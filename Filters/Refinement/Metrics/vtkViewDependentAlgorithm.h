// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewDependentAlgorithm
 * @brief   superclass of filters whose output may depend on a camera, an actor's matrix and a
 * viewport
 *
 * Filters that evaluate a vtkDepthTagMetric derive from this class. They execute again after a
 * change of the camera or the matrix only if the metric depends on it.
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
   * Set the camera, in world coordinates, for view-dependent metrics and for ribbons of curves,
   * which face it. There is none by default.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Set the width and height of the viewport in pixels, for view-dependent metrics. The default is
   * (300, 300). Values less than 1 are rejected with an error.
   */
  void SetViewportSize(int width, int height);
  void SetViewportSize(const int size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, int);
  //@}

  //@{
  /**
   * Set the matrix from the input's coordinates to world coordinates, for example an actor's
   * matrix. None, the default, means the identity.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneCapture
 * @brief   captures a renderer's scene, camera by camera
 *
 * Private to the module.
 */
#ifndef SceneCapture_h
#define SceneCapture_h

#include "Capture/CapturePass.h"
#include "Capture/CaptureRenderer.h"
#include "Capture/CaptureTarget.h"
#include "Capture/FittedCamera.h"
#include "Capture/SceneProps.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkCamera;
class vtkImageData;
class vtkRenderer;

namespace relevo
{
class CaptureRanks;

class SceneCapture
{
public:
  /// Set the ranks that capture together. Begin() and CaptureFrom() are then collective.
  void SetRanks(const CaptureRanks* ranks) { this->Ranks = ranks; }

  /// Prepare captures of this size in the renderer's window. Return the error, or "". End()
  /// releases the resources except for the shaders.
  std::string Begin(vtkRenderer* renderer, SceneParts parts, int width, int height);
  void End();

  /// Return the renderer's props, since Begin().
  const SceneProps& GetProps() const { return this->Props; }

  /// Return the relief, or nullptr if the camera sees nothing. Of several ranks, rank 0 has it.
  vtkSmartPointer<vtkImageData> CaptureFrom(vtkCamera* camera, bool withNormals, bool cropped);
  /// Return whether there was no relief because the last camera's matrices were singular.
  bool WasSingular() const { return this->IsSingular; }

private:
  std::string Prepare(vtkRenderer* renderer, SceneParts parts, int width, int height);

  const CaptureRanks* Ranks = nullptr;
  vtkNew<CapturePass> Pass;
  vtkSmartPointer<CaptureRenderer> Renderer;
  std::unique_ptr<CaptureTarget> Target;
  SceneProps Props;
  int Size[2] = { 0, 0 };
  double NearClippingPlaneTolerance = 0.0;
  bool IsSingular = false;
};
}

#endif

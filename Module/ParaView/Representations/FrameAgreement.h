// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FrameAgreement
 * @brief   lets the ranks that draw a view agree on something before each frame
 *
 * The function runs after the ranks have received the camera, on all ranks that draw, even if they
 * see nothing, while the representation is visible. The camera then has the projection of the
 * frame, see ReducedProjection.
 *
 * Private to the module.
 */
#ifndef FrameAgreement_h
#define FrameAgreement_h

#include "vtkWeakPointer.h"

#include <functional>

class vtkMultiProcessController;
class vtkPVDataRepresentation;
class vtkRenderer;
class vtkView;

namespace relevo
{
class FrameAgreement
{
public:
  /// The controller is nullptr if a single process draws the view.
  using Function = std::function<void(vtkMultiProcessController* ranks, vtkRenderer* renderer)>;

  FrameAgreement(vtkPVDataRepresentation* representation, Function agree);
  ~FrameAgreement();
  FrameAgreement(const FrameAgreement&) = delete;
  void operator=(const FrameAgreement&) = delete;

  /// Start with the view that the representation is added to.
  void Start(vtkView* view);
  void Stop();

private:
  void Agree();

  vtkPVDataRepresentation* Representation;
  Function AgreeWithRanks;
  vtkWeakPointer<vtkRenderer> Renderer; // of the view
  unsigned long Tag = 0;                // of its observer
};
}

#endif

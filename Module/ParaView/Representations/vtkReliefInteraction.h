// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefInteraction
 * @brief   shows reliefs in a render view while it moves
 *
 * This representation has no input and draws nothing itself. Each render view has one, because
 * representations take part in the updates and frames of a view. In interactive frames, it makes a
 * vtkReliefPass draw the view's renderer. Still frames are those of ParaView. While reliefs are
 * enabled, the view has no level of detail, so that reliefs show the data themselves.
 *
 * @sa vtkReliefPass
 */
#ifndef vtkReliefInteraction_h
#define vtkReliefInteraction_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkPVDataRepresentation.h"

#include <memory> // for Internals

class vtkPVRenderView;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkReliefInteraction : public vtkPVDataRepresentation
{
public:
  static vtkReliefInteraction* New();
  vtkTypeMacro(vtkReliefInteraction, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set whether interactive frames show reliefs. Off by default.
   */
  void SetShowReliefsWhileMoving(bool show);
  vtkGetMacro(ShowReliefsWhileMoving, bool);
  //@}

  //@{
  /**
   * Set the fraction of holes above which a new capture is made, see
   * vtkReliefPass::SetMaximumHoleShare().
   */
  void SetMaximumHoleShare(double share);
  double GetMaximumHoleShare();
  //@}

  //@{
  /**
   * Set the angle in degrees to the nearest capture above which a new one is made, see
   * vtkReliefPass::SetMaximumAngle().
   */
  void SetMaximumAngle(double angle);
  double GetMaximumAngle();
  //@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkReliefInteraction();
  ~vtkReliefInteraction() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkReliefInteraction(const vtkReliefInteraction&) = delete;
  void operator=(const vtkReliefInteraction&) = delete;

  void UpdateLevelOfDetail();
  void RemoveObservers();
  bool CanShowReliefs(vtkPVRenderView* view, bool areSeveral);
  void BeginFrame();
  void EndFrame();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  bool ShowReliefsWhileMoving = false;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveLICRepresentation
 * @brief   draws the surface of a data set with a vtkAdaptiveLICMapper
 *
 * If several processes draw parts of an image, streaks continue across their borders. In tiled
 * displays and caves, streaks end at the borders.
 *
 * @sa vtkAdaptiveLICMapper
 */
#ifndef vtkAdaptiveLICRepresentation_h
#define vtkAdaptiveLICRepresentation_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkAdaptiveRefinementRepresentation.h"

class vtkPVRenderView;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkAdaptiveLICRepresentation
  : public vtkAdaptiveRefinementRepresentation
{
public:
  static vtkAdaptiveLICRepresentation* New();
  vtkTypeMacro(vtkAdaptiveLICRepresentation, vtkAdaptiveRefinementRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkAdaptiveLICRepresentation();
  ~vtkAdaptiveLICRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkAdaptiveLICRepresentation(const vtkAdaptiveLICRepresentation&) = delete;
  void operator=(const vtkAdaptiveLICRepresentation&) = delete;

  void PrepareParallelFrame();
  void EndPicture();

  vtkPVRenderView* RenderView = nullptr; // the view that contains this representation
  unsigned long StartTag = 0;
  unsigned long EndTag = 0;
  bool IsTogether = false; // whether all processes draw the current image together
};

#endif

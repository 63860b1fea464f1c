// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveLICRepresentation
 * @brief   draws the surface of any data set with a vtkAdaptiveLICMapper
 *
 * Where several processes draw the parts of a picture, their streaks go on across the borders. In
 * tiled displays and caves they end there.
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

  vtkPVRenderView* RenderView = nullptr; // that it is in
  unsigned long StartTag = 0;
  unsigned long EndTag = 0;
  bool IsTogether = false; // the picture being drawn
};

#endif

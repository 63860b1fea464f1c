// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that relevo-view --stats draws one more frame, with the same picture.
#include "RelevoCheck.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"
#include "Scene/ViewerStatistics.h"
#include "Text/ViewerMessages.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScreenEdgeDepthTagMetric.h"

#include <sstream>

namespace
{
// A plane seen at an angle, with view-dependent levels.
struct View
{
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  int Frames = 0;

  View()
  {
    this->Recipe->SetMaximumLevel(5);
    this->Recipe->SetMetric(vtkNew<vtkScreenEdgeDepthTagMetric>());
    this->Mapper->SetInputData(RelevoMeshes::Plane(8, 8));
    this->Mapper->SetRefinement(this->Recipe);
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->SetRepresentationToWireframe();
    this->Renderer->AddActor(this->Actor);
    this->Renderer->GetActiveCamera()->SetPosition(0.3, -1.0, 0.8);
    this->Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCamera();
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(200, 150);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->AddObserver(vtkCommand::EndEvent, this, &View::CountFrame);
  }

  void CountFrame() { ++this->Frames; }
};
}

int TestViewerStatistics(int, char*[])
{
  RelevoCheck check;
  View plain;
  plain.Window->Render();
  CHECK_EQUAL(plain.Frames, 1);

  View measured;
  ViewerMessages messages;
  std::ostringstream stream;
  const double angle = measured.Renderer->GetActiveCamera()->GetViewAngle();
  DrawWithStatistics(measured.Mapper, measured.Renderer, measured.Window, messages, stream);
  CHECK_EQUAL(measured.Frames, 2);
  CHECK_EQUAL(measured.Mapper->GetNumberOfSelections(), 2); // the second frame selects levels again
  CHECK_EQUAL(measured.Renderer->GetActiveCamera()->GetViewAngle(), angle);
  CHECK_EQUAL(RelevoPicture(measured.Window).Colors, RelevoPicture(plain.Window).Colors);
  const std::string triangles =
    "drawn triangles: " + std::to_string(plain.Mapper->GetNumberOfDrawnTriangles()) + "\n";
  CHECK_NOT_EQUAL(stream.str().find(triangles), std::string::npos);
  CHECK_NOT_EQUAL(stream.str().find("frame time: "), std::string::npos);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoFuzzStage.h"

#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointPicker.h"
#include "vtkPropPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkShaderProperty.h"

#include <cmath>

namespace RelevoFuzz
{
Stage::Stage(Dice& dice)
  : D(dice)
{
  for (View& view : this->Views)
  {
    this->Renew(view);
  }
  for (auto& actor : this->Actors)
  {
    actor = vtkSmartPointer<vtkActor>::New();
    this->ChooseView().Renderer->AddActor(actor);
  }
}

void Stage::Renew(View& view)
{
  view.Window = vtkSmartPointer<vtkRenderWindow>::New();
  view.Window->SetMultiSamples(0);
  view.Window->SetSize(40 + this->D.Throw(30), 30 + this->D.Throw(30));
  view.Renderer = vtkSmartPointer<vtkRenderer>::New();
  view.Window->AddRenderer(view.Renderer);
  view.IsDrawn = false;
}

void Stage::ResetCamera(View& view)
{
  view.Renderer->ResetCamera();
  view.Renderer->GetActiveCamera()->Azimuth(360.0 * this->D.Share());
  view.Renderer->ResetCameraClippingRange();
}

void Stage::Render(View& view)
{
  view.Window->Render();
  view.IsDrawn = true;
  this->AfterRender();
}

void Stage::ChangeProperty(vtkProperty* property)
{
  property->SetRepresentation(this->D.Throw(3));
  property->SetInterpolation(this->D.Throw(4));
  property->SetOpacity(this->D.Once(3) ? this->D.Share() : 1.0);
  property->SetEdgeVisibility(this->D.Once(3));
  property->SetVertexVisibility(this->D.Once(3));
  property->SetBackfaceCulling(this->D.Once(4));
  property->SetFrontfaceCulling(this->D.Once(6));
  property->SetLighting(this->D.Throw(4) != 0);
  property->SetLineWidth(static_cast<float>(1 + this->D.Throw(4)));
  property->SetPointSize(static_cast<float>(1 + this->D.Throw(4)));
  property->SetRenderLinesAsTubes(this->D.Once(6));
  property->SetRenderPointsAsSpheres(this->D.Once(6));
}

void Stage::AddActorCalls(std::vector<Call>& calls)
{
  calls.insert(calls.end(),
    { { "property", [this] { this->ChangeProperty(this->ChooseActor()->GetProperty()); } },
      { "backs",
        [this]
        {
          vtkNew<vtkProperty> property;
          this->ChooseActor()->SetBackfaceProperty(this->D.Once(2) ? nullptr : property.Get());
        } },
      { "texture", [this] { this->ChooseActor()->SetTexture(MakeTexture(this->D)); } },
      { "place",
        [this]
        {
          vtkActor* actor = this->ChooseActor();
          actor->SetPosition(this->D.Number(), this->D.Share(), this->D.Share());
          actor->SetScale(this->D.Once(3) ? this->D.Number() : 1.0);
          actor->RotateY(this->D.Number());
        } },
      { "no place",
        [this]
        {
          vtkActor* actor = this->ChooseActor();
          actor->SetPosition(0.0, 0.0, 0.0);
          actor->SetOrientation(0.0, 0.0, 0.0);
          actor->SetScale(1.0);
        } },
      { "visibility", [this] { this->ChooseActor()->SetVisibility(this->D.Throw(3) != 0); } },
      { "passes",
        [this]
        {
          vtkActor* actor = this->ChooseActor();
          actor->SetForceOpaque(this->D.Once(4));
          actor->SetForceTranslucent(this->D.Once(4));
        } },
      { "mapper", [this] { this->ChooseActor()->SetMapper(this->ChooseMapperOfActor()); } },
      { "shader",
        [this]
        {
          // The replacement must compile: otherwise VTK's own lines crash.
          vtkShaderProperty* shader = this->ChooseActor()->GetShaderProperty();
          this->D.Once(2) ? shader->ClearAllShaderReplacements()
                          : shader->AddFragmentShaderReplacement(
                              "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  // more\n", false);
        } },
      { "add and remove",
        [this]
        {
          vtkRenderer* renderer = this->ChooseView().Renderer;
          this->D.Once(3) ? renderer->RemoveActor(this->ChooseActor())
                          : renderer->AddActor(this->ChooseActor());
        } } });
}

void Stage::AddViewCalls(std::vector<Call>& calls)
{
  calls.insert(calls.end(),
    { { "camera",
        [this]
        {
          vtkCamera* camera = this->ChooseView().Renderer->GetActiveCamera();
          camera->SetPosition(this->D.Number(), this->D.Number(), this->D.Number());
          camera->SetParallelProjection(this->D.Throw(2));
        } },
      { "reset", [this] { this->ResetCamera(this->ChooseView()); } },
      { "clipping range",
        [this]
        {
          this->ChooseView().Renderer->GetActiveCamera()->SetClippingRange(
            this->D.Number(), this->D.Number());
        } },
      { "size",
        [this]
        { this->ChooseView().Window->SetSize(1 + this->D.Throw(90), 1 + this->D.Throw(9)); } },
      { "renderer",
        [this]
        {
          vtkRenderer* renderer = this->ChooseView().Renderer;
          renderer->SetUseDepthPeeling(this->D.Throw(2));
          renderer->SetMaximumNumberOfPeels(1 + this->D.Throw(3));
          renderer->SetTwoSidedLighting(this->D.Throw(2));
        } },
      { "another window", [this] { this->Renew(this->ChooseView()); } },
      { "release",
        [this]
        {
          vtkRenderWindow* window = this->ChooseView().Window;
          this->D.Once(3)     ? window->Finalize()
            : this->D.Once(2) ? this->ChooseMapperOfActor()->ReleaseGraphicsResources(window)
                              : this->ChooseActor()->ReleaseGraphicsResources(window);
        } } });
}

void Stage::Pick()
{
  View& view = this->ChooseView();
  if (!view.IsDrawn)
  {
    this->Render(view); // VTK needs an initialized window to pick
  }
  vtkNew<vtkCellPicker> cells;
  vtkNew<vtkPointPicker> points;
  vtkNew<vtkPicker> boxes;
  vtkNew<vtkPropPicker> props;
  vtkAbstractPropPicker* pickers[] = { cells, points, boxes, props };
  const int* size = view.Window->GetSize();
  for (int i = 0; i < 3; ++i)
  {
    vtkAbstractPropPicker* picker = pickers[this->D.Throw(4)];
    const bool isHit =
      picker->Pick(size[0] * this->D.Share(), size[1] * this->D.Share(), 0.0, view.Renderer);
    const double* position = picker->GetPickPosition();
    if (isHit && picker == cells.Get() && cells->GetDataSet() &&
      (cells->GetCellId() < 0 || cells->GetCellId() >= cells->GetDataSet()->GetNumberOfCells() ||
        std::isnan(position[0] + position[1] + position[2])))
    {
      this->Say("a picked cell does not exist, or has no place");
    }
  }
}

void Stage::Select()
{
  View& view = this->ChooseView();
  this->Render(view);
  const int* size = view.Window->GetSize();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(view.Renderer);
  selector->SetArea(
    0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
  selector->SetFieldAssociation(this->D.Once(2) ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                                                : vtkDataObject::FIELD_ASSOCIATION_POINTS);
  auto selection = vtk::TakeSmartPointer(selector->Select());
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkInformation* properties = selection->GetNode(i)->GetProperties();
    if (!vtkActor::SafeDownCast(properties->Get(vtkSelectionNode::PROP())))
    {
      this->Say("something else than the actors is selected");
    }
  }
}
}

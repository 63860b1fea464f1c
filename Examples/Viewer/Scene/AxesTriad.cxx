// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AxesTriad.h"

#include "Text/ViewerText.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace
{
// In pixels.
const double Length = 32.0;
const double LetterDistance = 42.0;
const double FromRight = 60.0;
const double FromBottom = 96.0;

const double Colours[3][3] = { { 0.80, 0.10, 0.10 }, { 0.05, 0.50, 0.10 }, { 0.10, 0.20, 0.80 } };
}

//------------------------------------------------------------------------------
AxesTriad::AxesTriad(vtkRenderer* renderer)
  : Renderer(renderer)
{
  for (int i = 0; i < 3; ++i)
  {
    Axis& axis = this->Axes[i];
    vtkNew<vtkCellArray> line;
    line->InsertNextCell({ 0, 1 });
    axis.Points->SetNumberOfPoints(2);
    vtkNew<vtkPolyData> shape;
    shape->SetPoints(axis.Points);
    shape->SetLines(line);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    axis.Line->SetMapper(mapper);
    axis.Line->GetProperty()->SetColor(Colours[i][0], Colours[i][1], Colours[i][2]);
    axis.Line->GetProperty()->SetLineWidth(3.0f);
    axis.Letter = MakeText();
    axis.Letter->SetInput(i == 0 ? "x" : i == 1 ? "y" : "z");
    axis.Letter->SetVisibility(true);
    axis.Letter->GetTextProperty()->SetColor(Colours[i][0], Colours[i][1], Colours[i][2]);
    axis.Letter->GetTextProperty()->SetBackgroundOpacity(0.0);
    axis.Letter->GetTextProperty()->BoldOn();
    axis.Letter->GetTextProperty()->SetJustificationToCentered();
    axis.Letter->GetTextProperty()->SetVerticalJustificationToCentered();
    renderer->AddViewProp(axis.Line);
    renderer->AddViewProp(axis.Letter);
  }
  this->Tag = renderer->AddObserver(vtkCommand::StartEvent, this, &AxesTriad::OnStart);
}

//------------------------------------------------------------------------------
AxesTriad::~AxesTriad()
{
  for (const Axis& axis : this->Axes)
  {
    this->Renderer->RemoveViewProp(axis.Line);
    this->Renderer->RemoveViewProp(axis.Letter);
  }
  this->Renderer->RemoveObserver(this->Tag);
}

//------------------------------------------------------------------------------
void AxesTriad::OnStart(vtkObject*, unsigned long, void*)
{
  vtkMatrix4x4* view = this->Renderer->GetActiveCamera()->GetViewTransformMatrix();
  const double centre[2] = { this->Renderer->GetSize()[0] - FromRight, FromBottom };
  for (int i = 0; i < 3; ++i)
  {
    // The rows of the matrix are the camera's right and upward directions.
    const double right = view->GetElement(0, i);
    const double up = view->GetElement(1, i);
    Axis& axis = this->Axes[i];
    axis.Points->SetPoint(0, centre[0], centre[1], 0.0);
    axis.Points->SetPoint(1, centre[0] + Length * right, centre[1] + Length * up, 0.0);
    axis.Points->Modified();
    axis.Letter->SetPosition(centre[0] + LetterDistance * right, centre[1] + LetterDistance * up);
  }
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/PictureMarks.h"

#include "Text/ViewerText.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>

namespace
{
// In pixels.
const double Cross = 6.0;
const double Gap = 8.0;
const double Margin = 4.0;

// Returns the pixel of a point, from the lower left corner, or false if it is behind the camera.
bool Project(vtkRenderer* renderer, const std::array<double, 3>& point, double pixel[2])
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double sight[3];
  vtkMath::Subtract(point.data(), camera->GetPosition(), sight);
  if (!camera->GetParallelProjection() &&
    !(vtkMath::Dot(sight, camera->GetDirectionOfProjection()) > 0.0))
  {
    return false;
  }
  double x = point[0];
  double y = point[1];
  double z = point[2];
  renderer->WorldToView(x, y, z);
  pixel[0] = 0.5 * (x + 1.0) * renderer->GetSize()[0];
  pixel[1] = 0.5 * (y + 1.0) * renderer->GetSize()[1];
  return true;
}
}

//------------------------------------------------------------------------------
PictureMarks::PictureMarks(vtkRenderer* renderer)
  : Renderer(renderer)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Shape);
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetColor(0.1, 0.1, 0.1);
  this->Actor->GetProperty()->SetLineWidth(2.0f);
  renderer->AddViewProp(this->Actor);
  this->Tag = renderer->AddObserver(vtkCommand::StartEvent, this, &PictureMarks::OnStart);
}

//------------------------------------------------------------------------------
PictureMarks::~PictureMarks()
{
  this->Clear();
  this->Renderer->RemoveViewProp(this->Actor);
  this->Renderer->RemoveObserver(this->Tag);
}

//------------------------------------------------------------------------------
void PictureMarks::Clear()
{
  for (const Mark& mark : this->Marks)
  {
    this->Renderer->RemoveViewProp(mark.Label);
  }
  this->Marks.clear();
}

//------------------------------------------------------------------------------
void PictureMarks::AddPoint(const std::array<double, 3>& point, const std::string& text)
{
  this->Add({ { point, point }, false, nullptr }, text);
}

//------------------------------------------------------------------------------
void PictureMarks::AddLine(
  const std::array<double, 3>& first, const std::array<double, 3>& second, const std::string& text)
{
  this->Add({ { first, second }, true, nullptr }, text);
}

//------------------------------------------------------------------------------
void PictureMarks::Add(const Mark& mark, const std::string& text)
{
  this->Marks.push_back(mark);
  vtkSmartPointer<vtkTextActor> label = MakeText();
  label->SetInput(text.c_str());
  label->GetTextProperty()->SetVerticalJustificationToBottom();
  this->Renderer->AddViewProp(label);
  this->Marks.back().Label = label;
}

//------------------------------------------------------------------------------
void PictureMarks::OnStart(vtkObject*, unsigned long, void*)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto addLine = [&](double x0, double y0, double x1, double y1)
  {
    const vtkIdType first = points->InsertNextPoint(x0, y0, 0.0);
    points->InsertNextPoint(x1, y1, 0.0);
    lines->InsertNextCell({ first, first + 1 });
  };
  const int* size = this->Renderer->GetSize();
  for (const Mark& mark : this->Marks)
  {
    double pixels[2][2];
    const bool isShown = Project(this->Renderer, mark.Ends[0], pixels[0]) &&
      Project(this->Renderer, mark.Ends[1], pixels[1]);
    mark.Label->SetVisibility(isShown);
    if (!isShown)
    {
      continue;
    }
    if (mark.IsLine)
    {
      addLine(pixels[0][0], pixels[0][1], pixels[1][0], pixels[1][1]);
    }
    for (const double* pixel : { pixels[0], pixels[1] })
    {
      addLine(pixel[0] - Cross, pixel[1], pixel[0] + Cross, pixel[1]);
      addLine(pixel[0], pixel[1] - Cross, pixel[0], pixel[1] + Cross);
    }
    // The label is beside the point, but in the picture.
    double extent[2];
    mark.Label->GetSize(this->Renderer, extent);
    const double centre[2] = { 0.5 * (pixels[0][0] + pixels[1][0]),
      0.5 * (pixels[0][1] + pixels[1][1]) };
    const double right = centre[0] + Gap;
    const double x = right + extent[0] + Margin > size[0] ? centre[0] - Gap - extent[0] : right;
    const double y = std::min(centre[1] + Gap, size[1] - extent[1] - Margin);
    mark.Label->SetPosition(std::max(x, Margin), std::max(y, Margin));
  }
  this->Shape->SetPoints(points);
  this->Shape->SetLines(lines);
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoRandomLook.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

namespace RelevoRandomLook
{
void AddTexture(const Choice& choice, const Look& look)
{
  if (choice.Dice.Throw(6))
  {
    return;
  }
  choice.Log << "  texture\n";
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, choice.Dice.Throw(2) ? 3 : 4);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 64 * image->GetNumberOfScalarComponents(); ++i)
  {
    values[i] =
      static_cast<unsigned char>(i % 4 == 3 ? 255 * (i / 16 % 2) : choice.Dice.Throw(256));
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  for (vtkActor* actor : look.Actors)
  {
    actor->SetTexture(texture);
  }
}

void FillProperty(const Choice& choice, vtkProperty* property, bool anyOrder)
{
  RelevoDice& dice = choice.Dice;
  const RelevoRandomMapping::Limits& limits = choice.Limits;
  property->SetColor(dice.Share(), dice.Share(), dice.Share());
  property->SetAmbient(0.3 * dice.Share());
  property->SetSpecular(dice.Throw(2) ? dice.Share() : 0.0);
  property->SetSpecularPower(1.0 + 20.0 * dice.Share());
  property->SetLighting(dice.Throw(5) != 0);
  property->SetInterpolation(dice.Throw(3));
  // Translucent vertices that faces share look denser, because one is drawn per face.
  property->SetOpacity(
    property->GetVertexVisibility() || dice.Throw(4) ? 1.0 : 0.2 + 0.7 * dice.Share());
  // OpenGL may draw a line with other pixels than the reversed line, and refined edges may have the
  // opposite direction. The filter's triangles also have diagonals, which polygons do not.
  const bool hasLines = choice.Level == 0 && !anyOrder;
  const bool hasPoints = !anyOrder && !limits.HasTies;
  property->SetRepresentation(dice.Throw(4) ? VTK_SURFACE
      : hasLines && dice.Throw(2)           ? VTK_WIREFRAME
      : hasPoints                           ? VTK_POINTS
                                            : VTK_SURFACE);
  // If translucent lines or points overlap, their order and number are visible. VTK 9.1 draws other
  // edges if a mesh also has vertices or lines.
  const bool isOpaque = property->GetOpacity() == 1.0 && !limits.IsTranslucent;
  property->SetRepresentation(isOpaque ? property->GetRepresentation() : VTK_SURFACE);
  property->SetEdgeVisibility(dice.Once(5) && !limits.HasOtherCells && isOpaque && hasLines);
  property->SetEdgeColor(0.1, 0.1, dice.Share());
  property->SetLineWidth(dice.Throw(2) && isOpaque ? 3.0f : 1.0f);
  property->SetPointSize(dice.Throw(2) ? 1.0f : 5.0f);
  // If edges are drawn as tubes, VTK's shaders crash without lights.
  property->SetRenderLinesAsTubes(
    dice.Once(8) && (property->GetLighting() || !property->GetEdgeVisibility()));
  property->SetRenderPointsAsSpheres(dice.Once(8));
  property->SetBackfaceCulling(dice.Once(5));
  property->SetFrontfaceCulling(!property->GetBackfaceCulling() && dice.Once(8));
  choice.Log << "  property: representation " << property->GetRepresentation() << " interpolation "
             << property->GetInterpolation() << " opacity " << property->GetOpacity()
             << (property->GetLighting() ? "" : " unlit")
             << (property->GetEdgeVisibility() ? " edges" : "")
             << (property->GetVertexVisibility() ? " vertices" : "") << " line "
             << property->GetLineWidth() << " point " << property->GetPointSize()
             << (property->GetRenderLinesAsTubes() ? " tubes" : "")
             << (property->GetRenderPointsAsSpheres() ? " spheres" : "")
             << (property->GetBackfaceCulling() ? " no backs" : "")
             << (property->GetFrontfaceCulling() ? " no fronts\n" : "\n");
}

void PlaceActors(const Choice& choice, const Look& look, bool always)
{
  RelevoDice& dice = choice.Dice;
  const bool isMoved = dice.Throw(2) || always;
  const double numbers[] = { dice.Signed(), dice.Signed(), dice.Signed(), 180.0 * dice.Signed(),
    dice.Once(4) ? -1.0 : 1.0, 0.5 + dice.Share() };
  for (vtkActor* actor : look.Actors)
  {
    actor->SetPosition(numbers[0], numbers[1], numbers[2]);
    actor->SetOrientation(0.0, numbers[3], 20.0);
    actor->SetScale(1.0, numbers[4], numbers[5]);
    if (!isMoved)
    {
      actor->SetPosition(0.0, 0.0, 0.0);
      actor->SetOrientation(0.0, 0.0, 0.0);
      actor->SetScale(1.0);
    }
  }
  choice.Log << (isMoved ? "  moved\n" : "  not moved\n");
}

void PlaceCamera(const Choice& choice, vtkCamera* camera)
{
  RelevoDice& dice = choice.Dice;
  const int way = dice.Throw(5);
  const double distances[] = { 3.0, 2.0, 1.4, 0.2, 1.5 };
  const double direction[3] = { dice.Signed(), dice.Signed(), 0.3 + dice.Share() };
  const double length = distances[way] / vtkMath::Norm(direction);
  camera->SetFocalPoint(0.1 * dice.Signed(), 0.1, 0.0);
  camera->SetPosition(length * direction[0], length * direction[1], length * direction[2]);
  camera->SetViewUp(0.1, 1.0, 0.2);
  camera->SetParallelProjection(dice.Once(4));
  camera->SetParallelScale(0.3 + dice.Share());
  camera->SetViewAngle(20.0 + 60.0 * dice.Share());
  camera->SetWindowCenter(dice.Once(6) ? 0.4 : 0.0, 0.0);
  camera->SetClippingRange(way == 4 ? 1.0 + 0.6 * dice.Share() : 0.05, 10.0);
  camera->SetUserViewTransform(nullptr);
  if (dice.Once(10))
  {
    vtkNew<vtkTransform> sheared;
    sheared->Translate(0.2, -0.1, 0.3);
    sheared->RotateY(8.0);
    camera->SetUserViewTransform(sheared);
  }
  choice.Log << " camera " << way << (camera->GetParallelProjection() ? " parallel" : "")
             << (camera->GetUserViewTransform() ? " transformed\n" : "\n");
}
}

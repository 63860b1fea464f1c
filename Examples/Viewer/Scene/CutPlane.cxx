// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/CutPlane.h"

#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
const double Step = 0.02; // share of the extent along the normal
}

//------------------------------------------------------------------------------
CutPlane::CutPlane(const std::optional<std::vector<double>>& numbers)
{
  if (numbers)
  {
    this->Set(*numbers);
  }
}

//------------------------------------------------------------------------------
void CutPlane::Set(const std::vector<double>& numbers)
{
  if (!this->Plane)
  {
    this->Plane = vtkSmartPointer<vtkPlane>::New();
  }
  this->Plane->SetOrigin(numbers.data());
  this->Plane->SetNormal(numbers.data() + 3);
}

//------------------------------------------------------------------------------
CutPlane::~CutPlane() = default;

//------------------------------------------------------------------------------
vtkPlane* CutPlane::Get() const
{
  return this->Plane;
}

//------------------------------------------------------------------------------
void CutPlane::Start(const double bounds[6], vtkRenderer* renderer)
{
  const double* direction = renderer->GetActiveCamera()->GetDirectionOfProjection();
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(direction[i]) > std::abs(direction[axis]) ? i : axis;
  }
  double origin[3] = { 0.0, 0.0, 0.0 };
  double normal[3] = { 0.0, 0.0, 0.0 };
  normal[axis] = direction[axis] > 0.0 ? 1.0 : -1.0;
  origin[axis] = bounds[2 * axis + (direction[axis] > 0.0 ? 0 : 1)];
  this->Plane = vtkSmartPointer<vtkPlane>::New();
  this->Plane->SetOrigin(origin);
  this->Plane->SetNormal(normal);
}

//------------------------------------------------------------------------------
bool CutPlane::Move(char key, const double bounds[6], vtkRenderer* renderer)
{
  if (key != 'm' && key != 'n')
  {
    return false;
  }
  if (!this->Plane)
  {
    this->Start(bounds, renderer);
  }
  const double* normal = this->Plane->GetNormal();
  double extent = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    extent += std::abs(normal[i]) * (bounds[2 * i + 1] - bounds[2 * i]);
  }
  const double share = key == 'm' ? Step : -Step;
  this->Plane->Push(share * extent / vtkMath::Dot(normal, normal));
  return true;
}

//------------------------------------------------------------------------------
void CutPlane::WarnIfEmpty(const double bounds[6], ViewerMessages& messages) const
{
  bool isEmpty = true;
  for (int i = 0; i < 8; ++i)
  {
    double corner[3] = { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2 & 1)] };
    isEmpty = isEmpty && this->Plane->EvaluateFunction(corner) < 0.0;
  }
  if (isEmpty)
  {
    messages.Warn(this->GetOption() + " leaves nothing: the mesh is behind the plane");
  }
}

//------------------------------------------------------------------------------
std::string CutPlane::GetOption() const
{
  const double* origin = this->Plane->GetOrigin();
  const double* normal = this->Plane->GetNormal();
  return "--clip " +
    JoinNumbers({ origin[0], origin[1], origin[2], normal[0], normal[1], normal[2] });
}

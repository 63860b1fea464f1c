// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/ReliefView.h"

#include "OpenGL/RelevoOpenGL.h"
#include "OpenGL/ShaderUniforms.h"
#include "View/RendererLights.h"
#include "View/WorldView.h"

#include "vtkActor.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace relevo
{
namespace
{
// VTK's rows are GLM's columns, and a matrix that VTK stores for OpenGL is already transposed.
dmat4 FromOpenGL(vtkMatrix4x4* matrix)
{
  return transpose(MakeMatrix(matrix));
}

double GetLargest(const dvec4& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z), std::abs(v.w) });
}
}

ReliefView::ReliefView(vtkRenderer* renderer, vtkActor* actor, const dmat4& toModel)
{
  vtkMatrix4x4* worldToView;
  vtkMatrix4x4* viewToClip;
  vtkMatrix4x4* worldToClip;
  vtkMatrix3x3* normals;
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  this->ToWorld = MakeMatrix(actor->GetMatrix()) * toModel;
  this->ToView = FromOpenGL(worldToView) * this->ToWorld;
  this->ToClip = FromOpenGL(worldToClip) * this->ToWorld;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  GLint viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  this->Viewport = dvec4(viewport[0], viewport[1], viewport[2], viewport[3]);
  // The near and far planes.
  const dmat4 rows = transpose(this->ToClip);
  this->Planes = { rows[3] + rows[2], rows[3] - rows[2] };
  this->Sides = { rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1] };
}

void ReliefView::AddClippingPlane(const dvec4& plane)
{
  this->Planes.push_back(transpose(this->ToWorld) * plane);
}

void ReliefView::SetUniforms(vtkShaderProgram* program) const
{
  const dmat4 fromClip = inverse(this->ToClip);
  const dvec4 middle = this->ToClip[3];
  // Any depth near the relief works; distant ones lose precision.
  const double depth = middle.w > 0.0 ? std::clamp(middle.z / middle.w, -1.0, 1.0) : -1.0;
  const dvec4 base = fromClip[3] + depth * fromClip[2];
  const double scale =
    1.0 / std::max({ GetLargest(base), GetLargest(fromClip[0]), GetLargest(fromClip[1]) });
  SetVector(program, "reliefRayBase", scale * base);
  SetVector(program, "reliefRayX", scale * fromClip[0]);
  SetVector(program, "reliefRayY", scale * fromClip[1]);
  SetVector(program, "reliefEye", fromClip[2] / GetLargest(fromClip[2]));
  SetVector(program, "reliefViewport", this->Viewport);
  SetMatrix(program, "reliefToClip", this->ToClip);
  SetMatrix(program, "reliefToView", this->ToView);
  SetMatrix(program, "reliefPlaneToView", transpose(inverse(this->ToView)));
  for (size_t i = 0; i < this->Planes.size(); ++i)
  {
    const std::string name = "reliefPlane" + std::to_string(i);
    SetVector(program, name.c_str(), this->Planes[i] / GetLargest(this->Planes[i]));
  }
}

bool ReliefView::SetLamp(vtkShaderProgram* program, vtkRenderer* renderer) const
{
  const RendererLights lights(renderer);
  if (lights.IsEmpty())
  {
    return false;
  }
  const dvec4 seen = inverse(this->ToWorld) * lights.GetFirst().Position;
  SetVector(program, "reliefLamp", seen / GetLargest(seen));
  return true;
}

bool ReliefView::SeesFront(double height) const
{
  const dvec4 eye = inverse(this->ToClip)[2];
  return eye.z - height * eye.w > 0.0;
}

bool ReliefView::MaySee(const dvec3& low, const dvec3& high) const
{
  for (const std::vector<dvec4>* planes : { &this->Planes, &this->Sides })
  {
    for (const dvec4& plane : *planes)
    {
      const dvec3 nearest(plane.x > 0.0 ? high.x : low.x, plane.y > 0.0 ? high.y : low.y,
        plane.z > 0.0 ? high.z : low.z);
      if (dot(plane, dvec4(nearest, 1.0)) < 0.0)
      {
        return false;
      }
    }
  }
  return true;
}

double ReliefView::GetPixels(const dvec3& point) const
{
  const dvec4 place = this->ToClip * dvec4(point, 1.0);
  double most = 0.0;
  for (int axis = 0; axis < 3 && place.w > 0.0; ++axis)
  {
    const dvec4 step = this->ToClip[axis];
    const dvec2 slope = (dvec2(step) * place.w - dvec2(place) * step.w) / (place.w * place.w);
    most = std::max(most, length(slope * 0.5 * dvec2(this->Viewport.z, this->Viewport.w)));
  }
  return most;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/CapturePass.h"

#include "Capture/CaptureRenderer.h"
#include "Capture/CaptureTarget.h"

#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"

#include <regex>
#include <string>

namespace relevo
{
vtkStandardNewMacro(CapturePass);

namespace
{
constexpr const char* LightAnchor = "//VTK::Light::Impl";
constexpr const char* CaptureAnchor = "//VTK::ReliefCapture::Impl";

// Gives a prop unlimited time to render, so that it uses its finest level of detail.
class UnlimitedTime
{
public:
  UnlimitedTime(vtkProp* prop, vtkViewport* viewport)
    : Prop(prop)
    , Viewport(viewport)
    , Seconds(prop->GetAllocatedRenderTime())
  {
    this->Prop->SetAllocatedRenderTime(VTK_FLOAT_MAX, this->Viewport);
  }

  // This also restores the estimated time, which SetAllocatedRenderTime() saves.
  ~UnlimitedTime()
  {
    this->Prop->RestoreEstimatedRenderTime();
    this->Prop->SetAllocatedRenderTime(this->Seconds, this->Viewport);
    this->Prop->RestoreEstimatedRenderTime();
  }
  UnlimitedTime(const UnlimitedTime&) = delete;
  void operator=(const UnlimitedTime&) = delete;

private:
  vtkProp* Prop;
  vtkViewport* Viewport;
  double Seconds;
};
}

void CapturePass::Draw(
  CaptureRenderer* renderer, std::vector<vtkProp*>& props, CaptureTarget& target)
{
  this->Props = &props;
  this->Target = &target;
  renderer->SetPass(this);
  renderer->DeviceRender(); // prepares the environment's textures
  renderer->SetPass(nullptr);
  this->Props = nullptr;
  this->Target = nullptr;
}

void CapturePass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  vtkRenderState own(renderer);
  own.SetPropArrayAndCount(this->Props->data(), static_cast<int>(this->Props->size()));
  this->PreRender(&own);
  this->Target->Begin();
  for (vtkProp* prop : *this->Props)
  {
    const UnlimitedTime time(prop, renderer);
    this->Target->ActivateDrawBuffers(1);
    prop->RenderOpaqueGeometry(renderer);
  }
  this->Target->End();
  this->PostRender(&own);
}

bool CapturePass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkPolyDataMapper::SafeDownCast(mapper))
  {
    vtkShaderProgram::Substitute(
      fragmentShader, LightAnchor, std::string(LightAnchor) + "\n  " + CaptureAnchor, false);
  }
  return true;
}

bool CapturePass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const bool hasNormal = fragmentShader.find("normalVCVSOutput") != std::string::npos;
  // If a shader sets the same depth as the rasterizer, the latter is used.
  const bool setsDepth = std::regex_search(fragmentShader, std::regex("gl_FragDepth\\s*=[^=]"));
  vtkShaderProgram::Substitute(fragmentShader, CaptureAnchor,
    std::string("gl_FragData[1] = vec4(") + (hasNormal ? "normalVCVSOutput" : "0.0, 0.0, 0.0") +
      ", 1.0);\n  gl_FragData[2] = vec4(" +
      (setsDepth ? "gl_FragDepth == gl_FragCoord.z ? 1.0 / gl_FragCoord.w : 0.0, gl_FragDepth"
                 : "1.0 / gl_FragCoord.w, gl_FragCoord.z") +
      ", 0.0, 1.0);\n",
    false);
  return true;
}

bool CapturePass::SetShaderParameters(
  vtkShaderProgram*, vtkAbstractMapper* mapper, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  this->Target->ActivateDrawBuffers(
    vtkPolyDataMapper::SafeDownCast(mapper) ? CaptureTarget::NumberOfDrawBuffers : 1);
  return true;
}
}

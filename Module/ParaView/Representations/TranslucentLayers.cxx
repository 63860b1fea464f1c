// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TranslucentLayers.h"

#include "Segments/RaySegments.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPixelBufferObject.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
#include <cstring>

namespace relevo
{
namespace
{
// A colour, and a depth.
const std::vector<RenderTarget::Format> LayerFormats = { {}, { 1 } };

std::uint32_t GetWord(float value)
{
  std::uint32_t word = 0;
  std::memcpy(&word, &value, sizeof(word));
  return word;
}

std::vector<float> Download(vtkTextureObject* texture, int components)
{
  vtkSmartPointer<vtkPixelBufferObject> pixels;
  pixels.TakeReference(texture->Download());
  unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
  vtkIdType increments[2] = { 0, 0 };
  std::vector<float> values(static_cast<size_t>(components) * size[0] * size[1]);
  pixels->Download2D(VTK_FLOAT, values.data(), size, components, increments);
  return values;
}

// VTK's actors do not write depths of translucent fragments unless this is set.
void WriteDepths(const vtkRenderState* state, bool areWritten)
{
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkInformation* keys = state->GetPropArray()[i]->GetPropertyKeys();
    if (areWritten && !keys)
    {
      vtkNew<vtkInformation> created;
      state->GetPropArray()[i]->SetPropertyKeys(created);
      keys = created;
    }
    if (areWritten)
    {
      keys->Set(vtkOpenGLActor::GLDepthMaskOverride(), 1);
    }
    else if (keys)
    {
      keys->Remove(vtkOpenGLActor::GLDepthMaskOverride());
    }
  }
}
}

vtkStandardNewMacro(TranslucentLayers);

TranslucentLayers::TranslucentLayers() = default;
TranslucentLayers::~TranslucentLayers() = default;

void TranslucentLayers::Render(const vtkRenderState* state)
{
  this->Translucent->Render(state);
  this->NumberOfRenderedProps = this->Translucent->GetNumberOfRenderedProps();
}

bool TranslucentLayers::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  // If a mapper has replaced it already, this has no effect.
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::Depth::Impl", "gl_FragDepth = gl_FragCoord.z;");
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Dec",
    "uniform sampler2D relevoOpaqueDepths;\n"
    "uniform sampler2D relevoLayerDepths;\n"
    "uniform bool relevoIsFirstLayer;\n");
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::PreColor",
    "ivec2 relevoPixel = ivec2(gl_FragCoord.xy);\n"
    "  float relevoBefore = texelFetch(relevoLayerDepths, relevoPixel, 0).r;\n"
    "  bool relevoIsPeeled = !relevoIsFirstLayer &&\n"
    "    (relevoBefore < 0.0 || gl_FragDepth <= relevoBefore); // negative if there are no more\n"
    "  if (relevoIsPeeled || gl_FragDepth > texelFetch(relevoOpaqueDepths, relevoPixel, 0).r)\n"
    "  {\n"
    "    discard;\n"
    "  }\n");
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::DepthPeeling::Impl", "gl_FragData[1] = vec4(gl_FragDepth);\n");
  return true;
}

bool TranslucentLayers::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  vtkTextureObject* depths =
    this->Layer > 0 ? this->GetTarget(1).GetTexture(1) : this->OpaqueDepths.Get();
  program->SetUniformi("relevoOpaqueDepths", this->OpaqueDepths->GetTextureUnit());
  program->SetUniformi("relevoLayerDepths", depths->GetTextureUnit());
  program->SetUniformi("relevoIsFirstLayer", this->Layer == 0 ? 1 : 0);
  return true;
}

bool TranslucentLayers::Read(const vtkRenderState* state, const std::vector<float>& opaqueDepths,
  int most, RaySegments& fragments)
{
  this->OpaqueDepths = vtkSmartPointer<vtkTextureObject>::New();
  this->OpaqueDepths->SetContext(
    vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow()));
  const bool isUploaded = this->OpaqueDepths->Create2DFromRaw(
    static_cast<unsigned int>(fragments.Width), static_cast<unsigned int>(fragments.Height), 1,
    VTK_FLOAT, const_cast<float*>(opaqueDepths.data()));
  bool isDone = false;
  if (isUploaded)
  {
    this->SetActiveDrawBuffers(static_cast<unsigned int>(LayerFormats.size()));
    this->PreRender(state);
    WriteDepths(state, true);
    isDone = this->Peel(state, most, fragments);
    WriteDepths(state, false);
    this->PostRender(state);
  }
  this->OpaqueDepths = nullptr;
  return isDone;
}

bool TranslucentLayers::Peel(const vtkRenderState* state, int most, RaySegments& fragments)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
  Words records;
  size_t before = 0;
  this->Layer = 0;
  // One layer more than are kept shows whether there are more.
  for (; this->Layer <= static_cast<size_t>(most) && (this->Layer == 0 || records.size() > before);
       ++this->Layer)
  {
    before = records.size();
    RenderTarget& target = this->GetTarget(0);
    if (!target.Begin(window, fragments.Width, fragments.Height, LayerFormats, true))
    {
      return false;
    }
    this->DrawLayer(state);
    target.End();
    if (this->NumberOfRenderedProps > 0)
    {
      this->ReadLayer(records);
    }
  }
  fragments.Sort(records, most);
  return true;
}

// Textures are bound for each layer, because reading a layer back binds its textures.
void TranslucentLayers::DrawLayer(const vtkRenderState* state)
{
  vtkTextureObject* before = this->Layer > 0 ? this->GetTarget(1).GetTexture(1) : nullptr;
  this->OpaqueDepths->Activate();
  if (before)
  {
    before->Activate();
  }
  this->GetTarget(0).Draw(BlendOperation::Minimum, [&] { this->Render(state); });
  if (before)
  {
    before->Deactivate();
  }
  this->OpaqueDepths->Deactivate();
}

void TranslucentLayers::ReadLayer(Words& records)
{
  const std::vector<float> depths = Download(this->GetTarget(0).GetTexture(1), 1);
  const std::vector<float> colors = Download(this->GetTarget(0).GetTexture(0), 4);
  for (size_t pixel = 0; pixel < depths.size(); ++pixel)
  {
    if (depths[pixel] == RenderTarget::Empty)
    {
      continue;
    }
    const float opacity = std::clamp(colors[4 * pixel + 3], 0.0f, 1.0f);
    records.push_back(static_cast<std::uint32_t>(pixel));
    records.push_back(GetWord(depths[pixel]));
    records.push_back(GetWord(depths[pixel]));
    for (size_t c = 0; c < 3; ++c)
    {
      records.push_back(GetWord(opacity * std::clamp(colors[4 * pixel + c], 0.0f, 1.0f)));
    }
    records.push_back(GetWord(opacity));
  }
}

void TranslucentLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Translucent->ReleaseGraphicsResources(window);
  for (RenderTarget& target : this->Targets)
  {
    target.ReleaseGraphicsResources(window);
  }
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/LICScreenDrawer.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Changes/Dependencies.h"
#include "Passes/LICScreen.h"
#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLICSettings.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
// Find the origin of the drawn region in the renderer's viewport, in pixels. It differs from (0, 0)
// if a window draws an image in tiles, as for vtkWindowToImageFilter.
void FindPartOrigin(vtkRenderer* ren, int origin[2])
{
  vtkRenderWindow* window = ren->GetRenderWindow();
  const int* size = window->GetSize(); // size of the whole image
  for (int i = 0; i < 2; ++i)
  {
    const double first = std::max(0.0, window->GetTileViewport()[i] - ren->GetViewport()[i]);
    origin[i] = static_cast<int>(std::lround(first * size[i]));
  }
}

// Removes the render passes from an actor as long as the object lives. They apply to the visible
// image, and some set draw buffers whenever the actor is drawn.
class WithoutRenderPasses
{
public:
  explicit WithoutRenderPasses(vtkActor* actor)
    : Keys(actor->GetPropertyKeys())
  {
    vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
    for (int i = 0; this->Keys && i < key->Length(this->Keys); ++i)
    {
      this->Passes.emplace_back(key->Get(this->Keys, i));
    }
    if (!this->Passes.empty())
    {
      this->Keys->Remove(key);
    }
  }
  ~WithoutRenderPasses()
  {
    for (vtkObjectBase* pass : this->Passes)
    {
      vtkOpenGLRenderPass::RenderPasses()->Append(this->Keys, pass);
    }
  }
  WithoutRenderPasses(const WithoutRenderPasses&) = delete;
  void operator=(const WithoutRenderPasses&) = delete;

private:
  vtkInformation* Keys;
  std::vector<vtkSmartPointer<vtkObjectBase>> Passes;
};

// Saves the window's framebuffer and state, and restores them after drawing to textures.
class DrawingToTextures
{
public:
  DrawingToTextures(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer)
    : State(window->GetState())
    , Framebuffer(framebuffer)
  {
    this->State->PushFramebufferBindings();
    this->State->Push();
    this->Framebuffer->SetContext(window);
  }
  ~DrawingToTextures()
  {
    this->State->Pop();
    this->State->PopFramebufferBindings();
  }
  DrawingToTextures(const DrawingToTextures&) = delete;
  void operator=(const DrawingToTextures&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLFramebufferObject* Framebuffer;
};
}

bool LICScreenDrawer::Parameters::StretchesColors() const
{
  return this->Settings->EnhancesColorContrast();
}

LICColoring LICScreenDrawer::Parameters::GetColoring() const
{
  return { this->Settings->GetColorMode(), this->Settings->GetLICIntensity(),
    this->Settings->GetMapModeBias() };
}

std::string LICScreenDrawer::CheckSettings(vtkLICSettings* settings)
{
  // Factors that are not used may be invalid, as in vtkSurfaceLICMapper.
  std::string error = settings->EnhancesLICContrast() ? FindContrastError(settings) : std::string();
  if (error.empty() && settings->EnhancesColorContrast())
  {
    error = FindColorContrastError(settings);
  }
  if (error.empty() && !this->Noise.Update(settings))
  {
    error = this->Noise.GetError();
  }
  return error;
}

LICPassSettings LICScreenDrawer::GetPassSettings(const Parameters& parameters) const
{
  return MakeLICPassSettings(
    parameters.Settings, std::max(parameters.Longest, 0.0), this->Noise.GetMean());
}

void LICScreenDrawer::AddTo(Dependencies& dependencies, const Parameters& parameters) const
{
  const LICPassSettings pass = this->GetPassSettings(parameters);
  vtkLICSettings* settings = parameters.Settings;
  const auto add = [&dependencies](auto... values) { (dependencies.Add(values), ...); };
  add(this->Noise.GetVersion(), pass.Kernel.Steps, pass.Kernel.StepSize, pass.Kernel.Normalized,
    pass.Kernel.Oriented, pass.Kernel.Phase, pass.Enhanced, pass.Stretched, pass.StretchFactors.x,
    pass.StretchFactors.y, pass.NumberOfSmoothings, settings->GetMaskThreshold(),
    settings->GetMaskOnSurface(), settings->GetNoDataMagnitude());
}

int LICScreenDrawer::FindReach(const Parameters& parameters) const
{
  return LICImage::FindReach(this->GetPassSettings(parameters));
}

std::string LICScreenDrawer::Allocate(vtkRenderer* ren, LICScreen& screen, bool withColors)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, screen.Viewport);
  FindPartOrigin(ren, screen.PartOrigin);
  return screen.IsEmpty() || screen.Allocate(window, withColors) ? "" : LICImage::GetTextureError();
}

std::string LICScreenDrawer::DrawVectors(vtkRenderer* ren, vtkActor* act, LICScreen& screen,
  const std::function<void()>& draw, const std::function<void(vtkOpenGLFramebufferObject*)>& finish)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  DrawingToTextures drawing(window, this->Framebuffer);
  if (!screen.Begin(window, this->Framebuffer))
  {
    return LICImage::GetTextureError();
  }
  {
    WithoutRenderPasses plain(act);
    draw();
  }
  finish(this->Framebuffer);
  screen.End(window, this->Framebuffer);
  return "";
}

std::string LICScreenDrawer::DrawImage(vtkRenderer* ren, LICScreen& screen,
  const Parameters& parameters, bool convolve, const LICImage::RangeMerger& merge)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkTextureObject* noise = this->Noise.GetTexture(window);
  if (!noise)
  {
    return LICImage::GetTextureError();
  }
  DrawingToTextures drawing(window, this->Framebuffer);
  this->Framebuffer->Bind();
  bool done = true;
  if (convolve)
  {
    screen.Sources.Clear();
    done = this->Image.Convolve(
      window, this->Framebuffer, screen, noise, this->GetPassSettings(parameters), merge);
    ++this->NumberOfConvolutions;
  }
  done = done &&
    (!parameters.StretchesColors() ||
      this->Image.FindColorRange(
        window, this->Framebuffer, screen, parameters.GetColoring(), merge));
  this->Framebuffer->RemoveColorAttachment(0);
  this->Framebuffer->DeactivateDrawBuffers();
  return done ? "" : this->Image.GetError();
}

int LICScreenDrawer::CountRanges(const Parameters& parameters, bool convolve) const
{
  return (convolve ? LICImage::CountRanges(this->GetPassSettings(parameters)) : 0) +
    (parameters.StretchesColors() ? 1 : 0);
}

void LICScreenDrawer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Image.ReleaseGraphicsResources(window);
  this->Noise.ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
}
}

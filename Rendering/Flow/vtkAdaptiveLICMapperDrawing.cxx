// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A screen's vectors and their LIC: before the surface is drawn or, with other processes, before
// the picture is.
#include "vtkAdaptiveLICMapperInternals.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
// Where what is drawn starts in the renderer's viewport, in pixels: not at its corner where a
// window draws a picture larger than itself in parts, as for vtkWindowToImageFilter.
void FindPartOrigin(vtkRenderer* ren, int origin[2])
{
  vtkRenderWindow* window = ren->GetRenderWindow();
  const int* size = window->GetSize(); // of the whole picture
  for (int i = 0; i < 2; ++i)
  {
    const double first = std::max(0.0, window->GetTileViewport()[i] - ren->GetViewport()[i]);
    origin[i] = static_cast<int>(std::lround(first * size[i]));
  }
}

// Takes the render passes from an actor as long as it lives. They are about what is seen, and some
// set draw buffers of their own whenever the actor is drawn.
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

// Keeps what the window draws to, and how, from what is drawn to textures meanwhile.
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

void vtkAdaptiveLICMapper::vtkInternals::Prepare(vtkRenderer* ren, vtkActor* act)
{
  this->Screen = nullptr;
  if (!this->CanShow(ren, act))
  {
    return;
  }
  if (this->IsTogether())
  {
    const auto screen = this->Screens.find(ScreenKey(ren, act, ren->GetActiveCamera()));
    const bool isPrepared = screen != this->Screens.end() && !screen->second.Sources.IsEmpty();
    this->Screen = isPrepared ? &screen->second : nullptr;
    return;
  }
  this->CheckVectors();
  this->AllVectors = this->OwnVectors;
  std::string problem = this->FindVectorProblem();
  if (problem.empty())
  {
    problem = this->FindSettingsProblem();
  }
  if (problem.empty())
  {
    problem = this->UpdateScreen(ren, act);
  }
  this->SetProblem(problem);
}

void vtkAdaptiveLICMapper::vtkInternals::SetProblem(const std::string& problem)
{
  if (problem != this->Problem)
  {
    this->Problem = problem;
    if (!problem.empty())
    {
      vtkErrorWithObjectMacro(this->Root, << problem << " The surface has no LIC.");
    }
  }
}

std::string vtkAdaptiveLICMapper::vtkInternals::AllocateScreen(
  vtkRenderer* ren, relevo::LICScreen& screen)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, screen.Viewport);
  FindPartOrigin(ren, screen.PartOrigin);
  return screen.IsEmpty() || screen.Allocate(window, this->StretchesColors())
    ? ""
    : relevo::LICImage::GetTextureProblem();
}

std::string vtkAdaptiveLICMapper::vtkInternals::UpdateScreen(vtkRenderer* ren, vtkActor* act)
{
  relevo::LICScreen& screen = this->GetScreen(ren, act);
  std::string problem = this->AllocateScreen(ren, screen);
  if (!problem.empty() || screen.IsEmpty())
  {
    return problem;
  }
  const bool convolve = screen.Sources != this->GetScreenDependencies(ren, act, screen);
  if (convolve || this->StretchesColors())
  {
    problem = this->DrawVectors(ren, act, screen, nullptr);
    if (problem.empty())
    {
      problem = this->DrawImage(ren, screen, convolve, nullptr);
    }
    if (problem.empty())
    {
      screen.Sources = this->GetScreenDependencies(ren, act, screen); // with the levels drawn
    }
  }
  this->Screen = problem.empty() ? &screen : nullptr;
  return problem;
}

std::string vtkAdaptiveLICMapper::vtkInternals::DrawVectors(
  vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen, std::vector<float>* vectors)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  DrawingToTextures drawing(window, this->Framebuffer);
  if (!screen.Begin(window, this->Framebuffer))
  {
    return relevo::LICImage::GetTextureProblem();
  }
  this->IsDrawingVectors = true;
  {
    WithoutRenderPasses plain(act);
    this->Root->Superclass::RenderRefined(ren, act);
  }
  this->IsDrawingVectors = false;
  this->SetBounds(ren, act, screen);
  if (vectors)
  {
    *vectors = screen.ReadVectors(this->Framebuffer, screen.Rectangle);
  }
  screen.End(window, this->Framebuffer);
  return "";
}

std::string vtkAdaptiveLICMapper::vtkInternals::DrawImage(vtkRenderer* ren,
  relevo::LICScreen& screen, bool convolve, const relevo::LICImage::RangeMerger& merge)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkTextureObject* noise = this->Noise.GetTexture(window);
  if (!noise)
  {
    return relevo::LICImage::GetTextureProblem();
  }
  DrawingToTextures drawing(window, this->Framebuffer);
  this->Framebuffer->Bind();
  bool done = true;
  if (convolve)
  {
    screen.Sources.Clear();
    done = this->Image.Convolve(
      window, this->Framebuffer, screen, noise, this->GetPassSettings(), merge);
    ++this->Root->NumberOfConvolutions;
  }
  done = done &&
    (!this->StretchesColors() ||
      this->Image.FindColorRange(window, this->Framebuffer, screen, this->GetColoring(), merge));
  this->Framebuffer->RemoveColorAttachment(0);
  this->Framebuffer->DeactivateDrawBuffers();
  return done ? "" : this->Image.GetProblem();
}

void vtkAdaptiveLICMapper::vtkInternals::SetBounds(
  vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen)
{
  // Those of the actor are of the first sub-piece, and have the pipeline make it again.
  this->Root->ComputeBounds();
  vtkNew<vtkMatrix4x4> project;
  vtkMatrix4x4::Multiply4x4(ren->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                              ren->GetTiledAspectRatio(), -1, 1),
    act->GetMatrix(), project);
  screen.SetBounds(this->Root->Bounds, project);
}

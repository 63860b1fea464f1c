// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveLICMapperInternals.h"

#include "OpenGL/RelevoOpenGL.h"
#include "Passes/LICHoles.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkAdaptiveLICMapper);

namespace
{
constexpr size_t MostScreens = 8;

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
}

vtkAdaptiveLICMapper::vtkAdaptiveLICMapper()
  : LICSettings(vtkSmartPointer<vtkLICSettings>::New())
  , LIC(new vtkInternals(this))
{
  this->LIC->Vectors = this->AddFaceHelper();
  vtkNew<vtkAdaptiveRefinement> coarse;
  coarse->SetMaximumLevel(0);
  this->SetRefinement(coarse);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::VECTORS);
}

vtkAdaptiveLICMapper::~vtkAdaptiveLICMapper()
{
  this->ReleaseGraphicsResources(nullptr);
}

template <typename Work>
void vtkAdaptiveLICMapper::vtkInternals::ForEachLeaf(const Work& work)
{
  vtkDataObject* input = this->Root->GetInputDataObject(0, 0);
  const relevo::BlockLooks looks =
    relevo::GetBlockLooks(this->Root->GetCompositeDataDisplayAttributes(), input);
  if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(input))
  {
    work(mesh, relevo::FindLook(looks, 0));
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (vtkPolyData* leaf = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        work(leaf, relevo::FindLook(looks, iterator->GetCurrentFlatIndex()));
      }
    }
  }
}

//------------------------------------------------------------------------------
// What there is to show

relevo::LICArray vtkAdaptiveLICMapper::FindArray(vtkPolyData* input)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* chosen = this->GetInputArrayToProcess(0, input, association);
  return relevo::LICArray::Check(chosen, association, input);
}

bool vtkAdaptiveLICMapper::vtkInternals::CanShow(vtkRenderer* ren, vtkActor* act)
{
  return !ren->GetSelector() && act->GetProperty()->GetRepresentation() == VTK_SURFACE;
}

void vtkAdaptiveLICMapper::vtkInternals::CheckVectors()
{
  relevo::Dependencies dependencies =
    relevo::Dependencies::On(this->Root->BuildTime, this->Root->GetNoDataMagnitude());
  this->ForEachLeaf(
    [&](vtkPolyData* leaf, const relevo::BlockLook&) { dependencies.AddObject(leaf); });
  if (!this->VectorDependencies.Update(dependencies))
  {
    return;
  }
  std::string problem;
  double longest = -1.0;
  bool hasFaces = false;
  bool hasArray = false;
  this->ForEachLeaf(
    [&](vtkPolyData* leaf, const relevo::BlockLook&)
    {
      if (leaf->GetNumberOfPolys() == 0 && leaf->GetNumberOfStrips() == 0)
      {
        return;
      }
      hasFaces = true;
      const relevo::LICArray vectors = this->Root->FindArray(leaf);
      problem = problem.empty() ? vectors.Problem : problem;
      hasArray = hasArray || vectors.Array;
      longest = std::max(longest, vectors.FindLongest(this->Root->GetNoDataMagnitude()));
    });
  this->Longest = std::max(longest, 0.0);
  if (problem.empty() && hasFaces && !hasArray)
  {
    problem = "The input has no array of vectors that SetInputArrayToProcess(0, ...) chooses.";
  }
  else if (problem.empty() && hasFaces && longest < 0.0)
  {
    problem = "All vectors are no-data: not finite, or of NoDataMagnitude or more.";
  }
  this->VectorProblem = problem;
}

std::string vtkAdaptiveLICMapper::vtkInternals::FindProblem()
{
  this->CheckVectors();
  if (!this->VectorProblem.empty())
  {
    return this->VectorProblem;
  }
  vtkLICSettings* settings = this->Root->LICSettings;
  // Factors that are not used may be any, as for vtkSurfaceLICMapper.
  std::string error =
    settings->EnhancesLICContrast() ? relevo::FindContrastError(settings) : std::string();
  if (error.empty() && settings->EnhancesColorContrast())
  {
    error = relevo::FindColorContrastError(settings);
  }
  if (error.empty() && !this->Noise.Update(settings))
  {
    error = this->Noise.GetError();
  }
  return error;
}

relevo::LICScreen& vtkAdaptiveLICMapper::vtkInternals::GetScreen(vtkRenderer* ren, vtkActor* act)
{
  relevo::LICScreen& screen = this->Screens[ScreenKey(ren, act, ren->GetActiveCamera())];
  screen.LastUse = ++this->Use;
  while (this->Screens.size() > MostScreens)
  {
    auto oldest = std::min_element(this->Screens.begin(), this->Screens.end(),
      [](const auto& a, const auto& b) { return a.second.LastUse < b.second.LastUse; });
    oldest->second.ReleaseGraphicsResources(ren->GetRenderWindow());
    this->Screens.erase(oldest);
  }
  return screen;
}

relevo::Dependencies vtkAdaptiveLICMapper::vtkInternals::GetScreenDependencies(
  vtkRenderer* ren, vtkActor* act, const relevo::LICScreen& screen)
{
  relevo::Dependencies dependencies = relevo::Dependencies::On(
    screen.Viewport[2], screen.Viewport[3], screen.PartOrigin[0], screen.PartOrigin[1]);
  vtkCamera* camera = ren->GetActiveCamera();
  for (vtkMatrix4x4* matrix :
    { camera->GetModelViewTransformMatrix(),
      camera->GetProjectionTransformMatrix(ren->GetTiledAspectRatio(), -1, 1), act->GetMatrix() })
  {
    std::for_each(matrix->GetData(), matrix->GetData() + 16,
      [&dependencies](double element) { dependencies.Add(element); });
  }
  this->AddSettings(dependencies);
  dependencies.Add(this->Root->BuildTime);
  dependencies.Add(act->GetShaderProperty()->GetShaderMTime());
  vtkProperty* property = act->GetProperty();
  dependencies.Add(property->GetBackfaceCulling());
  dependencies.Add(property->GetFrontfaceCulling());
  if (vtkPlaneCollection* planes = this->Root->GetClippingPlanes())
  {
    for (int i = 0; i < planes->GetNumberOfItems(); ++i)
    {
      dependencies.AddObject(planes->GetItem(i));
    }
  }
  if (vtkAdaptiveRefinement* recipe = this->Root->GetRefinement())
  {
    dependencies.AddObject(recipe);
    vtkDisplacement* displacement = recipe->GetDisplacement();
    dependencies.AddObject(displacement ? displacement->GetHeightMap() : nullptr);
  }
  relevo::AddHoles(dependencies, act, this->Root->LookupTable);
  this->ForEachLeaf(
    [&](vtkPolyData* leaf, const relevo::BlockLook& look)
    {
      dependencies.AddObject(leaf);
      const bool isClear = (look.HasOpacity ? look.Opacity : property->GetOpacity()) <= 0.0;
      dependencies.Add(look.Visible && !isClear);
    });
  dependencies.Add(this->Root->GetNumberOfSelections());
  dependencies.Add(this->Root->GetLevelOffset());
  dependencies.Add(this->Root->GetMethod());
  return dependencies;
}

bool vtkAdaptiveLICMapper::vtkInternals::Prepare(vtkRenderer* ren, vtkActor* act)
{
  vtkAdaptiveLICMapper* self = this->Root;
  this->Screen = nullptr;
  if (!self->GetEnable() || !CanShow(ren, act) || !self->GetInputAlgorithm() ||
    !self->GetRefinement())
  {
    return false;
  }
  if (!self->GetStatic())
  {
    self->GetInputAlgorithm()->Update();
  }
  std::string problem = this->FindProblem();
  if (problem.empty())
  {
    problem = this->UpdateScreen(ren, act);
  }
  if (problem != this->Problem)
  {
    this->Problem = problem;
    if (!problem.empty())
    {
      vtkErrorWithObjectMacro(self, << problem << " The surface has no LIC.");
    }
  }
  return this->Screen != nullptr;
}

std::string vtkAdaptiveLICMapper::vtkInternals::UpdateScreen(vtkRenderer* ren, vtkActor* act)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  relevo::LICScreen& screen = this->GetScreen(ren, act);
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, screen.Viewport);
  if (screen.Viewport[2] < 1 || screen.Viewport[3] < 1)
  {
    return "";
  }
  FindPartOrigin(ren, screen.PartOrigin);
  if (!screen.Allocate(window, this->StretchesColors()))
  {
    return relevo::LICImage::GetTextureProblem();
  }
  const bool convolve = screen.Sources != this->GetScreenDependencies(ren, act, screen);
  const std::string problem =
    convolve || this->StretchesColors() ? this->Draw(ren, act, screen, convolve) : "";
  if (problem.empty())
  {
    this->Screen = &screen;
  }
  return problem;
}

//------------------------------------------------------------------------------
// Drawing

std::string vtkAdaptiveLICMapper::vtkInternals::Draw(
  vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen, bool convolve)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  vtkTextureObject* noise = this->Noise.GetTexture(window);
  if (!noise)
  {
    return relevo::LICImage::GetTextureProblem();
  }
  state->PushFramebufferBindings();
  state->Push();
  this->Framebuffer->SetContext(window);
  std::string problem = relevo::LICImage::GetTextureProblem();
  if (screen.Begin(window, this->Framebuffer))
  {
    this->IsDrawingVectors = true;
    {
      WithoutRenderPasses plain(act);
      this->Root->Superclass::RenderRefined(ren, act);
    }
    this->IsDrawingVectors = false;
    screen.End(window, this->Framebuffer);
    bool done = true;
    if (convolve)
    {
      screen.Sources.Clear();
      this->SetBounds(ren, act, screen);
      done =
        this->Image.Convolve(window, this->Framebuffer, screen, noise, this->GetPassSettings());
      ++this->Root->NumberOfConvolutions;
    }
    done = done &&
      (!this->StretchesColors() ||
        this->Image.FindColorRange(window, this->Framebuffer, screen, this->GetColoring()));
    problem = done ? "" : this->Image.GetProblem();
    this->Framebuffer->RemoveColorAttachment(0);
    this->Framebuffer->DeactivateDrawBuffers();
  }
  state->Pop();
  state->PopFramebufferBindings();
  if (problem.empty())
  {
    screen.Sources = this->GetScreenDependencies(ren, act, screen); // with the levels drawn
  }
  return problem;
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

void vtkAdaptiveLICMapper::RenderRefined(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *this->LIC;
  if (lic.NoDataMagnitude != this->GetNoDataMagnitude())
  {
    lic.NoDataMagnitude = this->GetNoDataMagnitude();
    this->BuildTime.Modified(); // buffers are without no-data
  }
  if (lic.Root == this)
  {
    lic.Prepare(ren, act);
  }
  this->Superclass::RenderRefined(ren, act);
}

vtkMTimeType vtkAdaptiveLICMapper::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->IsAskedByVTK() ? time : std::max(time, this->LICSettings->GetMTime());
}

void vtkAdaptiveLICMapper::UpdateBlocks()
{
  this->Superclass::UpdateBlocks();
  this->ForEachBlock([this](vtkAdaptiveRefinementMapper* block)
    { vtkAdaptiveLICMapper::SafeDownCast(block)->LIC->Root = this; });
}

bool vtkAdaptiveLICMapper::DrawsAllBlocks() const
{
  // One image holds the streaks of opaque and translucent blocks.
  return this->LIC->IsDrawingVectors;
}

void vtkAdaptiveLICMapper::RenderPieceDraw(vtkRenderer* ren, vtkActor* act)
{
  if (!this->LIC->Root->LIC->IsDrawingVectors)
  {
    this->Superclass::RenderPieceDraw(ren, act);
  }
  else if (this->IsDrawable() && this->LIC->HasVectors)
  {
    this->DrawingSelection = false;
    this->DrawingVertices = false;
    this->PrimitiveIDOffset = 0;
    this->DrawFaces(*this->LIC->Vectors, ren, act);
  }
}

void vtkAdaptiveLICMapper::RenderPieceFinish(vtkRenderer* ren, vtkActor* act)
{
  this->LIC->CellVectors.Deactivate();
  if (relevo::LICScreen* screen = this->LIC->Root->LIC->Screen)
  {
    for (vtkTextureObject* texture : { screen->Image.Get(), screen->Range.Get() })
    {
      if (texture)
      {
        texture->Deactivate();
      }
    }
  }
  this->Superclass::RenderPieceFinish(ren, act);
}

void vtkAdaptiveLICMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  vtkInternals& lic = *this->LIC;
  lic.Screen = nullptr;
  for (auto& screen : lic.Screens)
  {
    screen.second.ReleaseGraphicsResources(window);
  }
  lic.Screens.clear();
  lic.Image.ReleaseGraphicsResources(window);
  lic.Noise.ReleaseGraphicsResources(window);
  lic.CellVectors.ReleaseGraphicsResources(window);
  lic.CellVectorDependencies.Clear();
  lic.Framebuffer->ReleaseGraphicsResources(window);
}

vtkTypeInt64 vtkAdaptiveLICMapper::GetGraphicsMemorySize()
{
  vtkInternals& lic = *this->LIC;
  vtkTypeInt64 size = this->Superclass::GetGraphicsMemorySize() + lic.Image.GetMemorySize() +
    lic.Noise.GetMemorySize() + lic.CellVectors.GetMemorySize();
  for (const auto& screen : lic.Screens)
  {
    size += screen.second.GetMemorySize();
  }
  for (const char* name : { "relevoLICVector", "relevoLICPointNormal" })
  {
    if (vtkOpenGLVertexBufferObject* vbo = this->VBOs->GetVBO(name))
    {
      size += static_cast<vtkTypeInt64>(vbo->GetNumberOfTuples()) * vbo->GetStride();
    }
  }
  return size;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveLICMapper.h"

#include "Actors/ShaderVariantKey.h"
#include "Buffers/LICMeshVectors.h"
#include "Checks/MisplacedArray.h"
#include "Checks/ShouldReport.h"
#include "Composite/BlockAttributes.h"
#include "Composite/DataLeaves.h"
#include "Image/ForwardedSettings.h"
#include "Passes/LICHoles.h"
#include "Shaders/LICShader.h"
#include "Shaders/ShaderExtension.h"
#include "Stages/LICParallelFrame.h"
#include "Stages/LICScreenDrawer.h"
#include "Stages/LICScreens.h"
#include "Stages/LICVectorField.h"
#include "Stages/RenderHook.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkDataSetAttributes.h"
#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"
#include "vtkTransform.h"

#include <algorithm>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkAdaptiveLICMapper);

struct vtkAdaptiveLICMapper::vtkInternals
{
  explicit vtkInternals(vtkAdaptiveLICMapper* self)
    : Root(self)
  {
  }

  // The mapper whose screens a block of a composite input uses.
  vtkAdaptiveLICMapper* Root;
  vtkOpenGLHelper* VectorHelper = nullptr; // draws the vectors of this mapper's polydata
  relevo::LICMeshVectors Vectors;
  bool HasNormals = false;      // of the refined surface, for VectorHelper
  double NoDataMagnitude = 0.0; // of the buffers

  // The stages of a root mapper.
  relevo::LICVectorField Field;
  relevo::LICScreens Screens;
  relevo::LICScreenDrawer Drawer;
  relevo::LICParallelFrame Parallel;
  relevo::RenderHook Hook;
  relevo::LICScreen* Screen = nullptr; // shown on the surface; nullptr for none
  bool IsDrawingVectors = false;       // during DrawVectors()
  std::string Error;                   // error that was reported last

  using Mesh = std::pair<vtkPolyData*, relevo::BlockAttributes>;
  std::vector<Mesh> FindMeshes() const;
  relevo::LICScreenDrawer::Parameters GetParameters() const
  {
    return { this->Root->LICSettings, this->Field.GetLongest() };
  }

  bool CanShow(vtkRenderer* ren, vtkActor* act) const;
  void UpdateField();
  std::string DescribeMisplaced(vtkPolyData* mesh) const;
  relevo::Dependencies GetScreenSources(
    vtkRenderer* ren, vtkActor* act, const relevo::LICScreen& screen);

  void Prepare(vtkRenderer* ren, vtkActor* act);
  //@{
  /// Update the screen and its LIC. Return the error as a sentence, or "".
  std::string UpdateScreen(vtkRenderer* ren, vtkActor* act);
  std::string DrawVectors(
    vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen, std::vector<float>* vectors);
  std::string DrawImage(vtkRenderer* ren, relevo::LICScreen& screen, bool convolve,
    const relevo::LICImage::RangeMerger& merge);
  //@}
  void SetBounds(vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen);
  void Report(const std::string& error);

  /// Contribute this process's part of an image that several processes draw.
  void Contribute(
    vtkRenderer* ren, vtkActor* act, relevo::LICParallelFrame::Contribution& contribution);

  relevo::LICShaderOptions GetShaderOptions(
    vtkAdaptiveLICMapper* self, const vtkOpenGLHelper* helper) const;
  void SetVectorUniforms(
    vtkAdaptiveLICMapper* self, vtkShaderProgram* program, vtkRenderer* ren, vtkActor* act);
  void SetImageUniforms(vtkShaderProgram* program) const;
};

vtkAdaptiveLICMapper::vtkAdaptiveLICMapper()
  : LICSettings(vtkSmartPointer<vtkLICSettings>::New())
  , LIC(new vtkInternals(this))
{
  this->LIC->VectorHelper = this->AddFaceHelper();
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

//------------------------------------------------------------------------------
// Settings change live: only settings of missing values rebuild buffers.

relevoLICSettingsMacro(vtkAdaptiveLICMapper);

relevoForwardMacro(vtkAdaptiveLICMapper, Enable, int);
relevoForwardMacro(vtkAdaptiveLICMapper, NumberOfSteps, int);
relevoForwardMacro(vtkAdaptiveLICMapper, StepSize, double);
relevoForwardMacro(vtkAdaptiveLICMapper, NormalizeVectors, int);
relevoForwardMacro(vtkAdaptiveLICMapper, EnhancedLIC, int);
relevoForwardMacro(vtkAdaptiveLICMapper, OrientedLIC, int);
relevoForwardMacro(vtkAdaptiveLICMapper, Phase, double);
relevoForwardMacro(vtkAdaptiveLICMapper, EnhanceContrast, int);
relevoForwardMacro(vtkAdaptiveLICMapper, LowLICContrastEnhancementFactor, double);
relevoForwardMacro(vtkAdaptiveLICMapper, HighLICContrastEnhancementFactor, double);
relevoForwardMacro(vtkAdaptiveLICMapper, LowColorContrastEnhancementFactor, double);
relevoForwardMacro(vtkAdaptiveLICMapper, HighColorContrastEnhancementFactor, double);
relevoForwardMacro(vtkAdaptiveLICMapper, AntiAlias, int);
relevoForwardMacro(vtkAdaptiveLICMapper, MaskThreshold, double);
relevoForwardMacro(vtkAdaptiveLICMapper, MaskOnSurface, int);
relevoForwardMacro(vtkAdaptiveLICMapper, MaskIntensity, double);
relevoForwardMacro(vtkAdaptiveLICMapper, NoDataMagnitude, double);
relevoForwardMacro(vtkAdaptiveLICMapper, LICIntensity, double);
relevoForwardMacro(vtkAdaptiveLICMapper, MapModeBias, double);

void vtkAdaptiveLICMapper::SetMaskColor(double red, double green, double blue)
{
  this->LICSettings->ChangeFor(
    this, [=](vtkLICSettings& settings) { settings.SetMaskColor(red, green, blue); });
}

double* vtkAdaptiveLICMapper::GetMaskColor()
{
  return this->LICSettings->GetMaskColor();
}

void vtkAdaptiveLICMapper::GetMaskColor(double color[3])
{
  this->LICSettings->GetMaskColor(color);
}

void vtkAdaptiveLICMapper::GetMaskColor(double& red, double& green, double& blue)
{
  this->LICSettings->GetMaskColor(red, green, blue);
}

void vtkAdaptiveLICMapper::SetColorModeToBlend()
{
  this->LICSettings->SetColorModeToBlend();
}

void vtkAdaptiveLICMapper::SetColorModeToMultiply()
{
  this->LICSettings->SetColorModeToMap();
}

void vtkAdaptiveLICMapper::SetColorModeToMap()
{
  this->LICSettings->SetColorModeToMap();
}

//------------------------------------------------------------------------------
// Noise

relevoForwardMacro(vtkAdaptiveLICMapper, NoiseDataSet, vtkImageData*);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseFileName, const char*);
relevoForwardMacro(vtkAdaptiveLICMapper, GenerateNoiseTexture, int);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseType, int);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseTextureSize, int);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseGrainSize, int);
relevoForwardMacro(vtkAdaptiveLICMapper, MinNoiseValue, double);
relevoForwardMacro(vtkAdaptiveLICMapper, MaxNoiseValue, double);
relevoForwardMacro(vtkAdaptiveLICMapper, NumberOfNoiseLevels, int);
relevoForwardMacro(vtkAdaptiveLICMapper, ImpulseNoiseProbability, double);
relevoForwardMacro(vtkAdaptiveLICMapper, ImpulseNoiseBackgroundValue, double);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseGeneratorSeed, int);

//------------------------------------------------------------------------------
// The vectors to show

relevo::LICArray vtkAdaptiveLICMapper::FindArray(vtkPolyData* input)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* chosen = this->GetInputArrayToProcess(0, input, association);
  return relevo::LICArray::Check(chosen, association, input);
}

std::vector<vtkAdaptiveLICMapper::vtkInternals::Mesh>
vtkAdaptiveLICMapper::vtkInternals::FindMeshes() const
{
  vtkDataObject* input = this->Root->GetInputDataObject(0, 0);
  const relevo::AttributesOfBlocks blocks =
    relevo::GetAttributesOfBlocks(this->Root->GetCompositeDataDisplayAttributes(), input);
  std::vector<Mesh> meshes;
  for (const relevo::DataLeaf& leaf : relevo::FindDataLeaves(input))
  {
    if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(leaf.Data))
    {
      meshes.emplace_back(mesh, relevo::FindAttributes(blocks, leaf.FlatIndex));
    }
  }
  return meshes;
}

bool vtkAdaptiveLICMapper::vtkInternals::CanShow(vtkRenderer* ren, vtkActor* act) const
{
  return this->Root->GetEnable() && !ren->GetSelector() &&
    act->GetProperty()->GetRepresentation() == VTK_SURFACE && this->Root->GetInputAlgorithm() &&
    this->Root->GetRefinement();
}

void vtkAdaptiveLICMapper::vtkInternals::UpdateField()
{
  if (!this->Root->GetStatic())
  {
    this->Root->GetInputAlgorithm()->Update();
  }
  relevo::LICVectorField::Input input;
  for (const Mesh& mesh : this->FindMeshes())
  {
    input.Meshes.push_back(mesh.first);
  }
  input.BuildTime = this->Root->BuildTime;
  input.NoDataMagnitude = this->Root->GetNoDataMagnitude();
  input.FindArray = [this](vtkPolyData* mesh) { return this->Root->FindArray(mesh); };
  input.DescribeMisplaced = [this](vtkPolyData* mesh) { return this->DescribeMisplaced(mesh); };
  this->Field.Update(input);
}

std::string vtkAdaptiveLICMapper::vtkInternals::DescribeMisplaced(vtkPolyData* mesh) const
{
  vtkInformation* wanted = this->Root->GetInputArrayInformation(0);
  const std::string name =
    wanted->Has(vtkDataObject::FIELD_NAME()) ? wanted->Get(vtkDataObject::FIELD_NAME()) : "";
  return relevo::DescribeMisplacedArray(
    mesh, name, wanted->Get(vtkDataObject::FIELD_ASSOCIATION()), relevo::AdviseInputArray(name));
}

relevo::Dependencies vtkAdaptiveLICMapper::vtkInternals::GetScreenSources(
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
  this->Drawer.AddTo(dependencies, this->GetParameters());
  dependencies.Add(this->Parallel.IsUsed());
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
  for (const Mesh& mesh : this->FindMeshes())
  {
    dependencies.AddObject(mesh.first);
    const relevo::BlockAttributes& block = mesh.second;
    const bool isClear = (block.HasOpacity ? block.Opacity : property->GetOpacity()) <= 0.0;
    dependencies.Add(block.Visible && !isClear);
  }
  dependencies.Add(this->Root->GetNumberOfSelections());
  dependencies.Add(this->Root->GetLevelOffset());
  dependencies.Add(this->Root->GetMethod());
  return dependencies;
}

//------------------------------------------------------------------------------
// A screen with the LIC, before the surface is drawn

void vtkAdaptiveLICMapper::vtkInternals::Prepare(vtkRenderer* ren, vtkActor* act)
{
  this->Screen = nullptr;
  if (!this->CanShow(ren, act))
  {
    return;
  }
  if (this->Parallel.IsUsed())
  {
    this->Screen = this->Screens.Find(ren, act); // PrepareParallelFrame() has drawn it
    return;
  }
  this->UpdateField();
  this->Field.SetAll(this->Field.GetOwn());
  std::string error = this->Field.FindError();
  if (error.empty())
  {
    error = this->Drawer.CheckSettings(this->Root->LICSettings);
  }
  if (error.empty())
  {
    error = this->UpdateScreen(ren, act);
  }
  this->Report(error);
}

void vtkAdaptiveLICMapper::vtkInternals::Report(const std::string& error)
{
  if (relevo::ShouldReport(this->Error, error))
  {
    vtkErrorWithObjectMacro(this->Root, << error << " The surface is drawn without LIC.");
  }
}

std::string vtkAdaptiveLICMapper::vtkInternals::UpdateScreen(vtkRenderer* ren, vtkActor* act)
{
  relevo::LICScreen& screen = this->Screens.Get(ren, act);
  const bool stretchesColors = this->GetParameters().StretchesColors();
  std::string error = this->Drawer.Allocate(ren, screen, stretchesColors);
  if (!error.empty() || screen.IsEmpty())
  {
    return error;
  }
  const bool convolve = screen.Sources != this->GetScreenSources(ren, act, screen);
  if (convolve || stretchesColors)
  {
    error = this->DrawVectors(ren, act, screen, nullptr);
    if (error.empty())
    {
      error = this->DrawImage(ren, screen, convolve, nullptr);
    }
    if (error.empty())
    {
      screen.Sources = this->GetScreenSources(ren, act, screen); // now includes the drawn levels
    }
  }
  this->Screen = error.empty() ? &screen : nullptr;
  return error;
}

std::string vtkAdaptiveLICMapper::vtkInternals::DrawVectors(
  vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen, std::vector<float>* vectors)
{
  return this->Drawer.DrawVectors(
    ren, act, screen,
    [&]
    {
      this->IsDrawingVectors = true;
      this->Root->Superclass::RenderRefined(ren, act);
      this->IsDrawingVectors = false;
    },
    [&](vtkOpenGLFramebufferObject* framebuffer)
    {
      this->SetBounds(ren, act, screen);
      if (vectors)
      {
        *vectors = screen.ReadVectors(framebuffer, screen.Rectangle);
      }
    });
}

std::string vtkAdaptiveLICMapper::vtkInternals::DrawImage(vtkRenderer* ren,
  relevo::LICScreen& screen, bool convolve, const relevo::LICImage::RangeMerger& merge)
{
  const std::string error =
    this->Drawer.DrawImage(ren, screen, this->GetParameters(), convolve, merge);
  this->Root->NumberOfConvolutions = this->Drawer.GetNumberOfConvolutions();
  return error;
}

void vtkAdaptiveLICMapper::vtkInternals::SetBounds(
  vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen)
{
  // The actor's bounds are those of the first sub-piece, and computing them would run the pipeline
  // again.
  this->Root->ComputeBounds();
  vtkNew<vtkMatrix4x4> project;
  vtkMatrix4x4::Multiply4x4(ren->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                              ren->GetTiledAspectRatio(), -1, 1),
    act->GetMatrix(), project);
  screen.SetBounds(this->Root->Bounds, project);
}

//------------------------------------------------------------------------------
// Images that several processes draw

void vtkAdaptiveLICMapper::SetController(vtkMultiProcessController* controller)
{
  this->LIC->Parallel.SetController(controller);
}

vtkMultiProcessController* vtkAdaptiveLICMapper::GetController()
{
  return this->LIC->Parallel.GetController();
}

void vtkAdaptiveLICMapper::vtkInternals::Contribute(
  vtkRenderer* ren, vtkActor* act, relevo::LICParallelFrame::Contribution& contribution)
{
  if (!this->CanShow(ren, act))
  {
    return;
  }
  this->UpdateField();
  contribution.Error = this->Field.GetOwn().Error;
  if (contribution.Error.empty())
  {
    contribution.Error = this->Drawer.CheckSettings(this->Root->LICSettings);
  }
  relevo::LICScreen& screen = this->Screens.Get(ren, act);
  if (contribution.Error.empty())
  {
    contribution.Error =
      this->Drawer.Allocate(ren, screen, this->GetParameters().StretchesColors());
  }
  contribution.Screen = &screen;
  contribution.IsChanged = screen.Sources != this->GetScreenSources(ren, act, screen);
}

void vtkAdaptiveLICMapper::PrepareParallelFrame(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *this->LIC;
  if (!lic.Parallel.IsUsed())
  {
    return;
  }
  // These steps are the same as in a frame, which has not begun.
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  int viewport[4];
  ren->GetTiledSizeAndOrigin(viewport + 2, viewport + 3, viewport, viewport + 1);
  window->GetState()->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  ren->UpdateLightsGeometryToFollowCamera();
  vtkOpenGLRenderer::SafeDownCast(ren)->UpdateLights();

  using Contribution = relevo::LICParallelFrame::Contribution;
  vtkActor* drawn = act; // the actor that VTK passes to the mapper
  relevo::LICParallelFrame::Steps steps;
  steps.Prepare = [&](Contribution& contribution)
  {
    lic.Hook.RenderInstead(ren, act, this,
      [&](vtkRenderer*, vtkActor* rendered)
      {
        drawn = rendered;
        lic.Contribute(ren, rendered, contribution);
      });
  };
  steps.DrawVectors = [&](Contribution& contribution)
  {
    lic.Hook.RenderInstead(ren, act, this,
      [&](vtkRenderer*, vtkActor* rendered)
      {
        if (contribution.Screen)
        {
          contribution.Error =
            lic.DrawVectors(ren, rendered, *contribution.Screen, &contribution.Vectors);
        }
      });
  };
  steps.CountRanges = [&](bool convolve)
  { return lic.Drawer.CountRanges(lic.GetParameters(), convolve); };
  steps.FindReach = [&] { return lic.Drawer.FindReach(lic.GetParameters()); };
  steps.DrawImage =
    [&](relevo::LICScreen& screen, bool convolve, const relevo::LICImage::RangeMerger& merge)
  { return lic.DrawImage(ren, screen, convolve, merge); };
  steps.Finish = [&](relevo::LICScreen& screen)
  { screen.Sources = lic.GetScreenSources(ren, drawn, screen); };
  steps.StretchesColors = lic.GetParameters().StretchesColors();
  lic.Report(lic.Parallel.Run(ren, act, lic.Field, steps));
}

//------------------------------------------------------------------------------
// Rendering

void vtkAdaptiveLICMapper::RenderRefined(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *this->LIC;
  if (lic.NoDataMagnitude != this->GetNoDataMagnitude())
  {
    lic.NoDataMagnitude = this->GetNoDataMagnitude();
    this->BuildTime.Modified(); // buffers contain no no-data values
  }
  if (lic.Hook.Run(ren, act))
  {
    return;
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
  // One image contains the streaks of opaque and translucent blocks.
  return this->LIC->IsDrawingVectors;
}

void vtkAdaptiveLICMapper::RenderPieceDraw(vtkRenderer* ren, vtkActor* act)
{
  if (!this->LIC->Root->LIC->IsDrawingVectors)
  {
    this->Superclass::RenderPieceDraw(ren, act);
  }
  else if (this->IsDrawable() && !this->LIC->Vectors.IsEmpty())
  {
    this->DrawingSelection = false;
    this->DrawingVertices = false;
    this->PrimitiveIDOffset = 0;
    this->DrawFaces(*this->LIC->VectorHelper, ren, act);
  }
}

void vtkAdaptiveLICMapper::RenderPieceFinish(vtkRenderer* ren, vtkActor* act)
{
  this->LIC->Vectors.Deactivate();
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
  lic.Parallel.ForgetScreen();
  lic.Screens.ReleaseGraphicsResources(window);
  lic.Drawer.ReleaseGraphicsResources(window);
  lic.Vectors.ReleaseGraphicsResources(window);
}

vtkTypeInt64 vtkAdaptiveLICMapper::GetGraphicsMemorySize()
{
  const vtkInternals& lic = *this->LIC;
  return this->Superclass::GetGraphicsMemorySize() + lic.Drawer.GetMemorySize() +
    lic.Vectors.GetMemorySize(this->VBOs) + lic.Screens.GetMemorySize();
}

//------------------------------------------------------------------------------
// Buffers and shaders

void vtkAdaptiveLICMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *this->LIC;
  vtkPolyData* input = this->CurrentInput;
  relevo::Dependencies dependencies =
    relevo::Dependencies::On(this->GetMeshBuildMTime(), this->GetNoDataMagnitude());
  dependencies.AddObject(input);
  lic.Vectors.Update(
    dependencies, [&] { return this->FindArray(input); }, this->GetNoDataMagnitude());
  lic.Vectors.CacheArrays(this->VBOs, input, ren);
  this->Superclass::BuildBufferObjects(ren, act);

  // Other representations show no streaks.
  if (act->GetProperty()->GetRepresentation() == VTK_SURFACE &&
    !lic.Vectors.UploadCells(
      vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()), this->CellCellMap))
  {
    vtkErrorMacro(
      "Cannot upload the vectors of the cells: " << relevo::BufferTexture::GetTooLarge() << ".");
  }
}

relevo::LICShaderOptions vtkAdaptiveLICMapper::vtkInternals::GetShaderOptions(
  vtkAdaptiveLICMapper* self, const vtkOpenGLHelper* helper) const
{
  const vtkInternals& root = *this->Root->LIC;
  relevo::LICShaderOptions options;
  options.StretchesColors = root.GetParameters().StretchesColors();
  if (helper == this->VectorHelper)
  {
    options.Purpose = relevo::LICShaderOptions::VECTORS;
    options.AreOfCells = this->Vectors.AreOfCells();
    options.HasNormals = this->HasNormals;
    options.HasPointNormals = this->Vectors.HasPointNormals();
  }
  else if (root.Screen && self->IsFaceHelper(helper) && !self->DrawingVertices)
  {
    options.Purpose = relevo::LICShaderOptions::IMAGE;
  }
  return options;
}

void vtkAdaptiveLICMapper::ExtendShaders(
  const vtkOpenGLHelper* cellBO, relevo::ShaderExtension& extension)
{
  vtkInternals& lic = *this->LIC;
  if (cellBO == lic.VectorHelper)
  {
    lic.HasNormals = extension.HasNormals || lic.Vectors.HasPointNormals();
  }
  relevo::ExtendLICShaders(lic.GetShaderOptions(this, cellBO), extension);
}

void vtkAdaptiveLICMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  const relevo::LICShaderOptions options = this->LIC->GetShaderOptions(this, this->LastBoundBO);
  relevo::PrepareLICShaders(options, shaders, this->MissingAnchors);
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  const bool needsEdges = this->DrawingEdges(ren, act) && !relevo::HasOwnFragments(act);
  relevo::FinishLICShaders(options, needsEdges, shaders, this->MissingAnchors);
}

void vtkAdaptiveLICMapper::vtkInternals::SetVectorUniforms(
  vtkAdaptiveLICMapper* self, vtkShaderProgram* program, vtkRenderer* ren, vtkActor* act)
{
  const bool isShifted = self->VBOs->GetVBO("vertexMC")->GetCoordShiftAndScaleEnabled();
  vtkMatrix4x4* fromShifted = isShifted ? self->VBOInverseTransform->GetMatrix() : nullptr;
  this->Vectors.SetUniforms(program,
    { ren, act, fromShifted, this->Root->LICSettings, this->Root->LIC->Field.GetLongest() });
}

void vtkAdaptiveLICMapper::vtkInternals::SetImageUniforms(vtkShaderProgram* program) const
{
  const relevo::LICScreen& screen = *this->Screen;
  const auto read = [program](const char* sampler, vtkTextureObject* texture)
  {
    if (texture && program->IsUniformUsed(sampler))
    {
      texture->Activate();
      program->SetUniformi(sampler, texture->GetTextureUnit());
    }
  };
  read("relevoLICImage", screen.Image);
  read("relevoLICRange", screen.Range);
  this->GetParameters().GetColoring().SetUniforms(program);
  vtkLICSettings* settings = this->Root->LICSettings;
  if (program->IsUniformUsed("relevoLICOrigin"))
  {
    program->SetUniform2i("relevoLICOrigin", screen.Viewport);
    program->SetUniform2i("relevoLICSize", screen.Viewport + 2);
  }
  if (program->IsUniformUsed("relevoLICMaskColor"))
  {
    program->SetUniform3f("relevoLICMaskColor", settings->GetMaskColor());
    program->SetUniformf(
      "relevoLICMaskIntensity", static_cast<float>(settings->GetMaskIntensity()));
  }
  if (program->IsUniformUsed("relevoLICFactors"))
  {
    const float factors[2] = { static_cast<float>(settings->GetLowColorContrastEnhancementFactor()),
      static_cast<float>(settings->GetHighColorContrastEnhancementFactor()) };
    program->SetUniform2f("relevoLICFactors", factors);
  }
}

void vtkAdaptiveLICMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  const vtkInternals& root = *this->LIC->Root->LIC;
  if (&cellBO == this->LIC->VectorHelper)
  {
    this->LIC->SetVectorUniforms(this, cellBO.Program, ren, act);
  }
  else if (root.Screen && this->IsFaceHelper(&cellBO) && !this->DrawingVertices)
  {
    root.SetImageUniforms(cellBO.Program);
  }
}

//------------------------------------------------------------------------------

void vtkAdaptiveLICMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  if (vtkAdaptiveLICMapper* other = vtkAdaptiveLICMapper::SafeDownCast(mapper))
  {
    this->SetInputArrayToProcess(0, other->GetInputArrayInformation(0));
    this->SetLICSettings(other->LICSettings);
  }
}

void vtkAdaptiveLICMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LICSettings:\n";
  this->LICSettings->PrintSelf(os, indent.GetNextIndent());
  os << indent << "NumberOfConvolutions: " << this->NumberOfConvolutions << "\n";
}

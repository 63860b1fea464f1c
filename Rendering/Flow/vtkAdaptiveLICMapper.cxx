// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveLICMapperInternals.h"

#include "Checks/MisplacedArray.h"
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
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkStandardNewMacro(vtkAdaptiveLICMapper);

namespace
{
constexpr size_t MostScreens = 8;
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
  const relevo::AttributesOfBlocks blocks =
    relevo::GetAttributesOfBlocks(this->Root->GetCompositeDataDisplayAttributes(), input);
  if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(input))
  {
    work(mesh, relevo::FindAttributes(blocks, 0));
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (vtkPolyData* leaf = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        work(leaf, relevo::FindAttributes(blocks, iterator->GetCurrentFlatIndex()));
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
  return this->Root->GetEnable() && !ren->GetSelector() &&
    act->GetProperty()->GetRepresentation() == VTK_SURFACE && this->Root->GetInputAlgorithm() &&
    this->Root->GetRefinement();
}

void vtkAdaptiveLICMapper::vtkInternals::CheckVectors()
{
  if (!this->Root->GetStatic())
  {
    this->Root->GetInputAlgorithm()->Update();
  }
  relevo::Dependencies dependencies =
    relevo::Dependencies::On(this->Root->BuildTime, this->Root->GetNoDataMagnitude());
  this->ForEachLeaf(
    [&](vtkPolyData* leaf, const relevo::BlockAttributes&) { dependencies.AddObject(leaf); });
  if (!this->VectorDependencies.Update(dependencies))
  {
    return;
  }
  VectorFacts facts;
  this->ForEachLeaf(
    [&](vtkPolyData* leaf, const relevo::BlockAttributes&)
    {
      if (leaf->GetNumberOfPolys() == 0 && leaf->GetNumberOfStrips() == 0)
      {
        return;
      }
      facts.HasFaces = true;
      const relevo::LICArray vectors = this->Root->FindArray(leaf);
      facts.Problem = facts.Problem.empty() ? vectors.Problem : facts.Problem;
      facts.HasArray = facts.HasArray || vectors.Array;
      if (!vectors.Array && facts.Misplaced.empty())
      {
        facts.Misplaced = this->DescribeMisplaced(leaf);
      }
      facts.Longest =
        std::max(facts.Longest, vectors.FindLongest(this->Root->GetNoDataMagnitude()));
    });
  this->OwnVectors = facts;
}

std::string vtkAdaptiveLICMapper::vtkInternals::DescribeMisplaced(vtkPolyData* leaf)
{
  vtkInformation* wanted = this->Root->GetInputArrayInformation(0);
  const std::string name =
    wanted->Has(vtkDataObject::FIELD_NAME()) ? wanted->Get(vtkDataObject::FIELD_NAME()) : "";
  return relevo::DescribeMisplacedArray(
    leaf, name, wanted->Get(vtkDataObject::FIELD_ASSOCIATION()), relevo::AdviseInputArray(name));
}

std::string vtkAdaptiveLICMapper::vtkInternals::FindVectorProblem() const
{
  const VectorFacts& facts = this->AllVectors;
  if (facts.Problem.empty() && facts.HasFaces && !facts.HasArray)
  {
    return this->OwnVectors.Misplaced.empty()
      ? "The input has no array of vectors that SetInputArrayToProcess(0, ...) chooses."
      : "The input has " + this->OwnVectors.Misplaced + ".";
  }
  if (facts.Problem.empty() && facts.HasFaces && facts.Longest < 0.0)
  {
    return "All vectors are no-data: not finite, or of NoDataMagnitude or more.";
  }
  return facts.Problem;
}

std::string vtkAdaptiveLICMapper::vtkInternals::FindSettingsProblem()
{
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
  dependencies.Add(this->IsTogether());
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
    [&](vtkPolyData* leaf, const relevo::BlockAttributes& attributes)
    {
      dependencies.AddObject(leaf);
      const bool isClear =
        (attributes.HasOpacity ? attributes.Opacity : property->GetOpacity()) <= 0.0;
      dependencies.Add(attributes.Visible && !isClear);
    });
  dependencies.Add(this->Root->GetNumberOfSelections());
  dependencies.Add(this->Root->GetLevelOffset());
  dependencies.Add(this->Root->GetMethod());
  return dependencies;
}

//------------------------------------------------------------------------------
// Rendering

void vtkAdaptiveLICMapper::RenderRefined(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *this->LIC;
  if (lic.NoDataMagnitude != this->GetNoDataMagnitude())
  {
    lic.NoDataMagnitude = this->GetNoDataMagnitude();
    this->BuildTime.Modified(); // buffers are without no-data
  }
  if (lic.LocalContribution)
  {
    lic.TakePart(ren, act);
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
  if (lic.LocalContribution)
  {
    lic.LocalContribution->Screen = nullptr;
  }
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

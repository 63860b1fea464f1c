// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/RefinementPrograms.h"

#include "Checks/ShouldReport.h"
#include "Compatibility/VTKCompatibility.h"
#include "Shaders/StageShaders.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRefinementSurface.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <utility>

namespace relevo
{
namespace
{
constexpr size_t MaximumVariants = 32;

// Swap everything except the indices, which depend on the mesh and the representation.
void SwapPrograms(vtkOpenGLHelper& a, vtkOpenGLHelper& b)
{
  std::swap(a.Program, b.Program);
  std::swap(a.ShaderSourceTime, b.ShaderSourceTime);
  std::swap(a.VAO, b.VAO);
  std::swap(a.AttributeUpdateTime, b.AttributeUpdateTime);
  std::swap(a.ShaderChangeValue, b.ShaderChangeValue);
}

// The parts of a method's shaders that the user can replace.
Dependencies GetSources(vtkAdaptiveRefinement* recipe, vtkActor* actor)
{
  vtkRefinementSurface* surface = recipe->GetSurface();
  return Dependencies::On(actor->GetShaderProperty()->GetShaderMTime(),
    surface ? surface->GetShaderSource() : std::string());
}
}

RefinementPrograms::RefinementPrograms(int triangles, int vertices)
{
  this->Faces.PrimitiveType = triangles;
  this->Vertices.PrimitiveType = vertices;
}

RefinementPrograms::~RefinementPrograms() = default;

vtkOpenGLHelper* RefinementPrograms::AddFaceHelper()
{
  this->MoreFaces.emplace_back(new vtkOpenGLHelper);
  this->Helpers.push_back(this->MoreFaces.back().get());
  this->Helpers.back()->PrimitiveType = this->Faces.PrimitiveType;
  return this->Helpers.back();
}

bool RefinementPrograms::IsFaceHelper(const vtkOpenGLHelper* helper) const
{
  return std::find(this->Helpers.begin(), this->Helpers.end(), helper) != this->Helpers.end();
}

void RefinementPrograms::Swap(Variant& variant, const std::vector<vtkOpenGLHelper*>& helpersOfVTK,
  const std::function<void(std::shared_ptr<void>&)>& swap)
{
  std::vector<vtkOpenGLHelper*> helpers = this->Helpers;
  helpers.insert(helpers.end(), helpersOfVTK.begin(), helpersOfVTK.end());
  for (vtkOpenGLHelper* helper : helpers)
  {
    std::unique_ptr<vtkOpenGLHelper>& other = variant.Helpers[helper];
    if (!other)
    {
      other.reset(new vtkOpenGLHelper);
    }
    SwapPrograms(*helper, *other);
  }
  swap(variant.Info);
  std::swap(this->States, variant.States);
  std::swap(this->FailedSources, variant.FailedSources);
}

void RefinementPrograms::UseVariant(const Dependencies& key,
  const std::vector<vtkOpenGLHelper*>& helpersOfVTK,
  const std::function<void(std::shared_ptr<void>&)>& swap, vtkWindow* window)
{
  if (!this->VariantKey.IsEmpty())
  {
    this->Swap(this->Variants[this->VariantKey], helpersOfVTK, swap);
    Variant& next = this->Variants[key];
    this->Swap(next, helpersOfVTK, swap);
    next.LastUse = ++this->NumberOfUses;
  }
  this->VariantKey = key;
  if (this->Variants.size() > MaximumVariants)
  {
    this->ReleaseOldest(window);
  }
}

void RefinementPrograms::ReleaseOldest(vtkWindow* window)
{
  const auto oldest = std::min_element(this->Variants.begin(), this->Variants.end(),
    [](const auto& a, const auto& b) { return a.second.LastUse < b.second.LastUse; });
  for (auto& helper : oldest->second.Helpers)
  {
    helper.second->ReleaseGraphicsResources(window);
  }
  this->Variants.erase(oldest);
}

RefinementShaderOptions& RefinementPrograms::GetOptions(const vtkOpenGLHelper* helper)
{
  return this->States[helper].Options;
}

void RefinementPrograms::UpdateKey(const vtkOpenGLHelper* helper)
{
  State& state = this->States[helper];
  state.HasNewKey = state.Key.Update(state.Options.GetKey());
}

void RefinementPrograms::FillOptions(
  vtkAdaptiveRefinement* recipe, RefinementShaderOptions& options) const
{
  vtkRefinementSurface* surface = recipe->GetSurface();
  options.SurfaceSource = (surface ? surface : this->Linear.Get())->GetShaderSource();
  options.HasTables = surface && surface->HasTables();
  options.HasSurfaceDirections = surface && surface->HasDirections();
  vtkDisplacement* displacement = recipe->GetDisplacement();
  options.HasDisplacement = displacement != nullptr;
  options.AlongNormal = displacement && displacement->IsAlongNormal();
}

bool RefinementPrograms::CanUpdate(const vtkOpenGLHelper& helper, const Dependencies& sources)
{
  State& state = this->States[&helper];
  const bool changed = state.Sources.Update(sources);
  return !state.HasFailed || state.HasNewKey || changed;
}

StageResult RefinementPrograms::CheckUpdated(const vtkOpenGLHelper& helper)
{
  StageResult result;
  result.IsValid = helper.Program != nullptr;
  this->States[&helper].HasFailed = !result.IsValid;
  if (!result.IsValid)
  {
    result.Errors.push_back("The shaders could not be built; OpenGL's own message gives the "
                            "reason. A vtkProceduralSurface's "
                            "ShaderFunction and the actor's vtkShaderProperty are part of them.");
  }
  return result;
}

bool RefinementPrograms::NeedsBuild(vtkOpenGLHelper& helper, bool isNeededByVTK)
{
  State& state = this->States[&helper];
  const bool needed = isNeededByVTK || state.HasNewKey;
  if (needed)
  {
    // A program of other sources must not be used instead of one that failed to build.
    helper.Program = AsksLastProgram ? this->NoProgram.Get() : nullptr;
    state.Method = -1;
  }
  return needed;
}

RefinementPrograms::Built RefinementPrograms::BuildWithStages(vtkOpenGLHelper& helper, int method,
  const std::function<void(Shaders&)>& build,
  const std::function<vtkShaderProgram*(Shaders&)>& link)
{
  StageShaders stages;
  Shaders& shaders = stages.Get();
  build(shaders);
  if (this->States[&helper].DrawsNothing)
  {
    return Built::NOTHING;
  }
  vtkShaderProgram* program = link(shaders);
  if (!program)
  {
    return Built::FAILED;
  }
  helper.Program = program;
  helper.VAO->ReleaseGraphicsResources(); // it has the attributes of another program
  helper.ShaderSourceTime.Modified();
  this->States[&helper].Method = method;
  return Built::PROGRAM;
}

StageResult RefinementPrograms::Finish(
  const vtkOpenGLHelper* helper, Shaders& shaders, const MissingAnchors& missing, bool isSelecting)
{
  const std::string error = missing.empty() ? "" : DescribeMissing(missing);
  StageResult result;
  result.IsValid = error.empty();
  if (!result.IsValid)
  {
    DrawNothing(shaders);
  }
  this->States[helper].DrawsNothing = !result.IsValid;
  this->LacksIds = isSelecting && (this->LacksIds || !result.IsValid);
  if (ShouldReport(this->Error, error))
  {
    result.Errors.push_back(error);
  }
  return result;
}

void RefinementPrograms::Mark(const vtkOpenGLHelper* helper, const ShaderPurpose& purpose,
  Shaders& shaders, MissingAnchors& missing)
{
  MarkColors(this->States[helper].Options, purpose, shaders, missing);
}

void RefinementPrograms::Refine(const vtkOpenGLHelper* helper, const ShaderPurpose& purpose,
  Shaders& shaders, MissingAnchors& missing)
{
  ++this->NumberOfBuilds;
  State& state = this->States[helper];
  state.Attributes = RefineShaders(state.Options, purpose, shaders, missing);
}

const std::vector<std::string>& RefinementPrograms::GetAttributes(const vtkOpenGLHelper* helper)
{
  return this->States[helper].Attributes;
}

bool RefinementPrograms::Draws(const vtkOpenGLHelper& helper)
{
  return helper.Program && !this->States[&helper].DrawsNothing;
}

bool RefinementPrograms::TakeLackOfIds()
{
  return std::exchange(this->LacksIds, false);
}

void RefinementPrograms::SetFailedSources(vtkAdaptiveRefinement* recipe, vtkActor* actor)
{
  this->FailedSources = GetSources(recipe, actor);
}

bool RefinementPrograms::HasFailed(vtkAdaptiveRefinement* recipe, vtkActor* actor)
{
  if (!this->FailedSources.IsEmpty() && this->FailedSources != GetSources(recipe, actor))
  {
    this->FailedSources.Clear();
  }
  return !this->FailedSources.IsEmpty();
}

void RefinementPrograms::ForgetFailures()
{
  this->FailedSources.Clear();
  for (auto& variant : this->Variants)
  {
    variant.second.FailedSources.Clear();
  }
}

void RefinementPrograms::ForgetMethod(int method)
{
  const auto forget = [method](vtkOpenGLHelper& helper, State& state)
  {
    if (state.Method == method)
    {
      helper.Program = nullptr;
      state.Method = -1;
    }
  };
  for (vtkOpenGLHelper* helper : this->Helpers)
  {
    forget(*helper, this->States[helper]);
    for (auto& variant : this->Variants)
    {
      forget(*variant.second.Helpers[helper], variant.second.States[helper]);
    }
  }
}

void RefinementPrograms::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& variant : this->Variants)
  {
    for (auto& helper : variant.second.Helpers)
    {
      helper.second->ReleaseGraphicsResources(window);
    }
  }
  this->Variants.clear();
  for (vtkOpenGLHelper* helper : this->Helpers)
  {
    helper->ReleaseGraphicsResources(window);
  }
  this->States.clear();
  this->FailedSources.Clear();
  this->Error.clear();
}
}

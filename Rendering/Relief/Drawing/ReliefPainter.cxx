// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/ReliefPainter.h"

#include "OpenGL/RelevoOpenGL.h"

#include "Changes/Dependencies.h"
#include "Data/Relief.h"
#include "Data/ReliefSides.h"
#include "Drawing/ReliefRims.h"
#include "View/ReliefView.h"
#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace relevo
{
namespace
{
constexpr int VerticesOfBox = 36;
constexpr int VerticesOfPlane = 6;
// The number of layers of a translucent surface per tile.
constexpr int MaximumLayers = 4;
}

vtkStandardNewMacro(ReliefPainter);

ReliefPainter::ReliefPainter()
  : VariantPainter(ReliefShaderOptions::NUMBER_OF_METHODS)
{
}

ReliefPainter::~ReliefPainter() = default;

void ReliefPainter::SetRelief(const Relief& relief, double maximumStretch)
{
  const std::vector<unsigned char> sides = FindReliefSides(relief, maximumStretch);
  this->Tiles.Cut(relief, sides);
  this->Warped.SetRelief(relief.GetImage(), maximumStretch);
  this->Plane = this->Tiles.ToScaled(relief.GetPlane());
  this->Size = ivec2(relief.GetWidth(), relief.GetHeight());
  const vtkIdType quads = std::count_if(
    sides.begin(), sides.end(), [](unsigned char side) { return (side & Quad) != 0; });
  const vtkIdType all = static_cast<vtkIdType>(relief.GetWidth() - 1) * (relief.GetHeight() - 1);
  this->NumberOfTriangles = quads == all ? ReliefPatterns::CountTriangles(this->Tiles)
                                         : std::numeric_limits<double>::infinity();
  std::copy_n(this->Tiles.GetBounds(), 6, this->SurfaceBounds);
  this->Box->GetPoints()->SetNumberOfPoints(0);
  if (this->SurfaceBounds[0] <= this->SurfaceBounds[1])
  {
    const double* b = this->SurfaceBounds;
    this->Box->GetPoints()->InsertNextPoint(b[0], b[2], b[4]);
    this->Box->GetPoints()->InsertNextPoint(b[1], b[3], b[5]);
  }
  this->Box->GetPoints()->Modified();
  this->NeedsUpload = true;
}

std::string ReliefPainter::Prepare(vtkRenderer* renderer, vtkActor* actor, const Settings& settings)
{
  this->Current = settings;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const int largest = ReliefTextures::GetLargestSize();
  if (max(this->Size.x, this->Size.y) > largest)
  {
    return "The image has " + std::to_string(this->Size.x) + " x " + std::to_string(this->Size.y) +
      " points, but textures of this OpenGL have at most " + std::to_string(largest) + " per side.";
  }
  if (this->NeedsUpload)
  {
    this->NeedsUpload = false;
    ++this->NumberOfBufferBuilds;
    if (!this->Textures.Upload(window, this->Tiles))
    {
      return "There is not enough graphics memory for it.";
    }
  }
  if (this->Current.Search == ReliefShaderOptions::RELAXED_CONES && !this->Textures.HasCones() &&
    this->Tiles.GetNumberOfTiles() > 0)
  {
    ++this->NumberOfBufferBuilds;
    if (!this->Textures.UploadCones(window, this->Tiles))
    {
      return "There is not enough graphics memory for it.";
    }
  }
  if (this->Current.IsShadowed && !this->Textures.HasGrid() &&
    !this->Textures.UploadGrid(window, this->Tiles))
  {
    return "There is not enough graphics memory for it.";
  }
  if (this->Current.Method == ReliefShaderOptions::WARP &&
    (this->Tiles.GetNumberOfTiles() == 0 ||
      !this->MakeView(renderer, actor).SeesFront(this->Plane) ||
      !this->Warped.Update(renderer, actor, this->Tiles)))
  {
    this->Current.Method = ReliefShaderOptions::RAY_MARCH;
  }
  return "";
}

void ReliefPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Textures.ReleaseGraphicsResources(window);
  this->Patterns.ReleaseGraphicsResources(window);
  this->Warped.ReleaseGraphicsResources(window);
  this->NeedsUpload = true;
}

ReliefPainter::Counts ReliefPainter::GetCounts() const
{
  return { this->NumberOfBufferBuilds, this->Variants.GetNumberOfBuilds(),
    this->Warped.GetNumberOfWarps() };
}

void ReliefPainter::Counts::operator+=(const Counts& other)
{
  this->BufferBuilds += other.BufferBuilds;
  this->ShaderBuilds += other.ShaderBuilds;
  this->Warps += other.Warps;
}

//------------------------------------------------------------------------------
// Drawing

ReliefView ReliefPainter::MakeView(vtkRenderer* renderer, vtkActor* actor)
{
  ReliefView view(renderer, actor, this->Tiles.GetToWorld());
  for (int i = 0; i < this->GetNumberOfClippingPlanes(); ++i)
  {
    vtkPlane* plane = this->ClippingPlanes->GetItem(i);
    const double* normal = plane->GetNormal();
    const double* origin = plane->GetOrigin();
    const dvec3 n(normal[0], normal[1], normal[2]);
    view.AddClippingPlane(dvec4(n, -dot(n, dvec3(origin[0], origin[1], origin[2]))));
  }
  return view;
}

void ReliefPainter::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Textures.GetNumberOfTiles() == 0)
  {
    return;
  }
  const bool isTranslucent = actor->IsRenderingTranslucentPolygonalGeometry() != 0;
  this->NumberOfLayers = this->IsMarching() && isTranslucent ? MaximumLayers : 1;
  vtkOpenGLHelper& helper = this->GetHelper();
  const Dependencies options = Dependencies::On(this->GetOptions().GetKey());
  if (!this->UpdateProgram(helper, options, renderer, actor))
  {
    return;
  }
  helper.VAO->Bind(); // VTK releases it when the program changes
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE); // fragments compute which side they show
  if (renderer->GetSelector())
  {
    state->vtkglDepthMask(GL_TRUE); // VTK disables it for points on a surface that was drawn before
  }
  vtkOpenGLState::ScopedglEnableDisable multisample(state, GL_MULTISAMPLE);
  if (this->IsMarching())
  {
    // A pixel on the border of two tiles has one ray, but samples in both.
    state->vtkglDisable(GL_MULTISAMPLE);
  }
  this->DrawMethod(renderer, actor);
  helper.VAO->Release();
  this->Textures.Deactivate();
  this->Warped.Deactivate();
}

void ReliefPainter::DrawMethod(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (this->IsMarching())
  {
    this->DrawBoxes();
  }
  else if (this->Current.Method == ReliefShaderOptions::WARP)
  {
    glDrawArrays(GL_TRIANGLES, 0, VerticesOfPlane);
  }
  else if (this->Patterns.Select(window, this->Tiles, this->MakeView(renderer, actor)))
  {
    this->Patterns.Draw(this->GetHelper().Program);
    this->Patterns.Deactivate();
  }
}

void ReliefPainter::DrawBoxes()
{
  const bool clamped = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  glEnable(GL_DEPTH_CLAMP); // rays are clipped by near and far
  glDrawArraysInstanced(
    GL_TRIANGLES, 0, VerticesOfBox, this->Textures.GetNumberOfTiles() * this->NumberOfLayers);
  if (!clamped)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
}

void ReliefPainter::SetMapperShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  if (&helper == &this->GetHelper())
  {
    this->SetOwnUniforms(renderer, actor);
  }
}

void ReliefPainter::SetOwnUniforms(vtkRenderer* renderer, vtkActor* actor)
{
  vtkShaderProgram* program = this->GetHelper().Program;
  this->MakeView(renderer, actor).SetUniforms(program);
  if (this->Current.Method == ReliefShaderOptions::WARP)
  {
    this->Warped.Activate(program, this->Tiles);
  }
  if (this->Current.Method != ReliefShaderOptions::WARP || this->Current.IsShadowed)
  {
    this->Textures.Activate(program);
  }
  if (this->Current.IsShadowed)
  {
    this->MakeView(renderer, actor).SetLamp(program, renderer);
    const float grid[4] = { static_cast<float>(-this->Tiles.GetFirst().x),
      static_cast<float>(-this->Tiles.GetFirst().y),
      static_cast<float>(this->Tiles.GetGridSize().x),
      static_cast<float>(this->Tiles.GetGridSize().y) };
    program->SetUniform4f("reliefGrid", grid);
  }
  program->SetUniformi("reliefLayers", this->NumberOfLayers);
  vtkProperty* property = actor->GetProperty();
  const int sides[2] = { !property->GetFrontfaceCulling(),
    !property->GetBackfaceCulling() && !this->Current.IsRim };
  program->SetUniform2i("reliefSides", sides);
  // A rim has the ids of the relief that it extends.
  const ivec2 margin(this->Current.IsRim ? RimMargin : 0);
  const vec2 column(this->Tiles.GetFirst() - margin);
  const vec2 size(this->Size - 2 * margin);
  const float first[4] = { column.x, column.y, size.x, size.y };
  program->SetUniform4f("reliefFirstAndSize", first);
}

//------------------------------------------------------------------------------
// Shaders

ReliefShaderOptions ReliefPainter::GetOptions()
{
  ReliefShaderOptions options;
  options.Method = this->Current.Method;
  options.Search = this->Current.Search;
  options.IsLit = this->Current.IsLit;
  options.IsShadowed = this->Current.IsLit && this->Current.IsShadowed;
  options.Yields = this->Current.Yields;
  options.IsRim = this->Current.IsRim;
  options.HasNormals = this->Textures.HasNormals(); // the warped textures have normals if these do
  options.NumberOfPlanes = 2 + this->GetNumberOfClippingPlanes();
  switch (this->LastSelectionState)
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
    case vtkHardwareSelector::POINT_ID_HIGH24:
      options.Selected = ReliefShaderOptions::POINT_IDS;
      break;
    case vtkHardwareSelector::CELL_ID_LOW24:
    case vtkHardwareSelector::CELL_ID_HIGH24:
      options.Selected = ReliefShaderOptions::CELL_IDS;
      break;
    default:
      break;
  }
  return options;
}

bool ReliefPainter::GetNeedToRebuildShaders(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  const bool needed = this->Superclass::GetNeedToRebuildShaders(helper, renderer, actor);
  return this->Variants.NeedsBuild(helper, needed, Dependencies::On(this->GetOptions().GetKey()));
}

void ReliefPainter::PrepareShaders(ShaderVariants::Shaders& shaders, vtkActor*)
{
  PrepareReliefShaders(this->GetOptions(), shaders, this->Variants.GetMissing());
}

void ReliefPainter::FinishShaders(ShaderVariants::Shaders& shaders)
{
  FinishReliefShaders(this->GetOptions(), shaders, this->Variants.GetMissing());
}

// Otherwise the colours are shown as captured.
bool ReliefPainter::IsLit() const
{
  return this->Current.IsLit;
}

// Rays are clipped instead of fragments, so that the surface behind is visible.
void ReliefPainter::ReplaceShaderClip(
  std::map<vtkShader::Type, vtkShader*>, vtkRenderer*, vtkActor*)
{
}

//------------------------------------------------------------------------------
// Selection

void ReliefPainter::AnnounceIds(vtkHardwareSelector* selector) const
{
  const vtkIdType texels = static_cast<vtkIdType>(this->Size.x) * this->Size.y;
  selector->UpdateMaximumPointId(texels);
  selector->UpdateMaximumCellId(texels);
}

}

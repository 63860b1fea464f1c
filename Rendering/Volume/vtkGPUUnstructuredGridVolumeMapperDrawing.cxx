// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapperInternals.h"

#include "OpenGL/RelevoOpenGL.h"
#include "View/WorldView.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <vector>

namespace
{
std::vector<vtkOpenGLRenderPass*> FindPasses(vtkVolume* volume)
{
  std::vector<vtkOpenGLRenderPass*> passes;
  vtkInformation* keys = volume->GetPropertyKeys();
  const int count = keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())
    ? keys->Length(vtkOpenGLRenderPass::RenderPasses())
    : 0;
  for (int i = 0; i < count; ++i)
  {
    if (auto* pass =
          vtkOpenGLRenderPass::SafeDownCast(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i)))
    {
      passes.push_back(pass);
    }
  }
  return passes;
}

// What render passes do not replace: up to what is opaque.
constexpr const char* WholeRay = "initializeRayCast();\n"
                                 "  vec2 share = (gl_FragCoord.xy - viewportPlace.xy) / "
                                 "viewportPlace.zw;\n"
                                 "  float end = texture(opaqueDepth, share).r;\n"
                                 "  gl_FragData[0] = castRay(0.0, end);\n";
}

bool vtkGPUUnstructuredGridVolumeMapper::UpdateView(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  vtkCamera* camera = renderer->GetActiveCamera();
  const relevo::dmat4 projection = relevo::MakeMatrix(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  const relevo::dmat4 view = relevo::MakeMatrix(camera->GetViewTransformMatrix());
  return data.View.Compute(
    projection * view, relevo::MakeMatrix(volume->GetMatrix()), data.Mesh.Center, data.Mesh.Radius);
}

// What could not be built is not tried, and complained about, again.
vtkShaderProgram* vtkGPUUnstructuredGridVolumeMapper::ReadyProgram(
  const std::string& vertexSource, const std::string& source)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLShaderCache* cache = data.GetWindow()->GetShaderCache();
  const auto known = data.Programs.find(source);
  if (known != data.Programs.end())
  {
    return known->second ? cache->ReadyShaderProgram(known->second) : nullptr;
  }
  vtkShaderProgram* program = cache->ReadyShaderProgram(vertexSource.c_str(), source.c_str(), "");
  data.Programs[source] = program;
  ++data.NumberOfShaderBuilds;
  if (!program)
  {
    vtkErrorMacro("This OpenGL cannot build the shader.");
  }
  return program;
}

// Where rays enter the mesh, if all of it is in front of the eye.
bool vtkGPUUnstructuredGridVolumeMapper::RenderRayEntries(int width, int height)
{
  vtkInternals& data = *this->Internals;
  data.View.SetViewport(relevo::dvec4(0.0, 0.0, width, height));
  const bool isInFront = data.View.IsInFront(data.Mesh.HalfSize);
  const relevo::VolumeShaderOptions options = this->GetShaderOptions();
  vtkShaderProgram* program = this->ReadyProgram(
    relevo::MakeEntriesVertexShader(options), relevo::MakeEntriesShader(options));
  if (!program || !data.Entries.Begin(data.GetWindow(), width, height))
  {
    return false;
  }
  data.View.SetUniforms(program);
  data.View.SetOutlineUniforms(program);
  data.MeshBuffers.Activate(program);
  data.Entries.Draw(isInFront ? data.MeshBuffers.GetNumberOfBorderFaces() : 0);
  data.MeshBuffers.Deactivate();
  return isInFront;
}

void vtkGPUUnstructuredGridVolumeMapper::vtkInternals::ActivateTextures(vtkShaderProgram* program)
{
  this->MeshBuffers.Activate(program);
  this->FunctionBuffers.Activate(program);
  this->Surfaces.Activate(program);
  this->Integrals.Activate(program);
  this->Depth.Activate(program);
}

void vtkGPUUnstructuredGridVolumeMapper::vtkInternals::DeactivateTextures()
{
  this->Depth.Deactivate();
  this->Integrals.Deactivate();
  this->Surfaces.Deactivate();
  this->FunctionBuffers.Deactivate();
  this->MeshBuffers.Deactivate();
}

relevo::VolumeShaderOptions vtkGPUUnstructuredGridVolumeMapper::GetShaderOptions()
{
  const vtkInternals& data = *this->Internals;
  relevo::VolumeShaderOptions options = data.Options;
  options.HasTetrahedra = data.HasTetrahedra;
  options.HasCurvedCells = data.HasCurvedCells;
  options.HasQuadraticCells = data.Mesh.HasQuadraticCells;
  options.HasPyramids = data.Mesh.HasPyramids;
  options.HasFoldedFaces = data.Mesh.HasFoldedFaces;
  options.PreIntegrated = !data.IsPreIntegrated ? 0 : this->Integration == PRE_INTEGRATED ? 3 : 2;
  return options;
}

void vtkGPUUnstructuredGridVolumeMapper::Draw(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = data.GetWindow();
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  data.LayersSize = { { viewport[2], viewport[3] } };
  data.NumberOfLayers = -1;

  const std::vector<vtkOpenGLRenderPass*> passes = FindPasses(volume);
  if (passes.empty() && !data.Depth.Copy(window, viewport))
  {
    vtkErrorMacro("The depths of opaque props cannot be read.");
    return;
  }
  if (this->Method == CELL_PROJECTION && passes.empty())
  {
    this->DrawProjected(renderer, volume, viewport);
    return;
  }
  if (passes.empty() && this->FindSampledSize(volume, viewport))
  {
    this->DrawSampled(volume, viewport);
  }
  else if (this->ReadyRays(volume, viewport))
  {
    passes.empty() ? data.Screen.DrawOver(window) : data.Screen.Draw();
    data.FinishRays();
  }
}

// The ray caster for a viewport, in use, with all that it asks for; FinishRays() ends that.
vtkShaderProgram* vtkGPUUnstructuredGridVolumeMapper::ReadyRays(
  vtkVolume* volume, const int viewport[4])
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = data.GetWindow();
  const std::vector<vtkOpenGLRenderPass*> passes = FindPasses(volume);
  std::string source = relevo::MakeRayCastShader(this->GetShaderOptions());
  std::string none;
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PreReplaceShaderValues(none, none, source, this, volume);
    pass->PostReplaceShaderValues(none, none, source, this, volume);
  }
  vtkShaderProgram::Substitute(source, "//RELEVO::Main", "uniform sampler2D opaqueDepth;\n");
  vtkShaderProgram::Substitute(source, "//VTK::CallWorker::Impl", WholeRay);

  const bool areEntriesKnown = this->RenderRayEntries(viewport[2], viewport[3]);
  data.View.SetViewport(relevo::dvec4(viewport[0], viewport[1], viewport[2], viewport[3]));
  vtkShaderProgram* program = this->ReadyProgram(relevo::ScreenPass::GetVertexShader(), source);
  if (!program)
  {
    return nullptr;
  }
  data.View.SetUniforms(program);
  data.Planes.SetUniforms(program);
  data.Lights.SetUniforms(program);
  data.ActivateTextures(program);
  data.Entries.Activate(window, program);
  program->SetUniformi("areEntriesKnown", areEntriesKnown ? 1 : 0);
  if (program->IsUniformUsed("in_inverseWindowSize"))
  {
    const float inverse[2] = { 1.0f / viewport[2], 1.0f / viewport[3] };
    program->SetUniform2f("in_inverseWindowSize", inverse);
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->SetShaderParameters(program, this, volume, data.Screen.GetVertices());
  }
  return program;
}

void vtkGPUUnstructuredGridVolumeMapper::vtkInternals::FinishRays()
{
  this->Entries.Deactivate();
  this->DeactivateTextures();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/VolumePrograms.h"

#include "Passes/ScreenPass.h"
#include "View/RenderPasses.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

namespace relevo
{
namespace
{
// This code applies if no render pass replaces it: rays end at the opaque depth.
constexpr const char* WholeRay = "initializeRayCast();\n"
                                 "  vec2 share = (gl_FragCoord.xy - viewportRectangle.xy) / "
                                 "viewportRectangle.zw;\n"
                                 "  float end = texture(opaqueDepth, share).r;\n"
                                 "  gl_FragData[0] = castRay(0.0, end);\n";
constexpr const char* AllSegments = "initializeRayCast();\n"
                                    "  vec2 share = (gl_FragCoord.xy - viewportRectangle.xy) / "
                                    "viewportRectangle.zw;\n"
                                    "  vec2 range = texture(opaqueDepth, share).rg;\n"
                                    "  castSegments(hasBegins ? range.g : 0.0, range.r);\n"
                                    "  outputSegments();\n";

Dependencies MakeKey(VolumeShader shader, const VolumeShaderOptions& options)
{
  return Dependencies::On(shader, options.Blending, options.NumberOfComponents,
    options.NumberOfCurves, options.AreDependent, options.HasCellScalars, options.FirstComponent,
    options.HasTables, options.HasGradientOpacity, options.HasSurfaces, options.IsClipped,
    options.NumberOfMaterials, options.FirstMaterial, options.NumberOfLights, options.PreIntegrated,
    options.HasTetrahedra, options.HasCurvedCells, options.HasQuadraticCells, options.HasPyramids,
    options.HasFoldedFaces, options.IsDiscontinuous, options.HasCornerScalars,
    options.HasHangingFaces, options.HasActiveCells, options.HasVisibleCells, options.IsCutByNear,
    options.Segments);
}

std::string FinishRayShader(std::string source, const char* main)
{
  vtkShaderProgram::Substitute(
    source, "//RELEVO::Main", "uniform sampler2D opaqueDepth;\nuniform bool hasBegins;\n");
  vtkShaderProgram::Substitute(source, "//VTK::CallWorker::Impl", main);
  return source;
}

std::pair<std::string, std::string> Compose(VolumeShader shader, const VolumeShaderOptions& options)
{
  const char* screen = ScreenPass::GetVertexShader();
  switch (shader)
  {
    case VolumeShader::Entries:
      return { MakeEntriesVertexShader(options), MakeEntriesShader(options) };
    case VolumeShader::EntryCounts:
      return { screen, MakeCountShader(options) };
    case VolumeShader::Ranges:
      return { screen, MakeRangesShader(options) };
    case VolumeShader::Active:
      return { screen, MakeActiveShader(options) };
    case VolumeShader::Outlines:
      return { screen, MakeOutlinesShader(options) };
    case VolumeShader::FirstVisible:
      return { MakeVisibleVertexShader(options), MakeFirstShader(options) };
    case VolumeShader::LastVisible:
      return { MakeVisibleVertexShader(options), MakeLastShader() };
    case VolumeShader::Nearest:
      return { MakeNearestVertexShader(options), MakeNearestShader(options) };
    case VolumeShader::Rays:
      return { screen, FinishRayShader(MakeRayCastShader(options), WholeRay) };
    case VolumeShader::RayLimits:
      return { screen, MakeLimitsShader(options) };
    case VolumeShader::Projection:
      return { MakeProjectionVertexShader(options), MakeProjectionShader(options) };
    case VolumeShader::Finish:
      return { screen, MakeFinishShader(options) };
    default:
      return { screen, MakeProjectedShader() };
  }
}

vtkShaderProgram* Use(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  return program ? window->GetShaderCache()->ReadyShaderProgram(program) : nullptr;
}
}

vtkShaderProgram* VolumePrograms::Build(vtkOpenGLRenderWindow* window, const Sources& sources)
{
  const auto known = this->Built.find(sources);
  if (known != this->Built.end())
  {
    return Use(window, known->second);
  }
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(sources.first.c_str(), sources.second.c_str(), "");
  this->Built[sources] = program;
  ++this->NumberOfBuilds;
  return program;
}

vtkShaderProgram* VolumePrograms::Ready(
  vtkOpenGLRenderWindow* window, VolumeShader shader, const VolumeShaderOptions& wanted)
{
  VolumeShaderOptions options = wanted;
  options.Segments = SegmentOutput::None;
  const Dependencies key = MakeKey(shader, options);
  const auto known = this->Programs.find(key);
  if (known != this->Programs.end())
  {
    return Use(window, known->second);
  }
  vtkShaderProgram* program = this->Build(window, Compose(shader, options));
  this->Programs[key] = program;
  return program;
}

vtkShaderProgram* VolumePrograms::ReadyRays(
  vtkOpenGLRenderWindow* window, const VolumeShaderOptions& options, const RenderPasses& passes)
{
  if (passes.IsEmpty() && options.Segments == SegmentOutput::None)
  {
    return this->Ready(window, VolumeShader::Rays, options);
  }
  std::string& composed = this->RayShaders[MakeKey(VolumeShader::Rays, options)];
  if (composed.empty())
  {
    composed = MakeRayCastShader(options);
  }
  std::string source = composed;
  passes.ReplaceShaderValues(source);
  const char* main = options.Segments == SegmentOutput::None ? WholeRay : AllSegments;
  return this->Build(window, { ScreenPass::GetVertexShader(), FinishRayShader(source, main) });
}

void VolumePrograms::ReleaseGraphicsResources()
{
  this->Programs.clear();
  this->Built.clear();
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/ReliefShader.h"

#include "Buffers/ReliefCones.h"
#include "Buffers/ReliefTiles.h"
#include "relevoReliefBox.h"
#include "relevoReliefCones.h"
#include "relevoReliefFS.h"
#include "relevoReliefHits.h"
#include "relevoReliefLinear.h"
#include "relevoReliefMarch.h"
#include "relevoReliefMaterial.h"
#include "relevoReliefPatternFS.h"
#include "relevoReliefPatternTrace.h"
#include "relevoReliefPatternVS.h"
#include "relevoReliefRay.h"
#include "relevoReliefRefine.h"
#include "relevoReliefShadow.h"
#include "relevoReliefSteps.h"
#include "relevoReliefSurface.h"
#include "relevoReliefTrace.h"
#include "relevoReliefVS.h"
#include "relevoReliefWarpFS.h"
#include "relevoReliefWarpTrace.h"
#include "relevoReliefWarpVS.h"

#include <sstream>

namespace relevo
{
namespace
{
std::string GetDefines(const ReliefShaderOptions& options)
{
  std::ostringstream text;
  text << "// Relevo: vtkReliefMapper\n#extension GL_ARB_texture_gather : enable\n";
  text << "#define RELIEF_SIZE " << ReliefTiles::Size << "\n#define RELIEF_TEXELS "
       << ReliefTiles::Texels << "\n#define RELIEF_CELL " << ReliefTiles::CellSize
       << "\n#define RELIEF_CONE_RADIUS " << ConeRadius << "\n";
  if (options.Search == ReliefShaderOptions::LINEAR_SECANT)
  {
    text << "#define RELIEF_SECANT\n#define RELIEF_REFINEMENTS 4\n";
  }
  else
  {
    text << "#define RELIEF_REFINEMENTS 7\n";
  }
  if (options.Yields)
  {
    text << "#define RELIEF_YIELDS\n";
  }
  if (options.IsRim)
  {
    text << "#define RELIEF_RIM\n";
  }
  if (options.IsLit && options.HasNormals)
  {
    text << "#define RELIEF_NORMALS\n";
  }
  return text.str();
}

// Each plane has its own uniform, because Mesa copies arrays of uniforms if an index is not
// constant.
std::string GetPlanes(const ReliefShaderOptions& options)
{
  std::ostringstream uniforms;
  std::ostringstream cuts;
  for (int i = 0; i < options.NumberOfPlanes; ++i)
  {
    uniforms << "uniform vec4 reliefPlane" << i << ";\n";
    cuts << "  reliefCut(reliefPlane" << i << ");\n";
  }
  return uniforms.str() + "void reliefCutPlanes()\n{\n" + cuts.str() + "}\n";
}

// Return the code that traces a ray through a tile.
std::string GetWalk(const ReliefShaderOptions& options)
{
  std::string text = std::string(relevoReliefBox) + relevoReliefHits;
  if (options.Search == ReliefShaderOptions::MAXIMUM_MIPMAP)
  {
    return text + relevoReliefMarch;
  }
  text += std::string(relevoReliefRefine) + relevoReliefLinear;
  return text +
    (options.Search == ReliefShaderOptions::RELAXED_CONES ? relevoReliefCones : relevoReliefSteps);
}

// Return the fragment functions reliefFind() and, with shadows, reliefLight().
std::string GetSearch(const ReliefShaderOptions& options)
{
  const bool isMarching = options.Method == ReliefShaderOptions::RAY_MARCH;
  std::string text;
  if (options.Method != ReliefShaderOptions::WARP || options.IsShadowed)
  {
    text += relevoReliefSurface;
  }
  if (isMarching || options.IsShadowed)
  {
    text += GetWalk(options);
  }
  if (options.Method == ReliefShaderOptions::WARP)
  {
    text += relevoReliefWarpFS + GetPlanes(options) + relevoReliefWarpTrace;
  }
  else if (isMarching)
  {
    text += relevoReliefMaterial;
    text += relevoReliefRay + GetPlanes(options) + relevoReliefTrace;
  }
  else
  {
    text += relevoReliefMaterial;
    text += relevoReliefPatternFS + GetPlanes(options) + relevoReliefPatternTrace;
  }
  if (options.IsShadowed)
  {
    text += relevoReliefShadow;
  }
  return text;
}

std::string GetIds(const ReliefShaderOptions& options)
{
  return options.Selected == ReliefShaderOptions::POINT_IDS ? "reliefPointId()" : "reliefCellId()";
}
}

std::string ReliefShaderOptions::GetKey() const
{
  std::ostringstream key;
  key << this->Method << this->Search << this->IsLit << this->IsShadowed << this->Yields
      << this->IsRim << this->HasNormals << this->NumberOfPlanes << this->Selected;
  return key.str();
}

void PrepareReliefShaders(const ReliefShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  ShaderText vertex(shaders[vtkShader::Vertex], missing);
  vertex.Replace("//VTK::PositionVC::Dec", "");
  vertex.Replace("//VTK::PositionVC::Impl",
    options.Method == ReliefShaderOptions::WARP ? "gl_Position = reliefPlanePosition();"
      : options.Method == ReliefShaderOptions::RAY_MARCH
      ? "gl_Position = reliefBoxPosition();"
      : "gl_Position = reliefPatternPosition();");

  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  fragment.Replace("//VTK::PositionVC::Dec", "");
  fragment.Replace(
    "//VTK::PositionVC::Impl", "if (!reliefFind()) discard;\n  vec4 vertexVC = reliefVertex();");
  if (options.Yields || options.Method != ReliefShaderOptions::REFINEMENT)
  {
    // For the other methods, VTK's depth with a coincident offset needs these declarations.
    fragment.IfReplace("//VTK::UniformFlow::Impl", "");
    fragment.Replace("//VTK::Depth::Impl", "gl_FragDepth = reliefDepth();");
  }
  fragment.Replace("//VTK::Normal::Impl", "vec3 normalVCVSOutput = reliefNormal();");
  const std::string color = options.IsLit
    ? "  ambientColor = ambientIntensity * relief.rgb;\n"
      "  diffuseColor = diffuseIntensity * relief.rgb;\n"
    : "  ambientColor = vec3(0.0);\n  diffuseColor = relief.rgb;\n";
  fragment.InsertAfter("//VTK::Color::Impl",
    "\n  vec4 relief = reliefColor();\n" + color + "  opacity = opacityUniform * relief.a;\n");
  fragment.IfReplace("//VTK::Clip::Dec", "");
  fragment.IfReplace("//VTK::Clip::Impl", "");
}

void FinishReliefShaders(const ReliefShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  ShaderText vertex(shaders[vtkShader::Vertex], missing);
  vertex.InsertBeforeMain(options.Method == ReliefShaderOptions::WARP ? relevoReliefWarpVS
      : options.Method == ReliefShaderOptions::RAY_MARCH              ? relevoReliefVS
                                                                      : relevoReliefPatternVS);
  vertex.InsertAfterVersion(GetDefines(options));
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  fragment.IfReplace("gl_FrontFacing", "reliefIsFront");
  std::string shadow;
  if (options.IsShadowed && fragment.Has("lightColor0"))
  {
    // The first light is VTK's, multiplied by the shadow.
    fragment.Replace("lightColor0", "reliefLightColor");
    fragment.Replace("uniform vec3 reliefLightColor;", "uniform vec3 lightColor0;");
    fragment.Replace(
      "vec4 vertexVC =", "reliefLightColor = lightColor0 * reliefLight();\n  vec4 vertexVC =");
    shadow = "vec3 reliefLightColor;\n";
  }
  if (options.Selected == ReliefShaderOptions::CELL_IDS)
  {
    fragment.Replace("gl_PrimitiveID + PrimitiveIDOffset", GetIds(options));
  }
  else if (options.Selected == ReliefShaderOptions::POINT_IDS)
  {
    fragment.Replace("= vertexIDVSOutput", "= " + GetIds(options));
  }
  fragment.InsertBeforeMain(relevoReliefFS + GetSearch(options) + shadow);
  fragment.InsertAfterVersion(GetDefines(options));
}
}

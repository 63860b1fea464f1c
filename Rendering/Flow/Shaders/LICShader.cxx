// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/LICShader.h"

#include "Shaders/ShaderExtension.h"
#include "relevoLICApplyFS.h"
#include "relevoLICColor.h"
#include "relevoLICStretch.h"
#include "relevoLICVectorsFS.h"
#include "relevoLICVectorsVS.h"

#include <string>

namespace relevo
{
namespace
{
constexpr const char* ColoredFragment = "//VTK::DepthPeeling::Impl"; // the fragment has its colour

void ExtendVectorShaders(const LICShaderOptions& options, ShaderExtension& extension)
{
  extension.Varyings = { { "", "vec4", "relevoLICField" },
    { "", "vec3", options.HasNormals ? "relevoLICNormal" : "relevoLICPosition" } };
  extension.Declarations = std::string(relevoLICVectorsVS) +
    (options.AreOfCells ? "uniform samplerBuffer relevoLICCells;\n" : "");
  extension.Key = options.StretchesColors ? "vectors and colours" : "vectors";
  extension.Statements = std::string("  relevoLICFieldVSOutput = ") +
    (options.AreOfCells ? "texelFetch(relevoLICCells, relevoFace.w >> 3)" : "relevoLICVector") +
    ";\n"
    "#ifndef RELEVO_NORMALS\n" +
    (options.HasPointNormals ? "  relevoNormal = unitVector(relevoLICPointNormal);\n" : "") +
    "#endif\n" +
    (options.HasNormals ? "  relevoLICNormalVSOutput = relevoLICNormals * relevoNormal;\n"
                        : "  relevoLICPositionVSOutput = (relevoLICFromVertex * vertexMC).xyz;\n");
}

std::string GetFragmentFunctions(const LICShaderOptions& options)
{
  return options.Purpose == LICShaderOptions::VECTORS
    ? std::string(options.HasNormals ? "#define RELEVO_LIC_NORMALS\n" : "") + relevoLICVectorsFS
    : std::string(options.StretchesColors ? "#define RELEVO_LIC_STRETCH\n" : "") +
      relevoLICStretch + relevoLICColor + relevoLICApplyFS;
}
}

void ExtendLICShaders(const LICShaderOptions& options, ShaderExtension& extension)
{
  if (options.Purpose == LICShaderOptions::VECTORS)
  {
    ExtendVectorShaders(options, extension);
  }
  else if (options.Purpose == LICShaderOptions::IMAGE)
  {
    extension.Key = options.StretchesColors ? "LIC, stretched" : "LIC";
  }
}

void PrepareLICShaders(const LICShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  if (options.Purpose == LICShaderOptions::VECTORS)
  {
    ShaderText vertex(shaders[vtkShader::Vertex], missing);
    vertex.InsertBefore("//VTK::TCoord::Dec",
      std::string(options.AreOfCells ? "" : "in vec4 relevoLICVector;\n") +
        (options.HasPointNormals ? "in vec3 relevoLICPointNormal;\n" : ""));
    ShaderText fragment(shaders[vtkShader::Fragment], missing);
    fragment.InsertBefore(ColoredFragment,
      std::string(options.StretchesColors ? "vec3 relevoColor = gl_FragData[0].rgb;\n  " : "") +
        "gl_FragData[0] = relevoLICVector();\n  " +
        (options.StretchesColors ? "gl_FragData[1] = vec4(relevoColor, gl_FragData[0].w);\n  "
                                 : ""));
  }
  else if (options.Purpose == LICShaderOptions::IMAGE)
  {
    ShaderText fragment(shaders[vtkShader::Fragment], missing);
    fragment.InsertBefore(
      ColoredFragment, "gl_FragData[0].rgb = RELEVO_LIC(gl_FragData[0].rgb);\n  ");
  }
}

void FinishLICShaders(const LICShaderOptions& options, bool needsEdges,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  if (options.Purpose == LICShaderOptions::NONE)
  {
    return;
  }
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  // VTK has blended visible edges into the colour before.
  const std::string edges = "float emix";
  if (!fragment.Has(edges) && needsEdges)
  {
    fragment.Miss(edges);
  }
  fragment.InsertBeforeMain(GetFragmentFunctions(options) + // after the varyings
    (fragment.Has(edges) ? "#define RELEVO_LIC(color) mix(relevoLICFragment(color), color, emix)\n"
                         : "#define RELEVO_LIC(color) relevoLICFragment(color)\n"));
}
}

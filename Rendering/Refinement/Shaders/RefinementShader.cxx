// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/RefinementShader.h"

#include "relevoColorTable.h"
#include "relevoColorsVS.h"
#include "relevoDisplacedNormal.h"
#include "relevoDisplacement.h"
#include "relevoDisplacementVS.h"
#include "relevoEdgesGS.h"
#include "relevoFaceColorsFS.h"
#include "relevoFaceColorsVS.h"
#include "relevoFaceVS.h"
#include "relevoHeight.h"
#include "relevoHeightMap.h"
#include "relevoMorph.h"
#include "relevoNoDataVS.h"
#include "relevoRefineVS.h"
#include "relevoWeights.h"

#include "Core/VTKCompatibility.h"
#include "vtkShaderProgram.h"

#include <regex>
#include <sstream>

namespace relevo
{
namespace
{
// Where colours of faces replace VTK's own, in the fragment shader.
constexpr const char* ColorMark = "//Relevo::Color::Impl";

// Put text before the first main().
void InsertBeforeMain(std::string& source, const std::string& text)
{
  const size_t main = source.find("void main(");
  if (main != std::string::npos)
  {
    source.insert(main, text);
  }
}

// Put text right after the directive that becomes #version.
void InsertAfterVersion(std::string& source, const std::string& text)
{
  vtkShaderProgram::Substitute(source, "//VTK::System::Dec", "//VTK::System::Dec\n" + text, false);
}

// What scalars make of an attribute; coarse points keep what VTK gave them.
std::string GetScalarStatement(
  ScalarKind kind, const std::string& attribute, const std::string& sampler)
{
  if (kind == BY_VALUE && attribute == "scalarColor")
  {
    return "  if (!relevoIsCorner(w)) { scalarColor = relevoScalarColor(w); }\n";
  }
  if (kind == BY_NEAREST && attribute == "scalarColor")
  {
    return "  scalarColor = texelFetch(" + sampler + ", relevoFace[relevoNearestCorner(w)]);\n";
  }
  if (kind == BY_TEXTURE && attribute == ColorCoordinates)
  {
    return "  if (!relevoIsCorner(w)) { " + attribute + " = relevoScalarCoordinate(w); }\n";
  }
  return {};
}

std::string GetDefines(const RefinementShaderOptions& options, bool edges, bool lines)
{
  std::ostringstream text;
  text << "#extension GL_ARB_gpu_shader5 : enable\n"
          "#ifndef GL_ARB_gpu_shader5\n"
          "#define precise\n"
          "#endif\n"
          "#define RELEVO_FUNCTION\n"
          "#define RELEVO_UNUSED\n"
       << "#define RELEVO_POINT_STRIDE " << options.PointStride << "\n"
       << "#define RELEVO_POINT_DIRECTION " << options.PointDirection << "\n"
       << "#define RELEVO_POINT_VALUES " << options.PointValues << "\n"
       << "#define RELEVO_VECTORS_PER_EDGE " << options.VectorsPerEdge << "\n"
       << "#define RELEVO_VECTORS_PER_FACE " << options.VectorsPerFace << "\n";
  auto define = [&text](bool condition, const char* name)
  {
    if (condition)
    {
      text << "#define " << name << "\n";
    }
  };
  define(options.HasNormals, "RELEVO_NORMALS");
  define(options.HasDisplacement, "RELEVO_DISPLACEMENT");
  define(options.AlongNormal, "RELEVO_ALONG_NORMAL");
  define(options.HasDirections, "RELEVO_DIRECTIONS");
  define(options.HasSeams, "RELEVO_SEAMS");
  define(options.HasHoles, "RELEVO_HOLES");
  define(options.IsMorphing, "RELEVO_MORPH");
  define(options.IsIndirect, "RELEVO_INDIRECT");
  define(options.HasNoData, "RELEVO_NO_DATA");
  define(options.Scalars == BY_VALUE, "RELEVO_SCALARS");
  define(options.Scalars == BY_TEXTURE, "RELEVO_SCALAR_COORDINATES");
  define(options.Scalars == BY_NEAREST, "RELEVO_NEAREST_SCALARS");
  define(options.ColorMode == COLOR_BY_LEVEL || options.ColorMode == COLOR_BY_PATTERN,
    "RELEVO_COLORS_OF_FACES");
  define(options.ColorMode == COLOR_BY_METRIC, "RELEVO_COLORS_OF_TAGS");
  define(edges, "RELEVO_EDGES");
  define(lines, "RELEVO_LINES");
  return text.str();
}
}

std::string RefinementShaderOptions::GetKey() const
{
  return GetDefines(*this, false, false) + this->PlacementSource + this->SurfaceSource +
    this->Extension.Declarations + this->Extension.Statements;
}

void MarkColors(std::map<vtkShader::Type, vtkShader*>& shaders)
{
  std::string fragment = shaders[vtkShader::Fragment]->GetSource();
  vtkShaderProgram::Substitute(
    fragment, "//VTK::Color::Impl", std::string("//VTK::Color::Impl\n  ") + ColorMark, false);
  shaders[vtkShader::Fragment]->SetSource(fragment);
}

std::string GetAttributeSampler(const std::string& attribute)
{
  return "relevo_" + attribute;
}

std::vector<std::string> RefineShaders(const RefinementShaderOptions& options, bool lines,
  std::map<vtkShader::Type, vtkShader*>& shaders)
{
  std::string vertex = shaders[vtkShader::Vertex]->GetSource();
  std::string geometry = shaders[vtkShader::Geometry]->GetSource();
  std::string fragment = shaders[vtkShader::Fragment]->GetSource();
  const bool edges = geometry.find("//VTK::Edges::Impl") != std::string::npos;

  // Attributes become globals.
  std::vector<std::string> attributes;
  std::ostringstream samplers;
  std::ostringstream fetches;
  bool takesNormal = false;
  const std::regex declaration("(^|\\n)[ \\t]*(in|attribute) (float|vec2|vec3|vec4) (\\w+);");
  std::string rest = vertex;
  vertex.clear();
  std::smatch match;
  while (std::regex_search(rest, match, declaration))
  {
    const std::string type = match[3];
    const std::string name = match[4];
    vertex += match.prefix().str() + match[1].str() + type + " " + name + ";";
    if (name == "normalMC" && options.HasNormals)
    {
      takesNormal = true;
    }
    else if (name != "vertexMC")
    {
      attributes.push_back(name);
      const std::string sampler = GetAttributeSampler(name);
      const std::string components =
        type == "float" ? ".x" : (type == "vec2" ? ".xy" : (type == "vec3" ? ".xyz" : ""));
      samplers << "uniform samplerBuffer " << sampler << ";\n";
      fetches << "  " << name << " = weightedSum(texelFetch(" << sampler
              << ", relevoFace.x), texelFetch(" << sampler << ", relevoFace.y), texelFetch("
              << sampler << ", relevoFace.z), w)" << components << ";\n"
              << GetScalarStatement(options.Scalars, name, sampler);
      if (name == "normalMC")
      {
        // Unit normals, as the filter's, unless the mesh is drawn as it is.
        samplers << "uniform int relevoUnitNormals;\n";
        fetches << "  if (relevoUnitNormals == 1) { normalMC = unitVector(weightedSum("
                << "unitVector(texelFetch(" << sampler << ", relevoFace.x).xyz), "
                << "unitVector(texelFetch(" << sampler << ", relevoFace.y).xyz), "
                << "unitVector(texelFetch(" << sampler << ", relevoFace.z).xyz), w)); }\n";
      }
    }
    rest = match.suffix();
  }
  vertex += rest;

  std::vector<ShaderVarying> varyings = options.Extension.Varyings;
  varyings.push_back({ "flat ", "int", "relevoPrimitiveID" });
  if (edges)
  {
    varyings.push_back({ "", "vec3", "relevoWeights" });
    varyings.push_back({ "flat ", "int", "relevoHiddenEdges" });
  }
  if (options.ColorMode == COLOR_BY_METRIC)
  {
    varyings.push_back({ "flat ", "vec3", "relevoTags" });
    varyings.push_back({ "", "vec3", "relevoTagWeights" });
  }
  else if (options.ColorMode != COLOR_BY_SCALARS)
  {
    varyings.push_back({ "flat ", "vec3", "relevoColor" });
  }
  if (options.HasHoles)
  {
    varyings.push_back({ "", "float", "relevoValid" });
    varyings.push_back({ "", "vec2", "relevoHeightCoordinate" });
  }

  // The vertex shader.
  std::ostringstream text;
  text << relevoWeights << relevoDisplacedNormal << (options.IsMorphing ? relevoMorph : "")
       << relevoFaceVS << options.PlacementSource << options.SurfaceSource;
  if (options.HasDisplacement)
  {
    text << relevoHeightMap << relevoHeight << relevoDisplacementVS << relevoDisplacement;
  }
  if (options.Scalars != BY_VTK)
  {
    text << (options.Scalars == BY_VALUE ? relevoColorTable : "")
         << (options.HasNoData ? relevoNoDataVS : "") << relevoColorsVS;
  }
  if (options.ColorMode != COLOR_BY_SCALARS)
  {
    text << relevoFaceColorsVS;
  }
  for (const ShaderVarying& varying : varyings)
  {
    text << varying.Qualifier << "out " << varying.Type << " " << varying.Name << "VSOutput;\n";
  }
  text << "int relevoPointId;\nvec3 relevoNormal = vec3(0.0);\n"
       << samplers.str() << "void relevoSetNormal(vec3 normal)\n{\n"
       << (takesNormal ? "  normalMC = normal;\n" : "") << "}\n"
       << "void relevoSetAttributes(vec3 w)\n{\n"
       << fetches.str() << "}\n"
       << options.Extension.Declarations
       << "void relevoExtend();\n" // after what it reads is set: compilers warn by the text
       << relevoRefineVS << "void relevoExtend()\n{\n"
       << options.Extension.Statements << "}\n";
  InsertBeforeMain(vertex, text.str());
  InsertAfterVersion(vertex, GetDefines(options, edges, lines));
  vertex = std::regex_replace(
    vertex, std::regex("void main\\(\\)\\s*\\{"), "void main()\n{\n  relevoRefine();\n");
  vertex.insert(
    vertex.rfind('}'), "\n  if (relevoHidden) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); }\n");
  vtkShaderProgram::Substitute(vertex, "gl_VertexID", "relevoPointId");

  // The geometry shader hands on what the fragments need.
  if (!geometry.empty())
  {
    std::ostringstream declarations;
    std::ostringstream copies;
    for (const ShaderVarying& varying : varyings)
    {
      const std::string& name = varying.Name;
      declarations << varying.Qualifier << "in " << varying.Type << " " << name << "VSOutput[];\n"
                   << varying.Qualifier << "out " << varying.Type << " " << name << "GSOutput;\n";
      copies << name << "GSOutput = " << name << "VSOutput[i];\n    ";
    }
    if (edges)
    {
      declarations << relevoEdgesGS;
      vtkShaderProgram::Substitute(geometry, "//VTK::Edges::Impl",
        "if (relevoIsHiddenSide(2, 0)) edgeEqn[2].z = lineWidth;\n"
        "  if (relevoIsHiddenSide(1, 2)) edgeEqn[1].z = lineWidth;\n"
        "  if (relevoIsHiddenSide(0, 1)) edgeEqn[0].z = lineWidth;\n");
    }
    InsertBeforeMain(geometry, declarations.str());
    vtkShaderProgram::Substitute(geometry, "EmitVertex();", copies.str() + "EmitVertex();");
  }

  // The fragment shader knows coarse primitives and colours of faces, and leaves holes.
  std::string declarations;
  for (const ShaderVarying& varying : varyings)
  {
    declarations += varying.Qualifier + "in " + varying.Type + " " + varying.Name + "VSOutput;\n";
  }
  if (options.ColorMode != COLOR_BY_SCALARS)
  {
    declarations += std::string(relevoColorTable) + relevoFaceColorsFS;
    vtkShaderProgram::Substitute(fragment, ColorMark,
      "vec3 relevoFragment = relevoFragmentColor();\n"
      "  ambientColor = ambientIntensity * relevoFragment;\n"
      "  diffuseColor = diffuseIntensity * relevoFragment;\n"
      "  opacity = opacityUniform;\n");
  }
  InsertAfterVersion(fragment, GetDefines(options, false, false));
  if (options.HasHoles)
  {
    declarations += std::string(relevoHeightMap) + relevoHeight;
    fragment = std::regex_replace(fragment, std::regex("void main\\(\\)\\s*\\{"),
      "void main()\n{\n"
      "  if (relevoValidVSOutput < 0.999 || !heightValid(relevoHeightCoordinateVSOutput)) "
      "discard;\n");
  }
  InsertBeforeMain(fragment, declarations);
  vtkShaderProgram::Substitute(
    fragment, "gl_PrimitiveID + PrimitiveIDOffset", "relevoPrimitiveIDVSOutput");

  shaders[vtkShader::Vertex]->SetSource(vertex);
  shaders[vtkShader::Geometry]->SetSource(geometry);
  shaders[vtkShader::Fragment]->SetSource(fragment);
  return attributes;
}
}

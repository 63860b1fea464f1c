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
#include "relevoFieldFS.h"
#include "relevoHeight.h"
#include "relevoHeightMap.h"
#include "relevoMorph.h"
#include "relevoNoDataVS.h"
#include "relevoRefineVS.h"
#include "relevoScalars.h"
#include "relevoWeights.h"

#include "Compatibility/VTKCompatibility.h"
#include "Shaders/ShaderVaryings.h"

#include <regex>
#include <sstream>

namespace relevo
{
namespace
{
// The anchor in the fragment shader at which colours of faces replace VTK's.
constexpr const char* ColorMark = "//Relevo::Color::Impl";
// The anchor in the geometry shader at which VTK selects the visible edges.
constexpr const char* EdgeMark = "//VTK::Edges::Impl";

// Return the statement that computes an attribute from scalars; coarse points keep VTK's values.
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
  text << GetPreciseExtension()
       << "#define RELEVO_FUNCTION\n"
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
  define(options.HasSurfaceDirections, "RELEVO_SURFACE_DIRECTIONS");
  define(options.HasTables, "RELEVO_TABLES");
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
  define(options.Field == FieldColoring::COLORS, "RELEVO_FIELD_COLORS");
  define(options.Field == FieldColoring::TEXTURE, "RELEVO_FIELD_TEXTURE");
  define(options.Field == FieldColoring::TABLE, "RELEVO_FIELD_TABLE");
  define(edges, "RELEVO_EDGES");
  define(lines, "RELEVO_LINES");
  return text.str();
}

// Attributes that are replaced by globals.
struct TakenAttributes
{
  std::vector<std::string> Names;
  std::string Samplers;   // declarations of the samplers that replace the attributes
  std::string Fetches;    // statements that read them
  bool HasNormal = false; // the refined surface sets it
};

std::string GetFetch(
  const RefinementShaderOptions& options, const std::string& type, const std::string& name)
{
  const std::string sampler = GetAttributeSampler(name);
  const std::string components =
    type == "float" ? ".x" : (type == "vec2" ? ".xy" : (type == "vec3" ? ".xyz" : ""));
  std::ostringstream text;
  text << "  " << name << " = weightedSum(texelFetch(" << sampler << ", relevoFace.x), texelFetch("
       << sampler << ", relevoFace.y), texelFetch(" << sampler << ", relevoFace.z), w)"
       << components << ";\n"
       << GetScalarStatement(options.Scalars, name, sampler);
  if (name == "normalMC")
  {
    // Normals are normalized like the filter's, unless the mesh is drawn unrefined.
    text << "  if (relevoUnitNormals == 1) { normalMC = unitVector(weightedSum("
         << "unitVector(texelFetch(" << sampler << ", relevoFace.x).xyz), "
         << "unitVector(texelFetch(" << sampler << ", relevoFace.y).xyz), "
         << "unitVector(texelFetch(" << sampler << ", relevoFace.z).xyz), w)); }\n";
  }
  return text.str();
}

// Replace the attributes that VTK declares by globals.
TakenAttributes TakeAttributes(const RefinementShaderOptions& options, ShaderText& vertex)
{
  TakenAttributes taken;
  bool hasPosition = false;
  const std::regex declaration("(^|\\n)[ \\t]*(in|attribute) (float|vec2|vec3|vec4) (\\w+);");
  std::string text;
  std::string rest = vertex.Get();
  std::smatch match;
  while (std::regex_search(rest, match, declaration))
  {
    const std::string type = match[3];
    const std::string name = match[4];
    text += match.prefix().str() + match[1].str() + type + " " + name + ";";
    if (name == "vertexMC")
    {
      hasPosition = true;
    }
    else if (name == "normalMC" && options.HasNormals)
    {
      taken.HasNormal = true;
    }
    else
    {
      taken.Names.push_back(name);
      taken.Samplers += "uniform samplerBuffer " + GetAttributeSampler(name) + ";\n";
      taken.Samplers += name == "normalMC" ? "uniform int relevoUnitNormals;\n" : "";
      taken.Fetches += GetFetch(options, type, name);
    }
    rest = match.suffix();
  }
  text += rest;
  vertex.Set(text);
  if (!hasPosition)
  {
    vertex.Miss("in vec4 vertexMC;");
  }
  // An attribute with another declaration would be read per vertex.
  const std::regex other("(^|\\n)[ \\t]*((layout *\\([^)\\n]*\\)|\\w+)[ \\t]+)*(in|attribute)[ \\t]"
                         "[^;()\\n]*;");
  if (hasPosition && std::regex_search(text, other))
  {
    vertex.Miss("in TYPE NAME;");
  }
  return taken;
}

std::vector<ShaderVarying> GetVaryings(const RefinementShaderOptions& options, bool edges)
{
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
  if (options.Field != FieldColoring::NONE)
  {
    varyings.push_back({ "flat ", "ivec2", "relevoField" });
    varyings.push_back({ "", "vec3", "relevoFieldWeights" });
  }
  if (options.HasHoles)
  {
    varyings.push_back({ "", "float", "relevoValid" });
    varyings.push_back({ "", "vec2", "relevoHeightCoordinate" });
  }
  return varyings;
}

// Return all functions that relevoRefine() needs, and relevoRefine() itself.
std::string GetVertexFunctions(const RefinementShaderOptions& options,
  const std::vector<ShaderVarying>& varyings, const TakenAttributes& attributes)
{
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
         << (options.HasNoData ? relevoNoDataVS : "") << relevoScalars << relevoColorsVS;
  }
  if (options.ColorMode != COLOR_BY_SCALARS)
  {
    text << relevoFaceColorsVS;
  }
  text << DeclareVaryings("out", varyings)
       << "int relevoPointId;\nvec3 relevoVertexWeights;\nvec3 relevoNormal = vec3(0.0);\n"
       << attributes.Samplers << "void relevoSetNormal(vec3 normal)\n{\n"
       << (attributes.HasNormal ? "  normalMC = normal;\n" : "") << "}\n"
       << "void relevoSetAttributes(vec3 w)\n{\n"
       << attributes.Fetches << "}\n"
       << options.Extension.Declarations
       // declared after its inputs, because compilers warn in the order of the source
       << "void relevoExtend();\n"
       << relevoRefineVS << "void relevoExtend()\n{\n"
       << options.Extension.Statements
       << (options.Field != FieldColoring::NONE
              ? "  relevoFieldVSOutput = surfaceFieldRecord();\n"
                "  relevoFieldWeightsVSOutput = surfaceFieldWeights(relevoVertexWeights);\n"
              : "")
       << "}\n";
  return text.str();
}

std::vector<std::string> RefineVertexShader(const RefinementShaderOptions& options,
  const ShaderPurpose& purpose, bool edges, const std::vector<ShaderVarying>& varyings,
  ShaderText& vertex)
{
  const TakenAttributes attributes = TakeAttributes(options, vertex);
  vertex.InsertAtStart("  relevoRefine();\n");
  vertex.InsertAtEnd("  if (relevoHidden) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); }\n");
  vertex.InsertBeforeMain(GetVertexFunctions(options, varyings, attributes));
  vertex.InsertAfterVersion(GetDefines(options, edges, purpose.HasLines));
  if (purpose.HasPointIds)
  {
    vertex.Replace("gl_VertexID", "relevoPointId");
  }
  else
  {
    vertex.IfReplace("gl_VertexID", "relevoPointId"); // the actor's own code may use it
  }
  return attributes.Names;
}

// Pass on the values that fragments need.
void RefineGeometryShader(
  bool edges, const std::vector<ShaderVarying>& varyings, ShaderText& geometry)
{
  PassOnVaryings(varyings, geometry);
  if (edges)
  {
    geometry.InsertBeforeMain(relevoEdgesGS);
    geometry.Replace(EdgeMark,
      "if (relevoIsHiddenSide(2, 0)) edgeEqn[2].z = lineWidth;\n"
      "  if (relevoIsHiddenSide(1, 2)) edgeEqn[1].z = lineWidth;\n"
      "  if (relevoIsHiddenSide(0, 1)) edgeEqn[0].z = lineWidth;\n");
  }
}

// Use ids of coarse primitives and colours of faces, and discard holes.
void RefineFragmentShader(const RefinementShaderOptions& options, const ShaderPurpose& purpose,
  const std::vector<ShaderVarying>& varyings, ShaderText& fragment)
{
  std::string declarations = DeclareVaryings("in", varyings);
  if (options.ColorMode != COLOR_BY_SCALARS)
  {
    declarations += std::string(relevoColorTable) + relevoFaceColorsFS;
    fragment.IfReplace(ColorMark, // only if MarkColors() has inserted it
      "vec3 relevoFragment = relevoFragmentColor();\n"
      "  ambientColor = ambientIntensity * relevoFragment;\n"
      "  diffuseColor = diffuseIntensity * relevoFragment;\n"
      "  opacity = opacityUniform;\n");
  }
  if (options.Field != FieldColoring::NONE)
  {
    declarations += std::string(options.Field != FieldColoring::COLORS ? relevoScalars : "") +
      (options.Field == FieldColoring::TABLE ? relevoColorTable : "") + options.FieldSource +
      relevoFieldFS;
    fragment.IfReplace(ColorMark,
      std::string("vec4 relevoFragment = relevoFieldColor();\n") +
        (fragment.Has("relevoBlockColored") ? "  if (!relevoBlockColored)\n" : "") +
        "  {\n"
        "    ambientColor = ambientIntensity * relevoFragment.rgb;\n"
        "    diffuseColor = diffuseIntensity * relevoFragment.rgb;\n"
        "  }\n"
        "  opacity = opacityUniform * relevoFragment.a;\n");
  }
  fragment.InsertAfterVersion(GetDefines(options, false, false));
  if (options.HasHoles)
  {
    declarations += std::string(relevoHeightMap) + relevoHeight;
    fragment.InsertAtStart(
      "  if (relevoValidVSOutput < 0.999 || !heightValid(relevoHeightCoordinateVSOutput)) "
      "discard;\n");
  }
  fragment.InsertBeforeMain(declarations);
  // Selections, and colours and normals of cells, use the cell id.
  const std::string cell = "gl_PrimitiveID + PrimitiveIDOffset";
  if (purpose.HasCellIds || fragment.Has("(textureC,") || fragment.Has("(textureN,"))
  {
    fragment.Replace(cell, "relevoPrimitiveIDVSOutput");
  }
  else
  {
    fragment.IfReplace(cell, "relevoPrimitiveIDVSOutput");
  }
}
}

Dependencies RefinementShaderOptions::GetKey() const
{
  Dependencies key = Dependencies::On(GetDefines(*this, false, false), this->PlacementSource,
    this->SurfaceSource, this->FieldSource, this->Extension.Declarations,
    this->Extension.Statements, this->Extension.Key);
  for (const ShaderVarying& varying : this->Extension.Varyings)
  {
    key.Add(varying.Qualifier);
    key.Add(varying.Type);
    key.Add(varying.Name);
  }
  return key;
}

void MarkColors(const RefinementShaderOptions& options, const ShaderPurpose& purpose,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  if (options.ColorMode == COLOR_BY_SCALARS && options.Field == FieldColoring::NONE)
  {
    return;
  }
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  InsertColors(fragment, purpose.HasOwnFragments, std::string("\n  ") + ColorMark);
}

std::string GetAttributeSampler(const std::string& attribute)
{
  return "relevo_" + attribute;
}

std::vector<std::string> RefineShaders(const RefinementShaderOptions& options,
  const ShaderPurpose& purpose, std::map<vtkShader::Type, vtkShader*>& shaders,
  MissingAnchors& missing)
{
  ShaderText vertex(shaders[vtkShader::Vertex], missing);
  ShaderText geometry(shaders[vtkShader::Geometry], missing);
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  const bool edges = purpose.HasEdges || geometry.Has(EdgeMark);
  const std::vector<ShaderVarying> varyings = GetVaryings(options, edges);
  if (!geometry.IsEmpty() || edges)
  {
    RefineGeometryShader(edges, varyings, geometry);
  }
  RefineFragmentShader(options, purpose, varyings, fragment);
  return RefineVertexShader(options, purpose, edges, varyings, vertex);
}
}

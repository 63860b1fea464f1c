// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/CurveShader.h"

#include "Shaders/ShaderVaryings.h"
#include "relevoColorTable.h"
#include "relevoCurve.h"
#include "relevoCurveFrames.h"
#include "relevoCurveInstancedVS.h"
#include "relevoCurveTCS.h"
#include "relevoCurveTES.h"
#include "relevoCurveTables.h"
#include "relevoCurveVS.h"
#include "relevoCurveValues.h"
#include "relevoScalars.h"

#include <sstream>
#include <vector>

namespace relevo
{
namespace
{
bool HasValues(const CurveShaderOptions& options)
{
  return options.Coloring == CurveColoring::VALUES ||
    options.Coloring == CurveColoring::VALUES_OF_FRAGMENTS;
}

std::string GetDefines(const CurveShaderOptions& options)
{
  std::ostringstream text;
  text << GetPreciseExtension()
       << "#define RELEVO_FUNCTION\n#define Real float\n#define Real2 vec2\n#define Real3 vec3\n"
          "#define Real4 vec4\n"
       << "#define RELEVO_SIDES " << options.Sides << "\n#define RELEVO_MORE_RINGS "
       << GetMoreRings(options.Sides) << "\n";
  if (options.Degree > 0)
  {
    text << "#define RELEVO_DEGREE " << options.Degree << "\n";
  }
  const bool hasScalars = HasValues(options) || options.Coloring == CurveColoring::POINTS;
  const auto define = [&text](bool condition, const char* name)
  {
    if (condition)
    {
      text << "#define " << name << "\n";
    }
  };
  define(options.IsRational, "RELEVO_RATIONAL");
  define(options.Sides > 1, "RELEVO_FRAMES");
  define(options.HasRadii, "RELEVO_RADII");
  define(hasScalars, "RELEVO_SCALARS");
  define(options.HasRadii || hasScalars, "RELEVO_VALUES");
  define(options.Coloring == CurveColoring::CELLS, "RELEVO_CELL_COLORS");
  define(options.Coloring == CurveColoring::POINTS, "RELEVO_POINT_COLORS");
  define(options.Coloring == CurveColoring::VALUES_OF_FRAGMENTS, "RELEVO_SCALARS_OF_FRAGMENTS");
  define(options.HasCells, "RELEVO_CELLS");
  return text.str();
}

std::vector<ShaderVarying> GetVaryings(const CurveShaderOptions& options)
{
  std::vector<ShaderVarying> varyings;
  if (options.Coloring == CurveColoring::VALUES_OF_FRAGMENTS)
  {
    varyings.push_back({ "", "float", "relevoScalar" });
  }
  else if (options.Coloring != CurveColoring::ACTOR)
  {
    varyings.push_back(
      { options.Coloring == CurveColoring::CELLS ? "flat " : "", "vec4", "relevoColor" });
  }
  if (options.HasCells)
  {
    varyings.push_back({ "flat ", "int", "relevoCell" });
  }
  return varyings;
}

std::string GetVertexFunctions(
  const CurveShaderOptions& options, const std::vector<ShaderVarying>& varyings, bool hasNormal)
{
  std::ostringstream text;
  const bool hasScalars = HasValues(options) || options.Coloring == CurveColoring::POINTS;
  text << DeclareVaryings("out", varyings) << (hasScalars ? relevoScalars : "") << relevoCurveTables
       << relevoCurve;
  if (options.Sides > 1)
  {
    text << relevoCurveFrames;
  }
  if (hasScalars || options.HasRadii)
  {
    text << relevoCurveValues;
  }
  if (options.Coloring == CurveColoring::VALUES)
  {
    text << relevoColorTable;
  }
  if (options.HasCells)
  {
    text << "uniform usamplerBuffer relevoCells; // by curve\n";
  }
  text << "int relevoRing;\nint relevoSide;\nbool relevoHidden;\n"
       << (options.IsTessellated ? relevoCurveTES : relevoCurveInstancedVS)
       << "void relevoSetNormal(vec3 normal)\n{\n"
       << (hasNormal ? "  normalMC = normal;\n" : "") << "}\n"
       << relevoCurveVS;
  return text.str();
}
}

Dependencies CurveShaderOptions::GetKey() const
{
  return Dependencies::On(GetDefines(*this), this->IsTessellated);
}

int GetMoreRings(int sides)
{
  return sides > 2 ? 4 : 0; // for two caps: the centre and the rim
}

void PrepareCurveShaders(const CurveShaderOptions& options, bool ownFragments,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  if (options.Coloring == CurveColoring::ACTOR)
  {
    return;
  }
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  InsertColors(fragment, ownFragments,
    MakeMaterialColor(options.Coloring == CurveColoring::VALUES_OF_FRAGMENTS
        ? "relevoTableColor(relevoScalarVSOutput)"
        : "relevoColorVSOutput"));
}

void FinishCurveShaders(const CurveShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  const std::vector<ShaderVarying> varyings = GetVaryings(options);
  ShaderText vertex(shaders[vtkShader::Vertex], missing);
  const bool hasNormal = ComputeVertexAttributes(vertex, "relevoDrawCurve");
  vertex.InsertBeforeMain(GetVertexFunctions(options, varyings, hasNormal));
  vertex.InsertAfterVersion(GetDefines(options));

  ShaderText geometry(shaders[vtkShader::Geometry], missing);
  if (!geometry.IsEmpty())
  {
    PassOnVaryings(varyings, geometry);
  }
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  if (options.HasCells)
  {
    fragment.Replace("gl_PrimitiveID + PrimitiveIDOffset", "relevoCellVSOutput");
  }
  std::string declarations = DeclareVaryings("in", varyings);
  if (options.Coloring == CurveColoring::VALUES_OF_FRAGMENTS)
  {
    declarations += relevoColorTable;
  }
  fragment.InsertBeforeMain(declarations);
}

std::string GetCurveControlShader(const CurveShaderOptions& options)
{
  return GetDefines(options) + relevoCurveTCS;
}
}

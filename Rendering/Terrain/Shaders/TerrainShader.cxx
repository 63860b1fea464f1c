// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/TerrainShader.h"

#include "Bisection/GlobeFaces.h"
#include "Bisection/TerrainFace.h"
#include "Buffers/TerrainBorder.h"
#include "Lattice/BlockErrors.h"
#include "Shaders/ShaderVaryings.h"
#include "relevoColorTable.h"
#include "relevoTerrainFS.h"
#include "relevoTerrainFaceVS.h"
#include "relevoTerrainFootprintFS.h"
#include "relevoTerrainFootprintVS.h"
#include "relevoTerrainGlobeVS.h"
#include "relevoTerrainGradient.h"
#include "relevoTerrainHeightFS.h"
#include "relevoTerrainHeightsVS.h"
#include "relevoTerrainImageryFS.h"
#include "relevoTerrainPositionVS.h"
#include "relevoTerrainSolidVS.h"
#include "relevoTerrainTiles.h"
#include "relevoTerrainVS.h"

#include <sstream>
#include <vector>

namespace relevo
{
namespace
{
constexpr const char* HasNormals = "#define RELEVO_NORMALS\n";
constexpr int TileShift = 8;
static_assert(HeightTile::CellsPerTile == 1 << TileShift, "the shift must match the tiles");

// Whether a program draws walls or a bottom.
bool HasSides(const TerrainShaderOptions& options)
{
  return options.Part != TerrainPart::SURFACE;
}

// Walls and the bottom have the colour of the actor, except in the light of a hillshade.
std::string ColorSurface(const TerrainShaderOptions& options, const std::string& color)
{
  return HasSides(options) && options.Coloring != TerrainColoring::HILLSHADE
    ? "\n  if (relevoSideVSOutput == 0)\n  {" + color + "  }\n"
    : color;
}

std::string GetDefines(const TerrainShaderOptions& options)
{
  std::ostringstream text;
  text << GetPreciseExtension() << "#define RELEVO_SEGMENTS " << TerrainFace::Segments
       << "\n#define RELEVO_TILE_SHIFT " << TileShift << "\n#define RELEVO_FINEST_LEVEL ("
       << BlockErrors::FinestLevel << ")\n#define RELEVO_FINEST_TILE (" << TerrainTile::FinestLevel
       << ")\n#define RELEVO_FACE_VERTICES " << GlobeFaces::VerticesPerFace
       << "\n#define RELEVO_BOTTOM " << TerrainBorder::Bottom << "\n";
  const auto define = [&text](bool condition, const char* name)
  {
    if (condition)
    {
      text << "#define " << name << "\n";
    }
  };
  define(options.IsGlobe, "RELEVO_GLOBE");
  define(HasSides(options), "RELEVO_SOLID");
  define(options.Part == TerrainPart::BORDER, "RELEVO_BORDER");
  define(HasHeights(options.Coloring, options.HasContours), "RELEVO_HEIGHTS");
  define(options.HasCells, "RELEVO_CELLS");
  define(options.HasContours, "RELEVO_CONTOURS");
  define(options.Coloring == TerrainColoring::ELEVATION, "RELEVO_ELEVATION");
  define(options.Coloring == TerrainColoring::SLOPE, "RELEVO_SLOPE");
  define(options.Coloring == TerrainColoring::ASPECT, "RELEVO_ASPECT");
  define(options.Coloring == TerrainColoring::HILLSHADE, "RELEVO_HILLSHADE");
  define(options.Coloring == TerrainColoring::IMAGERY, "RELEVO_IMAGERY");
  define(options.Coloring == TerrainColoring::RASTER, "RELEVO_RASTER");
  return text.str();
}

std::vector<ShaderVarying> GetVaryings(const TerrainShaderOptions& options)
{
  std::vector<ShaderVarying> varyings = { { "", "vec2", "relevoRaster" },
    { "", "float", "relevoMissing" } };
  if (HasHeights(options.Coloring, options.HasContours))
  {
    varyings.push_back({ "", "float", "relevoHeight" });
  }
  if (options.IsGlobe)
  {
    varyings.push_back({ "", "vec3", "relevoUp" });
    varyings.push_back({ "", "vec4", "relevoDerivatives" });
  }
  if (HasSides(options))
  {
    varyings.push_back({ "flat ", "int", "relevoSide" });
  }
  if (options.HasCells)
  {
    varyings.push_back({ "flat ", "int", "relevoCell" });
  }
  return varyings;
}
}

bool HasTable(TerrainColoring coloring)
{
  return coloring == TerrainColoring::ELEVATION || coloring == TerrainColoring::SLOPE ||
    coloring == TerrainColoring::ASPECT || coloring == TerrainColoring::RASTER;
}

bool HasHeights(TerrainColoring coloring, bool hasContours)
{
  return coloring == TerrainColoring::ELEVATION || hasContours;
}

bool HasImagery(TerrainColoring coloring)
{
  return coloring == TerrainColoring::IMAGERY || coloring == TerrainColoring::RASTER;
}

bool HasGradients(TerrainColoring coloring)
{
  return coloring == TerrainColoring::SLOPE || coloring == TerrainColoring::ASPECT ||
    coloring == TerrainColoring::HILLSHADE;
}

Dependencies TerrainShaderOptions::GetKey() const
{
  return Dependencies::On(GetDefines(*this), this->HasVertexNormals);
}

void PrepareTerrainShaders(const TerrainShaderOptions& options, bool ownFragments,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  if (options.Coloring == TerrainColoring::IMAGERY)
  {
    InsertColors(fragment, ownFragments,
      ColorSurface(options,
        "\n  vec4 relevoColor = relevoImageryColor();\n"
        "  ambientColor = ambientIntensity * relevoColor.rgb + (1.0 - relevoColor.a) * "
        "ambientColor;\n"
        "  diffuseColor = diffuseIntensity * relevoColor.rgb + (1.0 - relevoColor.a) * "
        "diffuseColor;\n"));
  }
  else if (options.Coloring != TerrainColoring::SOLID)
  {
    InsertColors(
      fragment, ownFragments, ColorSurface(options, MakeMaterialColor("relevoTerrainColor()")));
  }
  if (options.HasContours)
  {
    fragment.InsertBefore("//VTK::DepthPeeling::Impl", // the fragment has its colour
      "gl_FragData[0].rgb = mix(gl_FragData[0].rgb, relevoContourColor, "
      "relevoContourCoverage());\n  ");
  }
}

void FinishTerrainShaders(const TerrainShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  const std::vector<ShaderVarying> varyings = GetVaryings(options);
  ShaderText vertex(shaders[vtkShader::Vertex], missing);
  const bool hasNormal = ComputeVertexAttributes(vertex, "relevoDrawTerrain");
  const bool hasVertexNormals = hasNormal && options.HasVertexNormals;
  vertex.InsertBeforeMain(DeclareVaryings("out", varyings) +
    "void relevoSetNormal(vec3 normal)\n{\n" + (hasNormal ? "  normalMC = normal;\n" : "") + "}\n" +
    relevoTerrainFaceVS + (options.IsGlobe ? relevoTerrainGlobeVS : "") + relevoTerrainHeightsVS +
    relevoTerrainPositionVS + (hasVertexNormals ? relevoTerrainFootprintVS : "") +
    (hasVertexNormals ? relevoTerrainTiles : "") +
    (HasSides(options) ? relevoTerrainSolidVS : relevoTerrainVS) +
    (hasVertexNormals ? relevoTerrainGradient : ""));
  vertex.InsertAfterVersion(GetDefines(options) + (hasVertexNormals ? HasNormals : ""));

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
  const bool hasNormals = fragment.Has("in vec3 normalVCVSOutput;") && !options.HasVertexNormals;
  if (hasNormals)
  {
    fragment.Replace("vec3 normalVCVSOutput = normalize(normalVCVSOutput);",
      "vec3 normalVCVSOutput = normalize(normalMatrix * relevoTerrainNormal());");
  }
  const bool hasFacing = hasNormals && options.IsGlobe;
  if (hasFacing)
  {
    fragment.IfReplace("gl_FrontFacing", "relevoIsFront");
  }
  const bool hasParallel = fragment.Has("uniform int cameraParallel;");
  const bool hasMatrix = fragment.Has("uniform mat3 normalMatrix;");
  const bool hasGradient = hasNormals || HasGradients(options.Coloring);
  const bool hasImagery = HasImagery(options.Coloring);
  const bool hasHeight = HasHeights(options.Coloring, options.HasContours);
  const bool hasTiles = hasGradient || hasImagery || hasHeight;
  fragment.InsertAtStart(std::string(hasTiles ? "  relevoMeasureFootprint();\n" : "") +
    (hasHeight ? "  relevoFindHeight(relevoDetail());\n" : "") +
    (options.HasContours ? "  relevoMeasureContours();\n" : "") +
    "  if (relevoIsOutside()) discard;\n" +
    (hasGradient ? "  relevoFindGradient(relevoDetail());\n" : "") +
    (hasFacing ? "  relevoFindFacing();\n" : ""));
  fragment.InsertBeforeMain(DeclareVaryings("in", varyings) +
    (hasNormals && !hasMatrix ? "uniform mat3 normalMatrix;\n" : "") +
    (HasTable(options.Coloring) ? relevoColorTable : "") +
    (hasTiles ? relevoTerrainFootprintFS : "") + (hasTiles ? relevoTerrainTiles : "") +
    (hasHeight ? relevoTerrainHeightFS : "") + (hasGradient ? relevoTerrainGradient : "") +
    (hasImagery ? relevoTerrainImageryFS : "") + relevoTerrainFS);
  fragment.InsertAfterVersion(GetDefines(options) + (hasNormals ? HasNormals : "") +
    (hasParallel ? "#define RELEVO_CAMERA_PARALLEL\n" : ""));
}
}

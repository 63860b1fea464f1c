// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/PatchShader.h"

#include "Shaders/ShaderExtension.h"
#include "relevoColorTable.h"
#include "relevoPatch.h"
#include "relevoPatchFieldFS.h"
#include "relevoPatchLinesFS.h"
#include "relevoScalars.h"

#include <string>

namespace relevo
{
namespace
{
constexpr const char* FieldMark = "//Relevo::Field::Impl";

std::string GetFragmentFunctions(const PatchShaderOptions& options)
{
  std::string text;
  const auto define = [&text](bool condition, const char* name)
  { text += condition ? std::string("#define ") + name + "\n" : ""; };
  define(options.HasIsolines, "RELEVO_ISOLINES");
  define(options.HasEdges, "RELEVO_PATCH_EDGES");
  define(options.IsRational, "RELEVO_RATIONAL");
  define(options.IsNumber, "RELEVO_FIELD_NUMBER");
  define(options.IsNumber, "PATCH_VECTOR float");
  define(options.Coloring == FieldColoring::COLORS, "RELEVO_FIELD_COLORS");
  define(options.Coloring == FieldColoring::TEXTURE, "RELEVO_FIELD_TEXTURE");
  if (options.HasColors())
  {
    text += std::string(options.Coloring == FieldColoring::COLORS ? "" : relevoScalars) +
      (options.Coloring == FieldColoring::TABLE ? relevoColorTable : "") +
      (options.IsNumber ? "float" : "vec4") + " patchPoint(int i);\n" + relevoPatch +
      relevoPatchFieldFS;
  }
  return text + (options.HasLines() ? relevoPatchLinesFS : "");
}
}

void ExtendPatchShaders(const PatchShaderOptions& options, ShaderExtension& extension)
{
  extension.HasOwnColors = options.HasColors();
  extension.Varyings = { { "flat ", "ivec2", "relevoPatch" },
    { "", "vec2", "relevoPatchCoordinate" } };
  extension.Statements = "  relevoPatchVSOutput = tableRecord(tableEntry()).xy;\n"
                         "  relevoPatchCoordinateVSOutput = patchCoordinate(facePatch(), "
                         "relevoVertexWeights);\n";
  extension.Key = std::string("patches") + (options.HasColors() ? ", colours" : "") +
    (options.IsRational ? ", rational" : "") + (options.IsNumber ? ", numbers" : "") +
    (options.HasIsolines ? ", isolines" : "") + (options.HasEdges ? ", edges " : " ") +
    std::to_string(static_cast<int>(options.Coloring));
}

void PreparePatchShaders(const PatchShaderOptions& options, bool ownFragments,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  if (options.IsEmpty())
  {
    return;
  }
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  if (options.HasColors())
  {
    InsertColors(fragment, ownFragments, std::string("\n  ") + FieldMark);
  }
  if (options.HasLines())
  {
    fragment.InsertBefore("//VTK::DepthPeeling::Impl", // the fragment has its colour
      std::string(options.HasIsolines
          ? "gl_FragData[0].rgb = mix(gl_FragData[0].rgb, relevoIsolineColor, "
            "relevoIsolineCoverage(relevoNumber));\n  "
          : "") +
        (options.HasEdges ? "gl_FragData[0].rgb = mix(gl_FragData[0].rgb, relevoPatchEdgeColor, "
                            "relevoCoverage(relevoPixelsToBorder(), relevoPatchEdgeWidth));\n  "
                          : ""));
  }
}

void FinishPatchShaders(const PatchShaderOptions& options,
  std::map<vtkShader::Type, vtkShader*>& shaders, MissingAnchors& missing)
{
  if (options.IsEmpty())
  {
    return;
  }
  ShaderText fragment(shaders[vtkShader::Fragment], missing);
  const bool isNumber = options.HasColors() && options.Coloring != FieldColoring::COLORS;
  const std::string evaluation = isNumber ? "  relevoNumber = relevoFieldNumber();\n" : "";
  if (!fragment.Has(FieldMark))
  {
    fragment.InsertAtStart(evaluation); // lines do not have the actor's colours
  }
  fragment.IfReplace(FieldMark,
    evaluation + "  vec4 relevoExact = " +
      (isNumber ? "relevoNumberColor(relevoNumber.Typed)" : "relevoFieldColor()") + ";\n" +
      (fragment.Has("relevoBlockColored") ? "  if (!relevoBlockColored)\n" : "") +
      "  {\n"
      "    ambientColor = ambientIntensity * relevoExact.rgb;\n"
      "    diffuseColor = diffuseIntensity * relevoExact.rgb;\n"
      "  }\n"
      "  opacity = opacityUniform * relevoExact.a;\n");
  if (options.HasLines())
  {
    fragment.InsertAtStart("  relevoMeasurePixels();\n");
  }
  fragment.InsertBeforeMain(GetFragmentFunctions(options)); // after the varyings
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What fragments show of patches.
#include "vtkAdaptivePatchMapperInternals.h"

#include "Actors/ShaderVariantKey.h"
#include "Shaders/ShaderExtension.h"
#include "Shaders/ShaderText.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkOpenGLHelper.h"
#include "vtkPatchSurface.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include "relevoColorTable.h"
#include "relevoPatch.h"
#include "relevoPatchFieldFS.h"
#include "relevoPatchLinesFS.h"
#include "relevoScalars.h"

#include <cmath>

namespace
{
constexpr const char* FieldMark = "//Relevo::Field::Impl";
}

void vtkAdaptivePatchMapper::ExtendShaders(
  const vtkOpenGLHelper*, relevo::ShaderExtension& extension)
{
  vtkInternals& data = *this->Patches;
  using Kind = relevo::PatchScalars;
  const Kind::Kinds kind = data.Scalars.GetKind();
  vtkInternals::Shown shown;
  if (vtkPatchSurface::SafeDownCast(this->GetRefinement()->GetSurface()) && !this->DrawingVertices)
  {
    shown.Colors = this->ExactScalars && kind != Kind::NONE &&
      this->GetRefinementColorMode() == COLOR_BY_SCALARS;
    shown.Isolines = shown.Colors && kind != Kind::COLORS && data.IsSurface &&
      static_cast<float>(this->IsolineSpacing) > 0.0f;
    shown.Edges = data.IsSurface && this->PatchEdges;
  }
  data.Shows = shown;
  if (!shown.Any())
  {
    return;
  }
  extension.HasOwnColors = shown.Colors;
  extension.Varyings = { { "flat ", "ivec2", "relevoPatch" },
    { "", "vec2", "relevoPatchCoordinate" } };
  extension.Statements = "  relevoPatchVSOutput = tableRecord(tableEntry()).xy;\n"
                         "  relevoPatchCoordinateVSOutput = patchCoordinate(facePatch(), "
                         "relevoVertexWeights);\n";
  extension.Key = std::string("patches") + (shown.Colors ? ", colours" : "") +
    (shown.Isolines ? ", isolines" : "") + (shown.Edges ? ", edges " : " ") + std::to_string(kind);
}

std::string vtkAdaptivePatchMapper::vtkInternals::GetFragmentFunctions() const
{
  using Kind = relevo::PatchScalars;
  const Kind::Kinds kind = this->Scalars.GetKind();
  std::string text;
  const auto define = [&text](bool condition, const char* name)
  { text += condition ? std::string("#define ") + name + "\n" : ""; };
  define(this->Shows.Isolines, "RELEVO_ISOLINES");
  define(this->Shows.Edges, "RELEVO_PATCH_EDGES");
  define(kind == Kind::COLORS, "RELEVO_FIELD_COLORS");
  define(kind == Kind::TEXTURE, "RELEVO_FIELD_TEXTURE");
  if (this->Shows.Colors)
  {
    text += std::string(kind == Kind::COLORS ? "" : relevoScalars) +
      (kind == Kind::TABLE ? relevoColorTable : "") + "vec4 patchPoint(int i);\n" + relevoPatch +
      relevoPatchFieldFS;
  }
  return text + (this->Shows.HasLines() ? relevoPatchLinesFS : "");
}

void vtkAdaptivePatchMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  const vtkInternals& data = *this->Patches;
  const vtkInternals::Shown shown =
    this->IsFaceHelper(this->LastBoundBO) ? data.Shows : vtkInternals::Shown();
  const bool isNumber = shown.Colors && data.Scalars.GetKind() != relevo::PatchScalars::COLORS;
  if (shown.Colors)
  {
    relevo::ShaderText fragment(shaders[vtkShader::Fragment], this->MissingAnchors);
    relevo::InsertColors(fragment, relevo::HasOwnFragments(act), std::string("\n  ") + FieldMark);
  }
  if (shown.HasLines())
  {
    relevo::ShaderText fragment(shaders[vtkShader::Fragment], this->MissingAnchors);
    fragment.InsertBefore("//VTK::DepthPeeling::Impl", // the fragment has its colour
      std::string(shown.Isolines
          ? "gl_FragData[0].rgb = mix(gl_FragData[0].rgb, relevoIsolineColor, "
            "relevoIsolineCoverage(relevoNumber));\n  "
          : "") +
        (shown.Edges ? "gl_FragData[0].rgb = mix(gl_FragData[0].rgb, relevoPatchEdgeColor, "
                       "relevoCoverage(relevoPixelsToBorder(), relevoPatchEdgeWidth));\n  "
                     : ""));
  }
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  if (!shown.Any())
  {
    return;
  }
  relevo::ShaderText fragment(shaders[vtkShader::Fragment], this->MissingAnchors);
  const std::string evaluation = isNumber ? "  relevoNumber = relevoFieldNumber();\n" : "";
  if (!fragment.Has(FieldMark))
  {
    fragment.InsertAtStart(evaluation); // colours are the actor's own, lines are not
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
  if (shown.HasLines())
  {
    fragment.InsertAtStart("  relevoMeasurePixels();\n");
  }
  fragment.InsertBeforeMain(data.GetFragmentFunctions()); // behind the varyings
}

void vtkAdaptivePatchMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  vtkShaderProgram* program = cellBO.Program;
  if (!this->IsFaceHelper(&cellBO) || !program->IsUniformUsed("relevoTablePoints"))
  {
    return;
  }
  vtkInternals& data = *this->Patches;
  data.Scalars.Activate(program);
  if (program->IsUniformUsed("relevoIsolines"))
  {
    // Numbers are less the bias; multiples of the spacing stay exact far from zero.
    const float isolines[3] = { static_cast<float>(this->IsolineSpacing),
      static_cast<float>(std::fmod(data.Scalars.GetBias(), this->IsolineSpacing)),
      static_cast<float>(this->IsolineWidth) };
    program->SetUniform3f("relevoIsolines", isolines);
    program->SetUniform3f("relevoIsolineColor", this->IsolineColor);
  }
  if (program->IsUniformUsed("relevoPatchEdgeWidth"))
  {
    program->SetUniformf("relevoPatchEdgeWidth", act->GetProperty()->GetLineWidth());
    program->SetUniform3f("relevoPatchEdgeColor", act->GetProperty()->GetEdgeColor());
  }
}

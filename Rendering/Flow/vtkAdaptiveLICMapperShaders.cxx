// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Vectors on the graphics card, and the shaders that draw them and show their LIC.
#include "vtkAdaptiveLICMapperInternals.h"

#include "OpenGL/RelevoOpenGL.h"
#include "relevoLICApplyFS.h"
#include "relevoLICColor.h"
#include "relevoLICStretch.h"
#include "relevoLICVectorsFS.h"
#include "relevoLICVectorsVS.h"

#include "Actors/ShaderVariantKey.h"
#include "Shaders/ShaderExtension.h"
#include "Shaders/ShaderText.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

namespace
{
// OpenGL's matrices are stored by columns.
void SetMatrix(vtkShaderProgram* program, const char* name, vtkMatrix4x4* matrix)
{
  if (program->IsUniformUsed(name))
  {
    vtkNew<vtkMatrix4x4> transposed;
    vtkMatrix4x4::Transpose(matrix, transposed);
    program->SetUniformMatrix(name, transposed);
  }
}

void SetMatrix(vtkShaderProgram* program, const char* name, const double matrix[3][3])
{
  if (program->IsUniformUsed(name))
  {
    vtkNew<vtkMatrix3x3> transposed;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        transposed->SetElement(i, j, matrix[j][i]);
      }
    }
    program->SetUniformMatrix(name, transposed);
  }
}
}

void vtkAdaptiveLICMapper::vtkInternals::PrepareVectors(
  vtkAdaptiveLICMapper* self, vtkPolyData* input)
{
  relevo::Dependencies dependencies =
    relevo::Dependencies::On(self->GetBuildMTime(), self->GetNoDataMagnitude());
  dependencies.AddObject(input);
  if (!this->PreparedDependencies.Update(dependencies))
  {
    return; // built for another actor
  }
  const relevo::LICArray vectors = self->FindArray(input);
  this->HasVectors = vectors.Array != nullptr;
  this->AreOfCells = vectors.IsOfCells;
  const double longest = vectors.FindLongest(self->GetNoDataMagnitude());
  // A power of two: the shaders' numbers are the same to the bit, whatever else a mapper draws.
  this->Unit = longest > 0.0 ? std::exp2(std::ceil(std::log2(longest))) : 1.0;
  this->Prepared =
    this->HasVectors ? vectors.Prepare(self->GetNoDataMagnitude(), this->Unit) : nullptr;
}

void vtkAdaptiveLICMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *this->LIC;
  vtkPolyData* input = this->CurrentInput;
  lic.PrepareVectors(this, input);
  this->VBOs->CacheDataArray(
    "relevoLICVector", lic.AreOfCells ? nullptr : lic.Prepared.Get(), ren, VTK_FLOAT);
  // Linear surfaces have none of their own; VTK's depend on lights.
  vtkDataArray* normals = lic.HasVectors ? input->GetPointData()->GetNormals() : nullptr;
  lic.HasPointNormals = normals && normals->GetNumberOfComponents() == 3 &&
    normals->GetNumberOfTuples() == input->GetNumberOfPoints();
  this->VBOs->CacheDataArray(
    "relevoLICPointNormal", lic.HasPointNormals ? normals : nullptr, ren, VTK_FLOAT);
  this->Superclass::BuildBufferObjects(ren, act);

  // Other representations show none.
  if (act->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    !lic.CellVectorDependencies.Update(lic.PreparedDependencies))
  {
    return;
  }
  lic.CellVectors.ReleaseGraphicsResources(ren->GetRenderWindow());
  if (lic.HasVectors && lic.AreOfCells)
  {
    std::vector<float> values(4 * this->CellCellMap->GetSize());
    for (size_t i = 0; i < this->CellCellMap->GetSize(); ++i)
    {
      lic.Prepared->GetTypedTuple(this->CellCellMap->GetValue(i), &values[4 * i]);
    }
    if (!lic.CellVectors.Upload(
          vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow()), values, 4))
    {
      lic.HasVectors = false;
      vtkErrorMacro("The vectors of cells cannot be sent to the graphics card: "
        << relevo::BufferTexture::GetTooLarge() << ".");
    }
  }
}

void vtkAdaptiveLICMapper::ExtendShaders(
  const vtkOpenGLHelper* cellBO, relevo::ShaderExtension& extension)
{
  vtkInternals& lic = *this->LIC;
  vtkInternals& root = *lic.Root->LIC;
  if (cellBO == lic.Vectors)
  {
    const bool ofCells = !lic.CellVectors.IsEmpty();
    lic.HasNormals = extension.HasNormals || lic.HasPointNormals;
    extension.Varyings = { { "", "vec4", "relevoLICField" },
      { "", "vec3", lic.HasNormals ? "relevoLICNormal" : "relevoLICPosition" } };
    extension.Declarations =
      std::string(relevoLICVectorsVS) + (ofCells ? "uniform samplerBuffer relevoLICCells;\n" : "");
    extension.Key = root.StretchesColors() ? "vectors and colours" : "vectors";
    extension.Statements = std::string("  relevoLICFieldVSOutput = ") +
      (ofCells ? "texelFetch(relevoLICCells, relevoFace.w >> 3)" : "relevoLICVector") +
      ";\n"
      "#ifndef RELEVO_NORMALS\n" +
      (lic.HasPointNormals ? "  relevoNormal = unitVector(relevoLICPointNormal);\n" : "") +
      "#endif\n" +
      (lic.HasNormals ? "  relevoLICNormalVSOutput = relevoLICNormals * relevoNormal;\n"
                      : "  relevoLICPositionVSOutput = (relevoLICFromVertex * vertexMC).xyz;\n");
  }
  else if (root.Screen && !this->DrawingVertices)
  {
    extension.Key = root.StretchesColors() ? "LIC, stretched" : "LIC";
  }
}

void vtkAdaptiveLICMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *this->LIC;
  vtkInternals& root = *lic.Root->LIC;
  const std::string place = "//VTK::DepthPeeling::Impl"; // the fragment has its colour
  std::string functions;
  if (this->LastBoundBO == lic.Vectors)
  {
    relevo::ShaderText vertex(shaders[vtkShader::Vertex], this->MissingAnchors);
    vertex.InsertBefore("//VTK::TCoord::Dec",
      std::string(lic.CellVectors.IsEmpty() ? "in vec4 relevoLICVector;\n" : "") +
        (lic.HasPointNormals ? "in vec3 relevoLICPointNormal;\n" : ""));
    relevo::ShaderText fragment(shaders[vtkShader::Fragment], this->MissingAnchors);
    fragment.InsertBefore(place,
      std::string(root.StretchesColors() ? "vec3 relevoColor = gl_FragData[0].rgb;\n  " : "") +
        "gl_FragData[0] = relevoLICVector();\n  " +
        (root.StretchesColors() ? "gl_FragData[1] = vec4(relevoColor, gl_FragData[0].w);\n  "
                                : ""));
    functions =
      std::string(lic.HasNormals ? "#define RELEVO_LIC_NORMALS\n" : "") + relevoLICVectorsFS;
  }
  else if (this->IsFaceHelper(this->LastBoundBO) && root.Screen && !this->DrawingVertices)
  {
    relevo::ShaderText fragment(shaders[vtkShader::Fragment], this->MissingAnchors);
    fragment.InsertBefore(place, "gl_FragData[0].rgb = RELEVO_LIC(gl_FragData[0].rgb);\n  ");
    functions = std::string(root.StretchesColors() ? "#define RELEVO_LIC_STRETCH\n" : "") +
      relevoLICStretch + relevoLICColor + relevoLICApplyFS;
  }
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
  if (!functions.empty())
  {
    relevo::ShaderText fragment(shaders[vtkShader::Fragment], this->MissingAnchors);
    // VTK has mixed the edges that it shows into the colour by then.
    const std::string edges = "float emix";
    functions += fragment.Has(edges)
      ? "#define RELEVO_LIC(color) mix(relevoLICFragment(color), color, emix)\n"
      : "#define RELEVO_LIC(color) relevoLICFragment(color)\n";
    if (!fragment.Has(edges) && this->DrawingEdges(ren, act) && !relevo::HasOwnFragments(act))
    {
      fragment.Miss(edges);
    }
    fragment.InsertBeforeMain(functions); // behind the varyings
  }
}

void vtkAdaptiveLICMapper::vtkInternals::SetVectorUniforms(
  vtkAdaptiveLICMapper* block, vtkShaderProgram* program, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *block->LIC;
  vtkLICSettings* settings = lic.Root->LICSettings;
  vtkCamera* camera = ren->GetActiveCamera();
  vtkNew<vtkMatrix4x4> modelView;
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix(), act->GetMatrix(), modelView);
  double directions[3][3];
  double normals[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      directions[i][j] = modelView->GetElement(i, j);
    }
  }
  vtkMath::Invert3x3(directions, normals);
  vtkMath::Transpose3x3(normals, normals);
  SetMatrix(program, "relevoLICDirections", directions);
  SetMatrix(program, "relevoLICNormals", normals);
  SetMatrix(program, "relevoLICProjection",
    camera->GetProjectionTransformMatrix(ren->GetTiledAspectRatio(), -1, 1));
  if (block->VBOs->GetVBO("vertexMC")->GetCoordShiftAndScaleEnabled())
  {
    vtkMatrix4x4::Multiply4x4(modelView, block->VBOInverseTransform->GetMatrix(), modelView);
  }
  SetMatrix(program, "relevoLICFromVertex", modelView);
  const double longest = lic.Root->LIC->AllVectors.Longest;
  program->SetUniformf(
    "relevoLICScale", static_cast<float>(longest > 0.0 ? lic.Unit / longest : 1.0));
  program->SetUniformf(
    "relevoLICThreshold", static_cast<float>(settings->GetMaskThreshold() / lic.Unit));
  program->SetUniformi("relevoLICMaskOnSurface", settings->GetMaskOnSurface());
  int viewport[4];
  vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float size[2] = { static_cast<float>(viewport[2]), static_cast<float>(viewport[3]) };
  program->SetUniform2f("relevoLICSize", size);
  lic.CellVectors.Activate(program, "relevoLICCells");
}

void vtkAdaptiveLICMapper::vtkInternals::SetImageUniforms(vtkShaderProgram* program)
{
  const relevo::LICScreen& screen = *this->Screen;
  const auto read = [program](const char* sampler, vtkTextureObject* texture)
  {
    if (texture && program->IsUniformUsed(sampler))
    {
      texture->Activate();
      program->SetUniformi(sampler, texture->GetTextureUnit());
    }
  };
  read("relevoLICImage", screen.Image);
  read("relevoLICRange", screen.Range);
  this->GetColoring().SetUniforms(program);
  vtkLICSettings* settings = this->Root->LICSettings;
  if (program->IsUniformUsed("relevoLICOrigin"))
  {
    program->SetUniform2i("relevoLICOrigin", screen.Viewport);
    program->SetUniform2i("relevoLICSize", screen.Viewport + 2);
  }
  if (program->IsUniformUsed("relevoLICMaskColor"))
  {
    program->SetUniform3f("relevoLICMaskColor", settings->GetMaskColor());
    program->SetUniformf(
      "relevoLICMaskIntensity", static_cast<float>(settings->GetMaskIntensity()));
  }
  if (program->IsUniformUsed("relevoLICFactors"))
  {
    const float factors[2] = { static_cast<float>(settings->GetLowColorContrastEnhancementFactor()),
      static_cast<float>(settings->GetHighColorContrastEnhancementFactor()) };
    program->SetUniform2f("relevoLICFactors", factors);
  }
}

void vtkAdaptiveLICMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  vtkInternals& lic = *this->LIC;
  if (&cellBO == lic.Vectors)
  {
    vtkInternals::SetVectorUniforms(this, cellBO.Program, ren, act);
  }
  else if (lic.Root->LIC->Screen && this->IsFaceHelper(&cellBO) && !this->DrawingVertices)
  {
    lic.Root->LIC->SetImageUniforms(cellBO.Program);
  }
}

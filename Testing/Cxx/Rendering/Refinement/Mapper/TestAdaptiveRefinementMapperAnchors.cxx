// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the mapper edits VTK's shaders at anchors. A missing anchor is an error that names
// it, and nothing is drawn, unless the actor's shader replacements removed it.
#include "RelevoDisplacements.h"
#include "RelevoOtherTemplates.h"
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
using namespace RelevoMeshes;
using Mapper = RelevoOtherTemplates<vtkAdaptiveRefinementMapper>;

struct Case
{
  const char* Stage;
  std::string From;
  std::string To;
  std::string Anchor;
  RelevoComparison::Builder Build;
  int Association = -1; // field association of a selection
};

vtkShader::Type GetStage(const std::string& name)
{
  return name == "vertex" ? vtkShader::Vertex
    : name == "geometry"  ? vtkShader::Geometry
                          : vtkShader::Fragment;
}

Mesh ColoredSphere(bool ofCells)
{
  Mesh mesh = Sphere(8, 7);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const vtkIdType size = ofCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  for (vtkIdType i = 0; i < size; ++i)
  {
    const unsigned char color[3] = { static_cast<unsigned char>(3 * i), 200, 100 };
    colors->InsertNextTypedTuple(color);
  }
  ofCells ? mesh->GetCellData()->SetScalars(colors) : mesh->GetPointData()->SetScalars(colors);
  return mesh;
}

void AddPlain(RelevoScene& scene)
{
  scene.Add(Sphere(8, 7), MakeRecipe(2));
}

void AddWithEdges(RelevoScene& scene)
{
  scene.Add(Sphere(8, 7), MakeRecipe(1))->GetProperty()->EdgeVisibilityOn();
}

void AddTubes(RelevoScene& scene)
{
  vtkProperty* property = scene.Add(Sphere(8, 7), MakeRecipe(1))->GetProperty();
  property->SetRepresentationToWireframe();
  property->RenderLinesAsTubesOn();
  property->SetLineWidth(3.0f);
}

void AddByLevel(RelevoScene& scene)
{
  scene.Add(Sphere(8, 7), MakeRecipe(1));
  scene.GetMapper(0)->SetColorModeToLevel();
}

void AddTessellated(RelevoScene& scene)
{
  AddPlain(scene);
  scene.GetMapper(0)->SetMethodToHardwareTessellation();
}

void AddColoredBlocks(RelevoScene& scene)
{
  const double aside[3] = { 1.5, 0.0, 0.0 };
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Sphere(8, 7));
  blocks->SetBlock(1, Moved(Sphere(7, 6), 1.0, aside, VTK_FLOAT));
  scene.Add(blocks, MakeRecipe(1));
  scene.GetMapper(0)->Update();
  scene.GetMapper(0)->SetBlockColor(1, 1.0, 0.0, 0.0);
}

void AddWithHoles(RelevoScene& scene)
{
  vtkNew<RelevoHeights> heights;
  heights->FillWavesWithHoles();
  auto displacement = MakeDisplacement(heights, 0.1);
  scene.Add(Plane(4, 4), MakeRecipe(3, nullptr, displacement));
}

bool SelectsNothing(RelevoScene& scene, int association)
{
  const std::vector<RelevoPicks::Hit> hits = RelevoPicks::SelectPixels(scene, association);
  return !hits.empty() &&
    std::all_of(hits.begin(), hits.end(), [](const RelevoPicks::Hit& hit) { return hit.Id < 0; });
}

void TestMissing(RelevoCheck& check, const Case& test)
{
  const auto fail = [&](const char* what)
  {
    check.Fail(__FILE__, __LINE__,
      std::string(test.Stage) + ", " + test.Anchor + " (" + test.To + "): " + what);
  };
  RelevoScene scene(RelevoScene::Refining);
  test.Build(scene);
  RelevoComplaints complaints(scene.GetMapper(0));
  scene.ResetCameras();
  scene.Render();
  const RelevoPicture expected(scene.Window);
  if (!complaints.None() || expected.CountForeground() == 0)
  {
    fail("it is not drawn as it is");
  }

  Mapper::Renaming = { GetStage(test.Stage), test.From, test.To };
  scene.GetMapper(0)->Modified();
  if (test.Association >= 0)
  {
    if (!SelectsNothing(scene, test.Association))
    {
      fail("something is selected");
    }
  }
  else
  {
    scene.Render();
    scene.Render();
    if (RelevoPicture(scene.Window).CountForeground() != 0)
    {
      fail("something is drawn");
    }
  }
  if (!complaints.IsMissing(test.Stage, test.Anchor))
  {
    fail("another error, or none");
  }

  // When the anchor is back, everything works as before.
  Mapper::Renaming = {};
  scene.GetMapper(0)->Modified();
  if (test.Association >= 0 && SelectsNothing(scene, test.Association))
  {
    fail("nothing is selected again");
  }
  scene.Render();
  if (RelevoPicture(scene.Window).Colors != expected.Colors || !complaints.None())
  {
    fail("it is not drawn again");
  }
}

// Shader replacements of the actor may remove anchors.
void TestOwnShaders(RelevoCheck& check)
{
  RelevoScene scene(RelevoScene::Refining);
  AddPlain(scene);
  vtkShaderProperty* shaders = scene.GetActor(0)->GetShaderProperty();
  RelevoComplaints complaints(scene.GetMapper(0));
  scene.ResetCameras();
  scene.Render();
  const RelevoPicture expected(scene.Window);

  shaders->AddVertexShaderReplacement("//VTK::System::Dec", true, "#version 150\n", false);
  scene.Render();
  CHECK_EQUAL(RelevoPicture(scene.Window).Colors, expected.Colors);
  shaders->ClearAllShaderReplacements();

  shaders->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
    "vec3 ambientColor = vec3(1.0, 0.0, 0.0); vec3 diffuseColor = vec3(0.0);\n"
    "  vec3 specularColor = vec3(0.0); float specularPower = 1.0; float opacity = 1.0;\n",
    false);
  for (const bool byLevel : { false, true })
  {
    CHECK_CASE(byLevel);
    byLevel ? scene.GetMapper(0)->SetColorModeToLevel()
            : scene.GetMapper(0)->SetColorModeToScalars();
    scene.Render();
    const RelevoPicture picture(scene.Window);
    CHECK_EQUAL(picture.CountForeground(), expected.CountForeground());
    const size_t middle = 3 * (picture.GetNumberOfPixels() / 2 + picture.Size[0] / 2);
    CHECK(picture.Colors[middle] == 255 && picture.Colors[middle + 1] == 0);
  }
  CHECK(complaints.None());

  // A broken replacement is drawn correctly after it is corrected.
  shaders->ClearAllShaderReplacements();
  scene.GetMapper(0)->SetColorModeToScalars();
  shaders->AddVertexShaderReplacement("void main()", true, "void first()", false);
  scene.Render();
  CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), 0);
  CHECK(complaints.IsMissing("vertex", "void main("));
  shaders->ClearAllShaderReplacements();
  scene.Render();
  CHECK_EQUAL(RelevoPicture(scene.Window).Colors, expected.Colors);
  CHECK(complaints.None());
}
}

int TestAdaptiveRefinementMapperAnchors(int, char*[])
{
  RelevoCheck check;
  RelevoScene::NewMapper = [](vtkDataObject*) -> vtkAdaptiveRefinementMapper*
  { return Mapper::New(); };
  const auto withColors = [](bool ofCells)
  { return [=](RelevoScene& scene) { scene.Add(ColoredSphere(ofCells), MakeRecipe(1)); }; };
  const std::string main = "void main(";
  const std::string body = "void main()\n{";
  const std::string noBody = "void main()\n  ;\n{";
  const std::string version = "//VTK::System::Dec";
  const std::string color = "//VTK::Color::Impl";
  const std::string cell = "gl_PrimitiveID + PrimitiveIDOffset";
  const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const Case cases[] = {
    { "vertex", "in vec4 vertexMC;", "in highp vec4 vertexMC;", "in vec4 vertexMC;", AddPlain },
    { "vertex", "in vec4 scalarColor;", "layout(location = 3) in vec4 scalarColor;",
      "in TYPE NAME;", withColors(false) },
    { "vertex", version, "//VTK::Other::Dec", version, AddPlain },
    { "vertex", version, "//VTK::Other::Dec", version, AddTessellated },
    { "vertex", main, "void first(", main, AddPlain },
    { "vertex", body, noBody, "{", AddPlain },
    { "vertex", "}", "/**/", "}", AddPlain },
    { "vertex", "gl_VertexID", "otherVertexID", "gl_VertexID", AddPlain, points },
    { "geometry", main, "void first(", main, AddWithEdges },
    { "geometry", "EmitVertex();", "EmitVertex ();", "EmitVertex();", AddWithEdges },
    { "geometry", "EmitVertex();", "EmitVertex ();", "EmitVertex();", AddTubes },
    { "geometry", "//VTK::Edges::Impl", "//VTK::Other::Impl", "//VTK::Edges::Impl", AddWithEdges },
    { "fragment", version, "//VTK::Other::Dec", version, AddPlain },
    { "fragment", main, "void first(", main, AddPlain },
    { "fragment", body, noBody, "{", AddWithHoles },
    { "fragment", color, "//VTK::Other::Impl", color, AddByLevel },
    { "fragment", color, "//VTK::Other::Impl", color, AddColoredBlocks },
    { "fragment", cell, "PrimitiveIDOffset + gl_PrimitiveID", cell, withColors(true) },
    { "fragment", cell, "PrimitiveIDOffset + gl_PrimitiveID", cell, AddPlain, cells },
  };
  for (const Case& test : cases)
  {
    TestMissing(check, test);
  }
  TestOwnShaders(check);
  return check.GetResult();
}

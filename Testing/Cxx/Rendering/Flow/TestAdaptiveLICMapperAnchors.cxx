// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the LIC mapper edits VTK's shaders at anchors. A missing anchor is an error that
// names it, and no wrong LIC is drawn.
#include "RelevoLICVectors.h"
#include "RelevoOtherTemplates.h"
#include "RelevoTestMeshes.h"

#include "vtkProperty.h"

namespace
{
using Mapper = RelevoOtherTemplates<vtkAdaptiveLICMapper>;

void Test(RelevoCheck& check, const std::string& stage, const RelevoRenaming& renaming,
  const std::string& anchor, bool isDrawnWithout)
{
  const auto fail = [&](const char* what)
  { check.Fail(__FILE__, __LINE__, stage + ", " + anchor + ": " + what); };
  RelevoScene scene(RelevoScene::Refining);
  RelevoMeshes::Mesh mesh = RelevoMeshes::Sphere(16, 12);
  RelevoLICVectors::AddVectors(mesh);
  scene.Add(mesh, RelevoMeshes::MakeRecipe(2))->GetProperty()->EdgeVisibilityOn();
  vtkAdaptiveLICMapper* mapper = vtkAdaptiveLICMapper::SafeDownCast(scene.GetMapper(0));
  RelevoComplaints complaints(mapper);
  scene.ResetCameras();
  scene.Render();
  const RelevoPicture expected(scene.Window);
  mapper->EnableOff();
  scene.Render();
  const RelevoPicture plain(scene.Window);
  mapper->EnableOn();
  if (!complaints.None() || expected.Colors == plain.Colors)
  {
    fail("there is no LIC as it is");
  }

  Mapper::Renaming = renaming;
  mapper->Modified();
  scene.Render();
  scene.Render();
  const RelevoPicture picture(scene.Window);
  if (isDrawnWithout ? picture.Colors != plain.Colors : picture.CountForeground() != 0)
  {
    fail("another picture");
  }
  if (!complaints.IsMissing(stage, anchor))
  {
    fail("another error, or none");
  }

  Mapper::Renaming = {};
  mapper->Modified();
  scene.Render();
  if (RelevoPicture(scene.Window).Colors != expected.Colors || !complaints.None())
  {
    fail("it is not drawn again");
  }
}
}

int TestAdaptiveLICMapperAnchors(int, char*[])
{
  RelevoCheck check;
  RelevoScene::NewMapper = [](vtkDataObject*) -> vtkAdaptiveRefinementMapper*
  { return Mapper::New(); };
  const std::string coordinates = "//VTK::TCoord::Dec";
  const std::string peeling = "//VTK::DepthPeeling::Impl";
  const std::string edges = "float emix";
  Test(check, "vertex", { vtkShader::Vertex, coordinates, "//VTK::Other::Dec" }, coordinates, true);
  Test(check, "fragment", { vtkShader::Fragment, peeling, "//VTK::Other::Impl" }, peeling, false);
  Test(check, "fragment", { vtkShader::Fragment, edges, "float  emix" }, edges, false);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinementMapper::SetMethod(): every method shows what ARKFPI shows.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkDisplacement.h"
#include "vtkPNTriangleSurface.h"

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

const char* const Names[] = { "ARKFPI", "ARK", "DMR", "SUAPT", "HardwareTessellation", "Uniform" };

// A scene of one mesh with depth-tags, drawn again and again.
struct Subject
{
  Subject(Mesh mesh, int level, int morphing)
    : Scene(RelevoScene::Refining)
  {
    this->Recipe->SetMaximumLevel(level);
    this->Recipe->SetSurface(this->Surface);
    this->Recipe->SetGeomorphing(morphing);
    this->Scene.Add(mesh, this->Recipe);
    this->GetMapper()->SetSelectionDeviceToCPU();
    this->Scene.ResetCameras();
  }
  Mapper* GetMapper() { return this->Scene.GetMapper(0); }

  RelevoPicture Draw(int method)
  {
    this->GetMapper()->SetMethod(method);
    this->Scene.Render();
    return RelevoPicture(this->Scene.Window);
  }

  vtkNew<vtkPNTriangleSurface> Surface;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  RelevoScene Scene;
};

Mesh Noisy(unsigned int seed, int level)
{
  Mesh mesh = Sphere(12, 8);
  PerturbNormals(mesh, seed, 0.3);
  AddRandomTextureCoordinates(mesh, seed);
  AddTags(mesh, seed, level);
  return mesh;
}

void TestSetting(RelevoCheck& check)
{
  vtkNew<Mapper> mapper;
  RelevoErrors errors(mapper);
  CHECK(mapper->GetMethod() == Mapper::METHOD_ARKFPI);
  mapper->SetMethodToUniform();
  CHECK(mapper->GetMethod() == Mapper::METHOD_UNIFORM);
  CHECK(errors.None());
  for (int wrong : { -1, 6 })
  {
    mapper->SetMethod(wrong);
    CHECK(errors.Said("Method"));
    CHECK(mapper->GetMethod() == Mapper::METHOD_UNIFORM);
  }
  vtkNew<Mapper> copy;
  copy->ShallowCopy(mapper);
  CHECK(copy->GetMethod() == Mapper::METHOD_UNIFORM);
  std::ostringstream text;
  mapper->Print(text);
  CHECK(text.str().find("Method: Uniform") != std::string::npos);
}

// One draw call per face, the same picture to the bit.
void TestARK(RelevoCheck& check, RelevoComparison& comparison)
{
  for (int morphing : { 0, 1 })
  {
    Subject subject(Noisy(3, 5), 5, morphing);
    vtkNew<RelevoHeights> rough;
    rough->FillRandom(64, 64, 9);
    vtkNew<vtkDisplacement> displacement;
    displacement->SetHeightMap(rough);
    displacement->SetScale(0.1);
    subject.Recipe->SetDisplacement(displacement);
    subject.GetMapper()->FrustumCullingOff();
    for (int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
    {
      subject.Scene.GetActor(0)->GetProperty()->SetRepresentation(representation);
      const RelevoPicture expected = subject.Draw(Mapper::METHOD_ARKFPI);
      const vtkIdType triangles = subject.GetMapper()->GetNumberOfDrawnTriangles();
      const vtkIdType builds = subject.GetMapper()->GetNumberOfBufferBuilds();
      const RelevoPicture actual = subject.Draw(Mapper::METHOD_ARK);
      CHECK(subject.GetMapper()->GetMethodInUse() == Mapper::METHOD_ARK);
      CHECK(subject.GetMapper()->GetNumberOfDrawCalls() ==
        subject.GetMapper()->GetNumberOfCoarseFaces());
      CHECK(subject.GetMapper()->GetNumberOfDrawnTriangles() == triangles);
      CHECK(subject.GetMapper()->GetNumberOfBufferBuilds() == builds);
      comparison.Compare("ARK" + std::to_string(morphing) + "." + std::to_string(representation),
        RelevoTolerance(), actual, expected);
    }
  }
}
}

int TestAdaptiveRefinementMapperMethods(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestSetting(check);
  TestARK(check, comparison);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that at level 0 the mapper draws what vtkPolyDataMapper draws: representations, edges,
// culling, translucency, clipping and all kinds of cells.
#include "RelevoNamedMeshes.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkVersionMacros.h"

namespace
{
using namespace RelevoMeshes;
using Compare = std::function<void(const std::string&, const RelevoComparison::Builder&)>;
using ChangeActor = std::function<void(vtkActor*)>;
using CompareActor = std::function<void(const std::string&, const ChangeActor&)>;

// The mesh with cells of one kind: 0 vertices and lines, 1 polygons, 2 strips.
Mesh Part(vtkPolyData* mesh, int kind)
{
  Mesh part = Make();
  part->ShallowCopy(mesh);
  if (kind != 0)
  {
    part->SetVerts(nullptr);
    part->SetLines(nullptr);
  }
  if (kind != 1)
  {
    part->SetPolys(nullptr);
  }
  if (kind != 2)
  {
    part->SetStrips(nullptr);
  }
  return part;
}

const RelevoTolerance Tight{ 1, 5e-7, 0 };

// Compares pictures of an actor of the mesh after a change.
void CompareMesh(RelevoComparison& comparison, const NamedMesh& mesh, const std::string& name,
  const ChangeActor& change)
{
  // Lines of strips run in the opposite direction, so other pixels are closest to them. Tubes,
  // which VTK 9.3 and later extend by the direction, end elsewhere. In VTK 9.6, the tube of a line
  // may lie behind edges at the same place in another actor.
  const bool areTubesHidden = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0) &&
    mesh.Name == "Mixed" && name == "EdgesAsTubes";
  const RelevoTolerance lines{ 1, 1e-6, areTubesHidden ? 600u : 60u };
  const bool ofStrips = mesh.Name == "Strips" || mesh.Name == "Mixed";
  comparison.Compare("Representation." + mesh.Name + "." + name, ofStrips ? lines : Tight,
    [&](RelevoScene& s)
    {
      // vtkPolyDataMapper draws wrong edges if there are other cells besides polygons, so its twin
      // has an actor for each kind.
      const bool apart = s.Kind == RelevoScene::Twin && mesh.Name == "Mixed";
      for (int kind = 0; kind < (apart ? 3 : 1); ++kind)
      {
        vtkActor* actor = s.Add(apart ? Part(mesh.Data, kind) : mesh.Data);
        actor->GetProperty()->SetColor(0.9, 0.8, 0.6);
        change(actor);
      }
    });
}

void TestWireframe(const CompareActor& compare)
{
  compare("Wireframe", [](vtkActor* a) { a->GetProperty()->SetRepresentationToWireframe(); });
  compare("WideWireframe",
    [](vtkActor* a)
    {
      a->GetProperty()->SetRepresentationToWireframe();
      a->GetProperty()->SetLineWidth(4);
    });
  compare("UnlitWireframe",
    [](vtkActor* a)
    {
      a->GetProperty()->SetRepresentationToWireframe();
      a->GetProperty()->LightingOff();
    });
  compare("FlatWireframe",
    [](vtkActor* a)
    {
      a->GetProperty()->SetRepresentationToWireframe();
      a->GetProperty()->SetInterpolationToFlat();
    });
}

void TestEdges(const CompareActor& compare)
{
  compare("Edges", [](vtkActor* a) { a->GetProperty()->EdgeVisibilityOn(); });
  compare("WideEdges",
    [](vtkActor* a)
    {
      a->GetProperty()->EdgeVisibilityOn();
      a->GetProperty()->SetLineWidth(3);
      a->GetProperty()->SetEdgeColor(1, 0, 0);
    });
  compare("FlatEdges",
    [](vtkActor* a)
    {
      a->GetProperty()->EdgeVisibilityOn();
      a->GetProperty()->SetInterpolationToFlat();
    });
  compare("EdgesAndVertices",
    [](vtkActor* a)
    {
      a->GetProperty()->EdgeVisibilityOn();
      a->GetProperty()->VertexVisibilityOn();
      a->GetProperty()->SetVertexColor(0, 1, 0);
      a->GetProperty()->SetPointSize(7);
    });
}

void TestPoints(const CompareActor& compare)
{
  compare("Vertices",
    [](vtkActor* a)
    {
      a->GetProperty()->VertexVisibilityOn();
      a->GetProperty()->SetPointSize(7);
    });
  compare("Points",
    [](vtkActor* a)
    {
      a->GetProperty()->SetRepresentationToPoints();
      a->GetProperty()->SetPointSize(8);
    });
  compare("PointsAsSpheres",
    [](vtkActor* a)
    {
      a->GetProperty()->SetRepresentationToPoints();
      a->GetProperty()->RenderPointsAsSpheresOn();
      a->GetProperty()->SetPointSize(20);
    });
}

void TestTubes(const CompareActor& compare)
{
  compare("LinesAsTubes",
    [](vtkActor* a)
    {
      a->GetProperty()->SetRepresentationToWireframe();
      a->GetProperty()->RenderLinesAsTubesOn();
      a->GetProperty()->SetLineWidth(8);
    });
  compare("EdgesAsTubes",
    [](vtkActor* a)
    {
      a->GetProperty()->EdgeVisibilityOn();
      a->GetProperty()->RenderLinesAsTubesOn();
      a->GetProperty()->SetLineWidth(8);
    });
}

void TestMesh(RelevoComparison& comparison, const NamedMesh& mesh)
{
  const CompareActor compare = [&](const std::string& name, const ChangeActor& change)
  { CompareMesh(comparison, mesh, name, change); };
  compare("Surface", [](vtkActor*) {});
  TestWireframe(compare);
  TestEdges(compare);
  TestPoints(compare);
  TestTubes(compare);
  compare("Translucent", [](vtkActor* a) { a->GetProperty()->SetOpacity(0.5); });
}

void TestSides(const Compare& compare)
{
  auto open = [&](const std::string& name, const ChangeActor& change)
  {
    compare("Open." + name,
      [&](RelevoScene& s)
      {
        vtkActor* actor = s.Add(Moebius());
        actor->GetProperty()->SetColor(0.9, 0.8, 0.6);
        change(actor);
      });
  };
  open("BackfaceCulling", [](vtkActor* a) { a->GetProperty()->BackfaceCullingOn(); });
  open("FrontfaceCulling", [](vtkActor* a) { a->GetProperty()->FrontfaceCullingOn(); });
  open("BackfaceProperty",
    [](vtkActor* a)
    {
      vtkNew<vtkProperty> back;
      back->SetColor(1, 0, 0);
      back->SetSpecular(0.5);
      a->SetBackfaceProperty(back);
    });
  open("CulledWireframe",
    [](vtkActor* a)
    {
      a->GetProperty()->BackfaceCullingOn();
      a->GetProperty()->SetRepresentationToWireframe();
    });
}

void TestTranslucency(const Compare& compare)
{
  compare("One", [](RelevoScene& s) { s.Add(Sphere(12, 10))->GetProperty()->SetOpacity(0.4); });
  compare("TwoOverlapping",
    [](RelevoScene& s)
    {
      vtkActor* first = s.Add(Sphere(12, 10));
      first->GetProperty()->SetOpacity(0.4);
      first->GetProperty()->SetColor(1, 0, 0);
      vtkActor* second = s.Add(Cube());
      second->GetProperty()->SetOpacity(0.6);
      second->GetProperty()->SetColor(0, 1, 0);
      second->SetPosition(0.3, 0.2, 0.1);
      vtkActor* third = s.Add(Cone());
      third->SetScale(0.3);
    });
  compare("OverOtherMappers",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10))->GetProperty()->SetOpacity(0.4);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(Cube());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetPosition(0.3, 0.2, 0.1);
      actor->GetProperty()->SetOpacity(0.5);
      actor->GetProperty()->SetColor(0, 0, 1);
      s.Renderer->AddActor(actor);
    });
  compare("Wireframe",
    [](RelevoScene& s)
    {
      vtkProperty* property = s.Add(Sphere(12, 10))->GetProperty();
      property->SetOpacity(0.4);
      property->SetRepresentationToWireframe();
      property->SetLineWidth(3);
    });
  compare("Edges",
    [](RelevoScene& s)
    {
      vtkProperty* property = s.Add(Cube())->GetProperty();
      property->SetOpacity(0.4);
      property->EdgeVisibilityOn();
      property->SetLineWidth(3);
    });
}

// Both ways to draw translucent surfaces.
void TestPeeling(const Compare& compare)
{
  for (bool peeling : { false, true })
  {
    const std::string prefix = peeling ? "Peeled." : "Blended.";
    TestTranslucency(
      [&](const std::string& name, const RelevoComparison::Builder& build)
      {
        compare(prefix + name,
          [&](RelevoScene& s)
          {
            s.Window->AlphaBitPlanesOn();
            s.Renderer->SetUseDepthPeeling(peeling);
            s.Renderer->SetMaximumNumberOfPeels(20);
            s.Renderer->SetOcclusionRatio(0.0);
            build(s);
          });
      });
  }
}

void TestClipping(const Compare& compare)
{
  auto addPlanes = [](vtkMapper* mapper)
  {
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.1, 0.0, 0.05);
      plane->SetNormal(i ? 0.3 : 1.0, i ? 1.0 : 0.2, 0.1);
      mapper->AddClippingPlane(plane);
    }
  };
  compare("ClippingPlanes", [&](RelevoScene& s) { addPlanes(s.Add(Sphere(12, 10))->GetMapper()); });
  compare("ClippingPlanesMoved",
    [&](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Cube());
      actor->SetScale(1, 2, 0.5);
      actor->RotateX(20);
      actor->GetProperty()->EdgeVisibilityOn();
      addPlanes(actor->GetMapper());
    });
  compare("ClippedMixedCells",
    [&](RelevoScene& s)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(2.2, 1.5, 0);
      plane->SetNormal(-1, 0.5, 0);
      s.Add(Mixed())->GetMapper()->AddClippingPlane(plane);
    });
}

void TestCoincidentTopology(const Compare& compare)
{
  compare("CoincidentTopology",
    [](RelevoScene& s)
    {
      Mesh mesh = Sphere(12, 10);
      s.Add(mesh);
      vtkActor* lines = s.Add(mesh);
      lines->GetProperty()->SetRepresentationToWireframe();
      lines->GetProperty()->SetColor(1, 0, 0);
      lines->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
      lines->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4);
    });
  compare("CoincidentPolygons",
    [](RelevoScene& s)
    {
      s.Add(Plane(3, 3));
      vtkActor* above = s.Add(Plane(5, 4));
      above->GetProperty()->SetColor(1, 0, 0);
      above->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
      above->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2, -2);
    });
}

void TestBlocks(const Compare& compare)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, Sphere(8, 6));
  const double offset[3] = { 1.2, 0.3, 0.0 };
  Mesh cube = Moved(Cube(), 0.8, offset, VTK_FLOAT);
  inner->SetBlock(2, cube);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, inner);
  const double back[3] = { -1.0, -0.4, 0.0 };
  blocks->SetBlock(3, Moved(Strips(), 0.7, back, VTK_DOUBLE));
  compare("Blocks", [&](RelevoScene& s) { s.Add(blocks); });
  compare("BlocksEdges", [&](RelevoScene& s) { s.Add(blocks)->GetProperty()->EdgeVisibilityOn(); });
  compare("BlocksTranslucent",
    [&](RelevoScene& s)
    {
      s.Add(blocks)->GetProperty()->SetOpacity(0.4);
      s.Renderer->UseDepthPeelingOn();
    });
}
}

int TestAdaptiveRefinementMapperRepresentation(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  auto compare = [&](const std::string& name, const RelevoComparison::Builder& build)
  { comparison.Compare("Representation." + name, Tight, build); };

  for (const NamedMesh& mesh : MakeNamedMeshes())
  {
    TestMesh(comparison, mesh);
  }
  TestSides(compare);
  TestPeeling(compare);
  TestClipping(compare);
  TestCoincidentTopology(compare);
  TestBlocks(compare);
  return check.GetResult();
}

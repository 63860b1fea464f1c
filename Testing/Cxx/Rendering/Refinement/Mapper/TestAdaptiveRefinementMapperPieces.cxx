// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the mapper requests its piece from the pipeline, as vtkPolyDataMapper does, and draws
// no ghost cells.
#include "RelevoPieceSource.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <memory>
#include <set>

namespace
{
using namespace RelevoMeshes;
using Request = std::array<int, 3>; // piece, number of pieces, ghost levels

Request GetRequest(vtkInformation* info)
{
  return { { vtkStreamingDemandDrivenPipeline::GetUpdatePiece(info),
    vtkStreamingDemandDrivenPipeline::GetUpdateNumberOfPieces(info),
    vtkStreamingDemandDrivenPipeline::GetUpdateGhostLevel(info) } };
}

// The faces of a sphere whose number modulo the number of pieces is the piece. With ghost levels,
// there are additional, much smaller ones.
Mesh MakePiece(const Request& request)
{
  Mesh whole = Sphere(12, 9);
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
  {
    if (i % request[1] == request[0] || i % 7 < request[2])
    {
      whole->GetCellPoints(i, ids);
      faces->InsertNextCell(ids);
    }
  }
  whole->SetPolys(faces);
  return whole;
}

void SetPieces(vtkPolyData* output, const Request& request)
{
  output->ShallowCopy(MakePiece(request));
}

void SetPieces(vtkMultiBlockDataSet* output, const Request& request)
{
  const double aside[3] = { 1.5, 0.0, 0.0 };
  output->SetBlock(0, MakePiece(request));
  output->SetBlock(2, Moved(MakePiece(request), 0.7, aside, VTK_FLOAT));
}

// Creates pieces and stores the last request.
template <typename Base>
class PieceAlgorithm : public RelevoPieceSource<Base>
{
public:
  static PieceAlgorithm* New() { VTK_STANDARD_NEW_BODY(PieceAlgorithm); }
  vtkTemplateTypeMacro(PieceAlgorithm, RelevoPieceSource<Base>);
  Request Last{ { -1, -1, -1 } };
  int Executions = 0;

protected:
  PieceAlgorithm()
  {
    this->Make = [this](vtkInformation* request)
    {
      this->Last = GetRequest(request);
      ++this->Executions;
      SetPieces(this->GetOutput(), this->Last);
    };
  }
};

using PieceSource = PieceAlgorithm<vtkPolyDataAlgorithm>;
using PieceBlocksSource = PieceAlgorithm<vtkMultiBlockDataSetAlgorithm>;

struct View
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;

  explicit View(vtkPolyDataMapper* mapper)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(200, 150);
    this->Window->AddRenderer(this->Renderer);
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
  }
};

vtkSmartPointer<vtkAdaptiveRefinementMapper> NewMapper(int level)
{
  auto mapper = vtk::TakeSmartPointer(RelevoScene::NewMapper(nullptr));
  mapper->SetRefinement(MakeRecipe(level));
  mapper->BackFaceCullingOff();
  return mapper;
}

// The first request, for bounds or a picture, asks for the piece. A change of the piece takes
// effect.
template <typename Source>
void TestRequests(RelevoCheck& check, RelevoComparison& comparison, const std::string& name)
{
  vtkNew<Source> source;
  auto mapper = NewMapper(0);
  mapper->SetInputConnection(source->GetOutputPort());
  View view(mapper);

  vtkNew<PieceSource> twinSource; // only for pictures of single blocks
  vtkNew<vtkPolyDataMapper> twinMapper;
  twinMapper->SetInputConnection(twinSource->GetOutputPort());
  View twin(twinMapper);
  const bool isTwin = std::is_same<Source, PieceSource>::value;

  const Request requests[] = { { { 1, 3, 0 } }, { { 0, 4, 0 } }, { { 3, 4, 2 } }, { { 0, 1, 0 } } };
  for (const Request& request : requests)
  {
    for (vtkPolyDataMapper* each : { static_cast<vtkPolyDataMapper*>(mapper), twinMapper.Get() })
    {
      each->SetPiece(request[0]);
      each->SetNumberOfPieces(request[1]);
      each->SetGhostLevel(request[2]);
    }
    double bounds[6];
    mapper->GetBounds(bounds);
    CHECK_EQUAL(source->Last, request);
    view.Renderer->ResetCamera();
    view.Window->Render();
    CHECK_EQUAL(source->Last, request);
    const vtkIdType faces = MakePiece(request)->GetNumberOfPolys() * (isTwin ? 1 : 2);
    CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), faces);
    CHECK_EQUAL(mapper->GetNumberOfCoarseFaces(), faces);
    const int executions = source->Executions;
    mapper->Update();
    mapper->GetBounds();
    view.Window->Render();
    CHECK_EQUAL(source->Executions, executions);
    if (isTwin)
    {
      double expected[6];
      twinMapper->GetBounds(expected);
      for (int i = 0; i < 6; ++i)
      {
        CHECK_NEAR(bounds[i], expected[i], 1e-6);
      }
      twin.Renderer->ResetCamera();
      twin.Renderer->GetActiveCamera()->DeepCopy(view.Renderer->GetActiveCamera());
      twin.Window->Render();
      comparison.Compare("Pieces." + name + "." + std::to_string(request[0]), RelevoTolerance(),
        RelevoPicture(view.Window), RelevoPicture(twin.Window));
    }
  }

  // The first request to a new mapper is for a picture.
  vtkNew<Source> other;
  auto next = NewMapper(1);
  next->SetInputConnection(other->GetOutputPort());
  next->SetPiece(2);
  next->SetNumberOfPieces(5);
  next->SetGhostLevel(1);
  View first(next);
  first.Window->Render();
  CHECK((other->Last == Request{ { 2, 5, 1 } }));

  // A copied mapper: VTK copies the number of pieces, but not the piece.
  auto copy = NewMapper(0);
  copy->ShallowCopy(next);
  CHECK_EQUAL(copy->GetNumberOfPieces(), 5);
  CHECK_EQUAL(copy->GetGhostLevel(), 1);
}

// VTK's source creates pieces itself.
void TestSphere(RelevoCheck& check, RelevoComparison& comparison)
{
  for (int piece = 0; piece < 3; ++piece)
  {
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(12);
    auto mapper = NewMapper(0);
    vtkNew<vtkPolyDataMapper> twinMapper;
    std::unique_ptr<View> views[2];
    int i = 0;
    for (vtkPolyDataMapper* each : { static_cast<vtkPolyDataMapper*>(mapper), twinMapper.Get() })
    {
      each->SetInputConnection(source->GetOutputPort());
      each->SetPiece(piece);
      each->SetNumberOfPieces(3);
      views[i] = std::make_unique<View>(each);
      views[i]->Renderer->GetActiveCamera()->SetPosition(0.3, 0.4, 3.0);
      views[i]->Renderer->ResetCamera();
      views[i++]->Window->Render();
    }
    comparison.Compare("Pieces.Sphere." + std::to_string(piece), RelevoTolerance(),
      RelevoPicture(views[0]->Window), RelevoPicture(views[1]->Window));
    CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), source->GetOutput()->GetNumberOfPolys());
  }
}
// A mesh of all kinds of cells, some of them ghost cells, and the same mesh without these.
Mesh WithGhosts(bool removed)
{
  Mesh mesh = Mixed();
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  vtkNew<vtkFloatArray> keptValues;
  vtkNew<vtkCellArray> kept[4];
  vtkCellArray* cells[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  vtkNew<vtkIdList> ids;
  cells[1]->InsertNextCell({ 3, 9, 15 });
  cells[3]->InsertNextCell({ 15, 21, 16, 22 });
  for (int kind = 0; kind < 4; ++kind)
  {
    for (vtkIdType i = 0; i < cells[kind]->GetNumberOfCells(); ++i)
    {
      // Hidden cells and ghost points are drawn, as by vtkPolyDataMapper.
      const bool isGhost = values->GetNumberOfValues() % 3 == 0;
      ghosts->InsertNextValue(
        isGhost ? vtkDataSetAttributes::DUPLICATECELL : vtkDataSetAttributes::HIDDENCELL);
      values->InsertNextValue(static_cast<float>(values->GetNumberOfValues()));
      if (!isGhost)
      {
        cells[kind]->GetCellAtId(i, ids);
        kept[kind]->InsertNextCell(ids);
        keptValues->InsertNextValue(values->GetValue(values->GetMaxId()));
      }
    }
  }
  mesh->GetCellData()->SetScalars(values);
  mesh->GetCellData()->AddArray(ghosts);
  if (removed)
  {
    mesh->SetVerts(kept[0]);
    mesh->SetLines(kept[1]);
    mesh->SetPolys(kept[2]);
    mesh->SetStrips(kept[3]);
    mesh->GetCellData()->Initialize();
    mesh->GetCellData()->SetScalars(keptValues);
  }
  return mesh;
}

void TestGhosts(RelevoCheck& check, RelevoComparison& comparison)
{
  for (int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
  {
    for (int level : { 0, 2 })
    {
      RelevoScene refining(RelevoScene::Refining);
      RelevoScene twin(RelevoScene::Twin);
      if (representation == VTK_WIREFRAME && level > 0)
      {
        continue; // the filter's triangles show diagonals
      }
      auto recipe = MakeRecipe(level);
      refining.Add(WithGhosts(false), recipe);
      twin.Add(WithGhosts(true), level > 0 ? recipe.Get() : nullptr);
      for (RelevoScene* scene : { &twin, &refining })
      {
        vtkActor* actor = scene->GetActor(0);
        actor->GetProperty()->SetRepresentation(representation);
        actor->GetProperty()->SetPointSize(8);
        actor->GetProperty()->SetLineWidth(4);
        actor->GetMapper()->SetScalarRange(0, 10);
      }
      twin.ResetCameras();
      twin.Render();
      refining.CopyCameras(twin);
      refining.Render();
      RelevoTolerance tolerance;
      // Lines may run in the opposite direction, and faces may be drawn in another order.
      tolerance.Pixels = representation == VTK_WIREFRAME ? 6 : level * 10;
      comparison.Compare("Ghosts." + std::to_string(representation) + "." + std::to_string(level),
        tolerance, RelevoPicture(refining.Window), RelevoPicture(twin.Window));
      Mesh refined = Refine(WithGhosts(false), recipe);
      CHECK_EQUAL(refining.CountTriangles(), refined->GetNumberOfPolys());
      CHECK_EQUAL(
        refined->GetNumberOfPolys(), Refine(WithGhosts(true), recipe)->GetNumberOfPolys());
      CHECK_EQUAL(refined->GetNumberOfVerts(), 1);
      CHECK_EQUAL(refined->GetNumberOfLines(), 1);
      double bounds[6];
      double expected[6];
      refining.GetMapper(0)->GetBounds(bounds);
      refined->GetCellsBounds(expected);
      for (int i = 0; i < 6; ++i)
      {
        CHECK_NEAR(bounds[i], expected[i], 1e-6);
      }
    }
  }
}

// Ghost cells provide neighbours, so a part of a surface is curved like the whole.
void TestGhostNeighbours(RelevoCheck& check)
{
  vtkNew<vtkPNTriangleSurface> surface;
  auto recipe = MakeRecipe(2, surface);
  Mesh whole = Explode(Sphere(9, 7));
  whole->GetPointData()->SetNormals(nullptr);
  const Mesh expected = Refine(whole, recipe);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
  {
    ghosts->InsertNextValue(i % 5 < 3 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  whole->GetCellData()->AddArray(ghosts);
  const Mesh part = Refine(whole, recipe);
  vtkIdType next = 0;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> expectedIds;
  for (vtkIdType i = 0; i < expected->GetNumberOfPolys(); ++i)
  {
    const auto cell =
      static_cast<vtkIdType>(expected->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(i));
    if (ghosts->GetValue(cell))
    {
      continue;
    }
    part->GetCellPoints(next++, ids);
    expected->GetCellPoints(i, expectedIds);
    for (int k = 0; k < 3; ++k)
    {
      const double* a = part->GetPoint(ids->GetId(k));
      const double point[3] = { a[0], a[1], a[2] };
      CHECK(std::equal(point, point + 3, expected->GetPoint(expectedIds->GetId(k))));
    }
  }
  CHECK_EQUAL(next, part->GetNumberOfPolys());
  CHECK_GREATER(next, 0);
  std::set<vtkIdType> used;
  for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
  {
    part->GetCellPoints(cell, ids);
    used.insert(ids->begin(), ids->end());
  }
  CHECK_EQUAL(static_cast<vtkIdType>(used.size()), part->GetNumberOfPoints());
}
}

int TestAdaptiveRefinementMapperPieces(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestRequests<PieceSource>(check, comparison, "Single");
  TestRequests<PieceBlocksSource>(check, comparison, "Blocks");
  TestSphere(check, comparison);
  TestGhosts(check, comparison);
  TestGhostNeighbours(check);
  return check.GetResult();
}

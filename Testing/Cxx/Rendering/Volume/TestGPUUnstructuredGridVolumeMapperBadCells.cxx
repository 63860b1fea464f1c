// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells of all types, and cells that are hard, wrong or doubled: vtkGPUUnstructuredGridVolumeMapper
// and vtkVolumeRayCastFilter issue one message, draw the rest, and agree.
#include "RelevoCheck.h"
#include "RelevoCurvedCells.h"
#include "RelevoVolumeScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace
{
constexpr int Width = 32;
constexpr int Height = 24;

// All errors and warnings of an object.
class Messages
{
public:
  explicit Messages(vtkObject* object)
    : Object(object)
  {
    this->Tags[0] = object->AddObserver(vtkCommand::ErrorEvent, this, &Messages::Take);
    this->Tags[1] = object->AddObserver(vtkCommand::WarningEvent, this, &Messages::Take);
  }
  ~Messages()
  {
    this->Object->RemoveObserver(this->Tags[0]);
    this->Object->RemoveObserver(this->Tags[1]);
  }
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  // Checks that there is one message with this text, or none if it is empty.
  void Check(RelevoCheck& check, const std::string& text) const
  {
    CHECK_EQUAL(this->Texts.size(), (text.empty() ? 0u : 1u));
    for (const std::string& given : this->Texts)
    {
      CHECK_CASE(given);
      CHECK(given.find(text) != std::string::npos);
    }
  }

private:
  void Take(vtkObject*, unsigned long, void* text)
  {
    this->Texts.emplace_back(static_cast<const char*>(text));
  }
  vtkObject* Object;
  unsigned long Tags[2];
  std::vector<std::string> Texts;
};

double GetMost(const std::vector<RelevoColor>& picture)
{
  double most = 0.0;
  for (const RelevoColor& color : picture)
  {
    most = std::max(most, color[0] + color[1] + color[2]);
  }
  return most;
}

bool AreFinite(const std::vector<RelevoColor>& picture)
{
  return std::all_of(picture.begin(), picture.end(),
    [](const RelevoColor& color)
    { return std::isfinite(color[0] + color[1] + color[2] + color[3]); });
}

// One window for all meshes, so that few shaders are built.
class Scene
{
public:
  explicit Scene(RelevoCheck& theCheck)
    : check(theCheck)
    , Window(MakeTetrahedra(2, GetLinearField), MakeLinearProperty(), Width, Height)
  {
  }

  // Both issue this message once, or none, and agree except at outlines.
  void Test(vtkUnstructuredGrid* mesh, const std::string& text, double most = 1.0)
  {
    this->Draw(mesh, text);
    this->Cast(mesh, text);
    if (GetMost(this->Drawn) == 0.0)
    {
      CHECK_EQUAL(GetMost(this->CastPicture), 0.0);
      return;
    }
    CHECK_LESS(CompareInside(this->Drawn, this->CastPicture, Width), most);
  }
  // The view is that of the good mesh. Its cells are drawn as if they were alone.
  void TestRest(vtkUnstructuredGrid* good, vtkUnstructuredGrid* mesh, const std::string& text)
  {
    this->See(good);
    this->Draw(good, "");
    this->Cast(good, "");
    const auto drawn = this->Drawn;
    const auto cast = this->CastPicture;
    CHECK_GREATER(GetMost(drawn), 0.3);
    this->Draw(mesh, text);
    this->Cast(mesh, text);
    CHECK_LESS_EQUAL(FindLargestDifference(this->Drawn, drawn), 1.0 / 255.0);
    CHECK_LESS(FindLargestDifference(this->CastPicture, cast), 1e-6);
  }
  void See(vtkDataSet* mesh) { this->Window.GetRenderer()->ResetCamera(mesh->GetBounds()); }
  void Draw(vtkUnstructuredGrid* mesh, const std::string& text)
  {
    this->Window.GetMapper()->SetInputData(mesh);
    const Messages messages(this->Window.GetMapper());
    this->Drawn = this->Window.Draw();
    CHECK(FindLargestDifference(this->Window.Draw(), this->Drawn) == 0.0);
    messages.Check(check, text);
  }
  void Cast(vtkUnstructuredGrid* mesh, const std::string& text)
  {
    vtkNew<vtkVolumeRayCastFilter> filter;
    filter->SetInputData(mesh);
    filter->SetVolumeProperty(this->Window.GetVolume()->GetProperty());
    filter->SetCamera(this->Window.GetCamera());
    filter->SetViewportSize(Width, Height);
    const Messages messages(filter);
    const RelevoErrors executiveErrors(filter->GetExecutive());
    this->CastPicture = ::Cast(filter);
    messages.Check(check, text);
    CHECK(AreFinite(this->CastPicture));
  }
  const std::vector<RelevoColor>& GetDrawn() const { return this->Drawn; }
  const std::vector<RelevoColor>& GetCast() const { return this->CastPicture; }
  RelevoVolumeScene& GetWindow() { return this->Window; }

private:
  RelevoCheck& check;
  RelevoVolumeScene Window;
  std::vector<RelevoColor> Drawn;
  std::vector<RelevoColor> CastPicture;
};

// A cube of cells by vtkCellTypeSource, or null if it does not make this type.
vtkSmartPointer<vtkUnstructuredGrid> MakeCube(int type, int order)
{
  vtkNew<vtkCellTypeSource> source;
  const RelevoErrors errors(source);
  source->SetCellType(type);
  source->SetCellOrder(order);
  source->SetBlocksDimensions(1, 1, 1);
  source->Update();
  vtkSmartPointer<vtkUnstructuredGrid> mesh = source->GetOutput();
  if (mesh->GetNumberOfCells() == 0 || mesh->GetCellType(0) != type)
  {
    return nullptr;
  }
  vtkNew<vtkDoubleArray> field;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint at;
    mesh->GetPoint(i, at.data());
    field->InsertNextValue(GetLinearField(at));
  }
  mesh->GetPointData()->SetScalars(field);
  return mesh;
}

void Move(vtkUnstructuredGrid* mesh, const std::function<RelevoPoint(const RelevoPoint&)>& move)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint at;
    mesh->GetPoint(i, at.data());
    points->InsertNextPoint(move(at).data());
  }
  mesh->SetPoints(points);
}

// Adds a cell with these points.
void AddCell(vtkUnstructuredGrid* mesh, int type, const std::vector<RelevoPoint>& points)
{
  std::vector<vtkIdType> ids;
  for (const RelevoPoint& at : points)
  {
    ids.push_back(mesh->GetPoints()->InsertNextPoint(at.data()));
    mesh->GetPointData()->GetScalars()->InsertTuple1(ids.back(), 0.5);
  }
  mesh->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
}

// All types that vtkCellTypeSource makes, in three orders. Those without volume are an error.
void TestTypes(RelevoCheck& check, Scene& scene)
{
  int solid = 0;
  scene.See(MakeTetrahedra(1, GetLinearField));
  const auto expected = MakeLinearPicture(scene.GetWindow().GetCamera(), Width, Height);
  for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
  {
    for (int order = 1; order <= (type < VTK_LAGRANGE_CURVE ? 1 : 3); ++order)
    {
      CHECK_CASE(type);
      CHECK_CASE(order);
      const auto mesh = MakeCube(type, order);
      if (mesh && mesh->GetCell(0)->GetCellDimension() < 3)
      {
        scene.Draw(mesh, "The input has no 3D cells.");
        scene.Cast(mesh, "The input has no 3D cells.");
        CHECK_EQUAL(GetMost(scene.GetDrawn()), 0.0);
      }
      else if (mesh)
      {
        scene.Test(mesh, "");
        CHECK_LESS(CompareInside(scene.GetDrawn(), expected, Width), 1.0);
        CHECK_EQUAL(
          scene.GetWindow().GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
        ++solid;
      }
    }
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  CHECK_EQUAL(solid, 32); // the source also makes voxels, triquadratic hexahedra and polyhedra
#else
  CHECK_EQUAL(solid, 29);
#endif
}

// Curved cells that are inside out, flat, tangled, or have no position or a weight of 0.
void TestCurved(RelevoCheck& check, Scene& scene)
{
  const auto good = MakeTetrahedra(2, GetLinearField);
  for (int type : { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
         VTK_QUADRATIC_PYRAMID, VTK_BEZIER_HEXAHEDRON })
  {
    CHECK_CASE(type);
    auto mesh = MakeCube(type, 2);
    const std::string all = std::to_string(mesh->GetNumberOfCells());
    const vtkIdType last = mesh->GetNumberOfPoints() - 1;
    scene.See(mesh);
    Move(mesh, [](const RelevoPoint& at) { return RelevoPoint{ { 1.0 - at[0], at[1], at[2] } }; });
    scene.Test(mesh, "");
    CHECK_GREATER(GetMost(scene.GetDrawn()), 0.3);
    Move(mesh, [](const RelevoPoint& at) { return RelevoPoint{ { at[0], at[1], 0.0 } }; });
    const bool isOne = mesh->GetNumberOfCells() == 1;
    scene.Test(mesh, all + " of " + all + (isOne ? " cell has" : " cells have") + " no volume");
    CHECK_EQUAL(GetMost(scene.GetDrawn()), 0.0);
    mesh = MakeCube(type, 2);
    mesh->GetPoints()->SetPoint(last, std::nan(""), 0.5, 0.5);
    scene.Test(mesh, " no volume, or points that are not finite");

    // A tangled cell beside good cells.
    mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    mesh->DeepCopy(good);
    const auto cell = MakeCube(type, 2);
    vtkNew<vtkIdList> nodes;
    cell->GetCellPoints(0, nodes);
    std::vector<RelevoPoint> points(static_cast<size_t>(nodes->GetNumberOfIds()));
    for (size_t i = 0; i < points.size(); ++i)
    {
      cell->GetPoint(nodes->GetId(static_cast<vtkIdType>(i)), points[i].data());
      points[i][0] += 20.0;
    }
    std::swap(points[0], points[1]);
    AddCell(mesh, type, points);
    scene.GetWindow().GetMapper()->SetShapeTolerance(0.1);
    scene.GetWindow().GetMapper()->SetFieldTolerance(0.1);
    scene.TestRest(good, mesh, "1 of 49 cells is tangled");
    CHECK_EQUAL(scene.GetWindow().GetMapper()->GetNumberOfDrawnCells(), 49);
    scene.GetWindow().GetMapper()->SetShapeTolerance(5e-4);
    scene.GetWindow().GetMapper()->SetFieldTolerance(4e-3);
  }
  const auto mesh = MakeCube(VTK_BEZIER_HEXAHEDRON, 2);
  vtkNew<vtkDoubleArray> weights;
  weights->SetNumberOfTuples(mesh->GetNumberOfPoints());
  weights->Fill(1.0);
  weights->SetValue(9, 0.0);
  mesh->GetPointData()->SetRationalWeights(weights);
  scene.Draw(mesh, "point 9 has the weight 0 in \"RationalWeights\"");
  scene.Cast(mesh, "point 9 has the weight 0 in \"RationalWeights\"");
  CHECK_EQUAL(GetMost(scene.GetDrawn()), 0.0);
}

// A Lagrange hexahedron of degree 3 that is bent to a ring, so that two of its faces meet.
void TestRing(RelevoCheck& check, Scene& scene)
{
  const int order[4] = { 3, 1, 1, 16 };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(16);
  vtkNew<vtkDoubleArray> field;
  field->SetNumberOfTuples(16);
  for (int i = 0; i < 16; ++i)
  {
    const int steps[3] = { i % 4, i / 4 % 2, i / 8 };
    const int id = vtkHigherOrderHexahedron::PointIndexFromIJK(steps[0], steps[1], steps[2], order);
    const double angle = vtkMath::RadiansFromDegrees(120.0 * (steps[0] % 3));
    const double radius = 1.0 + steps[1];
    points->SetPoint(id, radius * std::cos(angle), radius * std::sin(angle), steps[2]);
    field->SetValue(id, steps[0] / 3.0);
  }
  vtkNew<vtkUnstructuredGrid> mesh;
  mesh->SetPoints(points);
  std::vector<vtkIdType> ids(16);
  std::iota(ids.begin(), ids.end(), 0);
  mesh->InsertNextCell(VTK_LAGRANGE_HEXAHEDRON, 16, ids.data());
  mesh->GetPointData()->SetScalars(field);
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetNumberOfComponents(3);
  degrees->InsertNextTuple3(3, 1, 1);
  mesh->GetCellData()->SetHigherOrderDegrees(degrees);
  scene.See(mesh);
  scene.Test(mesh, "", 2.5);
  CHECK_GREATER(GetMost(scene.GetDrawn()), 0.3);
}

// Cells whose number of nodes or degree does not suit their type.
void TestNodes(RelevoCheck& check, Scene& scene)
{
  const auto good = MakeTetrahedra(2, GetLinearField);
  const std::vector<std::pair<int, int>> wrong = { { VTK_HEXAHEDRON, 20 },
    { VTK_QUADRATIC_HEXAHEDRON, 8 }, { VTK_TETRA, 10 }, { VTK_TRIQUADRATIC_HEXAHEDRON, 26 },
    { VTK_POLYHEDRON, 8 }, { VTK_LAGRANGE_WEDGE, 7 } };
  for (const auto& [type, nodes] : wrong)
  {
    CHECK_CASE(type);
    vtkNew<vtkUnstructuredGrid> mesh;
    mesh->DeepCopy(good);
    std::vector<vtkIdType> ids(static_cast<size_t>(nodes));
    std::iota(ids.begin(), ids.end(), 0);
    if (type == VTK_POLYHEDRON)
    {
      const vtkIdType face[4] = { 3, 0, 1, 30 };
      mesh->InsertNextCell(type, nodes, ids.data(), 1, face);
    }
    else
    {
      mesh->InsertNextCell(type, nodes, ids.data());
    }
    scene.TestRest(good, mesh,
      type == VTK_POLYHEDRON ? "it refers to point 30, but there are 27 points."
                             : "cannot have " + std::to_string(nodes) + " nodes.");
  }
  for (const auto& [type, nodes] : { std::make_pair(int(VTK_LAGRANGE_HEXAHEDRON), 1000),
         std::make_pair(int(VTK_BEZIER_TETRAHEDRON), 220) })
  {
    CHECK_CASE(type);
    vtkNew<vtkUnstructuredGrid> mesh;
    mesh->DeepCopy(good);
    AddCell(mesh, type, std::vector<RelevoPoint>(static_cast<size_t>(nodes)));
    scene.TestRest(
      good, mesh, "degrees are 9, 9, 9, but degrees must be whole numbers from 1 to 8.");
  }
}

// Doubled cells look like single ones. Three cells on a face are all drawn.
void TestShared(RelevoCheck& check, Scene& scene)
{
  const std::string words = "several cells on the same side. Where these cells overlap";
  for (int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON })
  {
    CHECK_CASE(type);
    const auto good = MakeCube(type, 2);
    vtkNew<vtkUnstructuredGrid> mesh;
    mesh->DeepCopy(good);
    vtkNew<vtkIdList> nodes;
    good->GetCellPoints(0, nodes);
    mesh->InsertNextCell(type, nodes);
    scene.TestRest(good, mesh, words);
  }
  for (const bool hasOwnPoints : { false, true })
  {
    const auto mesh = MakeTetrahedra(1, [](const RelevoPoint&) { return 0.5; });
    for (const double x : { 0.4, 0.8 })
    {
      AddCell(mesh, VTK_TETRA,
        { { { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 1.0, 1.0, 0.0 } },
          { { x, 0.3, -0.7 } } });
      if (!hasOwnPoints)
      {
        const vtkIdType ids[4] = { 0, 1, 3, mesh->GetNumberOfPoints() - 1 };
        mesh->GetCells()->ReplaceCellAtId(mesh->GetNumberOfCells() - 1, 4, ids);
      }
    }
    scene.See(mesh);
    scene.Test(mesh, "1 face has " + words, 1.5);
    CHECK_EQUAL(scene.GetWindow().GetMapper()->GetNumberOfDrawnCells(), 8);
  }
}

// Coordinates of 1e30, which are too large for squares of floats, and larger ones.
void TestHuge(RelevoCheck& check, Scene& scene)
{
  for (int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON })
  {
    CHECK_CASE(type);
    const auto mesh = MakeCube(type, 2);
    Move(mesh,
      [](const RelevoPoint& at) {
        return RelevoPoint{ { 1e30 * at[0], 1e30 * at[1], 1e30 * at[2] } };
      });
    scene.GetWindow().GetVolume()->GetProperty()->SetScalarOpacityUnitDistance(5e29);
    scene.See(mesh);
    scene.Test(mesh, "");
    CHECK_GREATER(GetMost(scene.GetDrawn()), 0.3);
  }
  const auto mesh = MakeTetrahedra(2, GetLinearField);
  Move(mesh,
    [](const RelevoPoint& at) {
      return RelevoPoint{ { 1e60 * at[0], 1e60 * at[1], 1e60 * at[2] } };
    });
  scene.See(mesh);
  scene.Draw(mesh, "The mesh is larger than 1e36 in world coordinates");
  scene.GetWindow().GetVolume()->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  const auto good = MakeTetrahedra(2, GetLinearField);
  for (const double far : { 1e30, 1e300 })
  {
    CHECK_CASE(far);
    vtkNew<vtkUnstructuredGrid> more;
    more->DeepCopy(good);
    AddCell(more, VTK_TETRA,
      { { { 3.0, 0.0, 0.0 } }, { { 4.0, 0.0, 0.0 } }, { { 3.0, 1.0, 0.0 } },
        { { 3.0, 0.0, far } } });
    scene.TestRest(good, more, "1 of 49 cells has no volume");
  }
}
}

int TestGPUUnstructuredGridVolumeMapperBadCells(int, char*[])
{
  RelevoCheck check;
  Scene scene(check);
  TestTypes(check, scene);
  TestCurved(check, scene);
  TestRing(check, scene);
  TestNodes(check, scene);
  TestShared(check, scene);
  TestHuge(check, scene);
  return check.GetResult();
}

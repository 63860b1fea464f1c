// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that for invalid input the mapper reports the cause once, draws nothing and does not
// disturb rendering. After a correction it draws again.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataSet.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace
{
using namespace RelevoMeshes;

const double NaN = std::numeric_limits<double>::quiet_NaN();

// Claims more samples than any texture can store, and has none.
class HugeHeights : public vtkHeightField
{
public:
  static HugeHeights* New()
  {
    HugeHeights* result = new HugeHeights;
    result->InitializeObjectBase();
    return result;
  }
  vtkTypeMacro(HugeHeights, vtkHeightField);
  bool Update() override { return true; }
  void GetDimensions(int dimensions[2]) override
  {
    dimensions[0] = 1 << 20;
    dimensions[1] = 3;
  }
  void GetRange(double range[2]) override
  {
    range[0] = 0.0;
    range[1] = 1.0;
  }
  bool HasNoData() override { return false; }
  vtkMTimeType GetSamplesMTime() override { return this->GetMTime(); }
  const float* GetSamples() override { return nullptr; }
  const unsigned char* GetValidity() override { return nullptr; }
};

// A metric that cannot be evaluated.
class NoMetric : public vtkDepthTagMetric
{
public:
  static NoMetric* New()
  {
    NoMetric* result = new NoMetric;
    result->InitializeObjectBase();
    return result;
  }
  bool IsViewDependent() override { return false; }
  bool ComputeTags(vtkPolyData*, const relevo::RefinementView&, int, vtkFloatArray*) override
  {
    return false;
  }
};

// A refined actor next to an ordinary one, which must always be drawn.
struct View
{
  RelevoCheck& Check;
  RelevoScene Scene{ RelevoScene::Refining };
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkAdaptiveRefinementMapper* Mapper;
  RelevoErrors Errors;

  View(RelevoCheck& check, vtkDataObject* mesh)
    : Check(check)
    , Mapper(vtkAdaptiveRefinementMapper::SafeDownCast(Scene.Add(mesh, Recipe)->GetMapper()))
    , Errors(Mapper)
  {
    this->Recipe->SetMaximumLevel(2);
    vtkNew<vtkPolyDataMapper> mapper;
    const double below[3] = { 0, -2, 0 };
    mapper->SetInputData(Moved(Cube(), 1, below, VTK_FLOAT));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Scene.Renderer->AddActor(actor);
    const double bounds[6] = { -1, 1, -3, 1, -1, 1 };
    this->Scene.Renderer->ResetCamera(bounds);
  }

  // Number of pixels drawn in the upper half, with the refined actor, and in the lower half.
  std::array<size_t, 2> Draw()
  {
    this->Scene.Render();
    const RelevoPicture picture(this->Scene.Window);
    std::array<size_t, 2> count{ { 0, 0 } };
    const size_t half = picture.GetNumberOfPixels() / 2;
    for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
    {
      if (!std::equal(&picture.Colors[0], &picture.Colors[0] + 3, &picture.Colors[3 * i]))
      {
        ++count[i < half ? 1 : 0];
      }
    }
    return count;
  }

  // Expects an error with these words, only the other actor, and no further messages.
  void TestFails(const std::string& words)
  {
    const auto drawn = this->Draw();
    const bool said = this->Errors.Said(words);
    this->Draw();
    this->Scene.Renderer->GetActiveCamera()->Azimuth(1);
    const auto again = this->Draw();
    const bool quiet = this->Errors.None();
    const bool nothing =
      drawn[0] == 0 && again[0] == 0 && this->Mapper->GetNumberOfDrawnTriangles() == 0;
    if (!said || !quiet || !nothing || drawn[1] == 0 || again[1] == 0)
    {
      std::ostringstream text;
      text << "\"" << words << "\"" << (said ? "" : ": not reported")
           << (quiet ? "" : ": reported again") << (nothing ? "" : ": something is drawn")
           << (drawn[1] ? "" : ": no other actor");
      this->Check.Fail(__FILE__, __LINE__, text.str());
    }
  }

  void TestWorks(const std::string& what)
  {
    const auto drawn = this->Draw();
    if (drawn[0] == 0 || drawn[1] == 0 || !this->Errors.None() ||
      this->Mapper->GetNumberOfDrawnTriangles() == 0)
    {
      this->Check.Fail(__FILE__, __LINE__, what + ": not drawn again");
    }
  }
};

void TestRecipe(RelevoCheck& check)
{
  View view(check, Cube());
  view.TestWorks("cube");
  view.Mapper->SetRefinement(nullptr);
  view.TestFails("no recipe");
  view.Mapper->SetRefinement(view.Recipe);
  view.TestWorks("recipe");
}

void TestTags(RelevoCheck& check)
{
  Mesh mesh = Sphere(8, 6);
  AddTags(mesh, 1, 3);
  View view(check, mesh);
  view.TestWorks("tags");
  mesh->GetPointData()->GetArray("DepthTag")->SetComponent(7, 0, NaN);
  mesh->Modified();
  view.TestFails("is NaN at point 7");
  mesh->GetPointData()->GetArray("DepthTag")->SetComponent(7, 0, 2);
  mesh->Modified();
  view.TestWorks("tags put right");
  mesh->GetPointData()->GetArray("DepthTag")->SetNumberOfTuples(5);
  mesh->Modified();
  view.TestFails("5 tuples");
  view.Recipe->SetDepthTagArrayName("Other");
  view.TestWorks("no tags");
  vtkNew<vtkFloatArray> pairs;
  pairs->SetName("Other");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(mesh->GetNumberOfPoints());
  pairs->Fill(1);
  mesh->GetPointData()->AddArray(pairs);
  view.TestFails("2 components");
  vtkNew<vtkStringArray> words;
  words->SetName("Words");
  words->SetNumberOfValues(mesh->GetNumberOfPoints());
  mesh->GetPointData()->AddArray(words);
  view.Recipe->SetDepthTagArrayName("Words");
  view.TestFails("holds no numbers");
}

void TestTextureCoordinates(RelevoCheck& check, View& view, vtkPolyData* mesh)
{
  view.TestFails("texture coordinates");
  AddTextureCoordinates(mesh,
    [](const double* p) {
      return std::array<double, 2>{ { p[0] + 0.5, p[1] + 0.5 } };
    });
  view.TestWorks("texture coordinates");
  mesh->GetPointData()->GetTCoords()->SetComponent(3, 1, NaN);
  mesh->Modified();
  view.Draw();
  CHECK(view.Errors.Said("texture coordinate"));
  mesh->GetPointData()->GetTCoords()->SetComponent(3, 1, 0.5);
  mesh->Modified();
  view.TestWorks("texture coordinates put right");
}

void TestHeights(View& view, vtkDisplacement* displacement)
{
  vtkSmartPointer<vtkHeightField> heights = displacement->GetHeightMap();
  vtkNew<HugeHeights> huge;
  displacement->SetHeightMap(huge);
  view.TestFails("1048576 x 3");
  displacement->SetHeightMap(heights);
  view.TestWorks("heights put right");

  vtkNew<RelevoHeights> none;
  RelevoErrors ofHeights(none);
  RelevoErrors ofDisplacement(displacement);
  displacement->SetHeightMap(none);
  view.TestFails("height map could not be read");
  none->FillRandom(10, 10, 1);
  view.TestWorks("heights filled");
}

void TestDisplacement(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(10, 10, 1);
  auto displacement = MakeDisplacement(heights, 0.1);
  Mesh mesh = Sphere(8, 6);
  View view(check, mesh);
  view.Recipe->SetDisplacement(displacement);
  TestTextureCoordinates(check, view, mesh);
  TestHeights(view, displacement);
}

void TestMetric(RelevoCheck& check)
{
  vtkNew<NoMetric> metric;
  View view(check, Cube());
  view.Recipe->SetMetric(metric);
  view.TestFails("returned no depth-tags");
  view.Recipe->SetMetric(nullptr);
  view.TestWorks("metric");
}

// Empty input is not an error.
void TestNothing(RelevoCheck& check)
{
  vtkNew<vtkPolyData> nothing;
  View view(check, nothing);
  CHECK_EQUAL(view.Draw()[0], 0);
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), 0);
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawCalls(), 0);
  Mesh lone = Make();
  lone->SetPoints(Cube()->GetPoints());
  view.Mapper->SetInputDataObject(lone);
  CHECK_EQUAL(view.Draw()[0], 0);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0, 1, 2, 3 });
  lone->SetVerts(verts);
  view.Scene.GetActor(0)->GetProperty()->SetPointSize(5);
  CHECK_GREATER(view.Draw()[0], 0); // vertices only
  vtkNew<vtkMultiBlockDataSet> blocks;
  view.Mapper->SetInputDataObject(blocks);
  CHECK_EQUAL(view.Draw()[0], 0);
  CHECK(view.Errors.None());
}

// NaN points and cells without area give a warning, and the rest is drawn.
void TestPoints(RelevoCheck& check)
{
  Mesh mesh = Sphere(8, 6);
  mesh->GetPoints()->SetPoint(9, NaN, 0, 0);
  View view(check, mesh);
  vtkNew<vtkPNTriangleSurface> surface;
  view.Recipe->SetSurface(surface);
  const auto drawn = view.Draw();
  CHECK_GREATER(drawn[0], 100);
  CHECK(view.Errors.Warned("degenerate"));
  CHECK_EQUAL(view.Draw(), drawn);
  CHECK(view.Errors.None());
  double bounds[6];
  view.Mapper->GetBounds(bounds);
  CHECK(bounds[1] <= 0.51 && bounds[0] >= -0.51);
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  RelevoErrors ofFilter(filter);
  filter->SetInputData(mesh);
  filter->SetRefinement(view.Recipe);
  filter->Update();
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), filter->GetOutput()->GetNumberOfPolys());
}

// Cells that refer to missing points.
void TestCells(RelevoCheck& check)
{
  Mesh mesh = Cube();
  View view(check, mesh);
  view.TestWorks("cube");
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 0, 1, 99 });
  vtkNew<vtkPolyData> broken;
  broken->SetPoints(mesh->GetPoints());
  broken->SetPolys(polys);
  view.Mapper->SetInputDataObject(broken);
  view.TestFails("cell 1 refers to point 99, but there are 24 points");
}

// The user's mapper reports errors of blocks, and other blocks are drawn.
void TestBlocks(RelevoCheck& check)
{
  Mesh good = Cube();
  Mesh bad = Sphere(8, 6);
  AddTags(bad, 1, 2);
  bad->GetPointData()->GetArray("DepthTag")->SetComponent(2, 0, NaN);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, good);
  blocks->SetBlock(1, bad);
  View view(check, blocks);
  CHECK_GREATER(view.Draw()[0], 0);
  CHECK(view.Errors.Said("is NaN at point 2"));
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), 12 * 16);
  view.Draw();
  CHECK(view.Errors.None());
  view.Mapper->SetRefinement(nullptr);
  view.Draw();
  CHECK(view.Errors.Said("no recipe"));
}

// Inputs and blocks of other types.
void TestTypes(RelevoCheck& check)
{
  const auto cube = Cube();
  View view(check, cube);
  view.TestWorks("cube");
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkTable> table;
    view.Mapper->SetInputDataObject(table);
    view.TestFails("The input is a vtkTable; a vtkPolyData or a vtkCompositeDataSet is needed.");
  }
  vtkNew<vtkUnstructuredGrid> grid;
  view.Mapper->SetInputDataObject(grid);
  view.TestFails("The input is a vtkUnstructuredGrid; a vtkPolyData or a ");
  view.Mapper->SetInputDataObject(cube);
  view.TestWorks("cube again");

  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkTable> table;
  blocks->SetBlock(0, cube);
  blocks->SetBlock(1, table);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "history");
  view.Mapper->SetInputDataObject(blocks);
  CHECK_GREATER(view.Draw()[0], 0);
  CHECK(view.Errors.Said(
    "Block 2 (\"history\") is a vtkTable; a vtkPolyData is needed; it is left out."));
  view.TestWorks("the other block");
  blocks->SetBlock(0, table);
  view.Draw();
  CHECK(
    view.Errors.Said("Block 1 is a vtkTable; a vtkPolyData is needed; it is left out. Block 2"));
  CHECK_EQUAL(view.Draw()[0], 0);
  CHECK(view.Errors.None());
}

void TestNoInput(RelevoCheck& check)
{
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  mapper->SetRefinement(vtkSmartPointer<vtkAdaptiveRefinement>::New());
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), 0);
  CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), 0);
  CHECK_EQUAL(mapper->GetNumberOfCoarseFaces(), 0);
  CHECK_EQUAL(mapper->GetGraphicsMemorySize(), 0);
  std::ostringstream text;
  mapper->Print(text);
  CHECK_NOT_EQUAL(text.str().find("NumberOfDrawnTriangles: 0"), std::string::npos);
}
}

int TestAdaptiveRefinementMapperErrors(int, char*[])
{
  RelevoCheck check;
  TestRecipe(check);
  TestTags(check);
  TestDisplacement(check);
  TestMetric(check);
  TestNothing(check);
  TestPoints(check);
  TestCells(check);
  TestBlocks(check);
  TestTypes(check);
  TestNoInput(check);
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveLICMapper promises streaks on composite data: blocks with point vectors, cell vectors
// or none, nested blocks and empty blocks.
#include "RelevoLICVectors.h"
#include "RelevoPictures.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <cmath>

namespace
{
using namespace RelevoMeshes;

constexpr int Size = 200; // pixels of a picture; each block has half of it
constexpr int Reach = 16; // length of streamlines in pixels

vtkAdaptiveRefinementMapper* NewMapper(vtkDataObject*)
{
  vtkAdaptiveLICMapper* mapper = vtkAdaptiveLICMapper::New();
  mapper->SetNumberOfSteps(8);
  mapper->SetLICIntensity(1.0);
  mapper->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, "Flow");
  return mapper;
}

// A square of side 1 whose lower left corner is (x, y).
Mesh Square(double x, double y)
{
  const double offset[3] = { x + 0.5, y + 0.5, 0.0 };
  return Moved(Plane(3, 3), 1.0, offset, VTK_FLOAT);
}

Mesh WithPointVectors(Mesh mesh, double x, double y)
{
  RelevoLICVectors::AddVectors(mesh,
    [x, y](const double*) {
      return std::array<double, 3>{ { x, y, 0.0 } };
    });
  return mesh;
}

Mesh WithCellVectors(Mesh mesh, double x, double y)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Flow");
  vectors->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vectors->InsertNextTuple2(x, y);
  }
  mesh->GetCellData()->AddArray(vectors);
  return mesh;
}

struct View
{
  RelevoScene Scene{ RelevoScene::Refining };
  vtkAdaptiveLICMapper* Mapper;
  RelevoErrors Errors;

  explicit View(vtkDataObject* data)
    : Mapper(RelevoLICVectors::GetMapper(this->Scene.Add(data, MakeRecipe(1))))
    , Errors(Mapper)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetPosition(1, 1, 5);
    camera->SetFocalPoint(1, 1, 0);
    camera->SetParallelScale(1.0);
    this->Scene.Window->SetSize(Size, Size);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  RelevoPicture Draw()
  {
    this->Scene.Render();
    return RelevoPicture(this->Scene.Window);
  }
};

// A quarter of a picture without a margin.
RelevoPicture Quarter(const RelevoPicture& picture, int column, int row, int margin)
{
  const int size = Size / 2 - 2 * margin;
  return RelevoPictures::Crop(
    picture, column * Size / 2 + margin, row * Size / 2 + margin, size, size);
}

// Point vectors to the right, cell vectors upwards, none, and nested ones to the upper left.
struct Blocks
{
  const Mesh Points = WithPointVectors(Square(0, 0), 3, 0);
  const Mesh Cells = WithCellVectors(Square(1, 0), 0, 0.5);
  const Mesh Bare = Square(0, 1);
  const Mesh Nested = WithPointVectors(Square(1, 1), -1, 1);
  View All{ this->Gather() };
  const RelevoPicture Picture = this->All.Draw();

  vtkSmartPointer<vtkMultiBlockDataSet> Gather() const
  {
    vtkNew<vtkMultiBlockDataSet> inner;
    inner->SetBlock(1, this->Nested);
    inner->SetBlock(2, vtkSmartPointer<vtkPolyData>::New());
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, this->Points);
    blocks->SetBlock(1, nullptr);
    blocks->SetBlock(2, this->Cells);
    blocks->SetBlock(3, this->Bare);
    blocks->SetBlock(4, inner);
    blocks->SetBlock(5, vtkSmartPointer<vtkMultiBlockDataSet>::New());
    return blocks;
  }

  RelevoPicture DrawPlain()
  {
    this->All.Mapper->EnableOff();
    RelevoPicture plain = this->All.Draw();
    this->All.Mapper->EnableOn();
    return plain;
  }
};

// One convolution serves all blocks.
void TestConvolutions(RelevoCheck& check, Blocks& blocks)
{
  CHECK(blocks.All.Errors.None());
  CHECK_EQUAL(blocks.All.Mapper->GetNumberOfConvolutions(), 1);
  blocks.All.Draw();
  CHECK_EQUAL(blocks.All.Mapper->GetNumberOfConvolutions(), 1);
}

// Away from its neighbours, each block looks like a single one.
void TestNeighbours(RelevoCheck& check, RelevoComparison& comparison, const Blocks& blocks)
{
  const struct
  {
    const char* Name;
    Mesh Block;
    int Column;
    int Row;
  } parts[] = { { "Points", blocks.Points, 0, 0 }, { "Cells", blocks.Cells, 1, 0 },
    { "Nested", blocks.Nested, 1, 1 } };
  for (const auto& part : parts)
  {
    CHECK_CASE(part.Name);
    View alone(part.Block);
    comparison.Compare(std::string("LICBlocks.") + part.Name, { 0, 1e-6, 0 },
      Quarter(blocks.Picture, part.Column, part.Row, Reach),
      Quarter(alone.Draw(), part.Column, part.Row, Reach));
    CHECK(alone.Errors.None());
  }
}

void TestBlockWithoutVectors(RelevoCheck& check, const Blocks& blocks, const RelevoPicture& plain)
{
  CHECK_EQUAL(Quarter(blocks.Picture, 0, 1, 2).Colors, Quarter(plain, 0, 1, 2).Colors);
}

// Up to the border, streaks follow their block's vectors: neighbouring pixels differ less along
// them.
void TestStreaks(RelevoCheck& check, const Blocks& blocks)
{
  for (const int column : { 0, 1 })
  {
    CHECK_CASE(column);
    const RelevoPicture part = Quarter(blocks.Picture, column, 0, 1);
    double along[2] = { 0.0, 0.0 };
    for (int y = 0; y + 1 < part.Size[1]; ++y)
    {
      for (int x = 0; x + 1 < part.Size[0]; ++x)
      {
        const size_t i = static_cast<size_t>(y) * part.Size[0] + x;
        along[0] += std::abs(part.Colors[3 * i] - part.Colors[3 * i + 3]);
        along[1] += std::abs(part.Colors[3 * i] - part.Colors[3 * (i + part.Size[0])]);
      }
    }
    CHECK_LESS(2.0 * along[column], along[1 - column]);
  }
}

void TestLostVectors(
  RelevoCheck& check, RelevoComparison& comparison, Blocks& blocks, const RelevoPicture& plain)
{
  blocks.Points->GetPointData()->RemoveArray("Flow");
  blocks.Points->Modified();
  const RelevoPicture fewer = blocks.All.Draw();
  CHECK(blocks.All.Errors.None());
  CHECK_EQUAL(Quarter(fewer, 0, 0, 2).Colors, Quarter(plain, 0, 0, 2).Colors);
  comparison.Compare("LICBlocks.Kept", { 0, 0.0, 0 }, Quarter(fewer, 1, 1, Reach),
    Quarter(blocks.Picture, 1, 1, Reach));
}

// Another array of this name is an error.
void TestReplacedVectors(
  RelevoCheck& check, RelevoComparison& comparison, Blocks& blocks, const RelevoPicture& plain)
{
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Flow");
  scalars->SetNumberOfTuples(blocks.Points->GetNumberOfPoints());
  scalars->Fill(1.0);
  blocks.Points->GetPointData()->AddArray(scalars);
  blocks.Points->Modified();
  CHECK_EQUAL(blocks.All.Draw().Colors, plain.Colors);
  CHECK(blocks.All.Errors.Said("\"Flow\" has 1 component"));
  WithPointVectors(blocks.Points, 3, 0);
  blocks.Points->Modified();
  comparison.Compare("LICBlocks.Again", {}, blocks.All.Draw(), blocks.Picture);
  CHECK(blocks.All.Errors.None());
}

void TestNoVectors(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> bare;
  bare->SetBlock(0, Square(0, 0));
  bare->SetBlock(1, Square(1, 1));
  View nothing(bare);
  nothing.Draw();
  nothing.Draw();
  CHECK(nothing.Errors.Said("does not have the array of vectors"));
  nothing.Draw();
  CHECK(nothing.Errors.None());
}
}

int TestAdaptiveLICMapperBlocks(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  RelevoScene::NewMapper = NewMapper;

  Blocks blocks;
  TestConvolutions(check, blocks);
  TestNeighbours(check, comparison, blocks);
  const RelevoPicture plain = blocks.DrawPlain();
  TestBlockWithoutVectors(check, blocks, plain);
  TestStreaks(check, blocks);
  TestLostVectors(check, comparison, blocks, plain);
  TestReplacedVectors(check, comparison, blocks, plain);
  TestNoVectors(check);
  return check.GetResult();
}

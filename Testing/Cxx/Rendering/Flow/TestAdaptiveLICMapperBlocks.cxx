// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A LIC on blocks: vectors of points, of cells, or none; nested and empty blocks.
#include "RelevoLICVectors.h"
#include "RelevoTestMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace RelevoMeshes;

constexpr int Size = 200; // pixels of a picture; a block has half of each
constexpr int Reach = 16; // pixels that streamlines cross

vtkAdaptiveRefinementMapper* NewMapper(vtkDataObject*)
{
  vtkAdaptiveLICMapper* mapper = vtkAdaptiveLICMapper::New();
  mapper->SetNumberOfSteps(8);
  mapper->SetLICIntensity(1.0);
  mapper->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, "Flow");
  return mapper;
}

// A square whose lower left corner is (x, y), of side 1.
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

// The quarter of a picture, without a margin.
RelevoPicture Quarter(const RelevoPicture& picture, int column, int row, int margin)
{
  const int size = Size / 2 - 2 * margin;
  RelevoPicture part(size, size);
  for (int y = 0; y < size; ++y)
  {
    const size_t from = static_cast<size_t>(row * Size / 2 + margin + y) * Size +
      static_cast<size_t>(column * Size / 2 + margin);
    std::copy_n(
      &picture.Colors[3 * from], 3 * size, &part.Colors[3 * static_cast<size_t>(y) * size]);
    std::copy_n(&picture.Depths[from], size, &part.Depths[static_cast<size_t>(y) * size]);
  }
  return part;
}
}

int TestAdaptiveLICMapperBlocks(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  RelevoScene::NewMapper = NewMapper;

  // Vectors of points, to the right; of cells, upwards; none; and nested, to the upper left.
  const Mesh points = WithPointVectors(Square(0, 0), 3, 0);
  const Mesh cells = WithCellVectors(Square(1, 0), 0, 0.5);
  const Mesh none = Square(0, 1);
  const Mesh nested = WithPointVectors(Square(1, 1), -1, 1);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(1, nested);
  inner->SetBlock(2, vtkSmartPointer<vtkPolyData>::New());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, points);
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, cells);
  blocks->SetBlock(3, none);
  blocks->SetBlock(4, inner);
  blocks->SetBlock(5, vtkSmartPointer<vtkMultiBlockDataSet>::New());
  View view(blocks);
  const RelevoPicture picture = view.Draw();
  CHECK(view.Errors.None());
  CHECK(view.Mapper->GetNumberOfConvolutions() == 1);
  view.Draw();
  CHECK(view.Mapper->GetNumberOfConvolutions() == 1);

  // Each as if it were alone, away from its neighbours.
  const struct
  {
    const char* Name;
    Mesh Block;
    int Column;
    int Row;
  } parts[] = { { "Points", points, 0, 0 }, { "Cells", cells, 1, 0 }, { "Nested", nested, 1, 1 } };
  for (const auto& part : parts)
  {
    View alone(part.Block);
    comparison.Compare(std::string("LICBlocks.") + part.Name, { 0, 1e-6, 0 },
      Quarter(picture, part.Column, part.Row, Reach),
      Quarter(alone.Draw(), part.Column, part.Row, Reach));
    CHECK(alone.Errors.None());
  }
  view.Mapper->EnableOff();
  const RelevoPicture plain = view.Draw();
  view.Mapper->EnableOn();
  CHECK(Quarter(picture, 0, 1, 2).Colors == Quarter(plain, 0, 1, 2).Colors);

  // Streaks go with their block's vectors up to its border: neighbours differ less along them.
  for (const int column : { 0, 1 })
  {
    const RelevoPicture part = Quarter(picture, column, 0, 1);
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
    CHECK(2.0 * along[column] < along[1 - column]);
  }

  // A block that changes or loses its vectors; one with something else is an error.
  points->GetPointData()->RemoveArray("Flow");
  points->Modified();
  const RelevoPicture fewer = view.Draw();
  CHECK(view.Errors.None());
  CHECK(Quarter(fewer, 0, 0, 2).Colors == Quarter(plain, 0, 0, 2).Colors);
  comparison.Compare(
    "LICBlocks.Kept", { 0, 0.0, 0 }, Quarter(fewer, 1, 1, Reach), Quarter(picture, 1, 1, Reach));
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Flow");
  scalars->SetNumberOfTuples(points->GetNumberOfPoints());
  scalars->Fill(1.0);
  points->GetPointData()->AddArray(scalars);
  points->Modified();
  CHECK(view.Draw().Colors == plain.Colors);
  CHECK(view.Errors.Said("\"Flow\" has 1 component"));
  WithPointVectors(points, 3, 0);
  points->Modified();
  comparison.Compare("LICBlocks.Again", {}, view.Draw(), picture);
  CHECK(view.Errors.None());

  // Without any vectors.
  vtkNew<vtkMultiBlockDataSet> bare;
  bare->SetBlock(0, Square(0, 0));
  bare->SetBlock(1, Square(1, 1));
  View nothing(bare);
  nothing.Draw();
  nothing.Draw();
  CHECK(nothing.Errors.Said("no array of vectors"));
  nothing.Draw();
  CHECK(nothing.Errors.None());
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkBezierPatchReader promises Bézier patches of all degrees as VTK's cells, compared with de
// Casteljau's algorithm.
#include "RelevoCheck.h"
#include "RelevoFiles.h"
#include "RelevoPatchFiles.h"

#include "vtkBezierPatchReader.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <clocale>
#include <locale>

namespace
{
RelevoPatch MakePatch(std::mt19937& random, int first, int second)
{
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  RelevoPatch patch{ first, second, {} };
  for (int i = 0; i < (first + 1) * (second + 1); ++i)
  {
    patch.Points.push_back({ place(random), place(random), place(random) });
  }
  return patch;
}

vtkSmartPointer<vtkUnstructuredGrid> Read(
  RelevoCheck& check, const std::string& name, const std::string& text)
{
  RelevoWriteFile(name, text);
  vtkNew<vtkBezierPatchReader> reader;
  RelevoErrors errors(reader);
  CHECK_EQUAL(reader->CanReadFile(name.c_str()), 1);
  reader->SetFileName(name.c_str());
  reader->Update();
  CHECK(errors.None());
  return reader->GetOutput();
}

void TestDegrees(RelevoCheck& check, const std::string& name)
{
  std::mt19937 random(1);
  std::vector<RelevoPatch> patches;
  for (int k = 0; k < 64; ++k)
  {
    patches.push_back(MakePatch(random, 1 + k % 8, 1 + k / 8));
  }
  auto grid = Read(check, name, RelevoWritePatches(patches));
  CHECK_EQUAL(grid->GetNumberOfCells(), 64);
  CHECK_EQUAL(grid->GetCellData()->GetHigherOrderDegrees(),
    grid->GetCellData()->GetArray("HigherOrderDegrees"));
  CHECK_EQUAL(grid->GetPointData()->GetNumberOfArrays(), 0);
  for (int k = 0; k < 64; ++k)
  {
    double degrees[3];
    grid->GetCellData()->GetHigherOrderDegrees()->GetTuple(k, degrees);
    CHECK_EQUAL(grid->GetCellType(k), VTK_BEZIER_QUADRILATERAL);
    CHECK(degrees[0] == 1 + k / 8 && degrees[1] == 1 + k % 8 && degrees[2] == 0.0);
  }
  CHECK_NEAR(RelevoGetPatchError(grid, patches), 0.0, 1e-14);
}

// Patches share their common borders, even if 0 and -0 are mixed.
void TestBorders(RelevoCheck& check, const std::string& name)
{
  std::mt19937 random(2);
  RelevoPatch left = MakePatch(random, 3, 4);
  RelevoPatch right = MakePatch(random, 2, 4);
  RelevoPatch turned = MakePatch(random, 4, 5);
  left.Points[17][1] = 0.0;
  for (int k = 0; k <= 4; ++k)
  {
    right.Points[k] = left.Points[15 + k];        // right's first row equals left's last
    turned.Points[6 * (4 - k)] = right.Points[k]; // and a column, reversed, of a third patch
  }
  right.Points[2][1] = -0.0;
  const std::vector<RelevoPatch> patches{ left, right, turned };
  auto grid = Read(check, name, RelevoWritePatches(patches));
  CHECK_EQUAL(grid->GetNumberOfPoints(), 20 + 15 + 30 - 10);
  CHECK_NEAR(RelevoGetPatchError(grid, patches), 0.0, 1e-14);

  // Inner points are never merged. A border that collapses to a point is one point.
  RelevoPatch fold = MakePatch(random, 3, 3);
  fold.Points[5] = fold.Points[6];
  auto folded = Read(check, name, RelevoWritePatches({ fold }));
  CHECK_EQUAL(folded->GetNumberOfPoints(), 16);
  fold.Points[1] = fold.Points[2] = fold.Points[3] = fold.Points[0];
  folded = Read(check, name, RelevoWritePatches({ fold }));
  CHECK_EQUAL(folded->GetNumberOfPoints(), 13);
  CHECK_NEAR(RelevoGetPatchError(folded, { fold }), 0.0, 1e-14);
}

// A locale with decimal commas and thousands separators for C++ streams.
class Punctuation : public std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

void TestTexts(RelevoCheck& check, const std::string& name)
{
  const std::vector<RelevoPatch> patches{ { 1, 1,
    { { 0.5, -1234.5, 2e-3 }, { 1, 0, 3 }, { 0, 1, 0 }, { 1, 1, 0.25 } } } };
  const std::locale before =
    std::locale::global(std::locale(std::locale::classic(), new Punctuation));
  std::setlocale(LC_ALL, "de_DE.UTF-8"); // if it is installed
  for (const char* text : {
         "1\n1 1\n0.5 -1234.5 2e-3\n1 0 3\n0 1 0\n1 1 0.25\n",
         "1 1 1 .5 -1.2345E3 0.2e-2 1. 0 3 0 1 0 1 1 0.25", // no line ends
         "\r\n+1\r\n\r\n1\t1\r\n+0.5 -1234.5 2e-3\r\n1 0 3\r\n0 1 0\r\n1 1 +.25\r\n \r\n",
       })
  {
    auto grid = Read(check, name, text);
    CHECK_EQUAL(grid->GetNumberOfCells(), 1);
    CHECK_EQUAL(grid->GetNumberOfPoints(), 4);
    CHECK_NEAR(RelevoGetPatchError(grid, patches), 0.0, 1e-12);
  }
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  CHECK_EQUAL(Read(check, name, "0\n")->GetNumberOfCells(), 0);
}
}

int TestBezierPatchReader(int argc, char* argv[])
{
  RelevoCheck check;
  const std::string name = RelevoMakeFolder(argc, argv, "BezierPatchReader") + "/patches.bpt";
  TestDegrees(check, name);
  TestBorders(check, name);
  TestTexts(check, name);
  return check.GetResult();
}

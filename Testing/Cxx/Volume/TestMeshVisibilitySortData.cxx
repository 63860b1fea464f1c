// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMeshVisibilitySort promises visibility order. The test casts random rays through real meshes:
// concave ones, with empty cells, and with parts that touch but share no points.
#include "RelevoCheck.h"
#include "RelevoVisibility.h"

#include "vtkByteSwap.h"
#include "vtkDataSetReader.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace
{
using Mesh = vtkSmartPointer<vtkUnstructuredGrid>;

// Reads a PLOT3D file: dimensions, x, y and z, and optionally which points are blanked.
Mesh ReadPlot3D(const std::string& file, bool hasBlanks)
{
  std::ifstream stream(file, std::ios::binary);
  int dimensions[3] = { 0, 0, 0 };
  stream.read(reinterpret_cast<char*>(dimensions), sizeof(dimensions));
  vtkByteSwap::Swap4BERange(dimensions, 3);
  const size_t size = static_cast<size_t>(dimensions[0]) * dimensions[1] * dimensions[2];
  std::vector<float> coordinates(3 * size);
  stream.read(reinterpret_cast<char*>(coordinates.data()), sizeof(float) * coordinates.size());
  vtkByteSwap::Swap4BERange(coordinates.data(), coordinates.size());
  std::vector<int> blanks(hasBlanks ? size : 0);
  stream.read(reinterpret_cast<char*>(blanks.data()), sizeof(int) * blanks.size());
  vtkNew<vtkPoints> points;
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(dimensions);
  grid->SetPoints(points);
  for (size_t i = 0; i < size; ++i)
  {
    points->InsertNextPoint(coordinates[i], coordinates[size + i], coordinates[2 * size + i]);
  }
  for (size_t i = 0; i < blanks.size(); ++i)
  {
    if (blanks[i] == 0)
    {
      grid->BlankPoint(static_cast<vtkIdType>(i));
    }
  }
  vtkNew<vtkDataSetTriangleFilter> split;
  split->SetInputData(grid);
  split->TetrahedraOnlyOn();
  split->Update();
  Mesh mesh = split->GetOutput();
  return mesh;
}
}

int TestMeshVisibilitySortData(int, char*[])
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  if (!data || !*data)
  {
    return 125;
  }
  const std::string folder = std::string(data) + "/volume/";
  RelevoCheck check;
  RelevoDice dice(1);
  const Mesh fin = ReadPlot3D(folder + "bluntfinxyz.bin", false);
  CHECK_EQUAL(fin->GetNumberOfCells(), 187395);
  CHECK_EQUAL(CountPairs(check, "blunt fin", fin, dice, 50).Wrong, 0);
  const Mesh post = ReadPlot3D(folder + "postxyz.bin", true);
  CHECK_EQUAL(post->GetNumberOfCells(), 513375);
  CHECK_EQUAL(CountPairs(check, "oxygen post", post, dice, 50).Wrong, 0);
  vtkNew<vtkDataSetReader> reader;
  reader->SetFileName((folder + "post.vtk").c_str());
  reader->Update();
  auto* coarse = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput());
  CHECK(coarse && coarse->GetNumberOfCells() == 8750);
  if (coarse)
  {
    CHECK_EQUAL(CountPairs(check, "coarse post", coarse, dice, 300).Wrong, 0);
  }
  return check.GetResult();
}

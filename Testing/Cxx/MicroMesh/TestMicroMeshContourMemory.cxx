// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshContourFilter takes much less memory than contouring the whole volume, because the
// image and the isosurface are in memory block by block.
#include "RelevoCheck.h"
#include "RelevoSanitizer.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMicroMeshContourFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"

#include <fstream>
#include <functional>
#include <iostream>
#include <string>

namespace
{
constexpr double Value = 240.0;

// The resident memory in kB, now ("VmRSS:") or the most since the last reset ("VmHWM:"); 0 if the
// system does not tell.
double GetMemory(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double size = 0.0;
  while (status >> word)
  {
    if (word == name && status >> size)
    {
      return size;
    }
  }
  return 0.0;
}

// The memory that a step takes, at most.
double MeasurePeak(const std::function<void()>& run)
{
  std::ofstream("/proc/self/clear_refs") << 5 << std::flush; // resets VmHWM
  const double before = GetMemory("VmRSS:");
  run();
  return GetMemory("VmHWM:") - before;
}

vtkIdType ContourBlocks(RelevoCheck& check, int size)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-size, size, -size, size, -size, size);
  vtkNew<vtkMicroMeshContourFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetTolerance(0.3); // the spacing is 1
  filter->SetValue(0, Value);
  filter->SetBlockSize(45);
  filter->Update();
  CHECK(errors.None());
  CHECK_LESS_EQUAL(filter->GetError(), 0.3);
  CHECK_GREATER(filter->GetOutput()->GetNumberOfPolys(), 100);
  return filter->GetNumberOfTriangles();
}

vtkIdType ContourWhole(int size)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-size, size, -size, size, -size, size);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(source->GetOutputPort());
  contour->SetValue(0, Value);
  contour->ComputeNormalsOff();
  contour->Update();
  return contour->GetOutput()->GetNumberOfPolys();
}
}

int TestMicroMeshContourMemory(int, char*[])
{
  RelevoCheck check;
  constexpr int size = 90;
  ContourBlocks(check, 20); // libraries and threads take memory, too
  vtkIdType triangles = 0;
  const double blocks = MeasurePeak([&] { triangles = ContourBlocks(check, size); });
  const double whole = MeasurePeak([&] { CHECK_EQUAL(ContourWhole(size), triangles); });
  std::cout << triangles << " triangles, " << blocks << " kB in blocks, " << whole
            << " kB as a whole\n";
  if (whole > 0.0 && !RelevoHasAddressSanitizer)
  {
    CHECK_LESS(blocks, 0.5 * whole);
  }
  return check.GetResult();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises a result that does not depend on the order of cells or on blocks.
// The test uses real meshes and saves their pictures for inspection.
#include "RelevoCheck.h"
#include "RelevoVolumes.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataSetReader.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <string>

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

void Write(const std::vector<RelevoColor>& picture, const std::string& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(Width, Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const RelevoColor& color : picture)
  {
    for (int c = 0; c < 3; ++c)
    {
      // The picture is composited over white.
      *bytes++ = static_cast<unsigned char>(255.0 * (color[c] + 1.0 - color[3]) + 0.5);
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
}
}

int TestVolumeRayCastFilterData(int argc, char* argv[])
{
  const char* folder = std::getenv("RELEVO_TEST_DATA");
  if (!folder || !*folder)
  {
    return 125;
  }
  RelevoCheck check;
  vtkNew<vtkDataSetReader> reader;
  reader->SetFileName((std::string(folder) + "/volume/post.vtk").c_str());
  reader->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput());
  CHECK(mesh && mesh->GetNumberOfCells() == 8750);
  if (!mesh)
  {
    return check.GetResult();
  }
  vtkNew<vtkVolumeProperty> property;
  vtkColorTransferFunction* color = property->GetRGBTransferFunction();
  color->SetColorSpaceToHSV();
  color->AddRGBPoint(0.36, 0.0, 0.0, 1.0);
  color->AddRGBPoint(1.64, 1.0, 0.0, 0.0);
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.36, 1.0);
  opacity->AddPoint(0.9, 0.0);
  opacity->AddPoint(1.1, 0.1);
  opacity->AddPoint(1.64, 1.0);
  double bounds[6];
  mesh->GetBounds(bounds);
  property->SetScalarOpacityUnitDistance(mesh->GetLength() / 20.0);
  const RelevoPoint middle = { { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) } };
  const double away = mesh->GetLength();
  const auto camera =
    MakeCamera({ { middle[0] + away, middle[1] - away, middle[2] + 0.8 * away } }, middle);
  camera->SetViewUp(0.0, 0.0, 1.0);
  mesh->GetPointData()->SetActiveScalars("Pressure");
  const auto picture = Cast(mesh, property, camera, Width, Height);
  double sum = 0.0;
  for (const RelevoColor& pixel : picture)
  {
    sum += pixel[3];
  }
  CHECK_GREATER(sum, 0.05 * Width * Height);
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == "-T")
    {
      Write(picture, std::string(argv[i + 1]) + "/TestVolumeRayCastFilterData.png");
    }
  }

  vtkNew<vtkUnstructuredGrid> reversed;
  reversed->SetPoints(mesh->GetPoints());
  reversed->GetPointData()->ShallowCopy(mesh->GetPointData());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = mesh->GetNumberOfCells(); i-- > 0;)
  {
    mesh->GetCellPoints(i, ids);
    vtkNew<vtkIdList> turned; // inside out
    for (vtkIdType j = ids->GetNumberOfIds(); j-- > 0;)
    {
      turned->InsertNextId(ids->GetId(j));
    }
    reversed->InsertNextCell(VTK_TETRA, turned);
  }
  CHECK_LESS(FindLargestDifference(Cast(reversed, property, camera, Width, Height), picture), 1e-9);
  return check.GetResult();
}

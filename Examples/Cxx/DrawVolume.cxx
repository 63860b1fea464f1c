// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Renders the volume of a mesh of tetrahedra without a display, and with the filter on the CPU.
 * Prints the middle pixel of both.
 */
#include "vtkCamera.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkEGLOffscreenRenderWindow.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeRayCastFilter.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>

int main()
{
  const int size = 201;
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(VTK_TETRA);
  source->SetBlocksDimensions(4, 4, 4);
  source->Update();
  vtkUnstructuredGrid* mesh = source->GetOutput();
  mesh->GetPointData()->SetActiveScalars("DistanceToCenter");
  double range[2];
  mesh->GetPointData()->GetScalars()->GetRange(range);

  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(range[0], 1.0, 0.4, 0.1);
  color->AddRGBPoint(range[1], 0.1, 0.4, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(range[0], 1.0);
  opacity->AddPoint(range[1], 0.0);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.0); // at opacity 1, 37 % of the light passes this length

  vtkNew<vtkGPUUnstructuredGridVolumeMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkEGLOffscreenRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(size, size);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(1.0, 0.7, 0.9);
  renderer->ResetCamera();
  window->Render();
  const std::unique_ptr<unsigned char[]> drawn(
    window->GetPixelData(size / 2, size / 2, size / 2, size / 2, 0, 0));

  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(mesh);
  filter->SetVolumeProperty(property);
  filter->SetCamera(renderer->GetActiveCamera());
  filter->SetViewportSize(size, size);
  filter->Update();

  bool areAlike = mapper->GetNumberOfDrawnCells() == mesh->GetNumberOfCells();
  for (int c = 0; c < 3; ++c)
  {
    const double cast =
      255.0 * filter->GetOutput()->GetScalarComponentAsDouble(size / 2, size / 2, 0, c);
    std::cout << "GPU " << static_cast<int>(drawn[c]) << ", CPU " << cast << "\n";
    areAlike = areAlike && cast > 5.0 && std::abs(drawn[c] - cast) < 2.0;
  }
  return areAlike ? EXIT_SUCCESS : EXIT_FAILURE;
}

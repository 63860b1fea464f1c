// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMeshVisibilitySort promises to work with vtkProjectedTetrahedraMapper: for a convex mesh of
// even cells the picture equals that of sorting by centres. A wrong order is the negative control.
#include "RelevoCheck.h"
#include "RelevoVolumes.h"
#include "vtkMeshVisibilitySort.h"

#include "vtkCellCenterDepthSort.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"

#include <cmath>
#include <cstdlib>

namespace
{
constexpr int Size = 200;

// Negative control: the nearest cells first, whatever direction the mapper requests.
class WrongSort : public vtkCellCenterDepthSort
{
public:
  static WrongSort* New();
  vtkTypeMacro(WrongSort, vtkCellCenterDepthSort);
  void InitTraversal() override
  {
    this->SetDirectionToFrontToBack();
    this->Superclass::InitTraversal();
  }
};
vtkStandardNewMacro(WrongSort);

vtkSmartPointer<vtkUnsignedCharArray> Draw(
  vtkUnstructuredGrid* mesh, vtkVisibilitySort* sort, vtkCamera* camera)
{
  vtkNew<vtkProjectedTetrahedraMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetVisibilitySort(sort);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(MakeVolumeProperty(1.0, 1.0, 0.3));
  volume->RotateX(20.0);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetActiveCamera(camera);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Size, Size);
  window->AddRenderer(renderer);
  // The first frame of VTK's mapper lacks the cells that GetNextCells() returns first.
  window->Render();
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, Size - 1, Size - 1, 1, pixels);
  return pixels;
}

// Mean difference over pixels that are covered in either picture.
double Compare(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  double sum = 0.0;
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    sum += std::abs(a->GetValue(i) - b->GetValue(i));
    count += a->GetValue(i) > 0 || b->GetValue(i) > 0 ? 1 : 0;
  }
  return count > Size * Size / 4 ? sum / count : 255.0;
}
}

int TestMeshVisibilitySortMapper(int, char*[])
{
  RelevoCheck check;
  const auto mesh = MakeTetrahedra(8, GetLinearField);
  for (bool isParallel : { false, true })
  {
    CHECK_CASE(isParallel);
    for (int side : { -1, 1 })
    {
      CHECK_CASE(side);
      const auto camera = MakeCamera(
        { { 0.5 + 1.5 * side, 0.5 + 1.1 * side, 0.5 + 2.0 * side } }, { { 0.5, 0.5, 0.5 } });
      camera->SetParallelProjection(isParallel);
      const auto ours = Draw(mesh, vtkNew<vtkMeshVisibilitySort>(), camera);
      const auto theirs = Draw(mesh, vtkNew<vtkCellCenterDepthSort>(), camera);
      CHECK_LESS(Compare(ours, theirs), 0.5);
      CHECK_GREATER(Compare(Draw(mesh, vtkNew<WrongSort>(), camera), theirs), 5.0);
    }
  }
  return check.GetResult();
}

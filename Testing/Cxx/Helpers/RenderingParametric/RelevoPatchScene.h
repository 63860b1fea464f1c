// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Flat curved cells seen from above, drawn by vtkAdaptivePatchMapper, and the values of VTK's cells
// at each pixel.
#ifndef RelevoPatchScene_h
#define RelevoPatchScene_h

#include "RelevoCheck.h"
#include "RelevoScene.h"

#include "vtkActor.h"
#include "vtkAdaptivePatchMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <functional>
#include <vector>

// One cell over the unit square at z = 0, whose inner nodes are moved by up to a share of its size.
// Point arrays are "Field" (1 component, about [-1, 1]), "Vector" (3), "Long" (5), "Color" (3
// bytes) and "Whole" (int, [0, 20]).
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewFlatCell(
  int type, const std::array<int, 3>& degrees, double share, bool isRational = false);

// n x m linear quadrilaterals of size 1, with "Field" = x.
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewFlatGrid(int n, int m);

class RelevoPatchScene
{
public:
  // 300 x 300 pixels that show [-0.1, 1.1] x [-0.1, 1.1], or the same margin around another size.
  // The background is magenta, and there are no lights.
  explicit RelevoPatchScene(vtkDataObject* input, double size = 1.0);

  RelevoPicture Draw();

  // Coordinates of a pixel's centre.
  std::array<double, 2> GetPosition(int x, int y) const;

  using Tuple = std::vector<double>;
  using Color = std::array<double, 3>;

  // Share of pixels whose colour differs by more than 2 / 255 from `toColor` of the tuple that
  // VTK's cell interpolates. Tests a quarter of the pixels and skips those at borders. Returns 1 if
  // fewer than 1000 pixels were compared.
  double GetShareOfOthers(vtkUnstructuredGrid* grid, const char* array,
    const std::function<Color(const Tuple&)>& toColor);

  // Uses the mapper's lookup table.
  std::function<Color(const Tuple&)> ByTable(const std::function<double(const Tuple&)>& number);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkAdaptivePatchMapper> Mapper;

private:
  const double Size;
};

#endif

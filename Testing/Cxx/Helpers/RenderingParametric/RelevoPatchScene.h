// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Flat curved cells seen from above, drawn by vtkAdaptivePatchMapper, and what VTK's own cells have
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

// One cell over the unit square in the plane z = 0, its inner nodes moved by up to a share of its
// size. Point arrays: "Field" (1 component, in about [-1, 1]), "Vector" (3), "Long" (5), "Color" (3
// bytes), "Whole" (int, in [0, 20]).
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewFlatCell(
  int type, const std::array<int, 3>& degrees, double share, bool isRational = false);

// n x m linear quadrilaterals of size 1, with "Field" = x.
vtkSmartPointer<vtkUnstructuredGrid> RelevoNewFlatGrid(int n, int m);

class RelevoPatchScene
{
public:
  // 300 x 300 pixels that show [-0.1, 1.1] x [-0.1, 1.1] or, of another size, as much around it.
  // The background is magenta; there are no lights.
  explicit RelevoPatchScene(vtkDataObject* input, double size = 1.0);

  RelevoPicture Draw();

  // Where the center of a pixel is.
  std::array<double, 2> GetPosition(int x, int y) const;

  using Tuple = std::vector<double>;
  using Color = std::array<double, 3>;

  // The share of a quarter of a cell's pixels whose colour differs by more than 2 / 255 from
  // `toColor`, of the tuple that VTK's cell interpolates there; pixels at its borders are left out.
  // At least 1000 pixels are compared, else it is 1.
  double GetShareOfOthers(vtkUnstructuredGrid* grid, const char* array,
    const std::function<Color(const Tuple&)>& toColor);

  // By the mapper's table.
  std::function<Color(const Tuple&)> ByTable(const std::function<double(const Tuple&)>& number);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkAdaptivePatchMapper> Mapper;

private:
  const double Size;
};

#endif

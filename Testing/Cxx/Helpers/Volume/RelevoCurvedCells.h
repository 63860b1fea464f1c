// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of curved cells whose shape and field are known in closed form, and pictures of them by
// sampling, without any code of the library.
#ifndef RelevoCurvedCells_h
#define RelevoCurvedCells_h

#include "RelevoVolumes.h"

// The shape is a unit cube whose points are moved along z by a polynomial of x and y. The field is
// a polynomial of the coordinates before. The basis of cells of the given degree contains both.
class RelevoCurvedCells
{
public:
  // `degree` is that of the polynomials. They are smooth, or waves that are so steep that linear
  // pieces of cells turn inside out.
  explicit RelevoCurvedCells(int degree, bool isSteep = false)
    : Degree(degree)
    , IsSteep(isSteep)
  {
  }

  // n^3 cubes of cells of this type. Lagrange and Bézier cells have the degree of the polynomials.
  vtkSmartPointer<vtkUnstructuredGrid> Make(int type, int n) const;

  RelevoPoint GetPosition(const RelevoPoint& at) const;
  double GetField(const RelevoPoint& at) const;

  // Colours and opacities by MakeVolumeProperty(first, last, unitDistance), premultiplied.
  std::vector<RelevoColor> MakePicture(
    vtkCamera* camera, int width, int height, double first, double last, double unitDistance) const;

private:
  bool FindField(const RelevoPoint& position, double& field) const;
  double GetWave(int degree, double x) const;

  int Degree;
  bool IsSteep;
};

// The largest difference of the colours of two pictures in units of 1/255, without this share of
// the pixels, and without those at outlines: next to a pixel that is empty in one picture.
double CompareInside(const std::vector<RelevoColor>& a, const std::vector<RelevoColor>& b,
  int width, double share = 0.0);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkSurface
 * @brief   a wavy coarse surface with depth-tags that refine it to a given number of triangles
 *
 * A grid over 4 x 3 units with analytic normals, texture coordinates and the point array
 * "DepthTag". Tags oscillate around a mean, with noise, so that many patterns are used.
 */
#ifndef BenchmarkSurface_h
#define BenchmarkSurface_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkAdaptiveRefinement;
class vtkPolyData;

class BenchmarkSurface
{
public:
  /// The numbers of faces and triangles are approximate.
  BenchmarkSurface(int numberOfFaces, double numberOfTriangles);
  ~BenchmarkSurface();

  vtkPolyData* GetMesh() { return this->Mesh; }

  /// Recipes for the mesh: linear, PN triangles, and PN triangles displaced by heights.
  static vtkSmartPointer<vtkAdaptiveRefinement> MakeLinearRecipe();
  static vtkSmartPointer<vtkAdaptiveRefinement> MakePNRecipe();
  static vtkSmartPointer<vtkAdaptiveRefinement> MakeDisplacedRecipe();

  /// The refined triangles with normals only, from the CPU filter.
  vtkSmartPointer<vtkPolyData> MakeRefinedMesh();

private:
  void BuildGrid(int numberOfFaces);
  void SetMeanLevel(double level);

  vtkNew<vtkPolyData> Mesh;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkSurface
 * @brief   a wavy coarse surface with depth-tags that refine it to a wanted number of triangles
 *
 * A grid over 4 x 3 units with analytic normals, texture coordinates and the point array
 * "DepthTag", which swings about a mean, with noise, so that tens of patterns are in use.
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
  /// About that many faces and triangles.
  BenchmarkSurface(int numberOfFaces, double numberOfTriangles);
  ~BenchmarkSurface();

  vtkPolyData* GetMesh() { return this->Mesh; }

  /// Recipes over the mesh: linear, PN triangles, PN triangles displaced by heights.
  static vtkSmartPointer<vtkAdaptiveRefinement> MakeLinearRecipe();
  static vtkSmartPointer<vtkAdaptiveRefinement> MakePNRecipe();
  static vtkSmartPointer<vtkAdaptiveRefinement> MakeDisplacedRecipe();

  /// The refined triangles with normals and nothing else, as the CPU filter gives them.
  vtkSmartPointer<vtkPolyData> MakeRefinedMesh();

private:
  void BuildGrid(int numberOfFaces);
  void SetMeanLevel(double level);

  vtkNew<vtkPolyData> Mesh;
};

#endif

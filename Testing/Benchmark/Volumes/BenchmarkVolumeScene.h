// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkVolumeScene
 * @brief   a structured grid, ways to split its cells, and transfer functions for its scalars
 */
#ifndef BenchmarkVolumeScene_h
#define BenchmarkVolumeScene_h

#include "vtkSmartPointer.h"

#include <string>

class vtkStructuredGrid;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

class BenchmarkVolumeScene
{
public:
  enum Split
  {
    FIVE, // tetrahedra per cell, by vtkDataSetTriangleFilter
    SIX,
    UNSPLIT // hexahedra
  };

  /**
   * "fin" and "post" are the blunt fin by density and the oxygen post by momentum along x, from
   * RELEVO_TEST_DATA; "grid N" has N x N x N cubes, and "bent N" the same, bent. There is no grid
   * if files are missing.
   */
  explicit BenchmarkVolumeScene(const std::string& name);
  ~BenchmarkVolumeScene();

  const std::string& GetName() const { return this->Name; }
  bool IsEmpty() const;

  vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(Split split) const;
  /// Functions with this many evenly spaced nodes, and a unit distance of three mean cells of the
  /// mesh.
  vtkSmartPointer<vtkVolumeProperty> MakeProperty(vtkUnstructuredGrid* mesh, int nodes) const;
  /// The scalar at this share of the range.
  double GetScalar(double part) const;

  /// Moves a node in the middle of the opacities, as a user would.
  static void EditOpacity(vtkVolumeProperty* property, double opacity);

private:
  std::string Name;
  vtkSmartPointer<vtkStructuredGrid> Grid; // with active point scalars
  double Range[2] = { 0.0, 1.0 };
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkVolumeScene
 * @brief   a structured grid, its cells split in some way, and a look for its scalars
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
    FIVE, // tetrahedra of a cell, by vtkDataSetTriangleFilter
    SIX,
    UNSPLIT // hexahedra
  };

  /**
   * "fin" and "post", the blunt fin by its density and the oxygen post by its momentum along x,
   * from RELEVO_TEST_DATA; "grid N", N x N x N cubes, and "bent N", the same bent. No grid where
   * files are missing.
   */
  explicit BenchmarkVolumeScene(const std::string& name);
  ~BenchmarkVolumeScene();

  const std::string& GetName() const { return this->Name; }
  bool IsEmpty() const;

  vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(Split split) const;
  /// Functions with so many nodes, evenly spaced, and a unit distance of three mean cells of the
  /// mesh.
  vtkSmartPointer<vtkVolumeProperty> MakeProperty(vtkUnstructuredGrid* mesh, int nodes) const;
  /// At that part of the scalars' range.
  double GetScalar(double part) const;

  /// Moves a node in the middle of the opacities, as a user would.
  static void EditOpacity(vtkVolumeProperty* property, double opacity);

private:
  std::string Name;
  vtkSmartPointer<vtkStructuredGrid> Grid; // with active scalars of points
  double Range[2] = { 0.0, 1.0 };
};

#endif

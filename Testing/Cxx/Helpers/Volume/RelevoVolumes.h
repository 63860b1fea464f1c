// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes of 3D cells, volume properties, and pictures by vtkVolumeRayCastFilter.
#ifndef RelevoVolumes_h
#define RelevoVolumes_h

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeRayCastFilter.h"

#include <array>
#include <functional>
#include <vector>

using RelevoPoint = std::array<double, 3>;
using RelevoColor = std::array<double, 4>;
using RelevoField = std::function<double(const RelevoPoint&)>;

// A cube from `low` to low + 1 of n^3 cubes with 6 tetrahedra each, and the point scalars "field".
vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra(
  int n, const RelevoField& field, double low = 0.0);

// Blocks of 3 x 3 x 3 of vtkCellTypeSource, from x to x + 3, with the point scalars "waves". Points
// are moved by up to `distortion`.
vtkSmartPointer<vtkUnstructuredGrid> MakeBlocksOfCells(
  int type, const RelevoField& field, double distortion = 0.0, double x = 0.0);

// Give each cell its own points, whose scalars differ by up to `jump` from those of the mesh.
vtkSmartPointer<vtkUnstructuredGrid> MakeDiscontinuous(vtkUnstructuredGrid* mesh, double jump);

// Blocks: the mesh as "solid", a surface "skin", and "air", whose array has another name.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocksToLeaveOut(vtkUnstructuredGrid* solid);

// One voxel from 0 to 1 with a field that is not linear in it.
double GetTrilinear(const RelevoPoint& at);
vtkSmartPointer<vtkImageData> MakeVoxel(const RelevoField& field);

// Red at 0 to blue at 1, with opacity from first to last.
vtkSmartPointer<vtkVolumeProperty> MakeVolumeProperty(
  double first, double last, double unitDistance = 1.0);

vtkSmartPointer<vtkCamera> MakeCamera(
  const RelevoPoint& position, const RelevoPoint& focalPoint, double angle = 30.0);

// Row after row; empty if the filter reports an error.
std::vector<RelevoColor> Cast(vtkVolumeRayCastFilter* filter);
std::vector<RelevoColor> Cast(
  vtkDataObject* mesh, vtkVolumeProperty* property, vtkCamera* camera, int width, int height);

double FindLargestDifference(const std::vector<RelevoColor>& a, const std::vector<RelevoColor>& b);
// The same for red, green and blue in columns and rows from first to last, for pictures of this
// width.
double FindLargestDifferenceInside(const std::vector<RelevoColor>& a,
  const std::vector<RelevoColor>& b, int width, int first, int last);

// A field that is linear in space, from 0 to 1 in a unit cube, a property for it, and the exact
// picture: colour and extinction are linear along a ray.
double GetLinearField(const RelevoPoint& at);
vtkSmartPointer<vtkVolumeProperty> MakeLinearProperty();
std::vector<RelevoColor> MakeLinearPicture(
  vtkCamera* camera, int width, int height, double low = 0.0);

// The ray through a pixel, from the camera's angles rather than matrices.
struct RelevoRay
{
  RelevoRay(vtkCamera* camera, int column, int row, int width, int height);

  RelevoPoint At(double t) const;
  // The part of the ray inside a cube, not before t = 0. Returns false if the ray misses it.
  bool CutBox(double low, double high, double& begin, double& end) const;

  RelevoPoint Origin;
  RelevoPoint Direction;
};

#endif

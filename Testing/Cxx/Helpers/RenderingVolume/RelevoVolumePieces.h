// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A mesh dealt out to pieces, whose ray segments are cast one after the other and merged.
#ifndef RelevoVolumePieces_h
#define RelevoVolumePieces_h

#include "RelevoVolumeScene.h"

#include "Segments/RaySegments.h"
#include "Stages/SegmentRequest.h"

#include <memory>
#include <string>
#include <vector>

// Hexahedra, wedges and pyramids with faces that are not flat, in a cube of n^3 cells around 0.5,
// with point scalars.
vtkSmartPointer<vtkUnstructuredGrid> MakeMixedCells(int n, const RelevoField& field);

enum class RelevoDealing
{
  Random,
  Slabs,
  Blobs,
  Awkward // random, but the last piece is empty and the one before has one cell
};

// Return the pieces of a mesh, whose points and cells have another order than those of the mesh.
std::vector<vtkSmartPointer<vtkUnstructuredGrid>> DealCells(
  vtkUnstructuredGrid* mesh, RelevoDealing dealing, int numberOfPieces);

// The same, with the piece of each cell's centre.
std::vector<vtkSmartPointer<vtkUnstructuredGrid>> DealCells(vtkUnstructuredGrid* mesh,
  const std::function<int(const RelevoPoint&)>& choose, int numberOfPieces);

// The pieces with a layer of ghost cells, which share points with their cells.
std::vector<vtkSmartPointer<vtkUnstructuredGrid>> DealCellsWithGhosts(
  vtkUnstructuredGrid* mesh, RelevoDealing dealing, int numberOfPieces);

class RelevoVolumePieces
{
public:
  // The pieces are shown as the mesh of the scene, whose mapper's settings are copied.
  RelevoVolumePieces(
    RelevoVolumeScene& scene, const std::vector<vtkSmartPointer<vtkUnstructuredGrid>>& pieces);

  // The extent of all pieces.
  relevo::MeshExtent Measure();

  // Cast the segments of the pieces with the depths of the other props.
  void Cast();
  const std::vector<relevo::RaySegments>& GetSegments() const { return this->Segments; }
  relevo::SegmentRequest& GetRequest() { return this->Request; }

  // The merged segments over the other props, rounded as in a window. Packed segments went through
  // a message.
  std::vector<RelevoColor> Merge(bool arePacked);

private:
  RelevoVolumeScene& Scene;
  std::vector<vtkSmartPointer<vtkGPUUnstructuredGridVolumeMapper>> Mappers;
  std::vector<relevo::RaySegments> Segments;
  relevo::SegmentRequest Request;
  std::vector<RelevoColor> Background;
};

#endif

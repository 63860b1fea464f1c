// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ProbedVolume
 * @brief   finds where a ray becomes opaque in the volume of a mapper
 *
 * Works on the CPU in double precision, with the integrals of vtkVolumeRayCastFilter. The cells are
 * read again only when the mesh changes.
 *
 * Private to the module.
 */
#ifndef ProbedVolume_h
#define ProbedVolume_h

#include "Cells/MeshScalars.h"
#include "Changes/Dependencies.h"
#include "Checks/StageReport.h"
#include "Integral/Ray.h"
#include "Integral/TransferFunctions.h"
#include "Probe/ProbeRequest.h"
#include "Probe/ProbedCell.h"

#include <memory>
#include <vector>

class vtkDataSet;
class vtkMatrix4x4;

namespace relevo
{
class CellCrossing;
class VolumeCells;

/// A position in a volume.
struct VolumeHit
{
  double Distance; // along the ray, in world coordinates
  dvec3 Position;  // in world coordinates
  dvec3 MeshPosition;
  vtkDataSet* Mesh;
  vtkIdType FlatIndex; // of the block, or -1 without blocks
  ProbedCell Cell;
  Scalars Values; // of the components that are drawn
  dvec3 Gradient; // of the first component, in the mesh's coordinates
};

class ProbedVolume
{
public:
  ProbedVolume();
  ~ProbedVolume();

  /// Read what has changed. Return false if there is nothing to draw.
  bool Update(const ProbeRequest& request, StageReport& report);

  int GetNumberOfComponents() const { return this->Functions.GetNumberOfComponents(); }

  /// Find where the opacity reaches the threshold along a ray in world coordinates. Call Update()
  /// with the same request before.
  bool Find(const ProbeRequest& request, vtkMatrix4x4* matrix, const Ray& ray, double threshold,
    VolumeHit& hit) const;

private:
  bool ReadCells(const ProbeRequest& request, StageReport& report);

  Dependencies KnownMesh;
  Dependencies KnownFunctions;
  std::vector<MeshScalars> Meshes;
  std::vector<double> Scales; // of the scalars of each mesh
  std::unique_ptr<VolumeCells> Cells;
  std::unique_ptr<CellCrossing> Crossing;
  TransferFunctions Functions;
  int NumberOfComponents = 1;
  bool HasFunctions = false;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshValues
 * @brief   replaces the scalars of a RayCastMesh that has been built
 *
 * This is possible if the mesh does not depend on the scalars: all of them are finite, and points
 * that have been merged have the same scalars again.
 *
 * Private to the module.
 */
#ifndef MeshValues_h
#define MeshValues_h

#include "Cells/MergedCellPoints.h"
#include "Cells/ScalarChoice.h"
#include "Integral/Ray.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace relevo
{
class ScalarTable;
class VolumeCells;
struct MeshScalars;
struct RayCastMesh;

class MeshValues
{
public:
  MeshValues();
  ~MeshValues();
  MeshValues(MeshValues&& other);
  MeshValues& operator=(MeshValues&& other);

  /// Take the sources of scalars from a mesh that was built of these cells. If the mesh has
  /// gradients, the cells are moved here to compute them again.
  void Keep(VolumeCells& cells, RayCastMesh& mesh);
  void Clear() { *this = MeshValues(); }
  bool IsEmpty() const { return this->PointIds.empty() && this->CellIds.empty(); }

  /**
   * Store points, scalars and gradients in a mesh, which has its transformation of positions.
   * Return false if the mesh must be built again. There is a choice for each data set; all have the
   * same association as before.
   */
  bool Replace(const std::vector<MeshScalars>& sets, const std::vector<ScalarChoice>& choices,
    int numberOfComponents, RayCastMesh& mesh);

private:
  std::vector<vtkIdType> FindTuples(const ScalarTable& all) const;
  std::vector<dvec3> GetPoints(const std::vector<MeshScalars>& sets) const;

  std::vector<std::uint32_t> PointIds; // see RayCastMesh
  std::vector<vtkIdType> CellIds;
  std::vector<std::uint32_t> CornerIds;
  size_t NumberOfTuples = 0;
  std::unique_ptr<VolumeCells> Cells; // only with gradients
  MergedCellPoints Merged;            // if scalars are continuous
  bool AreMerged = false;
};
}

#endif

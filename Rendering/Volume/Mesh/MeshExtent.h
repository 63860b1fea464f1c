// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  MeshExtent
 * @brief   the ranges of a mesh's points and scalars
 *
 * If pieces of a mesh use the extent of the whole mesh, they scale positions and scalars equally,
 * and shared points get the same bits in all pieces. Contains no pointers, so that ranks can
 * exchange the bytes. Private to the modules.
 */
#ifndef MeshExtent_h
#define MeshExtent_h

#include "Integral/TransferFunctions.h"
#include "Mathematics/FiniteBox.h"
#include "RelevoRenderingVolumeModule.h" // for export macro

#include <limits> // for the empty extent

namespace relevo
{
class VolumeCells;

struct RELEVORENDERINGVOLUME_EXPORT MeshExtent
{
  FiniteBox Points;
  Scalars ScalarLow{ { Infinity, Infinity, Infinity, Infinity } };
  Scalars ScalarHigh{ { -Infinity, -Infinity, -Infinity, -Infinity } };
  double LongestEdge = 0.0; // of a cell, or diagonal
  int NumberOfComponents = 0;

  /// Return the extent of cells; it is empty without cells.
  static MeshExtent Of(const VolumeCells& cells, int numberOfComponents);

  bool IsEmpty() const { return this->NumberOfComponents == 0; }
  /// Include another piece. Return false, without a change, if its scalars have another number of
  /// components.
  bool Add(const MeshExtent& other);
  bool operator==(const MeshExtent& other) const;

  /// Return the factor of stored scalars, see RayCastMesh::ScalarSize.
  double GetScalarSize(int component) const;
  /// Return half the diagonal of the points' box, or 1 for a point.
  double GetRadius() const;

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
};
}

#endif

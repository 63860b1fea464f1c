// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MicroMeshEncoder
 * @brief   encodes a dense mesh as a micro-mesh within a tolerance
 *
 * Each round displaces the grids of the coarse faces onto the dense mesh, chooses the lowest
 * sufficient levels and measures the error. Where it is above the tolerance, the next round samples
 * with a higher level. If the highest level is not enough, the next round simplifies the dense mesh
 * again and allows only smaller clusters of vertices there, and in the end none, so that the dense
 * mesh is kept.
 */
#ifndef MicroMeshEncoder_h
#define MicroMeshEncoder_h

#include "Encoding/BaseMesh.h"

#include <functional> // for progress
#include <memory>     // for the result

namespace relevo
{
struct MicroMeshSettings
{
  double Tolerance; // in the units of the input
  double TargetReduction;
  int MaximumLevel;
};

struct EncodedMesh
{
  BaseMesh Base;
  MicroMesh Mesh;       // in the coordinates of the dense mesh
  double InputToResult; // in the units of the input
  double ResultToInput;
  int NumberOfRounds;
};

/// Encode a mesh. `goOn(share)` is called from time to time and returns false to stop; the result
/// is then nullptr.
std::unique_ptr<EncodedMesh> EncodeMicroMesh(const DenseMesh& dense,
  const MicroMeshSettings& settings, const std::function<bool(double)>& goOn);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MicroMeshEncoder
 * @brief   encodes a dense mesh as a micro-mesh within a tolerance
 *
 * The grids of the coarse faces are displaced onto the dense mesh, with higher levels until they
 * change little. Levels are then reduced, and the error is measured. Where it is above the
 * tolerance, the next round reduces levels less, then samples with a higher level. Where the
 * highest level is not enough, the dense mesh is simplified again with smaller clusters of
 * vertices, down to single vertices, so that triangles of the dense mesh are kept. Only what
 * changed is simplified, sampled and measured again.
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

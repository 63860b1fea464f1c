// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   transfer functions of a volume, from a file or computed for an array
 */
#ifndef VolumeFunctions_h
#define VolumeFunctions_h

#include "Files/TransferFile.h"

#include <vector>

class vtkColorTransferFunction;
class vtkColorTransferFunction;
class vtkVolumeProperty;
struct ViewerOptions;
struct VolumeArray;

/**
 * Computes functions over an array's range that suit most data: the colours of meshes, and
 * opacities that increase with the values and their ranks. Opacities decrease with the number of
 * cells along a side, and increase the thinner the mesh is: its mean chord as a share of its
 * diagonal, 0 if unknown. They may exceed 1. In blend modes where opacity does not depend on
 * length, it is constant.
 */
std::vector<TransferNode> MakeTransferNodes(
  const ViewerOptions& options, const VolumeArray& array, double cellsOfSide, double thickness);

/// Adds opacity peaks at the values, so narrow that only isosurfaces show them.
std::vector<TransferNode> AddPeaks(
  std::vector<TransferNode> nodes, const std::vector<double>& values, double opacity);

/// Sets colours, which replace those of the nodes unless they are nullptr, and opacities multiplied
/// by a factor. The factor raises no opacity above 1. The property keeps its colour function.
void SetTransferNodes(vtkVolumeProperty* property, const std::vector<TransferNode>& nodes,
  double factor, vtkColorTransferFunction* colours);

#endif

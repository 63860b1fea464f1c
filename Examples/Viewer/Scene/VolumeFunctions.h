// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   transfer functions of a volume: of a file, or made for an array
 */
#ifndef VolumeFunctions_h
#define VolumeFunctions_h

#include "Files/TransferFile.h"

#include <vector>

class vtkColorTransferFunction;
class vtkVolumeProperty;
struct ViewerOptions;
struct VolumeArray;

/**
 * Functions over an array's range that show something of any data: the colours of meshes, and
 * opacities that rise with the values and their ranks, the lower the more cells there are along
 * a side, and the higher the thinner the mesh is: the mean length of lines through it, as a share
 * of its diagonal, 0 if it is not known. They may be above 1. Where opacity does not count by
 * length it is the same for all values.
 */
std::vector<TransferNode> MakeTransferNodes(
  const ViewerOptions& options, const VolumeArray& array, double cellsOfSide, double thickness);

/// Has opacity peak at values, so narrowly that only isosurfaces see it.
std::vector<TransferNode> AddPeaks(
  std::vector<TransferNode> nodes, const std::vector<double>& values, double opacity);

/// Colours, and opacities times a factor that makes none more than 1.
void SetTransferNodes(
  vtkVolumeProperty* property, const std::vector<TransferNode>& nodes, double factor);

#endif

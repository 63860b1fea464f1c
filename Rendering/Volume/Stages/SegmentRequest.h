// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  SegmentRequest
 * @brief   the input of vtkGPUUnstructuredGridVolumeMapper::CastSegments()
 *
 * Private to the modules.
 */
#ifndef SegmentRequest_h
#define SegmentRequest_h

#include "Mesh/MeshExtent.h"

#include <vector> // for depths

namespace relevo
{
struct SegmentRequest
{
  /// The extent of all pieces.
  MeshExtent Whole;
  /// The window depths from 0 to 1 of the opaque scene in the renderer's viewport, row by row from
  /// the lower left corner. If it is empty, rays end at the depths of the current framebuffer.
  std::vector<float> Depths;
  /// The window depths where rays begin, like Depths. If it is empty, rays begin at the near plane.
  /// Rays that begin at or behind their end have no segments.
  std::vector<float> Begins;
  /// Whether buffers may be used that need OpenGL 4.3. They are faster.
  bool UsesStorageBuffers = true;
};
}

#endif

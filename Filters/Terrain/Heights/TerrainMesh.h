// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the coarse triangles of a terrain, flat, at z = 0
 *
 * Private to the module's own sources.
 */
#ifndef TerrainMesh_h
#define TerrainMesh_h

#include <functional>

class vtkPolyData;

namespace relevo
{
class TerrainFrame;

/**
 * A grid of squares of two triangles each over the frame's footprint, `resolution` along the longer
 * side and as many along the other as keep them about square, never finer than the texels. Where
 * `validity`, one byte a texel, is not nullptr, squares without any sample that has data are left
 * out.
 *
 * Points have normals (+z) and texture coordinates, u east and v north. `goesOn` is asked after
 * every row of squares; false when it has said no.
 */
bool BuildTerrainMesh(const TerrainFrame& frame, const int texels[2], int resolution,
  const unsigned char* validity, const std::function<bool()>& goesOn, vtkPolyData* output);
}

#endif

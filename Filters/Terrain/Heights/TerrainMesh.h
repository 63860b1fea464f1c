// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   generation of the flat coarse mesh of a terrain
 *
 * Private to the module.
 */
#ifndef TerrainMesh_h
#define TerrainMesh_h

#include <functional>

class vtkPolyData;

namespace relevo
{
class TerrainFrame;

/**
 * Generates a grid of squares, of two triangles each, over the footprint. The longer side has
 * `resolution` squares, and the shorter side enough to make them about square, but at most one per
 * texel. `validity` has one byte per texel, or is nullptr. Squares without valid samples are
 * omitted. If the grid is aligned, its lines pass through the centres of texels, see
 * vtkTerrainSource::SetAlignToSamples().
 *
 * Points have normals (+z) and texture coordinates, u east and v north. `goesOn` is called after
 * each row of squares. Returns false if it returned false.
 */
bool BuildTerrainMesh(const TerrainFrame& frame, const int texels[2], int resolution,
  bool isAligned, const unsigned char* validity, const std::function<bool()>& goesOn,
  vtkPolyData* output);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   texture coordinates for meshes that have none
 */
#ifndef MeshMapping_h
#define MeshMapping_h

class vtkPolyData;
struct ViewerOptions;

/**
 * Lays pictures around the mesh, from pole to pole of the up axis through the middle of its
 * bounding box, or on it as it is seen along the axis that it is thinnest along. Around it means
 * once over the near half and back, mirrored, over the far one: a picture repeats itself nowhere
 * else, and meets itself without a seam.
 */
void AddTextureCoordinates(vtkPolyData* mesh, const ViewerOptions& options);

#endif

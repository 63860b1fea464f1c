// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds texture coordinates to meshes
 */
#ifndef MeshMapping_h
#define MeshMapping_h

class vtkPolyData;
struct ViewerOptions;

/**
 * Wraps a picture around the mesh, from pole to pole of the up axis through the centre of its
 * bounding box, or projects it along the thinnest axis. Wrapped pictures cover the near half and,
 * mirrored, the far half, so that they have no seam.
 */
void AddTextureCoordinates(vtkPolyData* mesh, const ViewerOptions& options);

#endif

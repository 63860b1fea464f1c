// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what differs between the releases of VTK that Relevo builds with: 9.1 to 9.6
 *
 * The loader of OpenGL's functions differs as well: RelevoOpenGL.h, as filters know no OpenGL.
 */
#ifndef VTKCompatibility_h
#define VTKCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace relevo
{
/**
 * Whether the algorithm is to stop: by its own flag and, since VTK 9.3, also because an algorithm
 * that it is part of or that it depends on was aborted.
 */
inline bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/**
 * Whether VTK's mapper draws the vertices of every representation, in picking as well, when they
 * are to be visible; up to VTK 9.4 it does so only together with the edges of surfaces.
 */
constexpr bool VerticesNeedNoEdges = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0);

/**
 * Whether VTK's mapper, where it cannot build a program, asks the one before for its time, which
 * must not be missing then; from VTK 9.3 on it goes on with that one.
 */
constexpr bool AsksLastProgram = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0);

/**
 * The vertex attribute that says where a texture of a lookup table has a point's colour.
 */
constexpr const char* ColorCoordinates =
  VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0) ? "colorTCoord" : "tcoord";
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   reads the surface of a glTF scene
 */
#ifndef GLTFReader_h
#define GLTFReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;
class ViewerMessages;

/**
 * Returns the triangles of the default scene with the transforms of its nodes. Winding is that of
 * the scene. If materials or points have colours, they are the scalars "Color", bytes in sRGB.
 * Textures are ignored.
 */
vtkSmartPointer<vtkPolyData> ReadGLTF(const std::string& fileName, ViewerMessages& messages);

#endif

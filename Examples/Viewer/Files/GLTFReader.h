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
 * The triangles of the default scene, of all its nodes where they stand, facing as they do in the
 * scene. Where materials or points have colours, the scalars are these: "Color", bytes in sRGB.
 * Pictures of materials are left out.
 */
vtkSmartPointer<vtkPolyData> ReadGLTF(const std::string& fileName, ViewerMessages& messages);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how VTK's mapper is told what to take from positions and to multiply them with
 *
 * Private to the modules.
 */
#ifndef PositionShift_h
#define PositionShift_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <vector>

class vtkDataArray;
class vtkOpenGLVertexBufferObjectGroup;
class vtkRenderer;

namespace relevo
{
/// Before the mapper builds its buffers of these points by MANUAL_SHIFT_SCALE.
RELEVORENDERINGCORE_EXPORT void ShiftPositions(vtkOpenGLVertexBufferObjectGroup* buffers,
  vtkDataArray* points, vtkRenderer* ren, const std::vector<double>& shift,
  const std::vector<double>& scale);
}

#endif

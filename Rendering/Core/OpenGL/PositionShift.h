// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   sets the shift and scale that VTK's mapper applies to positions
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
/// Set the shift and scale before the mapper builds its buffers of these points with
/// MANUAL_SHIFT_SCALE.
RELEVORENDERINGCORE_EXPORT void ShiftPositions(vtkOpenGLVertexBufferObjectGroup* buffers,
  vtkDataArray* points, vtkRenderer* ren, const std::vector<double>& shift,
  const std::vector<double>& scale);
}

#endif

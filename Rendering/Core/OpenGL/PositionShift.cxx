// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/PositionShift.h"

#include "vtkDataArray.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkRenderer.h"

namespace relevo
{
void ShiftPositions(vtkOpenGLVertexBufferObjectGroup* buffers, vtkDataArray* points,
  vtkRenderer* ren, const std::vector<double>& shift, const std::vector<double>& scale)
{
  // This creates the buffer that VTK will use, without filling it.
  buffers->CacheDataArray("vertexMC", points, ren, VTK_FLOAT);
  vtkOpenGLVertexBufferObject* positions = buffers->GetVBO("vertexMC");
  buffers->ClearAllDataArrays();
  positions->SetShift(shift);
  positions->SetScale(scale);
  if (positions->GetUploadTime() < positions->GetMTime())
  {
    positions->UploadDataArray(points); // VTK does not upload unchanged points
  }
}
}

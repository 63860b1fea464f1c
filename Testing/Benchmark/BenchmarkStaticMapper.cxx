// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkStaticMapper.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"

vtkStandardNewMacro(BenchmarkStaticMapper);

double BenchmarkStaticMapper::GetGraphicsMemorySize()
{
  double size = 0.0;
  for (const char* name : { "vertexMC", "normalMC", "scalarColor", "tcoord", "colorTCoord" })
  {
    if (vtkOpenGLVertexBufferObject* buffer = this->VBOs->GetVBO(name))
    {
      size += static_cast<double>(buffer->GetNumberOfTuples()) * buffer->GetStride();
    }
  }
  for (const vtkOpenGLHelper& helper : this->Primitives)
  {
    size += static_cast<double>(helper.IBO->IndexCount * sizeof(unsigned int));
  }
  return size;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceBuffer
 * @brief   isosurfaces on the GPU: the values of relevoVolumeSurfaces.glsl and their colours
 *
 * Private to the module.
 */
#ifndef SurfaceBuffer_h
#define SurfaceBuffer_h

#include "Buffers/BufferTexture.h"
#include "Integral/TransferFunctions.h"

class vtkVolumeProperty;

namespace relevo
{
class SurfaceBuffer
{
public:
  /// For scalars that are low + size * what the mesh has. false when it does not fit.
  bool Upload(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property,
    const TransferFunctions& functions, const Scalars& low, const Scalars& size);

  /// Whose values these are.
  int GetComponent() const { return this->Component; }

  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Values.Deactivate(); }
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Values.ReleaseGraphicsResources(window);
  }
  vtkTypeInt64 GetMemorySize() const { return this->Values.GetMemorySize(); }

private:
  BufferTexture Values;
  int NumberOfValues = 0;
  int Component = 0;
  int Curve = 0;
  float Same = 0.0f; // scalars of cells that touch may differ so much
};
}

#endif

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

#include <vector>

class vtkVolumeProperty;

namespace relevo
{
class SurfaceBuffer
{
public:
  /// Upload the isosurfaces for scalars that are low + size * the mesh's scalars. Return false if
  /// they do not fit.
  bool Upload(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property,
    const TransferFunctions& functions, const Scalars& low, const Scalars& size);

  /// Return the component of the isovalues.
  int GetComponent() const { return this->Component; }

  /// Return whether nothing is visible behind a surface, with colours that do not depend on
  /// gradients.
  bool AreOpaque() const { return this->IsOpaque; }

  /// Return the isovalues in units of the mesh's scalars, which are from 0 to 1.
  const std::vector<float>& GetScaledValues() const { return this->ScaledValues; }

  /// Return the tolerance between scalars of adjacent cells, in these units.
  float GetSame() const { return this->Same; }

  void Activate(vtkShaderProgram* program);
  void Deactivate() { this->Values.Deactivate(); }
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Values.ReleaseGraphicsResources(window);
  }
  vtkTypeInt64 GetMemorySize() const { return this->Values.GetMemorySize(); }

private:
  BufferTexture Values;
  std::vector<float> ScaledValues;
  bool IsOpaque = true;
  int Component = 0;
  int Curve = 0;
  float Same = 0.0f;
};
}

#endif

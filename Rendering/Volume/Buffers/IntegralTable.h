// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   IntegralTable
 * @brief   a table of the volume rendering integral over ray segments, for pre-integration
 *
 * The parameters are the scalars at the front and the back, and the length up to a maximum; in 2D
 * the scalars alone: see relevoVolumePreIntegrated.glsl. Private to the module.
 */
#ifndef IntegralTable_h
#define IntegralTable_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class TransferFunctions;

class IntegralTable
{
public:
  struct Settings
  {
    int Size = 0; // texels per axis
    bool Is2D = false;
    double Longest = 0.0;   // maximum length in world units
    double ScalarLow = 0.0; // scalars are low + size * the mesh's scalars
    double ScalarSize = 1.0;
  };

  IntegralTable();
  ~IntegralTable();

  /// Compute and upload the table for functions of one component, without gradients. Return false
  /// if the texture cannot be created.
  bool Upload(
    vtkOpenGLRenderWindow* window, const TransferFunctions& functions, const Settings& settings);

  /// Return whether the table has these settings, up to rounding.
  bool Has(const Settings& settings) const;

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTypeInt64 GetMemorySize() const;

private:
  vtkSmartPointer<vtkTextureObject> Texture;
  Settings Kept;
};
}

#endif

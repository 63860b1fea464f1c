// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   IntegralTable
 * @brief   the volume rendering integral of parts of a ray, tabulated for pre-integration
 *
 * By the scalar in front, the one at the back, and the length, of parts that are no longer than
 * what is given; or, in 2D, by the scalars alone: see relevoVolumePreIntegrated.glsl. Private to
 * the module.
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
    int Size = 0; // each way
    bool Is2D = false;
    double Longest = 0.0;   // world length
    double ScalarLow = 0.0; // scalars are low + size * what the mesh has
    double ScalarSize = 1.0;
  };

  IntegralTable();
  ~IntegralTable();

  /// Functions of one component, without gradients. false where the texture cannot be made.
  bool Upload(
    vtkOpenGLRenderWindow* window, const TransferFunctions& functions, const Settings& settings);

  /// Whether it is one of such settings, up to rounding.
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

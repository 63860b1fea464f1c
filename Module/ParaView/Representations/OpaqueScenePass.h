// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OpaqueScenePass
 * @brief   a render pass that draws a renderer as ParaView does, without translucent props
 *
 * It draws the lights, the opaque props with the settings of the renderer, and overlays.
 *
 * Private to the module.
 */
#ifndef OpaqueScenePass_h
#define OpaqueScenePass_h

#include "vtkRenderPass.h"

namespace relevo
{
class OpaqueScenePass : public vtkRenderPass
{
public:
  static OpaqueScenePass* New();
  vtkTypeMacro(OpaqueScenePass, vtkRenderPass);

  void Render(const vtkRenderState* state) override;

protected:
  OpaqueScenePass() = default;
  ~OpaqueScenePass() override = default;

private:
  OpaqueScenePass(const OpaqueScenePass&) = delete;
  void operator=(const OpaqueScenePass&) = delete;
};
}

#endif

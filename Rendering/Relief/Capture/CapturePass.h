// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CapturePass
 * @brief   draws opaque props into a CaptureTarget, with normals and depths of full precision
 *
 * The shaders of VTK's polydata mappers and of derived mappers write normals and depths; other
 * props do not. The object stays the same from capture to capture, so that mappers keep their
 * shaders. Private to the module.
 */
#ifndef CapturePass_h
#define CapturePass_h

#include "vtkOpenGLRenderPass.h"

#include <vector>

class vtkProp;

namespace relevo
{
class CaptureRenderer;
class CaptureTarget;

class CapturePass : public vtkOpenGLRenderPass
{
public:
  static CapturePass* New();
  vtkTypeMacro(CapturePass, vtkOpenGLRenderPass);

  /// Draw with the renderer's camera.
  void Draw(CaptureRenderer* renderer, std::vector<vtkProp*>& props, CaptureTarget& target);

  /// Render as a part of Draw().
  void Render(const vtkRenderState* state) override;

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* arrays) override;

protected:
  CapturePass() = default;
  ~CapturePass() override = default;

private:
  CapturePass(const CapturePass&) = delete;
  void operator=(const CapturePass&) = delete;

  std::vector<vtkProp*>* Props = nullptr;
  CaptureTarget* Target = nullptr;
};
}

#endif

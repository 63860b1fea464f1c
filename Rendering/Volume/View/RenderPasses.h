// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RenderPasses
 * @brief   render passes that change the shaders of a volume, such as depth peeling
 *
 * Private to the module.
 */
#ifndef RenderPasses_h
#define RenderPasses_h

#include <string>
#include <vector>

class vtkAbstractMapper;
class vtkOpenGLRenderPass;
class vtkOpenGLVertexArrayObject;
class vtkProp;
class vtkShaderProgram;

namespace relevo
{
class RenderPasses
{
public:
  /// No render passes.
  RenderPasses() = default;
  /// The render passes of the prop, which require its mapper.
  RenderPasses(vtkAbstractMapper* mapper, vtkProp* prop);

  bool IsEmpty() const { return this->Passes.empty(); }
  void ReplaceShaderValues(std::string& fragmentShader) const;
  void SetShaderParameters(vtkShaderProgram* program, vtkOpenGLVertexArrayObject* vertices) const;

private:
  std::vector<vtkOpenGLRenderPass*> Passes;
  vtkAbstractMapper* Mapper = nullptr;
  vtkProp* Prop = nullptr;
};
}

#endif

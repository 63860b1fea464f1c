// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VariantPainter
 * @brief   a mapper that draws vertices of its own with VTK's shaders
 *
 * Lights, clipping planes, opacity, render passes and selections are VTK's. A subclass draws in
 * RenderPieceDraw(), after UpdateProgram(), and changes VTK's shaders in PrepareShaders() and
 * FinishShaders(). Private to the modules.
 */
#ifndef VariantPainter_h
#define VariantPainter_h

#include "Changes/Dependencies.h"
#include "RelevoRenderingCoreModule.h" // for export macro
#include "Shaders/ShaderVariants.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkVersionMacros.h"

#include <map>
#include <string>
#include <vector>

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT VariantPainter : public vtkOpenGLPolyDataMapper
{
public:
  vtkTypeMacro(VariantPainter, vtkOpenGLPolyDataMapper);

  /// Return the error of the shaders that were built last, or "".
  const std::string& GetShaderError() const { return this->Variants.GetError(); }

  void ReleaseGraphicsResources(vtkWindow* window) override;
  /// Do nothing: the ids that are drawn are those of the input.
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& pixels, vtkProp* prop) override;

protected:
  explicit VariantPainter(int numberOfVariants = 1);
  ~VariantPainter() override;

  /// Build the program of a variant if necessary. `options` are all that its shaders depend on,
  /// apart from the actor's shader property and the clipping planes. Return false if there is no
  /// program.
  bool UpdateProgram(
    vtkOpenGLHelper& helper, const Dependencies& options, vtkRenderer* renderer, vtkActor* actor);
  /// Return whether the ids of cells are being drawn.
  bool IsSelectingCells() const;

  /// Change the shaders before and after VTK does. Anchors that are missing are added to
  /// Variants.GetMissing().
  virtual void PrepareShaders(ShaderVariants::Shaders& shaders, vtkActor* actor) = 0;
  virtual void FinishShaders(ShaderVariants::Shaders& shaders) = 0;
  /// Return whether VTK's lights shade what is drawn. The default is true.
  virtual bool IsLit() const { return true; }

  void BuildShaders(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;

  ShaderVariants Variants;
  vtkNew<vtkPolyData> Box; // the input, because VTK's mapper needs points

private:
  VariantPainter(const VariantPainter&) = delete;
  void operator=(const VariantPainter&) = delete;

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 20260726)
  bool FragmentShaderUsesPrimitiveID(vtkRenderer* renderer, vtkActor* actor) override;
#endif
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PsiTable
 * @brief   linearSegmentPsi() as a texture, which no transfer function changes
 *
 * Private to the module.
 */
#ifndef PsiTable_h
#define PsiTable_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class PsiTable
{
public:
  static constexpr int Size = 256; // each way

  PsiTable();
  ~PsiTable();

  bool Upload(vtkOpenGLRenderWindow* window);
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  bool IsEmpty() const { return this->Texture == nullptr; }
  vtkTypeInt64 GetMemorySize() const;

private:
  vtkSmartPointer<vtkTextureObject> Texture;
};
}

#endif

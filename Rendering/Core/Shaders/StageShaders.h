// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   StageShaders
 * @brief   an empty vertex, geometry and fragment shader, as VTK's mappers fill in
 *
 * Private to the modules.
 */
#ifndef StageShaders_h
#define StageShaders_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkNew.h"                    // for members
#include "vtkShader.h"                 // for members

#include <map> // for members

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT StageShaders
{
public:
  StageShaders();
  StageShaders(const StageShaders&) = delete;
  void operator=(const StageShaders&) = delete;

  /// Return the shaders, which live as long as this object.
  std::map<vtkShader::Type, vtkShader*>& Get() { return this->Shaders; }

private:
  vtkNew<vtkShader> Stages[3];
  std::map<vtkShader::Type, vtkShader*> Shaders;
};
}

#endif

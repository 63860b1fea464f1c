// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/StageShaders.h"

namespace relevo
{
StageShaders::StageShaders()
{
  const vtkShader::Type types[3] = { vtkShader::Vertex, vtkShader::Geometry, vtkShader::Fragment };
  for (int i = 0; i < 3; ++i)
  {
    this->Stages[i]->SetType(types[i]);
    this->Shaders[types[i]] = this->Stages[i];
  }
}
}

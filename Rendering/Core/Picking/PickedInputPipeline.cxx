// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Picking/PickedInputPipeline.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"

namespace relevo
{
vtkStandardNewMacro(PickedInputPipeline);

vtkDataObject* PickedInputPipeline::GetInputData(int port, int connection)
{
  vtkDataObject* input = this->vtkCompositeDataPipeline::GetInputData(port, connection);
  return port == 0 && connection == 0 && input && this->GetAlgorithm() ? this->Replace(input)
                                                                       : input;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickedInputPipeline
 * @brief   the executive of a mapper that replaces the input for pickers by the drawn surface
 *
 * Private to the modules.
 */
#ifndef PickedInputPipeline_h
#define PickedInputPipeline_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkCompositeDataPipeline.h"

#include <functional> // for members

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT PickedInputPipeline : public vtkCompositeDataPipeline
{
public:
  static PickedInputPipeline* New();

  /// The function that returns the replacement of an input. It is called as long as there is an
  /// algorithm.
  std::function<vtkDataObject*(vtkDataObject*)> Replace;

  using vtkCompositeDataPipeline::GetInputData;
  vtkDataObject* GetInputData(int port, int connection) override;
};
}

#endif

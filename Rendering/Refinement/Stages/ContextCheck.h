// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContextCheck
 * @brief   what the OpenGL context of a mapper can do
 *
 * Private to the module.
 */
#ifndef ContextCheck_h
#define ContextCheck_h

#include "Stages/StageResult.h"

namespace relevo
{
/// Where faces choose their patterns; the numbers of
/// vtkAdaptiveRefinementMapper::SelectionDevices.
enum SelectionDevice
{
  SELECTION_DEVICE_AUTOMATIC = 0,
  SELECTION_DEVICE_CPU = 1,
  SELECTION_DEVICE_GPU = 2
};

class ContextCheck
{
public:
  /// Look at the context that is current, unless that has been done.
  StageResult Update(int selectionDevice);
  /// Look again, with the next update.
  void Reset() { this->IsChecked = false; }

  /// Whether the context can select on the device that was asked for.
  bool CanCompute() const { return this->HasCompute; }

private:
  bool IsChecked = false;
  bool IsValid = false;
  bool HasCompute = false;
};
}

#endif

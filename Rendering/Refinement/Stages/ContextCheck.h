// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContextCheck
 * @brief   checks the capabilities of a mapper's OpenGL context
 *
 * Private to the module.
 */
#ifndef ContextCheck_h
#define ContextCheck_h

#include "Stages/StageResult.h"

namespace relevo
{
/// The processor that selects patterns; the values are those of
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
  /// Check the current context, unless that has been done.
  StageResult Update(int selectionDevice);
  /// Check again in the next update.
  void Reset() { this->IsChecked = false; }

  /// Return whether the context can select on the requested processor.
  bool CanCompute() const { return this->HasCompute; }

private:
  bool IsChecked = false;
  bool IsValid = false;
  bool HasCompute = false;
};
}

#endif

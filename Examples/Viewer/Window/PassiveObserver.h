// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   observers that are called while the mouse is dragged, too
 *
 * During a drag VTK's interactor styles grab all events of the interactor, ends and timers
 * included. Only passive observers are called then.
 */
#ifndef PassiveObserver_h
#define PassiveObserver_h

#include <functional>

class vtkObject;

/// Calls the function with the event's data.
void AddPassiveObserver(
  vtkObject* object, unsigned long event, const std::function<void(void*)>& function);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   observers that are called while the mouse is dragged, too
 *
 * In a drag VTK's interactor styles keep the events that they handle to themselves: those of the
 * mouse, keys and timers. Only passive observers are called then.
 */
#ifndef PassiveObserver_h
#define PassiveObserver_h

#include <functional>

class vtkObject;

/// Calls the function with the event's data.
void AddPassiveObserver(
  vtkObject* object, unsigned long event, const std::function<void(void*)>& function);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   observers that are also called while the mouse is dragged
 *
 * During a drag, VTK's interactor styles consume mouse, key and timer events. Only passive
 * observers are still called.
 */
#ifndef PassiveObserver_h
#define PassiveObserver_h

#include <functional>

class vtkObject;

/// Calls the function with the event's data.
void AddPassiveObserver(
  vtkObject* object, unsigned long event, const std::function<void(void*)>& function);

#endif

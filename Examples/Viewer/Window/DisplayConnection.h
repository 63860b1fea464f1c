// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DisplayConnection
 * @brief   a connection to the display by a window that is never shown
 *
 * It stays open until the program's window is closed, because some X servers reset when their last
 * client disconnects, and then refuse the next one. The program's window cannot query the screen
 * before it has an interactor: it would own the connection and close it while VTK 9.1's interactor
 * still uses it.
 */
#ifndef DisplayConnection_h
#define DisplayConnection_h

#include "vtkNew.h"
#include "vtkRenderWindow.h"

class ViewerMessages;
class vtkRenderWindowInteractor;

class DisplayConnection
{
public:
  /// Throws ViewerError if the display cannot be opened.
  explicit DisplayConnection(ViewerMessages& messages);

private:
  vtkNew<vtkRenderWindow> Window;
};

/// Whether DISPLAY names a display.
bool HasDisplay();

/// Sets the interactor style, which rotates around the vertical axis of a terrain, or freely.
void SetStyle(vtkRenderWindowInteractor* interactor, bool isTerrain);

/// Ends the program when its window is closed.
void EndWithWindow(vtkRenderWindowInteractor* interactor);

#endif

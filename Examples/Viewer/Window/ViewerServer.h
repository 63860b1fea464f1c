// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerServer
 * @brief   serves a window to browsers, until Ctrl-C
 */
#ifndef ViewerServer_h
#define ViewerServer_h

#include "vtkSmartPointer.h"

struct ViewerOptions;
class ViewerMessages;
class ViewerScene;
class vtkRenderWindow;
class vtkWindowServer;

class ViewerServer
{
public:
  /// Gives an off-screen window an interactor, which observers can be added to. Throws ViewerError
  /// if this build cannot serve windows.
  ViewerServer(vtkRenderWindow* window, ViewerMessages& messages);
  ~ViewerServer();

  /// Prints the URL on stdout, and serves the window until SIGINT or SIGTERM. Port 0 is any free
  /// port. Throws ViewerError.
  void Run(int port);

private:
  ViewerMessages& Messages;
  vtkSmartPointer<vtkWindowServer> Server;
};

/// Serves a scene with the mouse and the keys of a window. Throws ViewerError.
void ServeScene(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   sends events of an interactor to the current ImGui context
 */
#ifndef ImGuiInput_h
#define ImGuiInput_h

#include <string>

class vtkRenderWindowInteractor;

namespace relevo
{
/// Prepare the keys of the current context.
void PrepareInput();

/// Send the position of the interactor's last event, in a window of this height.
void SendMousePosition(vtkRenderWindowInteractor* interactor, int height);
/// Tell ImGui that the mouse has left the window.
void SendMouseLeave();
/// Send a button: 0 left, 1 right, 2 middle.
void SendMouseButton(int button, bool isDown);
void SendMouseWheel(float steps);

/// Send Shift, Ctrl and Alt of the interactor's last event.
void SendModifiers(vtkRenderWindowInteractor* interactor);
/// Send a key by its symbol, such as Tab or a.
void SendKey(const std::string& symbol, bool isDown);
/// Send a printable character.
void SendCharacter(char character);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   a scene in a window, to be turned and asked
 */
#ifndef ViewerWindow_h
#define ViewerWindow_h

struct ViewerOptions;
class ViewerMessages;
class ViewerScene;

/// Whether DISPLAY names one.
bool HasDisplay();

/// Shows the scene until the window is closed; throws ViewerError.
void ShowWindow(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   shows a scene in an interactive window
 */
#ifndef ViewerWindow_h
#define ViewerWindow_h

struct ViewerOptions;
class ViewerMessages;
class ViewerScene;

/// Shows the scene until the window is closed. Throws ViewerError.
void ShowWindow(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   creates the scene for the options
 */
#ifndef SceneFactory_h
#define SceneFactory_h

#include <memory>

class ViewerMessages;
class ViewerScene;
struct ViewerOptions;

/// Reads the files and returns the scene. Throws ViewerError.
std::unique_ptr<ViewerScene> MakeScene(const ViewerOptions& options, ViewerMessages& messages);

#endif

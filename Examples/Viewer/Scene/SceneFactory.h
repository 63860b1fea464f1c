// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   makes the scene that the options ask for
 */
#ifndef SceneFactory_h
#define SceneFactory_h

#include <memory>

class ViewerMessages;
class ViewerScene;
struct ViewerOptions;

/// Read the files and return the scene. Throws ViewerError.
std::unique_ptr<ViewerScene> MakeScene(const ViewerOptions& options, ViewerMessages& messages);

#endif

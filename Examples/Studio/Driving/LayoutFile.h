// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   writes the layout and the figures of a frame for scripts and tests
 */
#ifndef LayoutFile_h
#define LayoutFile_h

#include "Panels/LayoutList.h"
#include "Scene/SceneContent.h"

#include <string>

/// Writes a JSON list: the controls with their places, then the figures, whose names begin with
/// figure-. Throws ViewerError.
void WriteLayout(
  const std::string& fileName, const LayoutList& layout, const SceneFigures& figures);

#endif

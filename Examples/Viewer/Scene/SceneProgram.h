// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   saves programs that draw the picture of a scene
 */
#ifndef SceneProgram_h
#define SceneProgram_h

#include <array>
#include <string>

class ViewerScene;
struct ViewerOptions;

/// Writes a Python script (.py) that draws the last frame, whose size in pixels is given. Data that
/// a script cannot make from the user's file are written beside it. Throws ViewerError if a program
/// cannot draw the same picture.
void SaveScript(ViewerScene& scene, const ViewerOptions& options, const std::array<int, 2>& size,
  const std::string& fileName);

/// The same as C++ with its CMakeLists.txt, in a folder. Other files in the folder stay.
void SaveSource(ViewerScene& scene, const ViewerOptions& options, const std::array<int, 2>& size,
  const std::string& folder);

#endif

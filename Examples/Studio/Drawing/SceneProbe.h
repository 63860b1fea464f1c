// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneProbe
 * @brief   the values under the mouse, and those of a point that the user keeps
 *
 * Pixels are counted from the lower left corner of the window.
 */
#ifndef SceneProbe_h
#define SceneProbe_h

#include <array>
#include <optional>
#include <string>

class ViewerScene;

using WindowPixel = std::array<int, 2>;

class SceneProbe
{
public:
  /// Finds the values in a pixel, or forgets them without one.
  void Point(ViewerScene& scene, const std::optional<WindowPixel>& pixel);
  /// The values, as lines of text, or "".
  const std::string& GetText() const { return this->Text; }

  /// Keeps the values in a pixel and their point. Returns false if there are none.
  bool Keep(ViewerScene& scene, const WindowPixel& pixel);
  void Forget();
  const std::string& GetKeptText() const { return this->KeptText; }
  /// Where the kept point is in the window, or nothing.
  std::optional<std::array<double, 2>> FindKeptPixel(ViewerScene& scene) const;

private:
  std::string Text;
  std::string KeptText;
  std::array<double, 3> KeptPoint;
};

#endif

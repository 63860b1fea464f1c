// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LegendCode
 * @brief   adds the parts of a legend to the program of a scene
 */
#ifndef LegendCode_h
#define LegendCode_h

#include <array>

class SceneCode;
class vtkScalarsToColors;
class vtkTextActor;

/// How a bar follows the range of its colours.
enum class LegendScale
{
  Linear,
  Logarithmic,
  Indexed
};

class LegendCode
{
public:
  /// The code must know the table.
  LegendCode(SceneCode& code, vtkScalarsToColors* table);

  /// Left, bottom, right and top in pixels.
  void AddRectangle(
    const std::array<int, 4>& sides, const std::array<double, 3>& color, double opacity);
  /// Left, bottom, width and height in pixels.
  void AddBar(const std::array<int, 4>& place, LegendScale scale);
  void AddText(vtkTextActor* text, bool isTitle);

private:
  SceneCode& Code;
  vtkScalarsToColors* Table;
};

#endif

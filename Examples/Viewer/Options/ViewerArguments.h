// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   parses values of options: numbers, words and lists
 *
 * All functions throw UsageError with the option and its value.
 */
#ifndef ViewerArguments_h
#define ViewerArguments_h

#include "Options/UsageError.h"
#include "Text/ViewerText.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A finite number.
double ToNumber(const std::string& option, const std::string& text);

/// A value that a raster can contain: a finite number, nan, inf or -inf.
double ToSample(const std::string& option, const std::string& text);

double ToPositiveNumber(const std::string& option, const std::string& text);

/// A number from `lowest` to `highest`.
double ToNumber(const std::string& option, const std::string& text, double lowest, double highest);

int ToInteger(const std::string& option, const std::string& text, int lowest, int highest);

/// Numbers separated by commas, as many as the form, for example X,Y,Z, has words.
std::vector<double> ToNumbers(
  const std::string& option, const std::string& text, const std::string& form);

/// One or more numbers separated by commas.
std::vector<double> ToList(const std::string& option, const std::string& text);

/// A,B: A is less than B.
std::array<double, 2> ToRange(const std::string& option, const std::string& text);

/// Red, green and blue from 0 to 1 of `#rrggbb` or of a name of HTML, such as `white`.
std::array<double, 3> ToColor(const std::string& option, const std::string& text);

/// X,Y,Z,NX,NY,NZ: a point and a nonzero normal.
std::vector<double> ToPlane(const std::string& option, const std::string& text);

/// AZIMUTH,ELEVATION in degrees. The elevation is at most the given one, upwards or downwards.
std::array<double, 2> ToDirection(
  const std::string& option, const std::string& text, double highest);

/// Azimuth and elevation of `front`, `back`, `left`, `right`, `top` or `bottom`; nothing for other
/// words.
std::optional<std::array<double, 2>> FindPlanView(const std::string& name);

/// Longitude and latitude of `86.925E,27.988N`, in either order. Returns nothing if no part has
/// such a letter.
std::optional<std::array<double, 2>> ToDegrees(const std::string& option, const std::string& text);

/// Longitude and latitude as numbers, in this order, or with letters as ToDegrees().
std::array<double, 2> ToLongitudeLatitude(const std::string& option, const std::string& text);

/// X,Y,Z, or X,Y for height maps.
std::vector<double> ToPlace(const std::string& option, const std::string& text, bool isOnMesh);

/// WIDTHxHEIGHT in pixels.
void ToSize(const std::string& option, const std::string& text, int size[2]);

/// Three positive integers.
void ToBands(const std::string& option, const std::string& text, int bands[3]);

/// A file name with one of the extensions, for example .png.
std::string ToFileName(
  const std::string& option, const std::string& text, const std::vector<std::string>& extensions);

/// The value that belongs to a word.
template <typename T>
T ToChoice(const std::string& option, const std::string& text,
  const std::vector<std::pair<std::string, T>>& choices)
{
  std::vector<std::string> words;
  for (const auto& choice : choices)
  {
    if (choice.first == text)
    {
      return choice.second;
    }
    words.push_back(choice.first);
  }
  throw UsageError(option + " needs " + JoinWords(words) + ", not '" + text + "'");
}

#endif

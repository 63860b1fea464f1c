// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what the values of options are: numbers, words, lists
 *
 * All throw UsageError, with the option's name and the value in it.
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

/// Finite.
double ToNumber(const std::string& option, const std::string& text);

/// A value that a raster may hold: a finite number, nan, inf or -inf.
double ToSample(const std::string& option, const std::string& text);

double ToPositiveNumber(const std::string& option, const std::string& text);

/// From `lowest` to `highest`.
double ToNumber(const std::string& option, const std::string& text, double lowest, double highest);

int ToInteger(const std::string& option, const std::string& text, int lowest, int highest);

/// Numbers between commas, as many as the form, say X,Y,Z, has words.
std::vector<double> ToNumbers(
  const std::string& option, const std::string& text, const std::string& form);

/// Numbers between commas, one or more.
std::vector<double> ToList(const std::string& option, const std::string& text);

/// X,Y,Z,NX,NY,NZ: a place and a normal that has a direction.
std::vector<double> ToPlane(const std::string& option, const std::string& text);

/// AZIMUTH,ELEVATION in degrees, the elevation no more than the highest up or down.
std::array<double, 2> ToDirection(
  const std::string& option, const std::string& text, double highest);

/// Longitude and latitude of `86.925E,27.988N`, in either order; nothing if no part has such a
/// letter.
std::optional<std::array<double, 2>> ToDegrees(const std::string& option, const std::string& text);

/// X,Y,Z or, on height maps, X,Y.
std::vector<double> ToPlace(const std::string& option, const std::string& text, bool isOnMesh);

/// WIDTHxHEIGHT
void ToSize(const std::string& option, const std::string& text, int size[2]);

/// Three whole numbers above 0.
void ToBands(const std::string& option, const std::string& text, int bands[3]);

/// A file name with one of the extensions, say .png.
std::string ToFileName(
  const std::string& option, const std::string& text, const std::vector<std::string>& extensions);

/// What a word stands for.
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

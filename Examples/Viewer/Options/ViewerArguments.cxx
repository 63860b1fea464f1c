// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/ViewerArguments.h"

#include "Files/ViewerFile.h"

#include "vtkColor.h"
#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace
{
const int LargestBand = 65535;
const int LargestSize = 16384;

UsageError BadValue(const std::string& option, const std::string& what, const std::string& text)
{
  return UsageError(option + " needs " + what + ", not '" + text + "'");
}

// Splits a text at commas.
std::vector<std::string> Split(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text + ",");
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

std::string ToText(double value)
{
  std::ostringstream stream;
  stream << value;
  return stream.str();
}
}

//------------------------------------------------------------------------------
double ToNumber(const std::string& option, const std::string& text)
{
  std::size_t end = 0;
  double value = 0.0;
  try
  {
    value = std::stod(text, &end);
  }
  catch (const std::logic_error&)
  {
    end = 0;
  }
  if (end == 0 || end != text.size() || !std::isfinite(value))
  {
    throw BadValue(option, "a number", text);
  }
  return value;
}

//------------------------------------------------------------------------------
double ToNumber(const std::string& option, const std::string& text, double lowest, double highest)
{
  const double value = ToNumber(option, text);
  if (value < lowest || value > highest)
  {
    throw BadValue(option, "a number from " + ToText(lowest) + " to " + ToText(highest), text);
  }
  return value;
}

//------------------------------------------------------------------------------
double ToSample(const std::string& option, const std::string& text)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const std::map<std::string, double> words = { { "nan", std::nan("") }, { "inf", infinity },
    { "-inf", -infinity } };
  const auto word = words.find(vtksys::SystemTools::LowerCase(text));
  return word != words.end() ? word->second : ToNumber(option, text);
}

//------------------------------------------------------------------------------
double ToPositiveNumber(const std::string& option, const std::string& text)
{
  const double value = ToNumber(option, text);
  if (value <= 0.0)
  {
    throw BadValue(option, "a number above 0", text);
  }
  return value;
}

//------------------------------------------------------------------------------
int ToInteger(const std::string& option, const std::string& text, int lowest, int highest)
{
  const double value = ToNumber(option, text);
  if (value != std::floor(value) || value < lowest || value > highest)
  {
    throw BadValue(option,
      "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest), text);
  }
  return static_cast<int>(value);
}

//------------------------------------------------------------------------------
std::vector<double> ToNumbers(
  const std::string& option, const std::string& text, const std::string& form)
{
  const std::vector<std::string> parts = Split(text);
  if (parts.size() != Split(form).size())
  {
    throw BadValue(option, form, text);
  }
  return ToList(option, text);
}

//------------------------------------------------------------------------------
std::vector<double> ToList(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = Split(text);
  std::vector<double> numbers;
  std::transform(parts.begin(), parts.end(), std::back_inserter(numbers),
    [&](const std::string& part) { return ToNumber(option, part); });
  return numbers;
}

//------------------------------------------------------------------------------
std::array<double, 2> ToRange(const std::string& option, const std::string& text)
{
  const std::vector<double> numbers = ToNumbers(option, text, "A,B");
  if (numbers[0] >= numbers[1])
  {
    throw BadValue(option, "A,B with A less than B", text);
  }
  return { { numbers[0], numbers[1] } };
}

//------------------------------------------------------------------------------
std::array<double, 3> ToColor(const std::string& option, const std::string& text)
{
  const bool isNumber = text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  vtkNew<vtkNamedColors> colours;
  if (!isNumber && (text.empty() || !colours->ColorExists(text)))
  {
    throw BadValue(option, "a colour such as white or #ff8800", text);
  }
  const vtkColor3ub bytes = isNumber ? colours->HTMLColorToRGB(text) : colours->GetColor3ub(text);
  return { { bytes.GetRed() / 255.0, bytes.GetGreen() / 255.0, bytes.GetBlue() / 255.0 } };
}

//------------------------------------------------------------------------------
std::vector<double> ToPlane(const std::string& option, const std::string& text)
{
  const std::vector<double> numbers = ToNumbers(option, text, "X,Y,Z,NX,NY,NZ");
  if (!(std::hypot(numbers[3], numbers[4], numbers[5]) > 0.0))
  {
    throw BadValue(option, "a normal other than 0,0,0", text);
  }
  return numbers;
}

//------------------------------------------------------------------------------
std::array<double, 2> ToDirection(
  const std::string& option, const std::string& text, double highest)
{
  const auto angles = ToNumbers(option, text, "AZIMUTH,ELEVATION");
  ToNumber(option + "'s elevation", Split(text)[1], -highest, highest);
  return { { angles[0], angles[1] } };
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> FindPlanView(const std::string& name)
{
  static const std::map<std::string, std::array<double, 2>> views = { { "front", { 180.0, 0.0 } },
    { "back", { 0.0, 0.0 } }, { "left", { 270.0, 0.0 } }, { "right", { 90.0, 0.0 } },
    { "top", { 180.0, 90.0 } }, { "bottom", { 180.0, -90.0 } } };
  const auto found = views.find(name);
  return found == views.end() ? std::nullopt : std::make_optional(found->second);
}

//------------------------------------------------------------------------------
std::vector<double> ToPlace(const std::string& option, const std::string& text, bool isOnMesh)
{
  const std::size_t numbers = Split(text).size();
  if (numbers != 3 && (isOnMesh || numbers != 2))
  {
    throw BadValue(option, isOnMesh ? "X,Y,Z" : "X,Y or X,Y,Z", text);
  }
  return ToNumbers(option, text, numbers == 3 ? "X,Y,Z" : "X,Y");
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> ToDegrees(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = Split(text);
  const std::string letters = "EeWwNnSs";
  const auto isDegrees = [&](const std::string& part)
  { return part.size() > 1 && letters.find(part.back()) != std::string::npos; };
  if (std::none_of(parts.begin(), parts.end(), isDegrees))
  {
    return std::nullopt;
  }
  std::array<std::optional<double>, 2> degrees;
  for (const std::string& part : parts)
  {
    const std::size_t letter = letters.find(part.empty() ? ' ' : part.back());
    const std::size_t axis = letter < 4 ? 0 : 1;
    if (letter == std::string::npos || degrees[axis] || parts.size() != 2)
    {
      throw BadValue(option, "a longitude and a latitude such as 86.925E,27.988N", text);
    }
    const double size = ToNumber(option + (axis == 0 ? "'s longitude" : "'s latitude"),
      part.substr(0, part.size() - 1), axis == 0 ? -180.0 : -90.0, axis == 0 ? 360.0 : 90.0);
    degrees[axis] = letter % 4 < 2 ? size : -size;
  }
  return { { *degrees[0], *degrees[1] } };
}

//------------------------------------------------------------------------------
std::array<double, 2> ToLongitudeLatitude(const std::string& option, const std::string& text)
{
  if (const std::optional<std::array<double, 2>> degrees = ToDegrees(option, text))
  {
    return *degrees;
  }
  const std::vector<double> numbers = ToNumbers(option, text, "LON,LAT");
  if (std::abs(numbers[1]) > 90.0 || numbers[0] < -180.0 || numbers[0] > 360.0)
  {
    throw BadValue(option, "a longitude from -180 to 360 and a latitude from -90 to 90", text);
  }
  return { { numbers[0], numbers[1] } };
}

//------------------------------------------------------------------------------
void ToSize(const std::string& option, const std::string& text, int size[2])
{
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos)
  {
    throw BadValue(option, "WIDTHxHEIGHT", text);
  }
  size[0] = ToInteger(option, text.substr(0, cross), 1, LargestSize);
  size[1] = ToInteger(option, text.substr(cross + 1), 1, LargestSize);
}

//------------------------------------------------------------------------------
void ToBands(const std::string& option, const std::string& text, int bands[3])
{
  const std::vector<std::string> parts = Split(text);
  if (parts.size() != 3)
  {
    throw BadValue(option, "three bands such as 3,2,1", text);
  }
  std::transform(parts.begin(), parts.end(), bands,
    [&](const std::string& part) { return ToInteger(option, part, 1, LargestBand); });
}

//------------------------------------------------------------------------------
std::string ToFileName(
  const std::string& option, const std::string& text, const std::vector<std::string>& extensions)
{
  if (std::find(extensions.begin(), extensions.end(), GetExtension(text)) == extensions.end())
  {
    throw BadValue(option, "the name of a " + JoinWords(extensions) + " file", text);
  }
  return text;
}

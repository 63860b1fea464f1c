// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Quantities/ArrayQuantity.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace relevo
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// In the order xx, yy, zz, xy, yz, xz.
using Tensor = std::array<double, 6>;
constexpr std::array<int, 6> Rows{ 0, 1, 2, 0, 1, 0 };
constexpr std::array<int, 6> Columns{ 0, 1, 2, 1, 2, 2 };

bool IsTensor(int components)
{
  return components == 6 || components == 9;
}

Tensor ReadTensor(const double* values, int components)
{
  Tensor tensor;
  for (int i = 0; i < 6; ++i)
  {
    tensor[i] = components == 6
      ? values[i]
      : 0.5 * (values[3 * Rows[i] + Columns[i]] + values[3 * Columns[i] + Rows[i]]);
  }
  return tensor;
}

double GetVonMises(const Tensor& t)
{
  const double normal =
    std::pow(t[0] - t[1], 2) + std::pow(t[1] - t[2], 2) + std::pow(t[2] - t[0], 2);
  return std::sqrt(0.5 * normal + 3.0 * (t[3] * t[3] + t[4] * t[4] + t[5] * t[5]));
}

// The largest first.
std::array<double, 3> GetPrincipalValues(const Tensor& tensor)
{
  if (!std::all_of(tensor.begin(), tensor.end(), [](double x) { return std::isfinite(x); }))
  {
    return { NotANumber, NotANumber, NotANumber };
  }
  double matrix[3][3];
  double vectors[3][3];
  std::array<double, 3> values;
  for (int i = 0; i < 6; ++i)
  {
    matrix[Rows[i]][Columns[i]] = matrix[Columns[i]][Rows[i]] = tensor[i];
  }
  double* rows[3] = { matrix[0], matrix[1], matrix[2] };
  double* columns[3] = { vectors[0], vectors[1], vectors[2] };
  vtkMath::Jacobi(rows, values.data(), columns);
  std::sort(values.rbegin(), values.rend());
  return values;
}

double GetMean(const double* values, int components)
{
  double sum = 0.0;
  for (int c = 0; c < components; ++c)
  {
    sum += values[c] / components;
  }
  return sum;
}

double GetMagnitude(const double* values, int components)
{
  double sum = 0.0;
  for (int c = 0; c < components; ++c)
  {
    sum += values[c] * values[c];
  }
  return std::sqrt(sum);
}

std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

int FindAxis(char letter)
{
  const std::size_t axis = std::string("xyz").find(letter);
  return axis < 3 ? static_cast<int>(axis) : -1;
}

bool IsNumber(const std::string& text)
{
  return !text.empty() && text.size() < 4 &&
    std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Finds the quantity of lower-case words.
std::optional<ArrayQuantity> FindQuantity(const std::string& words)
{
  const std::map<std::string, ArrayQuantity> named = {
    { "von mises", { ArrayQuantity::VonMises, "von Mises" } },
    { "von-mises", { ArrayQuantity::VonMises, "von Mises" } },
    { "tresca", { ArrayQuantity::Tresca, "Tresca" } },
    { "magnitude", { ArrayQuantity::Magnitude, words } },
    { "mean", { ArrayQuantity::Mean, words } },
    { "principal 1", { ArrayQuantity::Principal, words, 0 } },
    { "principal 2", { ArrayQuantity::Principal, words, 1 } },
    { "principal 3", { ArrayQuantity::Principal, words, 2 } },
  };
  const auto found = named.find(words);
  if (found != named.end())
  {
    return found->second;
  }
  const std::string component = "component ";
  if (words.rfind(component, 0) == 0 && IsNumber(words.substr(component.size())))
  {
    const int index = std::stoi(words.substr(component.size()));
    return ArrayQuantity{ ArrayQuantity::Component, words, index };
  }
  if (words.size() == 1 && FindAxis(words[0]) >= 0)
  {
    return ArrayQuantity{ ArrayQuantity::Coordinate, words, FindAxis(words[0]) };
  }
  if (words.size() == 2 && FindAxis(words[0]) >= 0 && FindAxis(words[1]) >= 0)
  {
    return ArrayQuantity{ ArrayQuantity::Entry, words, FindAxis(words[0]), FindAxis(words[1]) };
  }
  return std::nullopt;
}

// The place of an entry in a tuple; at least the number of components if there is none.
int FindEntry(const ArrayQuantity& quantity, int components)
{
  if (components == 9)
  {
    return 3 * quantity.Index + quantity.Column;
  }
  for (int i = 0; i < 6; ++i)
  {
    if (Rows[i] == quantity.Index && Columns[i] == quantity.Column)
    {
      return i;
    }
  }
  return components;
}

double ComputeNumber(const ArrayQuantity& quantity, const double* values, int components)
{
  switch (quantity.Kind)
  {
    case ArrayQuantity::Component:
    case ArrayQuantity::Coordinate:
      return values[quantity.Index];
    case ArrayQuantity::Entry:
      return values[FindEntry(quantity, components)];
    case ArrayQuantity::Magnitude:
      return GetMagnitude(values, components);
    case ArrayQuantity::Mean:
      return GetMean(values, components);
    case ArrayQuantity::VonMises:
      return GetVonMises(ReadTensor(values, components));
    case ArrayQuantity::Tresca:
    {
      const std::array<double, 3> principal = GetPrincipalValues(ReadTensor(values, components));
      return principal[0] - principal[2];
    }
    case ArrayQuantity::Principal:
      return GetPrincipalValues(ReadTensor(values, components))[quantity.Index];
  }
  return NotANumber;
}
}

std::optional<ArrayQuantity> ParseQuantity(const std::string& text)
{
  const std::string joint = " of ";
  const std::size_t end = text.find(joint);
  const std::string words = ToLower(text.substr(0, end));
  std::optional<ArrayQuantity> quantity = FindQuantity(words);
  if (quantity && end != std::string::npos)
  {
    quantity->Source = text.substr(end + joint.size());
  }
  const bool needsSource = quantity && quantity->Kind != ArrayQuantity::VonMises &&
    quantity->Kind != ArrayQuantity::Tresca && quantity->Kind != ArrayQuantity::Principal;
  return needsSource && quantity->Source.empty() ? std::nullopt : quantity;
}

std::vector<std::string> FindQuantities(int components)
{
  std::vector<std::string> names = { "magnitude", "x", "y", "z" };
  if (IsTensor(components))
  {
    names = { "von Mises", "Tresca", "principal 1", "principal 2", "principal 3", "xx", "yy", "zz",
      "xy", "yz", "xz", "yx", "zy", "zx", "magnitude" };
  }
  const auto isUnusable = [&](const std::string& name)
  { return components < 2 || !FindQuantity(ToLower(name))->CanUse(components); };
  names.erase(std::remove_if(names.begin(), names.end(), isUnusable), names.end());
  const bool hasNames = names.size() > 1;
  if (!hasNames && !names.empty())
  {
    names.push_back("mean");
  }
  for (int i = 0; !hasNames && !names.empty() && i < components; ++i)
  {
    names.push_back("component " + std::to_string(i));
  }
  return names;
}

bool ArrayQuantity::CanUse(int components) const
{
  switch (this->Kind)
  {
    case Component:
      return this->Index < components;
    case Coordinate:
      return (components == 2 || components == 3) && this->Index < components;
    case Entry:
      return IsTensor(components) && FindEntry(*this, components) < components;
    case Magnitude:
    case Mean:
      return true;
    default:
      return IsTensor(components);
  }
}

std::string ArrayQuantity::GetNeed() const
{
  switch (this->Kind)
  {
    case Component:
      return "more than " + std::to_string(this->Index) + " components";
    case Coordinate:
      return this->Index < 2 ? "2 or 3 components" : "3 components";
    case Entry:
      return this->Index <= this->Column ? "6 or 9 components" : "9 components";
    case Magnitude:
    case Mean:
      return "numbers";
    default:
      return "6 or 9 components";
  }
}

vtkSmartPointer<vtkDataArray> ArrayQuantity::Compute(vtkDataArray* array) const
{
  auto result = vtkSmartPointer<vtkDoubleArray>::New();
  result->SetNumberOfTuples(array->GetNumberOfTuples());
  const int components = array->GetNumberOfComponents();
  vtkSMPTools::For(0, array->GetNumberOfTuples(),
    [&](vtkIdType first, vtkIdType end)
    {
      std::vector<double> values(static_cast<std::size_t>(components));
      for (vtkIdType i = first; i < end; ++i)
      {
        array->GetTuple(i, values.data());
        result->SetValue(i, ComputeNumber(*this, values.data(), components));
      }
    });
  if (array->HasInformation())
  {
    result->CopyInformation(array->GetInformation()); // with the unit
  }
  return result;
}
}

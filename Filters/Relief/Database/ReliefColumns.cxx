// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Database/ReliefColumns.h"

#include "Data/Reliefs.h"
#include "Database/CSVFile.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace relevo
{
namespace
{
void AddVector(ReliefParameters& parameters, const std::string& name, const dvec3& vector)
{
  for (int i = 0; i < 3; ++i)
  {
    parameters.emplace_back(name + "_" + "xyz"[i], FormatNumber(vector[i]));
  }
}

bool IsOfFiles(const std::string& name)
{
  return name.find(FileColumn) == 0;
}

bool Has(const ReliefParameters& parameters, const std::string& name)
{
  return std::any_of(parameters.begin(), parameters.end(),
    [&](const auto& parameter) { return parameter.first == name; });
}

// The view at the middle of the texels. Depths increase away from the viewer.
void AddView(ReliefParameters& parameters, const Relief& relief)
{
  const double column = 0.5 * (relief.GetWidth() - 1);
  const double row = 0.5 * (relief.GetHeight() - 1);
  const dmat4& matrix = relief.GetTexelToWorld();
  const dvec4 middle = matrix * dvec4(column, row, 0.0, 1.0);
  const dvec4 position = relief.IsPerspective() ? matrix[2] : middle;
  const dvec4 direction = relief.IsPerspective() ? middle : matrix[2];
  AddVector(parameters, "position", dvec3(position) / position.w);
  AddVector(parameters, "direction", normalize(dvec3(direction)));
  AddVector(parameters, "up", normalize(dvec3(matrix[1])));
}

void AddFieldArrays(ReliefParameters& parameters, vtkFieldData* fields)
{
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (array->GetNumberOfValues() != 1 || name.empty() || IsOfFiles(name) ||
      name == Relief::GetProjectionName() || Has(parameters, name))
    {
      continue;
    }
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      parameters.emplace_back(name, FormatNumber(numbers->GetComponent(0, 0)));
    }
    else if (auto* texts = vtkStringArray::SafeDownCast(array))
    {
      parameters.emplace_back(name, texts->GetValue(0));
    }
  }
}
}

ReliefParameters GetReliefParameters(const ReliefBlock& block)
{
  const Relief& relief = block.Data;
  ReliefParameters parameters;
  parameters.emplace_back("name", block.Name);
  parameters.emplace_back("projection", relief.IsPerspective() ? "1" : "0");
  parameters.emplace_back("columns", std::to_string(relief.GetWidth()));
  parameters.emplace_back("rows", std::to_string(relief.GetHeight()));
  const double valid = static_cast<double>(relief.GetNumberOfValidTexels());
  parameters.emplace_back(
    "valid", FormatNumber(valid / static_cast<double>(relief.GetNumberOfTexels())));
  AddView(parameters, relief);
  AddFieldArrays(parameters, relief.GetImage()->GetFieldData());
  return parameters;
}

std::vector<std::vector<std::string>> MakeTable(const std::vector<ReliefParameters>& reliefs)
{
  std::vector<std::string> names;
  for (bool areOfFiles : { false, true })
  {
    for (const ReliefParameters& relief : reliefs)
    {
      for (const auto& parameter : relief)
      {
        if (IsOfFiles(parameter.first) == areOfFiles &&
          std::find(names.begin(), names.end(), parameter.first) == names.end())
        {
          names.push_back(parameter.first);
        }
      }
    }
  }
  std::vector<std::vector<std::string>> rows{ names };
  for (const ReliefParameters& relief : reliefs)
  {
    std::vector<std::string> row(names.size());
    for (const auto& parameter : relief)
    {
      row[std::find(names.begin(), names.end(), parameter.first) - names.begin()] =
        parameter.second;
    }
    rows.push_back(row);
  }
  return rows;
}

int FindReliefFile(const std::vector<std::string>& names, const std::vector<std::string>& row)
{
  for (std::size_t i = 0; i < names.size() && i < row.size(); ++i)
  {
    std::string extension = std::filesystem::path(row[i]).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (IsOfFiles(names[i]) && extension == ".vti")
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::string GetDatabaseFolder(const std::string& fileName)
{
  const std::filesystem::path path(fileName);
  const std::filesystem::path folder = path.filename() == DatabaseTable ? path.parent_path() : path;
  return folder.empty() ? "." : folder.string();
}
}

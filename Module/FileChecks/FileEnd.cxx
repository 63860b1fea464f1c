// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FileEnd.h"

#include "FileError.h"
#include "FileNames.h"
#include "NetCDFCheck.h"
#include "OBJCheck.h"
#include "PLYCheck.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

namespace
{
// The last bytes of a file, without trailing white space.
std::string ReadEnd(const std::string& fileName, std::streamoff number)
{
  std::ifstream file(fileName, std::ios::binary);
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  file.seekg(std::max<std::streamoff>(size - number, 0));
  std::string end(static_cast<std::size_t>(std::min(size, number)), '\0');
  file.read(end.data(), static_cast<std::streamsize>(end.size()));
  end.erase(end.find_last_not_of(" \t\r\n") + 1);
  return end;
}

using Warn = std::function<void(const std::string&)>;

void CheckXML(const std::string& fileName, const Warn&)
{
  const std::string tag = "</VTKFile>";
  const std::string end = ReadEnd(fileName, 1024);
  if (end.size() < tag.size() || end.compare(end.size() - tag.size(), tag.size(), tag) != 0)
  {
    throw FileError("the file is truncated: it does not end with " + tag);
  }
}

// VTK's reader skips pieces that it cannot read.
void CheckPieces(const std::string& fileName, const Warn& warn)
{
  CheckXML(fileName, warn);
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
    vtkXMLUtilities::ReadElementFromFile(fileName.c_str()));
  vtkXMLDataElement* grid = root ? root->FindNestedElementWithName("PUnstructuredGrid") : nullptr;
  const std::filesystem::path folder = std::filesystem::path(fileName).parent_path();
  for (int i = 0; grid && i < grid->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* piece = grid->GetNestedElement(i);
    const char* source = piece->GetAttribute("Source");
    if (!source || std::string(piece->GetName()) != "Piece")
    {
      continue;
    }
    const std::string name = (folder / source).string();
    const std::string reason = FindReadError(name);
    if (!reason.empty())
    {
      throw FileError("its piece " + name + ": " + reason);
    }
    try
    {
      CheckXML(name, warn);
    }
    catch (const FileError& error)
    {
      throw FileError("its piece " + name + ": " + error.what());
    }
  }
}

bool IsText(const std::string& begin)
{
  const std::size_t word = begin.find_first_not_of(" \t\r\n");
  return word != std::string::npos && begin.compare(word, 5, "solid") == 0 &&
    begin.find('\0') == std::string::npos;
}

// Some programs write a wrong number of triangles, but always complete ones.
void CheckSTL(const std::string& fileName, const Warn& warn)
{
  constexpr long long header = 84;
  constexpr long long triangle = 50;
  std::ifstream file(fileName, std::ios::binary);
  std::string begin(512, ' ');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  const auto size = static_cast<long long>(std::filesystem::file_size(fileName));
  long long number = 0;
  for (std::size_t i = 0; i < 4 && begin.size() >= header; ++i)
  {
    number |= static_cast<long long>(static_cast<unsigned char>(begin[80 + i])) << (8 * i);
  }
  if (size == header + number * triangle)
  {
    return;
  }
  if (IsText(begin))
  {
    if (ReadEnd(fileName, 1024).find("endsolid") == std::string::npos)
    {
      throw FileError("the file is truncated: it does not end with endsolid");
    }
    return;
  }
  const long long rest = size - header;
  if (rest < 0 || (rest < number * triangle && rest % triangle != 0))
  {
    throw FileError("the file is truncated: its header declares " + std::to_string(number) +
      " triangles, but there are " + std::to_string(std::max(rest, 0LL) / triangle));
  }
  if (rest / triangle != number)
  {
    warn(fileName + ": the header declares " + std::to_string(number) +
      " triangles, but there are " + std::to_string(rest / triangle));
  }
}
}

//------------------------------------------------------------------------------
void CheckFileEnd(const std::string& fileName, const Warn& warn)
{
  using Function = std::function<void(const std::string&, const Warn&)>;
  static const std::map<std::string, Function> checks = {
    { ".obj", [](const std::string& name, const Warn&) { CheckOBJ(name); } },
    { ".ply", [](const std::string& name, const Warn&) { CheckPLY(name); } },
    { ".e", [](const std::string& name, const Warn&) { CheckNetCDF(name); } },
    { ".ex2", [](const std::string& name, const Warn&) { CheckNetCDF(name); } },
    { ".exo", [](const std::string& name, const Warn&) { CheckNetCDF(name); } },
    { ".g", [](const std::string& name, const Warn&) { CheckNetCDF(name); } },
    { ".nc", [](const std::string& name, const Warn&) { CheckNetCDF(name); } },
    { ".pvtu", CheckPieces },
    { ".stl", CheckSTL },
    { ".vtp", CheckXML },
    { ".vtu", CheckXML },
  };
  const auto check = checks.find(GetExtension(fileName));
  if (check != checks.end())
  {
    check->second(fileName, warn);
  }
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OBJCheck.h"

#include "FileError.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fstream>

namespace
{
// The lists that the numbers in a corner such as 1/2/3 refer to, in this order.
enum Kind
{
  Points,
  TextureCoordinates,
  Normals,
  NumberOfKinds
};
constexpr std::array<const char*, NumberOfKinds> Names = { "point", "texture coordinate",
  "normal" };

class Checker
{
public:
  explicit Checker(const std::string& fileName)
    : File(fileName, std::ios::binary)
  {
  }

  void Check()
  {
    std::string line;
    for (long long number = 1; std::getline(this->File, line); ++number)
    {
      this->ReadLine(line, number);
    }
    for (int kind = 0; kind < NumberOfKinds; ++kind)
    {
      this->Require(this->Highest[kind], kind, this->LineOfHighest[kind]);
    }
  }

private:
  void ReadLine(const std::string& line, long long number)
  {
    const char* text = line.c_str();
    text += std::min(line.find_first_not_of(" \t"), line.size());
    const char* end = text;
    while (*end != '\0' && !std::isspace(static_cast<unsigned char>(*end)))
    {
      ++end;
    }
    const std::string word(text, end);
    if (word == "v" || word == "vt" || word == "vn")
    {
      ++this->Counts[word == "v" ? Points : word == "vt" ? TextureCoordinates : Normals];
    }
    else if (word == "f" || word == "l" || word == "p")
    {
      this->ReadCorners(end, number);
    }
  }

  // Ignores other text, which VTK's reader reports.
  void ReadCorners(const char* text, long long line)
  {
    for (int kind = Points; *text != '\0';)
    {
      if (*text == '/')
      {
        ++kind;
        ++text;
        if (kind == NumberOfKinds)
        {
          throw FileError(
            "line " + std::to_string(line) + " has a corner with more than three indices");
        }
        continue;
      }
      if (std::isspace(static_cast<unsigned char>(*text)))
      {
        kind = Points;
        ++text;
        continue;
      }
      char* end = nullptr;
      const long long index = std::strtoll(text, &end, 10);
      if (end == text)
      {
        return;
      }
      this->AddIndex(index, kind, line);
      text = end;
    }
  }

  // Negative indices count backwards from this line.
  void AddIndex(long long index, int kind, long long line)
  {
    if (index == 0 || index < -this->Counts[kind])
    {
      throw FileError("line " + std::to_string(line) + " refers to " + Names[kind] + " " +
        std::to_string(index) + ", but there are " + std::to_string(this->Counts[kind]) +
        " before it");
    }
    if (index > this->Highest[kind])
    {
      this->Highest[kind] = index;
      this->LineOfHighest[kind] = line;
    }
  }

  void Require(long long index, int kind, long long line) const
  {
    if (index > this->Counts[kind])
    {
      throw FileError("line " + std::to_string(line) + " refers to " + Names[kind] + " " +
        std::to_string(index) + ", but there are " + std::to_string(this->Counts[kind]));
    }
  }

  std::ifstream File;
  std::array<long long, NumberOfKinds> Counts{};
  std::array<long long, NumberOfKinds> Highest{};
  std::array<long long, NumberOfKinds> LineOfHighest{};
};
}

//------------------------------------------------------------------------------
void CheckOBJ(const std::string& fileName)
{
  Checker(fileName).Check();
}

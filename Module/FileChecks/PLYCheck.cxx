// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYCheck.h"

#include "FileError.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace
{
struct Property
{
  int Size = 0;      // in bytes, of a list's items
  int CountSize = 0; // in bytes, 0 if it is not a list
};

struct Element
{
  std::string Name;
  long long Count = 0;
  std::vector<Property> Properties;
};

class PLYChecker
{
public:
  explicit PLYChecker(const std::string& fileName)
    : File(fileName, std::ios::binary)
    , Left(static_cast<long long>(std::filesystem::file_size(fileName)))
  {
  }

  void Check()
  {
    this->ReadHeader();
    this->Left -= static_cast<long long>(this->File.tellg());
    for (const Element& element : this->Elements)
    {
      this->IsText ? this->CheckLines(element) : this->CheckBytes(element);
    }
  }

private:
  static int GetSize(const std::string& type)
  {
    static const std::map<std::string, int> sizes = { { "char", 1 }, { "double", 8 },
      { "float", 4 }, { "float32", 4 }, { "float64", 8 }, { "int", 4 }, { "int16", 2 },
      { "int32", 4 }, { "int8", 1 }, { "short", 2 }, { "uchar", 1 }, { "uint", 4 }, { "uint16", 2 },
      { "uint32", 4 }, { "uint8", 1 }, { "ushort", 2 } };
    const auto size = sizes.find(type);
    if (size == sizes.end())
    {
      throw FileError("its header has a property of the unknown type '" + type + "'");
    }
    return size->second;
  }

  void ReadHeader()
  {
    std::string line;
    std::getline(this->File, line);
    if (line.compare(0, 3, "ply") != 0)
    {
      throw FileError("it is not a PLY file");
    }
    bool hasFormat = false;
    while (std::getline(this->File, line))
    {
      std::istringstream words(line);
      std::string word;
      words >> word;
      if (word == "end_header")
      {
        if (!hasFormat)
        {
          break;
        }
        return;
      }
      hasFormat = this->ReadHeaderLine(word, words) || hasFormat;
    }
    throw FileError(hasFormat ? "its header has no end_header: the file is truncated"
                              : "its header has no format line");
  }

  // Returns whether the line names the format.
  bool ReadHeaderLine(const std::string& keyword, std::istream& words)
  {
    std::string word;
    if (keyword == "format")
    {
      words >> word;
      this->IsText = word == "ascii";
      this->IsBigEndian = word == "binary_big_endian";
      if (!this->IsText && !this->IsBigEndian && word != "binary_little_endian")
      {
        throw FileError("its header has the unknown format '" + word + "'");
      }
      return true;
    }
    if (keyword == "element")
    {
      Element element;
      if (!(words >> element.Name >> element.Count) || element.Count < 0)
      {
        throw FileError("its header has an element without a number");
      }
      this->Elements.push_back(element);
    }
    else if (keyword == "property" && !this->Elements.empty())
    {
      Property property;
      words >> word;
      if (word == "list")
      {
        words >> word;
        property.CountSize = GetSize(word);
        words >> word;
      }
      property.Size = GetSize(word);
      this->Elements.back().Properties.push_back(property);
    }
    return false;
  }

  [[noreturn]] static void FailShort(const Element& element, long long number)
  {
    throw FileError("the file is truncated: its header declares " + std::to_string(element.Count) +
      " of '" + element.Name + "', but there are " + std::to_string(number));
  }

  // Returns whether the file has this many bytes left.
  bool Skip(long long bytes)
  {
    if (bytes < 0 || bytes > this->Left)
    {
      return false;
    }
    this->Left -= bytes;
    this->File.ignore(bytes);
    return true;
  }

  // Returns -1 at the end of the file.
  long long ReadCount(int size)
  {
    unsigned char bytes[8] = {};
    if (size > this->Left || !this->File.read(reinterpret_cast<char*>(bytes), size))
    {
      return -1;
    }
    this->Left -= size;
    std::uint64_t count = 0;
    for (int i = 0; i < size; ++i)
    {
      count = count << 8 | bytes[this->IsBigEndian ? i : size - 1 - i];
    }
    return static_cast<long long>(count);
  }

  void CheckBytes(const Element& element)
  {
    long long fixed = 0;
    bool hasLists = false;
    for (const Property& property : element.Properties)
    {
      fixed += property.CountSize > 0 ? 0 : property.Size;
      hasLists = hasLists || property.CountSize > 0;
    }
    if (!hasLists)
    {
      const long long number = fixed > 0 ? this->Left / fixed : element.Count;
      if (number < element.Count || !this->Skip(element.Count * fixed))
      {
        FailShort(element, number);
      }
      return;
    }
    for (long long i = 0; i < element.Count; ++i)
    {
      for (const Property& property : element.Properties)
      {
        const long long items = property.CountSize > 0 ? this->ReadCount(property.CountSize) : 1;
        if (items < 0 || items > this->Left || !this->Skip(items * property.Size))
        {
          FailShort(element, i);
        }
      }
    }
  }

  // VTK reads one line per item.
  void CheckLines(const Element& element)
  {
    std::string line;
    for (long long i = 0; i < element.Count; ++i)
    {
      if (!std::getline(this->File, line))
      {
        FailShort(element, i);
      }
      const char* place = line.c_str();
      bool isWhole = true;
      for (const Property& property : element.Properties)
      {
        double items = 1.0;
        isWhole = isWhole && (property.CountSize == 0 || ReadNumber(place, items)) &&
          items >= 0.0 && items < 1e9;
        for (long long j = 0; isWhole && j < static_cast<long long>(items); ++j)
        {
          double number = 0.0;
          isWhole = ReadNumber(place, number);
        }
      }
      if (!isWhole)
      {
        throw FileError("line " + std::to_string(i + 1) + " of '" + element.Name +
          "' has fewer values than the header declares, or values that are not numbers");
      }
    }
  }

  static bool ReadNumber(const char*& place, double& number)
  {
    char* end = nullptr;
    number = std::strtod(place, &end);
    const bool isNumber =
      end != place && (*end == '\0' || *end == ' ' || *end == '\t' || *end == '\r');
    place = end;
    return isNumber;
  }

  std::ifstream File;
  long long Left; // in bytes
  bool IsText = false;
  bool IsBigEndian = false;
  std::vector<Element> Elements;
};
}

//------------------------------------------------------------------------------
void CheckPLY(const std::string& fileName)
{
  PLYChecker(fileName).Check();
}

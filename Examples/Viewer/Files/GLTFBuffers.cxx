// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/GLTFBuffers.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>

namespace
{
constexpr std::uint32_t Magic = 0x46546C67;  // "glTF"
constexpr std::uint32_t Binary = 0x004E4942; // "BIN"

// Little-endian, as the numbers of .glb files are.
std::uint32_t ReadNumber(std::istream& file)
{
  std::array<unsigned char, 4> bytes{};
  file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    number |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
  }
  return number;
}

// From one quotation mark to the next, where `position` is left.
std::string ReadString(const std::string& text, std::size_t& position)
{
  std::string string;
  for (++position; position < text.size() && text[position] != '"'; ++position)
  {
    position += text[position] == '\\' ? 1 : 0;
    string += text[position];
  }
  return string;
}
}

//------------------------------------------------------------------------------
std::vector<GLTFBuffer> ParseGLTFBuffers(const std::string& text)
{
  std::vector<GLTFBuffer> buffers;
  const int inBuffer = 2; // objects in an array
  int depth = 0;
  std::string key;
  std::string string;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isOfBuffer = depth == inBuffer && !buffers.empty();
    switch (text[i])
    {
      case '"':
        string = ReadString(text, i);
        if (isOfBuffer && key == "uri")
        {
          buffers.back().URI = string;
        }
        break;
      case ':':
        key = string;
        if (isOfBuffer && key == "byteLength")
        {
          buffers.back().ByteLength = std::atoll(text.c_str() + i + 1);
        }
        break;
      case ',':
        key.clear();
        break;
      case '{':
      case '[':
        key.clear();
        if (++depth == inBuffer)
        {
          buffers.emplace_back();
        }
        break;
      case '}':
      case ']':
        --depth;
        break;
      default:
        break;
    }
  }
  return buffers;
}

//------------------------------------------------------------------------------
long long GetGLBLength(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  if (ReadNumber(file) != Magic)
  {
    return 0;
  }
  ReadNumber(file); // version
  ReadNumber(file); // length of the file
  const std::uint32_t lengthOfText = ReadNumber(file);
  ReadNumber(file); // "JSON"
  file.seekg(lengthOfText, std::ios::cur);
  const std::uint32_t length = ReadNumber(file);
  return ReadNumber(file) == Binary && file ? length : 0;
}

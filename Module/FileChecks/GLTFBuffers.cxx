// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GLTFBuffers.h"

#include "FileNames.h"

#include "vtk_jsoncpp.h"

#include <vtksys/SystemTools.hxx>

#include <array>
#include <cstdint>
#include <fstream>
#include <memory>

namespace
{
constexpr std::uint32_t Magic = 0x46546C67;  // "glTF"
constexpr std::uint32_t Binary = 0x004E4942; // "BIN"

// Numbers in .glb files are little-endian.
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
}

//------------------------------------------------------------------------------
std::vector<GLTFBuffer> ParseGLTFBuffers(const std::string& text)
{
  std::vector<GLTFBuffer> buffers;
  Json::Value array;
  const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
  if (!reader->parse(text.data(), text.data() + text.size(), &array, nullptr) || !array.isArray())
  {
    return buffers;
  }
  for (const Json::Value& item : array)
  {
    GLTFBuffer buffer;
    if (item.isObject() && item["uri"].isString())
    {
      buffer.URI = item["uri"].asString();
    }
    if (item.isObject() && item["byteLength"].isInt64())
    {
      buffer.ByteLength = item["byteLength"].asInt64();
    }
    buffers.push_back(buffer);
  }
  return buffers;
}

//------------------------------------------------------------------------------
bool HasCompleteChunks(const std::string& fileName)
{
  if (GetExtension(fileName) != ".glb")
  {
    return true; // a text
  }
  std::ifstream file(fileName, std::ios::binary);
  if (ReadNumber(file) != Magic)
  {
    return false;
  }
  ReadNumber(file); // version
  const std::uint64_t end = ReadNumber(file);
  std::uint64_t position = 12;
  while (position < end && end <= vtksys::SystemTools::FileLength(fileName))
  {
    position += 8 + static_cast<std::uint64_t>(ReadNumber(file));
    ReadNumber(file); // the type
    file.seekg(static_cast<std::streamoff>(position));
  }
  return position == end;
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ChunkFile.h"

#include "Files/LittleEndian.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <new>

namespace relevo
{
namespace
{
constexpr std::string_view Magic("\x89RMM\r\n\x1a\n", 8);
constexpr std::uint64_t NewestVersion = 2;
constexpr std::size_t HeaderSize = 32;
constexpr std::size_t ChecksumSize = 4;
constexpr std::size_t ChunkSize = 16 + ChecksumSize; // without data
// zlib's largest ratio is 1032.
constexpr std::uint64_t LargestRatio = 1040;

std::uint64_t GetChecksum(std::string_view bytes)
{
  uLong checksum = crc32(0, nullptr, 0);
  constexpr std::size_t most = 1 << 30; // a uInt
  while (!bytes.empty())
  {
    const std::size_t number = std::min(bytes.size(), most);
    checksum =
      crc32(checksum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(number));
    bytes.remove_prefix(number);
  }
  return checksum;
}

std::string Compress(const std::string& bytes)
{
  constexpr int level = 9;
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string compressed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
        reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()),
        level) != Z_OK)
  {
    throw std::bad_alloc(); // the only possible error
  }
  compressed.resize(size);
  return compressed;
}

bool Uncompress(std::string_view compressed, std::string& bytes)
{
  uLongf size = static_cast<uLongf>(bytes.size());
  const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
    reinterpret_cast<const Bytef*>(compressed.data()), static_cast<uLong>(compressed.size()));
  if (result == Z_MEM_ERROR)
  {
    throw std::bad_alloc();
  }
  return result == Z_OK && size == bytes.size();
}

std::string GetDamage(const std::string& place)
{
  return "the file is damaged: " + place;
}

// Reads a chunk and removes it from the file.
std::string UnpackChunk(std::string_view& file, const std::string& name, std::string& chunk)
{
  std::string_view rest = file;
  const std::uint64_t size = TakeNumber(rest, 8);
  const std::uint64_t compressedSize = TakeNumber(rest, 8);
  if (file.size() < ChunkSize || compressedSize > file.size() - ChunkSize)
  {
    return GetDamage(name + " has a wrong size");
  }
  const std::string_view compressed = rest.substr(0, compressedSize);
  rest.remove_prefix(compressedSize);
  const std::string_view covered = file.substr(0, ChunkSize - ChecksumSize + compressedSize);
  if (TakeNumber(rest, ChecksumSize) != GetChecksum(covered))
  {
    return GetDamage(name + " has a wrong checksum");
  }
  if (size / LargestRatio > compressedSize)
  {
    return GetDamage(name + " has a wrong size");
  }
  chunk.resize(size);
  if (!Uncompress(compressed, chunk))
  {
    return GetDamage(name + " cannot be decompressed");
  }
  file = rest;
  return "";
}
}

std::string PackChunks(const std::vector<std::string>& chunks)
{
  std::string body;
  for (const std::string& chunk : chunks)
  {
    const std::string compressed = Compress(chunk);
    std::string packed;
    AppendNumber(packed, chunk.size(), 8);
    AppendNumber(packed, compressed.size(), 8);
    packed += compressed;
    AppendNumber(packed, GetChecksum(packed), ChecksumSize);
    body += packed;
  }
  std::string file(Magic);
  AppendNumber(file, NewestVersion, 4);
  AppendNumber(file, chunks.size(), 4);
  AppendNumber(file, HeaderSize + body.size(), 8);
  AppendNumber(file, 0, 4);
  AppendNumber(file, GetChecksum(file), ChecksumSize);
  return file + body;
}

bool AreChunks(std::string_view file)
{
  return file.substr(0, Magic.size()) == Magic;
}

std::string UnpackChunks(std::string_view file, std::vector<std::string>& chunks)
{
  if (!AreChunks(file))
  {
    return "it is not an .rmm file";
  }
  const std::string_view covered = file.substr(0, HeaderSize - ChecksumSize);
  std::string_view rest = file.substr(Magic.size());
  const std::uint64_t version = TakeNumber(rest, 4);
  const std::uint64_t number = TakeNumber(rest, 4);
  const std::uint64_t size = TakeNumber(rest, 8);
  TakeNumber(rest, 4);
  if (file.size() < HeaderSize)
  {
    return "the file is truncated: it has only " + std::to_string(file.size()) + " bytes";
  }
  if (TakeNumber(rest, ChecksumSize) != GetChecksum(covered))
  {
    return GetDamage("its header has a wrong checksum");
  }
  if (version != NewestVersion)
  {
    return "its format has version " + std::to_string(version) + ", but this Relevo reads only " +
      std::to_string(NewestVersion) +
      (version > NewestVersion ? ". Use a newer Relevo" : ". Encode the mesh again");
  }
  if (file.size() != size)
  {
    return file.size() < size
      ? "the file is truncated: it has " + std::to_string(file.size()) + " of " +
        std::to_string(size) + " bytes"
      : GetDamage("it has " + std::to_string(file.size() - size) + " bytes too many");
  }
  for (std::uint64_t i = 0; i < number; ++i)
  {
    chunks.emplace_back();
    const std::string error = UnpackChunk(rest, "chunk " + std::to_string(i), chunks.back());
    if (!error.empty())
    {
      return error;
    }
  }
  return rest.empty() ? "" : GetDamage("it has bytes after its last chunk");
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NetCDFCheck.h"

#include "FileError.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

namespace
{
constexpr int Alignment = 4; // names and values are padded to a multiple of this

// The header of the formats CDF-1, CDF-2 (64-bit offsets) and CDF-5 (64-bit data).
class Header
{
public:
  explicit Header(const std::string& fileName)
    : File(fileName, std::ios::binary)
    , FileSize(static_cast<double>(std::filesystem::file_size(fileName)))
  {
    char magic[4] = {};
    this->File.read(magic, sizeof(magic));
    const bool isClassic = magic[0] == 'C' && magic[1] == 'D' && magic[2] == 'F';
    this->Version = isClassic ? magic[3] : 0;
  }

  bool IsClassic() const { return this->Version == 1 || this->Version == 2 || this->Version == 5; }

  void Check()
  {
    const double records = this->ReadNumber();
    const bool isStreaming =
      records == (this->Version == 5 ? 18446744073709551615.0 : 4294967295.0);
    this->ReadDimensions();
    this->SkipAttributes();
    this->ReadVariables();
    double size = this->FixedEnd;
    if (this->RecordSize > 0.0 && !isStreaming)
    {
      // Records are padded unless there is only one variable.
      const double record =
        this->NumberOfRecordVariables > 1 ? this->RecordSize : this->UnpaddedRecordSize;
      size = std::max(size, this->RecordBegin + records * record);
    }
    // Some programs omit the padding of the last value.
    if (size >= this->FileSize + Alignment)
    {
      throw FileError("the file is truncated: its header declares " +
        std::to_string(static_cast<long long>(size)) + " bytes, but there are " +
        std::to_string(static_cast<long long>(this->FileSize)));
    }
  }

private:
  [[noreturn]] static void FailShort()
  {
    throw FileError("the file is truncated or damaged: its netCDF header is not complete");
  }

  double ReadBytes(int number)
  {
    double value = 0.0;
    for (int i = 0; i < number; ++i)
    {
      const int byte = this->File.get();
      if (byte < 0)
      {
        FailShort();
      }
      value = 256.0 * value + byte;
    }
    return value;
  }

  // Reads a size, or the number of entries in a list, each of which takes at least four bytes.
  double ReadNumber() { return this->ReadBytes(this->Version == 5 ? 8 : 4); }

  std::size_t ReadCount()
  {
    const double count = this->ReadNumber();
    if (count > this->FileSize / Alignment)
    {
      FailShort();
    }
    return static_cast<std::size_t>(count);
  }

  void Skip(double bytes)
  {
    const double padded = Pad(bytes);
    if (padded > this->FileSize)
    {
      FailShort();
    }
    this->File.seekg(static_cast<std::streamoff>(padded), std::ios::cur);
  }

  void SkipName() { this->Skip(this->ReadNumber()); }

  static double Pad(double bytes) { return Alignment * std::ceil(bytes / Alignment); }

  double GetTypeSize(double type) const
  {
    // Starting at 1: byte, char, short, int, float, double, ubyte, ushort, uint, int64, uint64.
    static const double sizes[] = { 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
    if (type < 1.0 || type > 11.0)
    {
      throw FileError("the file is damaged: its netCDF header has a value of an unknown type");
    }
    return sizes[static_cast<int>(type) - 1];
  }

  void ReadDimensions()
  {
    this->ReadBytes(4); // the tag of the list
    this->Dimensions.resize(this->ReadCount());
    for (double& length : this->Dimensions)
    {
      this->SkipName();
      length = this->ReadNumber();
    }
  }

  void SkipAttributes()
  {
    this->ReadBytes(4);
    for (std::size_t left = this->ReadCount(); left > 0; --left)
    {
      this->SkipName();
      const double size = this->GetTypeSize(this->ReadBytes(4));
      this->Skip(size * this->ReadNumber());
    }
  }

  void ReadVariables()
  {
    this->ReadBytes(4);
    for (std::size_t left = this->ReadCount(); left > 0; --left)
    {
      this->ReadVariable();
    }
  }

  void ReadVariable()
  {
    this->SkipName();
    double values = 1.0;
    bool isRecord = false;
    const std::size_t rank = this->ReadCount();
    for (std::size_t i = 0; i < rank; ++i)
    {
      const double dimension = this->ReadNumber();
      if (dimension >= static_cast<double>(this->Dimensions.size()))
      {
        throw FileError("the file is damaged: its netCDF header has an unknown dimension");
      }
      const double length = this->Dimensions[static_cast<std::size_t>(dimension)];
      isRecord = isRecord || (i == 0 && length == 0.0);
      values *= i == 0 && isRecord ? 1.0 : length;
    }
    this->SkipAttributes();
    const double size = values * this->GetTypeSize(this->ReadBytes(4));
    this->ReadNumber(); // the size, which is wrong for large variables
    const double begin = this->ReadBytes(this->Version == 1 ? 4 : 8);
    if (!isRecord)
    {
      this->FixedEnd = std::max(this->FixedEnd, begin + size);
      return;
    }
    this->RecordBegin =
      this->NumberOfRecordVariables == 0 ? begin : std::min(this->RecordBegin, begin);
    this->RecordSize += Pad(size);
    this->UnpaddedRecordSize = size;
    ++this->NumberOfRecordVariables;
  }

  std::ifstream File;
  double FileSize;
  int Version = 0;
  std::vector<double> Dimensions;
  double FixedEnd = 0.0;
  double RecordBegin = 0.0;
  double RecordSize = 0.0;
  double UnpaddedRecordSize = 0.0;
  int NumberOfRecordVariables = 0;
};
}

//------------------------------------------------------------------------------
void CheckNetCDF(const std::string& fileName)
{
  Header header(fileName);
  if (header.IsClassic())
  {
    header.Check();
  }
}

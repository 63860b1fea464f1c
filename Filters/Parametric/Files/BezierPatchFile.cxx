// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/BezierPatchFile.h"

#include "Cells/BezierCells.h"

#include <charconv>
#include <cmath>
#include <istream>
#include <limits>

namespace relevo
{
namespace
{
constexpr std::size_t LongestNumber = 1100; // all digits of any double, and a sign

// Reads numbers separated by white space. Stops at the first error.
class NumberReader
{
public:
  explicit NumberReader(std::istream& in)
    : In(in)
  {
  }

  const std::string& GetError() const { return this->Error; }

  int ReadInteger(const char* reason, int lowest, int highest)
  {
    int number = lowest;
    if (!this->ReadWord() || (this->Parse(number) && number >= lowest && number <= highest))
    {
      return number;
    }
    this->SetError(this->GetQuote() + reason);
    return lowest;
  }

  double ReadNumber()
  {
    double number = 0.0;
    if (this->ReadWord() && !(this->Parse(number) && std::isfinite(number)))
    {
      this->SetError(this->GetQuote() + " is not a finite number.");
    }
    return number;
  }

  void ReadEnd()
  {
    if (this->Error.empty() && this->SkipSpace())
    {
      this->SetError("there are more values than the number of patches in line 1 requires.");
    }
  }

private:
  static bool IsSpace(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  // Whether anything follows.
  bool SkipSpace()
  {
    constexpr int none = std::char_traits<char>::eof();
    int c = this->In.peek();
    for (; c != none && IsSpace(c); c = this->In.peek())
    {
      this->Line += this->In.get() == '\n' ? 1 : 0;
    }
    return c != none;
  }

  bool ReadWord()
  {
    if (!this->Error.empty())
    {
      return false;
    }
    if (!this->SkipSpace())
    {
      this->SetError("the file ends too early.");
      return false;
    }
    constexpr int none = std::char_traits<char>::eof();
    this->Word.clear();
    for (int c = this->In.peek(); c != none && !IsSpace(c); c = this->In.peek())
    {
      if (this->Word.size() > LongestNumber)
      {
        return true; // Parse() reports the error
      }
      this->Word += static_cast<char>(this->In.get());
    }
    return true;
  }

  // Independent of the locale. A leading plus is accepted, as in C.
  template <typename T>
  bool Parse(T& number) const
  {
    const char* end = this->Word.data() + this->Word.size();
    const char* begin = this->Word.data();
    begin += end - begin > 1 && begin[0] == '+' && begin[1] != '-' ? 1 : 0;
    const auto [stop, error] = std::from_chars(begin, end, number);
    return this->Word.size() <= LongestNumber && stop == end && error == std::errc();
  }

  // Limits the length, because a binary file may have no white space.
  std::string GetQuote() const { return "'" + this->Word.substr(0, 80) + "'"; }

  void SetError(const std::string& what)
  {
    this->Error = "line " + std::to_string(this->Line) + ": " + what;
  }

  std::istream& In;
  int Line = 1;
  std::string Word;
  std::string Error;
};

int ReadNumberOfPatches(NumberReader& reader)
{
  return reader.ReadInteger(" is not a number of patches.", 0, std::numeric_limits<int>::max());
}

// The second degree comes first in the file. It determines the number of rows of control points.
ivec2 ReadDegrees(NumberReader& reader)
{
  const int second = reader.ReadInteger(" is not a degree from 1 to 8.", 1, LargestDegree);
  return ivec2(reader.ReadInteger(" is not a degree from 1 to 8.", 1, LargestDegree), second);
}

BezierPatch ReadPatch(NumberReader& reader)
{
  BezierPatch patch;
  patch.Degrees = ReadDegrees(reader);
  const ivec2 size = patch.Degrees + 1;
  patch.Points.resize(static_cast<std::size_t>(size.x) * size.y);
  for (dvec4& point : patch.Points)
  {
    point.x = reader.ReadNumber();
    point.y = reader.ReadNumber();
    point.z = reader.ReadNumber();
    point.w = 1.0;
  }
  return patch;
}
}

bool ReadBezierPatches(std::istream& in, std::vector<BezierPatch>& patches, std::string& error)
{
  NumberReader reader(in);
  const int number = ReadNumberOfPatches(reader);
  for (int i = 0; i < number && reader.GetError().empty(); ++i)
  {
    patches.push_back(ReadPatch(reader));
  }
  reader.ReadEnd();
  error = reader.GetError();
  return error.empty();
}

bool IsBezierPatchFile(std::istream& in)
{
  NumberReader reader(in);
  if (ReadNumberOfPatches(reader) > 0)
  {
    ReadDegrees(reader);
  }
  return reader.GetError().empty();
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRefinementPatternTable promises exact triangulations for all levels in any order. Files are
// read back unchanged, and damaged files are errors.
#include "RelevoCheck.h"
#include "RelevoPatternCheck.h"

#include "Patterns/RefinementPattern.h"
#include "vtkCellArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternSource.h"
#include "vtkRefinementPatternTable.h"
#include "vtkTestUtilities.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace RelevoPatternCheck;

template <typename Visitor>
void ForEachLevels(int maximumLevel, Visitor&& visit)
{
  for (int i = 0; i <= maximumLevel; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        visit(i, j, k);
      }
    }
  }
}

void TestPatterns(RelevoCheck& check)
{
  vtkNew<vtkRefinementPatternTable> table;
  auto checkPattern = [&](int n1, int n2, int n3)
  {
    const auto made = table->GetPatternOfSegments(n1, n2, n3);
    const relevo::RefinementPattern& pattern = *made;
    CHECK(pattern.Segments[0] == n1 && pattern.Segments[1] == n2 && pattern.Segments[2] == n3);
    CheckVertices(check, pattern);
    CheckTriangles(check, pattern);
    CHECK(n1 != n3 || pattern.GetNumberOfTriangles() == n1 * n1);
    CHECK_EQUAL(made, table->GetPatternOfSegments(n1, n2, n3));
  };
  int index = 0;
  ForEachLevels(7,
    [&](int i, int j, int k)
    {
      checkPattern(1 << i, 1 << j, 1 << k);
      CHECK_EQUAL(vtkRefinementPatternTable::GetPatternIndex(i, j, k), index++);
    });
  CHECK_EQUAL(index, 120);
  for (int n1 = 1; n1 <= 10; ++n1)
  {
    for (int n2 = 1; n2 <= n1; ++n2)
    {
      for (int n3 = 1; n3 <= n2; ++n3)
      {
        checkPattern(n1, n2, n3);
      }
    }
  }
  checkPattern(128, 127, 3);
  checkPattern(127, 127, 127);
  checkPattern(101, 100, 99);
  checkPattern(77, 1, 1);

  RelevoErrors errors(table);
  for (const auto& n :
    { std::array<int, 3>{ 2, 4, 1 }, { 4, 1, 2 }, { 1, 1, 0 }, { 129, 1, 1 }, { -1, -2, -3 } })
  {
    const auto instead = table->GetPatternOfSegments(n[0], n[1], n[2]);
    CHECK(errors.Said("segments"));
    CHECK_EQUAL(instead->GetNumberOfTriangles(), 1);
  }
}

/// Number of segments on each edge of the triangle (0, 0), (1, 0), (0, 1).
std::array<int, 3> CountSegments(vtkPolyData* polyData)
{
  std::array<int, 3> segments = { -1, -1, -1 };
  for (vtkIdType p = 0; p < polyData->GetNumberOfPoints(); ++p)
  {
    double x[3];
    polyData->GetPoint(p, x);
    segments[0] += x[1] == 0.0 ? 1 : 0;
    segments[1] += x[0] + x[1] == 1.0 ? 1 : 0;
    segments[2] += x[0] == 0.0 ? 1 : 0;
  }
  return segments;
}

void CheckPolyData(RelevoCheck& check, vtkPolyData* polyData)
{
  auto* weights = vtkFloatArray::SafeDownCast(polyData->GetPointData()->GetArray("Barycentrics"));
  if (!CHECK(weights && weights->GetNumberOfComponents() == 3 &&
        weights->GetNumberOfTuples() == polyData->GetNumberOfPoints()))
  {
    return;
  }
  for (vtkIdType p = 0; p < polyData->GetNumberOfPoints(); ++p)
  {
    float w[3];
    weights->GetTypedTuple(p, w);
    double x[3];
    polyData->GetPoint(p, x);
    CHECK_EQUAL(w[0] + w[1] + w[2], 1.0f);
    CHECK(x[0] == w[1] && x[1] == w[2] && x[2] == 0.0);
  }
  double area = 0.0;
  polyData->BuildCells();
  for (vtkIdType t = 0; t < polyData->GetNumberOfCells(); ++t)
  {
    vtkIdType size;
    const vtkIdType* ids;
    polyData->GetCellPoints(t, size, ids);
    double a[3], b[3], c[3];
    polyData->GetPoint(ids[0], a);
    polyData->GetPoint(ids[1], b);
    polyData->GetPoint(ids[2], c);
    const double cross = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    CHECK_EQUAL(size, 3);
    CHECK_GREATER(cross, 0.0);
    area += cross;
  }
  CHECK_EQUAL(area, 1.0);
}

void TestPermutations(RelevoCheck& check)
{
  // These examples are from the method's publication (Lenz 2009, tab. 4.2).
  const struct
  {
    int Levels[3];
    int Lambda;
    int Permutation[3];
    bool Odd;
  } rows[] = { { { 2, 1, 0 }, 0, { 0, 1, 2 }, false }, { { 1, 2, 0 }, 1, { 2, 1, 0 }, true },
    { { 1, 1, 2 }, 2, { 0, 2, 1 }, true }, { { 2, 0, 1 }, 4, { 1, 0, 2 }, true },
    { { 0, 2, 1 }, 5, { 2, 0, 1 }, false }, { { 1, 0, 2 }, 6, { 1, 2, 0 }, false },
    { { 0, 1, 2 }, 7, { 0, 2, 1 }, true } };
  for (const auto& row : rows)
  {
    int levels[3] = { row.Levels[0], row.Levels[1], row.Levels[2] };
    CHECK_EQUAL(vtkRefinementPatternTable::Canonicalize(levels), row.Lambda);
    int permutation[3];
    vtkRefinementPatternTable::GetPermutation(row.Lambda, permutation);
    CHECK(std::equal(permutation, permutation + 3, row.Permutation));
    CHECK_EQUAL(vtkRefinementPatternTable::IsOdd(row.Lambda), row.Odd);
  }

  vtkNew<vtkRefinementPatternTable> table;
  vtkNew<vtkPolyData> polyData;
  std::set<int> lambdas;
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; j <= 4; ++j)
    {
      for (int k = 0; k <= 4; ++k)
      {
        int levels[3] = { i, j, k };
        lambdas.insert(vtkRefinementPatternTable::Canonicalize(levels));
        CHECK(levels[0] >= levels[1] && levels[1] >= levels[2]);
        CHECK_EQUAL(levels[0] + levels[1] + levels[2], i + j + k);
        CHECK(levels[0] == std::max({ i, j, k }) && levels[2] == std::min({ i, j, k }));
        if (CHECK(table->GetPattern(i, j, k, polyData)))
        {
          CHECK_EQUAL(CountSegments(polyData), (std::array<int, 3>{ 1 << i, 1 << j, 1 << k }));
          CheckPolyData(check, polyData);
        }
      }
    }
  }
  CHECK_EQUAL(lambdas, (std::set<int>{ 0, 1, 2, 4, 5, 6, 7 }));
}

void TestLevels(RelevoCheck& check)
{
  vtkNew<vtkRefinementPatternTable> table;
  RelevoErrors errors(table);
  CHECK_EQUAL(table->GetMaximumLevel(), 5);
  CHECK_EQUAL(table->GetNumberOfPatterns(), 56);
  const int counts[] = { 1, 4, 10, 20, 35, 56, 84, 120 };
  for (int level = 0; level <= 7; ++level)
  {
    table->SetMaximumLevel(level);
    CHECK_EQUAL(table->GetNumberOfPatterns(), counts[level]);
  }
  CHECK(errors.None());
  const vtkMTimeType time = table->GetMTime();
  for (int level : { -1, 8, 1000 })
  {
    CHECK_CASE(level);
    table->SetMaximumLevel(level);
    CHECK(errors.Said("MaximumLevel"));
  }
  CHECK_EQUAL(table->GetMaximumLevel(), 7);
  CHECK_EQUAL(table->GetMTime(), time);

  table->SetMaximumLevel(3);
  vtkNew<vtkPolyData> polyData;
  CHECK(!table->GetPattern(4, 0, 0, polyData) && errors.Said("[4, 0, 0]"));
  CHECK(!table->GetPattern(0, -1, 0, polyData) && errors.Said("[0, -1, 0]"));
  CHECK(!table->GetPattern(0, 0, 0, nullptr) && errors.Said("vtkPolyData"));

  CHECK_EQUAL(table->GetMemorySize(), 0);
  table->GetPattern(3, 3, 3, polyData);
  const vtkTypeInt64 size = table->GetMemorySize();
  // The pattern has 45 vertices, 64 triangles and 108 lines.
  CHECK(size >= 45 * 12 + 64 * 12 + 108 * 8 && size < 2 * (45 * 12 + 64 * 12 + 108 * 8));
  table->GetPattern(3, 3, 2, polyData);
  CHECK_GREATER(table->GetMemorySize(), size);
}

void TestSource(RelevoCheck& check)
{
  vtkNew<vtkRefinementPatternSource> source;
  RelevoErrors errors(source);
  source->Update();
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 1);
  source->SetLevels(1, 7, 3);
  source->Update();
  CHECK_EQUAL(CountSegments(source->GetOutput()), (std::array<int, 3>{ 2, 128, 8 }));
  CheckPolyData(check, source->GetOutput());
  source->SetLevels(0, 8, 0);
  CHECK(errors.Said("Levels"));
  CHECK_EQUAL(source->GetLevels()[1], 7);

  vtkNew<vtkRefinementPatternTable> table;
  source->SetTable(table);
  {
    RelevoErrors executiveErrors(source->GetExecutive());
    source->Update();
  }
  CHECK(errors.Said("MaximumLevel"));
  CHECK_EQUAL(source->GetOutput()->GetNumberOfPoints(), 0);
  table->SetMaximumLevel(7);
  source->Update();
  CHECK(errors.None());
  CHECK_GREATER(source->GetOutput()->GetNumberOfPoints(), 0);
}

std::string Slurp(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

void Spill(const std::string& fileName, const std::string& bytes)
{
  std::ofstream file(fileName, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

bool IsSame(const relevo::RefinementPattern& a, const relevo::RefinementPattern& b)
{
  return std::equal(a.Segments, a.Segments + 3, b.Segments) && a.Vertices == b.Vertices &&
    a.Triangles == b.Triangles && a.Lines == b.Lines;
}

void TestFile(RelevoCheck& check, const std::string& fileName)
{
  vtkNew<vtkRefinementPatternTable> written;
  written->SetMaximumLevel(4);
  CHECK(written->Write(fileName.c_str()));
  vtkNew<vtkRefinementPatternTable> read;
  RelevoErrors errors(read);
  const auto former = read->GetPatternOfSegments(8, 4, 1);
  const relevo::RefinementPattern copy = *former;
  const vtkMTimeType time = read->GetMTime();
  CHECK(read->Read(fileName.c_str()));
  CHECK(errors.None());
  CHECK_EQUAL(read->GetMaximumLevel(), 4);
  CHECK_GREATER(read->GetMTime(), time);
  CHECK(IsSame(*former, copy)); // a pattern lives as long as it is used
  ForEachLevels(4,
    [&](int i, int j, int k)
    {
      CHECK(IsSame(*written->GetPatternOfSegments(1 << i, 1 << j, 1 << k),
        *read->GetPatternOfSegments(1 << i, 1 << j, 1 << k)));
    });
}

// Modifies the bytes of a valid file. A table must report an error for the result.
struct BadFiles
{
  explicit BadFiles(const char* folder)
    : Folder(folder)
  {
    this->Writer->SetMaximumLevel(2);
  }
  std::string WriteGood(RelevoCheck& check, const std::string& name)
  {
    const std::string good = this->Folder + name;
    CHECK(this->Writer->Write(good.c_str()));
    return Slurp(good);
  }
  void Refuse(RelevoCheck& check, const std::string& damaged, const std::string& words)
  {
    Spill(this->Bad, damaged);
    CHECK(!this->Table->Read(this->Bad.c_str()));
    CHECK(this->Errors.Said(words));
    CHECK(this->Errors.None());
  }

  std::string Folder;
  std::string Bad = this->Folder + "/RefinementPatterns.bad";
  vtkNew<vtkRefinementPatternTable> Writer;
  vtkNew<vtkRefinementPatternTable> Table;
  RelevoErrors Errors{ this->Table };
};

void TestTruncated(RelevoCheck& check, BadFiles& files, const std::string& bytes)
{
  for (std::size_t length = 0; length < bytes.size(); length += length < 64 ? 1 : 41)
  {
    files.Refuse(check, bytes.substr(0, length), length < 8 ? "not a file" : "truncated");
  }
  files.Refuse(check, std::string(1000, 'x'), "not a file");
  files.Refuse(check, bytes + "more", "after its last pattern");
}

void TestWrongNumbers(RelevoCheck& check, BadFiles& files, const std::string& bytes)
{
  auto refuses = [&](std::size_t place, std::uint32_t value, const std::string& words)
  {
    std::string damaged = bytes;
    for (int i = 0; i < 4; ++i)
    {
      damaged[place + i] = static_cast<char>((value >> (8 * i)) & 0xff);
    }
    files.Refuse(check, damaged, words);
  };
  refuses(8, 2, "version 2");
  refuses(12, 8, "out of range");
  refuses(12, 0xffffffff, "out of range");
  refuses(16, 0xffffffff, "patterns instead of");
  refuses(20, 2, "is missing or out of order");
  refuses(32, 0xffffffff, "truncated");
  refuses(36, 0x7fffffff, "truncated");
  refuses(40, 0x7fc00000, "weights"); // NaN
  refuses(40, 0x7f800000, "weights"); // infinity
  refuses(40, 0xbf800000, "weights"); // -1
  refuses(40, 0x3f000000, "weights"); // 0.5, 0, 0
  refuses(76, 3, "does not exist");   // the first index of the first triangle
  refuses(76, 1, "degenerate");
}

void TestFileNames(RelevoCheck& check, BadFiles& files)
{
  vtkRefinementPatternTable* table = files.Table;
  RelevoErrors& errors = files.Errors;
  CHECK(!table->Read((files.Folder + "/no such file").c_str()) && errors.Said("no such file"));
  CHECK(!table->Read(files.Folder.c_str()) && errors.Said("is not a regular file."));
  CHECK(!table->Read(nullptr) && errors.Said("file name"));
  CHECK(!table->Read("") && errors.Said("file name"));
  CHECK(!table->Write(nullptr) && errors.Said("file name"));
  CHECK(!table->Write((files.Folder + "/no such folder/x").c_str()) &&
    errors.Said("cannot be written"));
}

// Other damage is an error or leaves valid patterns, such as a shifted inner point.
void TestRandomDamage(RelevoCheck& check, const BadFiles& files, const std::string& bytes)
{
  std::uint32_t random = 1;
  for (int attempt = 0; attempt < 500; ++attempt)
  {
    random = random * 1664525u + 1013904223u;
    std::string damaged = bytes;
    damaged[(random >> 8) % bytes.size()] ^= static_cast<char>(1 + (random & 0x7f));
    Spill(files.Bad, damaged);
    vtkNew<vtkRefinementPatternTable> victim;
    RelevoErrors victimErrors(victim);
    if (victim->Read(files.Bad.c_str()))
    {
      ForEachLevels(2,
        [&](int i, int j, int k)
        {
          const auto pattern = victim->GetPatternOfSegments(1 << i, 1 << j, 1 << k);
          CheckVertices(check, *pattern);
          CheckTriangles(check, *pattern);
        });
    }
    else
    {
      CHECK(victimErrors.Said("Cannot read the patterns"));
      CHECK_EQUAL(victim->GetMaximumLevel(), 5);
      CHECK_EQUAL(victim->GetMemorySize(), 0);
    }
  }
}

void TestBadVTP(RelevoCheck& check, BadFiles& files, const std::string& bytes)
{
  const std::string vtp = files.Folder + "/RefinementPatterns.bad.vtp";
  const std::string xml = files.WriteGood(check, "/RefinementPatterns.good.vtp");
  for (std::size_t length : { std::size_t(0), std::size_t(20), xml.size() / 4, xml.size() / 2 })
  {
    CHECK_CASE(length);
    Spill(vtp, xml.substr(0, length));
    CHECK(!files.Table->Read(vtp.c_str()));
    CHECK(files.Errors.Said("RefinementPatterns.bad.vtp"));
  }
  Spill(vtp, bytes);
  CHECK(!files.Table->Read(vtp.c_str()) && files.Errors.Said("RefinementPatterns.bad.vtp"));
}

// A file that cannot be read leaves the table unchanged.
void TestBadFiles(RelevoCheck& check, const char* folder)
{
  BadFiles files(folder);
  const std::string bytes = files.WriteGood(check, "/RefinementPatterns.good");
  // The bytes are the signature, version 1, MaximumLevel 2, ten patterns, and a first pattern of 1,
  // 1, 1 segments.
  const unsigned char head[] = { 'R', 'e', 'l', 'e', 'v', 'o', 'R', 'P', 1, 0, 0, 0, 2, 0, 0, 0, 10,
    0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0x80, 0x3f };
  CHECK_GREATER(bytes.size(), sizeof(head));
  CHECK_EQUAL(std::memcmp(bytes.data(), head, sizeof(head)), 0);

  const auto before = files.Table->GetPatternOfSegments(4, 2, 1);
  TestTruncated(check, files, bytes);
  TestWrongNumbers(check, files, bytes);
  TestFileNames(check, files);
  TestRandomDamage(check, files, bytes);
  TestBadVTP(check, files, bytes);
  CHECK_EQUAL(files.Table->GetMaximumLevel(), 5);
  CHECK_EQUAL(before, files.Table->GetPatternOfSegments(4, 2, 1));
}

void TestThreads(RelevoCheck& check)
{
  vtkNew<vtkRefinementPatternTable> table;
  constexpr int NumberOfThreads = 4;
  std::array<relevo::RefinementPatterns, NumberOfThreads> seen;
  std::vector<std::thread> threads;
  for (auto& patterns : seen)
  {
    threads.emplace_back(
      [&table, &patterns]
      {
        ForEachLevels(5,
          [&](int i, int j, int k)
          { patterns.push_back(table->GetPatternOfSegments(1 << i, 1 << j, 1 << k)); });
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& patterns : seen)
  {
    CHECK_EQUAL(patterns, seen[0]);
  }
}
}

int TestRefinementPatternTable(int argc, char* argv[])
{
  RelevoCheck check;
  char* folder =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  TestPatterns(check);
  TestPermutations(check);
  TestLevels(check);
  TestSource(check);
  TestFile(check, std::string(folder) + "/RefinementPatterns.bin");
  TestFile(check, std::string(folder) + "/RefinementPatterns.vtp");
  TestBadFiles(check, folder);
  TestThreads(check);
  delete[] folder;
  return check.GetResult();
}

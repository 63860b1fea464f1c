// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/RefinementPatternFile.h"

#include "Checks/ErrorCollector.h"
#include "Files/WriteFile.h"
#include "Patterns/RefinementPatternGenerator.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace
{
constexpr char Magic[] = "RelevoRP"; // eight bytes in the file
constexpr std::size_t MagicSize = 8;
constexpr std::uint32_t Version = 1;

bool IsVTP(const char* fileName)
{
  std::string extension = std::filesystem::path(fileName).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".vtp";
}

/// Appends little-endian numbers to a string of bytes.
class ByteWriter
{
public:
  void Put(std::uint32_t value)
  {
    for (int shift = 0; shift < 32; shift += 8)
    {
      this->Bytes.push_back(static_cast<char>((value >> shift) & 0xff));
    }
  }
  void Put(int value) { this->Put(static_cast<std::uint32_t>(value)); }
  void Put(float value)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    this->Put(bits);
  }
  template <typename T>
  void Put(const std::vector<T>& values)
  {
    for (const T& value : values)
    {
      this->Put(value);
    }
  }

  std::string Bytes = Magic;
};

/// Reads little-endian numbers from a string of bytes. Past its end, numbers are 0 and IsGood() is
/// false.
class ByteReader
{
public:
  explicit ByteReader(const std::string& bytes)
    : Bytes(bytes)
  {
  }

  std::uint32_t Get()
  {
    if (this->GetRemaining() < 4)
    {
      this->Good = false;
      return 0;
    }
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 8)
    {
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(this->Bytes[this->Position++]))
        << shift;
    }
    return value;
  }
  void Get(float& value)
  {
    const std::uint32_t bits = this->Get();
    std::memcpy(&value, &bits, sizeof(bits));
  }
  void Get(unsigned int& value) { value = this->Get(); }
  template <typename T>
  void Get(std::vector<T>& values, std::size_t count)
  {
    if (this->GetRemaining() / 4 < count)
    {
      this->Good = false;
      return;
    }
    values.resize(count);
    for (T& value : values)
    {
      this->Get(value);
    }
  }

  std::size_t GetRemaining() const { return this->Bytes.size() - this->Position; }
  bool IsGood() const { return this->Good; }

private:
  const std::string& Bytes;
  std::size_t Position = MagicSize;
  bool Good = true;
};

std::string Name(const relevo::RefinementPattern& pattern)
{
  const int* n = pattern.Segments;
  return "the pattern of " + std::to_string(n[0]) + ", " + std::to_string(n[1]) + ", " +
    std::to_string(n[2]) + " segments";
}

/// Whether a table can have this MaximumLevel.
bool IsLevel(std::int64_t level)
{
  return level >= 0 && level <= relevo::HighestLevel;
}

/// Creates all patterns for levels up to a maximum, with only their segments.
std::vector<relevo::RefinementPattern> MakeEmptyPatterns(int maximumLevel)
{
  std::vector<relevo::RefinementPattern> patterns;
  for (int i = 0; i <= maximumLevel; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        relevo::RefinementPattern pattern;
        pattern.Segments[0] = 1 << i;
        pattern.Segments[1] = 1 << j;
        pattern.Segments[2] = 1 << k;
        patterns.push_back(pattern);
      }
    }
  }
  return patterns;
}

std::string WriteBinary(
  const char* fileName, int maximumLevel, const relevo::RefinementPatterns& patterns)
{
  ByteWriter writer;
  writer.Put(Version);
  writer.Put(maximumLevel);
  writer.Put(static_cast<std::uint32_t>(patterns.size()));
  for (const auto& pattern : patterns)
  {
    for (int segments : pattern->Segments)
    {
      writer.Put(segments);
    }
    writer.Put(pattern->GetNumberOfVertices());
    writer.Put(pattern->GetNumberOfTriangles());
    writer.Put(pattern->Vertices);
    writer.Put(pattern->Triangles);
  }
  return relevo::AtomicFile::Write(fileName, writer.Bytes);
}

std::string ReadBinary(
  const char* fileName, int& maximumLevel, std::vector<relevo::RefinementPattern>& patterns)
{
  const std::string name = fileName;
  std::ifstream file(fileName, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (bytes.compare(0, MagicSize, Magic) != 0)
  {
    return name + " is not a file of refinement patterns.";
  }
  ByteReader reader(bytes);
  const std::uint32_t version = reader.Get();
  const std::uint32_t level = reader.Get();
  const std::uint32_t count = reader.Get();
  if (!reader.IsGood())
  {
    return name + " is truncated.";
  }
  if (version != Version)
  {
    return name + " has version " + std::to_string(version) + ", but only version " +
      std::to_string(Version) + " is supported.";
  }
  if (!IsLevel(level))
  {
    return name + " has MaximumLevel " + std::to_string(level) + ", which is out of range.";
  }
  maximumLevel = static_cast<int>(level);
  patterns = MakeEmptyPatterns(maximumLevel);
  if (count != patterns.size())
  {
    return name + " has " + std::to_string(count) + " patterns instead of " +
      std::to_string(patterns.size()) + ".";
  }
  for (relevo::RefinementPattern& pattern : patterns)
  {
    for (int segments : pattern.Segments)
    {
      if (reader.Get() != static_cast<std::uint32_t>(segments) && reader.IsGood())
      {
        return name + " is damaged: " + Name(pattern) + " is missing or out of order.";
      }
    }
    const std::size_t numberOfVertices = reader.Get();
    const std::size_t numberOfTriangles = reader.Get();
    reader.Get(pattern.Vertices, 3 * numberOfVertices);
    reader.Get(pattern.Triangles, 3 * numberOfTriangles);
    if (!reader.IsGood())
    {
      return name + " is truncated in " + Name(pattern) + ".";
    }
  }
  if (reader.GetRemaining() > 0)
  {
    return name + " has " + std::to_string(reader.GetRemaining()) +
      " bytes after its last pattern.";
  }
  return std::string();
}

vtkSmartPointer<vtkIntArray> NewPatternArray()
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName("Pattern");
  return array;
}

std::string WriteVTP(
  const char* fileName, int maximumLevel, const relevo::RefinementPatterns& patterns)
{
  constexpr int columns = 12;
  constexpr double spacing = 1.25;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkFloatArray> barycentrics;
  barycentrics->SetName("Barycentrics");
  barycentrics->SetNumberOfComponents(3);
  auto patternOfPoint = NewPatternArray();
  auto patternOfCell = NewPatternArray();
  for (int index = 0; index < static_cast<int>(patterns.size()); ++index)
  {
    const relevo::RefinementPattern& pattern = *patterns[index];
    const vtkIdType first = points->GetNumberOfPoints();
    const double x = spacing * (index % columns);
    const double y = -spacing * (index / columns);
    for (std::size_t i = 0; i < pattern.Vertices.size(); i += 3)
    {
      const float* weights = &pattern.Vertices[i];
      points->InsertNextPoint(
        x + weights[1] + 0.5 * weights[2], y + 0.8660254037844386 * weights[2], 0.0);
      barycentrics->InsertNextTypedTuple(weights);
      patternOfPoint->InsertNextValue(index);
    }
    for (std::size_t t = 0; t < pattern.Triangles.size(); t += 3)
    {
      const unsigned int* triangle = &pattern.Triangles[t];
      const vtkIdType ids[3] = { first + triangle[0], first + triangle[1], first + triangle[2] };
      triangles->InsertNextCell(3, ids);
      patternOfCell->InsertNextValue(index);
    }
  }
  vtkNew<vtkIntArray> level;
  level->SetName("MaximumLevel");
  level->InsertNextValue(maximumLevel);

  vtkNew<vtkPolyData> polyData;
  polyData->SetPoints(points);
  polyData->SetPolys(triangles);
  polyData->GetPointData()->AddArray(barycentrics);
  polyData->GetPointData()->AddArray(patternOfPoint);
  polyData->GetCellData()->AddArray(patternOfCell);
  polyData->GetFieldData()->AddArray(level);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(polyData);
  return relevo::WriteFile(fileName, writer.Get(), relevo::IsWholeXML);
}

std::string ReadVTP(
  const char* fileName, int& maximumLevel, std::vector<relevo::RefinementPattern>& patterns)
{
  const std::string name = fileName;
  std::string errors;
  vtkNew<vtkXMLPolyDataReader> reader;
  auto collector = relevo::NewErrorCollector(errors);
  reader->AddObserver(vtkCommand::ErrorEvent, collector);
  reader->SetParserErrorObserver(collector);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, collector);
  if (!reader->CanReadFile(fileName))
  {
    return name + " is not a VTK XML file of polygonal data.";
  }
  reader->SetFileName(fileName);
  reader->Update();
  vtkPolyData* polyData = reader->GetOutput();
  if (!errors.empty() || reader->GetErrorCode() != 0)
  {
    return name + " is damaged. " + errors.substr(0, errors.find('\n'));
  }
  auto* barycentrics =
    vtkFloatArray::SafeDownCast(polyData->GetPointData()->GetArray("Barycentrics"));
  auto* patternOfPoint = vtkIntArray::SafeDownCast(polyData->GetPointData()->GetArray("Pattern"));
  auto* patternOfCell = vtkIntArray::SafeDownCast(polyData->GetCellData()->GetArray("Pattern"));
  auto* level = vtkIntArray::SafeDownCast(polyData->GetFieldData()->GetArray("MaximumLevel"));
  if (!barycentrics || barycentrics->GetNumberOfComponents() != 3 || !patternOfPoint ||
    patternOfPoint->GetNumberOfComponents() != 1 || !patternOfCell ||
    patternOfCell->GetNumberOfComponents() != 1 || !level || level->GetNumberOfValues() != 1)
  {
    return name +
      " is not a file of refinement patterns: it needs the point arrays Barycentrics and "
      "Pattern, the cell array Pattern and the field array MaximumLevel.";
  }
  if (polyData->GetNumberOfCells() != polyData->GetNumberOfPolys())
  {
    return name + " has cells that are not triangles.";
  }
  if (!IsLevel(level->GetValue(0)))
  {
    return name + " has MaximumLevel " + std::to_string(level->GetValue(0)) +
      ", which is out of range.";
  }
  maximumLevel = level->GetValue(0);
  patterns = MakeEmptyPatterns(maximumLevel);
  const int count = static_cast<int>(patterns.size());

  // Points and cells of a pattern are in order, but need not be contiguous.
  const vtkIdType numberOfPoints = polyData->GetNumberOfPoints();
  std::vector<unsigned int> vertexOfPoint(numberOfPoints);
  for (vtkIdType p = 0; p < numberOfPoints; ++p)
  {
    const int index = patternOfPoint->GetValue(p);
    if (index < 0 || index >= count)
    {
      return name + " has a point that belongs to no pattern.";
    }
    std::vector<float>& vertices = patterns[index].Vertices;
    vertexOfPoint[p] = static_cast<unsigned int>(vertices.size() / 3);
    const float* weights = barycentrics->GetPointer(3 * p);
    vertices.insert(vertices.end(), weights, weights + 3);
  }
  auto cells = vtk::TakeSmartPointer(polyData->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    const int index = patternOfCell->GetValue(cells->GetCurrentCellId());
    if (size != 3 || index < 0 || index >= count)
    {
      return name + " has a cell that is not a triangle of an existing pattern.";
    }
    for (vtkIdType i = 0; i < 3; ++i)
    {
      if (ids[i] < 0 || ids[i] >= numberOfPoints || patternOfPoint->GetValue(ids[i]) != index)
      {
        return name + " has a triangle with points of another pattern.";
      }
      patterns[index].Triangles.push_back(vertexOfPoint[ids[i]]);
    }
  }
  return std::string();
}
}

namespace relevo
{
std::string WritePatterns(
  const char* fileName, int maximumLevel, const RefinementPatterns& patterns)
{
  if (!fileName || !*fileName)
  {
    return "the file name is empty.";
  }
  const std::string error = IsVTP(fileName) ? WriteVTP(fileName, maximumLevel, patterns)
                                            : WriteBinary(fileName, maximumLevel, patterns);
  return error.empty() ? "" : std::string(fileName) + " cannot be written: " + error + ".";
}

std::string ReadPatterns(
  const char* fileName, int& maximumLevel, std::vector<RefinementPattern>& patterns)
{
  if (!fileName || !*fileName)
  {
    return "the file name is empty.";
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(fileName, ignored))
  {
    return std::string(fileName) + " does not exist or is not a regular file.";
  }
  std::string error = IsVTP(fileName) ? ReadVTP(fileName, maximumLevel, patterns)
                                      : ReadBinary(fileName, maximumLevel, patterns);
  for (std::size_t i = 0; i < patterns.size() && error.empty(); ++i)
  {
    if (const char* defect = FindDefect(patterns[i]))
    {
      error = std::string(fileName) + " is damaged in " + Name(patterns[i]) + ": " + defect + ".";
    }
    else
    {
      MakeLines(patterns[i]);
    }
  }
  return error;
}
}

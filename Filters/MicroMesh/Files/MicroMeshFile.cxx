// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MicroMeshFile.h"

#include "Data/MicroMeshArrays.h"
#include "Files/ArrayPacking.h"
#include "Files/ChunkFile.h"
#include "Files/ComputedArray.h"
#include "Files/DirectionPacking.h"
#include "Files/LittleEndian.h"
#include "Files/NumberPrediction.h"
#include "Files/PointPacking.h"
#include "Files/SamplePrediction.h"
#include "Files/TrianglePacking.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace relevo
{
namespace
{
enum Owners
{
  POINTS,
  TRIANGLES,
  POINT_DATA,
  CELL_DATA,
  FIELD_DATA
};

enum Codings
{
  VALUES,
  TRIANGLE_OPERATIONS,
  DIRECTIONS,
  EDGES,
  FACES,
  SAMPLES,
  COMPUTED,
  INTEGER_POINTS
};

struct Entry
{
  int Owner = 0;
  int Type = 0;
  int Bits = 0;
  int Role = 0;
  int Coding = VALUES;
  std::uint64_t Components = 0;
  std::uint64_t Tuples = 0;
  std::string Name;
};

constexpr std::size_t EntrySize = 21; // without the name

void AppendEntry(const Entry& entry, std::string& table)
{
  for (int number : { entry.Owner, entry.Type, entry.Bits, entry.Role, entry.Coding })
  {
    AppendNumber(table, static_cast<std::uint64_t>(number), 1);
  }
  AppendNumber(table, entry.Components, 4);
  AppendNumber(table, entry.Tuples, 8);
  AppendNumber(table, entry.Name.size(), 4);
  table += entry.Name;
}

// Returns false if the table has no further entry.
bool TakeEntry(std::string_view& table, Entry& entry)
{
  const bool isWhole = table.size() >= EntrySize;
  for (int* number : { &entry.Owner, &entry.Type, &entry.Bits, &entry.Role, &entry.Coding })
  {
    *number = static_cast<int>(TakeNumber(table, 1));
  }
  entry.Components = TakeNumber(table, 4);
  entry.Tuples = TakeNumber(table, 8);
  const std::uint64_t length = TakeNumber(table, 4);
  if (!isWhole || length > table.size())
  {
    return false;
  }
  entry.Name = table.substr(0, length);
  table.remove_prefix(length);
  return true;
}

// Replaces the corners of triangles by the first of the points at the same place.
std::vector<PackedTriangle> MergeCorners(
  const std::vector<PackedTriangle>& triangles, const std::vector<int>& firsts)
{
  std::vector<PackedTriangle> merged = triangles;
  for (PackedTriangle& triangle : merged)
  {
    for (int& corner : triangle)
    {
      const bool isPoint = corner >= 0 && static_cast<std::size_t>(corner) < firsts.size();
      corner = isPoint ? firsts[static_cast<std::size_t>(corner)] : corner;
    }
  }
  return merged;
}

template <std::size_t Size>
void CopyNumbers(vtkDataArray* array, std::vector<std::array<int, Size>>& numbers)
{
  numbers.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  const int* values = vtkIntArray::SafeDownCast(array)->GetPointer(0);
  for (std::array<int, Size>& tuple : numbers)
  {
    std::copy_n(values, Size, tuple.begin());
    values += Size;
  }
}

template <std::size_t Size>
void CopyNumbers(const std::vector<std::array<int, Size>>& numbers, vtkDataArray* array)
{
  int* values = vtkIntArray::SafeDownCast(array)->GetPointer(0);
  for (const std::array<int, Size>& tuple : numbers)
  {
    values = std::copy(tuple.begin(), tuple.end(), values);
  }
}

// The triangles of a mesh that TakeMicroMesh() has read.
vtkSmartPointer<vtkIntArray> CopyTriangles(const MicroMesh& micro)
{
  std::vector<PackedTriangle> corners;
  for (const MicroMesh::Face& face : micro.Faces)
  {
    corners.push_back(face.Corners);
  }
  auto triangles = vtkSmartPointer<vtkIntArray>::New();
  triangles->SetNumberOfComponents(3);
  triangles->SetNumberOfTuples(static_cast<vtkIdType>(corners.size()));
  CopyNumbers(corners, triangles);
  return triangles;
}

class MicroPacker
{
public:
  MicroPacker(const MicroMesh& micro, std::vector<std::string>& leftOut)
    : Micro(micro)
    , LeftOut(leftOut)
    , Chunks(1)
  {
  }

  void Pack(vtkPolyData* mesh)
  {
    this->AddPoints(mesh->GetPoints()->GetData());
    this->AddTriangles();
    const std::array<std::pair<int, const char*>, 4> arrays{ { { POINT_DATA, MicroDirectionsName },
      { FIELD_DATA, MicroEdgesName }, { CELL_DATA, MicroFacesName },
      { FIELD_DATA, MicroDisplacementsName } } };
    for (const auto& array : arrays)
    {
      this->AddMicroArray(array.first, GetData(mesh, array.first), array.second);
    }
    for (int owner : { POINT_DATA, CELL_DATA, FIELD_DATA })
    {
      vtkFieldData* data = GetData(mesh, owner);
      auto attributes = vtkDataSetAttributes::SafeDownCast(data);
      for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* array = data->GetAbstractArray(i);
        const bool isDone = std::any_of(arrays.begin(), arrays.end(),
          [&](const auto& done)
          { return done.first == owner && data->GetAbstractArray(done.second) == array; });
        if (!isDone)
        {
          this->Add(owner, attributes ? attributes->IsArrayAnAttribute(i) + 1 : 0, array);
        }
      }
    }
  }

  std::string GetFile() const { return PackChunks(this->Chunks); }

private:
  static vtkFieldData* GetData(vtkPolyData* mesh, int owner)
  {
    return owner == POINT_DATA ? mesh->GetPointData()
      : owner == CELL_DATA     ? mesh->GetCellData()
                               : mesh->GetFieldData();
  }

  void AddChunk(int owner, int role, int coding, int bits, vtkDataArray* array, std::string bytes)
  {
    Entry entry;
    entry.Owner = owner;
    entry.Type = array->GetDataType();
    entry.Bits = bits;
    entry.Role = role;
    entry.Coding = coding;
    entry.Components = static_cast<std::uint64_t>(array->GetNumberOfComponents());
    entry.Tuples = static_cast<std::uint64_t>(array->GetNumberOfTuples());
    entry.Name = array->GetName() ? array->GetName() : "";
    AppendEntry(entry, this->Chunks.front());
    this->Chunks.push_back(std::move(bytes));
  }

  // The array, or a copy of it with standard memory layout.
  static vtkSmartPointer<vtkDataArray> GetStandard(vtkDataArray* array)
  {
    if (array->HasStandardMemoryLayout())
    {
      return array;
    }
    auto copy = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(array->GetDataType()));
    copy->DeepCopy(array);
    copy->SetName(array->GetName());
    return copy;
  }

  void AddPoints(vtkDataArray* points)
  {
    this->Firsts = FindFirstPoints(points);
    if (IsFloating(points->GetDataType()))
    {
      const vtkSmartPointer<vtkDataArray> standard = GetStandard(points);
      this->AddChunk(POINTS, 0, INTEGER_POINTS, 0, standard, PackPoints(standard, this->Firsts));
    }
    else
    {
      this->Add(POINTS, 0, points);
    }
  }

  void AddTriangles()
  {
    const vtkSmartPointer<vtkIntArray> array = CopyTriangles(this->Micro);
    std::vector<PackedTriangle> triangles;
    CopyNumbers(array, triangles);
    this->AddChunk(TRIANGLES, 0, TRIANGLE_OPERATIONS, 0, array, PackTriangles(triangles));
    this->Triangles = MergeCorners(triangles, this->Firsts);
  }

  void AddMicroArray(int owner, vtkFieldData* data, const char* name)
  {
    auto attributes = vtkDataSetAttributes::SafeDownCast(data);
    int index = -1;
    auto array = vtkDataArray::SafeDownCast(data->GetAbstractArray(name, index));
    const int role = attributes ? attributes->IsArrayAnAttribute(index) + 1 : 0;
    std::string bytes;
    if (owner == POINT_DATA)
    {
      const bool isPacked = PackDirections(this->Micro.Directions, this->Firsts, bytes);
      isPacked ? this->AddChunk(owner, role, DIRECTIONS, 0, array, std::move(bytes))
               : this->Add(owner, role, array);
    }
    else if (owner == CELL_DATA)
    {
      std::vector<FaceNumbers> faces;
      CopyNumbers(array, faces);
      this->AddChunk(
        owner, role, FACES, 0, array, PackFaceNumbers(faces, this->Triangles, this->Edges));
    }
    else if (std::string(name) == MicroEdgesName)
    {
      CopyNumbers(array, this->Edges);
      this->AddChunk(owner, role, EDGES, 0, array, PackEdgeNumbers(this->Edges));
    }
    else
    {
      this->AddChunk(owner, role, SAMPLES, 0, array, PackSamples(this->Micro));
    }
  }

  void Add(int owner, int role, vtkAbstractArray* abstract)
  {
    vtkSmartPointer<vtkDataArray> array = vtkDataArray::SafeDownCast(abstract);
    if (!array || !IsPackedType(array->GetDataType()))
    {
      this->LeftOut.emplace_back(abstract->GetName() ? abstract->GetName() : "");
      return;
    }
    array = GetStandard(array);
    const vtkSmartPointer<vtkFloatArray> computed = owner == POINT_DATA
      ? ComputeMicroPointData(this->Micro, array->GetName())
      : owner == CELL_DATA ? ComputeMicroCellData(this->Micro, array->GetName())
                           : nullptr;
    if (computed && IsLikeComputed(array, computed))
    {
      this->AddChunk(owner, role, COMPUTED, 0, array, PackOtherTuples(array, computed));
      return;
    }
    const int bits = FindBits(array);
    this->AddChunk(owner, role, VALUES, bits, array, PackArray(array, bits));
  }

  const MicroMesh& Micro;
  std::vector<std::string>& LeftOut;
  std::vector<std::string> Chunks;
  std::vector<int> Firsts;               // points, per point
  std::vector<PackedTriangle> Triangles; // with merged corners
  std::vector<EdgeNumbers> Edges;
};

class MicroUnpacker
{
public:
  explicit MicroUnpacker(vtkPolyData* mesh)
    : Mesh(mesh)
  {
  }

  std::string Unpack(const std::vector<std::string>& chunks)
  {
    std::string_view table = chunks.empty() ? std::string_view() : chunks.front();
    for (std::size_t i = 1; i < chunks.size(); ++i)
    {
      Entry entry;
      vtkSmartPointer<vtkDataArray> array;
      if (!TakeEntry(table, entry) || !this->MakeArray(entry, chunks[i], array) ||
        !this->Place(entry, array))
      {
        return "the file is damaged: the array of chunk " + std::to_string(i) + " is invalid";
      }
    }
    if (!table.empty() || !this->Mesh->GetPoints() || this->Mesh->GetNumberOfPolys() == 0)
    {
      return "the file is damaged: its table lacks points or triangles";
    }
    MicroMesh micro;
    std::string error;
    return TakeMicroMesh(this->Mesh, micro, error) ? "" : error;
  }

private:
  bool MakeArray(const Entry& entry, const std::string& bytes, vtkSmartPointer<vtkDataArray>& array)
  {
    constexpr std::uint64_t mostComponents = 1 << 20;
    if (!IsPackedType(entry.Type) || entry.Components == 0 || entry.Components > mostComponents ||
      !HasRightSize(entry, bytes.size()))
    {
      return false;
    }
    if (entry.Coding == COMPUTED)
    {
      return this->Compute(entry, bytes, array);
    }
    array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(entry.Type));
    array->SetName(entry.Name.empty() ? nullptr : entry.Name.c_str());
    array->SetNumberOfComponents(static_cast<int>(entry.Components));
    array->SetNumberOfTuples(static_cast<vtkIdType>(entry.Tuples));
    switch (entry.Coding)
    {
      case VALUES:
        UnpackArray(bytes, entry.Bits, array);
        return true;
      case INTEGER_POINTS:
        return UnpackPoints(bytes, array);
      case TRIANGLE_OPERATIONS:
        return this->FillTriangles(bytes, array);
      case DIRECTIONS:
        return this->FillDirections(bytes, array);
      case EDGES:
        return this->FillEdges(bytes, array);
      case FACES:
        return this->FillFaces(bytes, array);
      case SAMPLES:
        return this->FillSamples(entry, bytes, array);
      default:
        return false;
    }
  }

  // Whether a chunk has the size that its entry tells, so that arrays are not larger than files
  // allow.
  static bool HasRightSize(const Entry& entry, std::size_t size)
  {
    const bool hasValues = entry.Coding == VALUES;
    const int bits = 8 * vtkDataArray::GetDataTypeSize(entry.Type);
    const bool isSmall = entry.Type == VTK_SHORT && (entry.Bits == 8 || entry.Bits == 11);
    if (hasValues)
    {
      return (entry.Bits == bits || isSmall) &&
        GetPackedSize(entry.Type, entry.Bits, entry.Components, entry.Tuples) == size;
    }
    const auto isFilled = [&](std::uint64_t sizeOfTuple)
    { return entry.Tuples <= size / sizeOfTuple && entry.Tuples * sizeOfTuple == size; };
    const bool isNumber = entry.Type == VTK_INT;
    switch (entry.Coding)
    {
      case INTEGER_POINTS:
        return IsFloating(entry.Type) && entry.Components == 3 && entry.Tuples <= size;
      case TRIANGLE_OPERATIONS:
        return isNumber && entry.Components == 3 && entry.Tuples <= size;
      case DIRECTIONS:
        return entry.Type == VTK_FLOAT && entry.Components == 3 && entry.Tuples <= size &&
          GetPackedDirectionSize(entry.Tuples) == size;
      case EDGES:
      case FACES:
        return isNumber &&
          entry.Components ==
          (entry.Coding == EDGES ? std::tuple_size<EdgeNumbers>::value
                                 : std::tuple_size<FaceNumbers>::value) &&
          isFilled(SizeOfPackedNumber * entry.Components);
      case SAMPLES:
        return (entry.Type == VTK_SHORT || entry.Type == VTK_SIGNED_CHAR) &&
          entry.Components == 1 && isFilled(SizeOfPackedSample);
      default:
        return entry.Coding == COMPUTED && entry.Type == VTK_FLOAT;
    }
  }

  bool FillTriangles(std::string_view bytes, vtkDataArray* array)
  {
    std::vector<PackedTriangle> triangles;
    const auto number = static_cast<std::size_t>(array->GetNumberOfTuples());
    if (!this->Mesh->GetPoints() || !UnpackTriangles(bytes, number, triangles))
    {
      return false;
    }
    CopyNumbers(triangles, array);
    this->Triangles = MergeCorners(triangles, this->Firsts);
    return true;
  }

  bool FillDirections(std::string_view bytes, vtkDataArray* array) const
  {
    std::vector<vec3> directions(static_cast<std::size_t>(array->GetNumberOfTuples()));
    if (directions.size() != this->Firsts.size())
    {
      return false;
    }
    UnpackDirections(bytes, this->Firsts, directions);
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      vtkFloatArray::SafeDownCast(array)->SetTypedTuple(
        static_cast<vtkIdType>(i), &directions[i].x);
    }
    return true;
  }

  bool FillEdges(std::string_view bytes, vtkDataArray* array)
  {
    this->Edges.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
    UnpackEdgeNumbers(bytes, this->Edges);
    CopyNumbers(this->Edges, array);
    return true;
  }

  bool FillFaces(std::string_view bytes, vtkDataArray* array) const
  {
    std::vector<FaceNumbers> faces(static_cast<std::size_t>(array->GetNumberOfTuples()));
    if (faces.size() != this->Triangles.size())
    {
      return false;
    }
    UnpackFaceNumbers(bytes, this->Triangles, this->Edges, faces);
    CopyNumbers(faces, array);
    return true;
  }

  // The other arrays of the micro-mesh are there.
  bool FillSamples(const Entry& entry, std::string_view bytes, vtkDataArray* array)
  {
    array->Fill(0.0);
    vtkNew<vtkPolyData> mesh;
    mesh->ShallowCopy(this->Mesh);
    mesh->GetFieldData()->AddArray(array);
    this->Micro = {};
    std::string error;
    if (entry.Name != MicroDisplacementsName || !this->Mesh->GetPoints() ||
      !TakeMicroMesh(mesh, this->Micro, error))
    {
      return false;
    }
    UnpackSamples(bytes, this->Micro);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->SetComponent(i, 0, this->Micro.Samples[static_cast<std::size_t>(i)]);
    }
    return true;
  }

  bool Compute(
    const Entry& entry, std::string_view bytes, vtkSmartPointer<vtkDataArray>& array) const
  {
    const vtkSmartPointer<vtkFloatArray> computed = entry.Owner == POINT_DATA
      ? ComputeMicroPointData(this->Micro, entry.Name.c_str())
      : ComputeMicroCellData(this->Micro, entry.Name.c_str());
    array = computed;
    return computed && UnpackOtherTuples(bytes, computed);
  }

  bool Place(const Entry& entry, vtkDataArray* array)
  {
    switch (entry.Owner)
    {
      case POINTS:
        return this->PlacePoints(array);
      case TRIANGLES:
        return this->PlaceTriangles(array);
      case POINT_DATA:
        return PlaceInData(
          entry, array, this->Mesh->GetPointData(), this->Mesh->GetNumberOfPoints());
      case CELL_DATA:
        return PlaceInData(entry, array, this->Mesh->GetCellData(), this->Mesh->GetNumberOfPolys());
      case FIELD_DATA:
        this->Mesh->GetFieldData()->AddArray(array);
        return true;
      default:
        return false;
    }
  }

  bool PlacePoints(vtkDataArray* array)
  {
    if (this->Mesh->GetPoints() || array->GetNumberOfComponents() != 3)
    {
      return false;
    }
    vtkNew<vtkPoints> points;
    points->SetDataType(array->GetDataType());
    points->SetData(array);
    this->Mesh->SetPoints(points);
    this->Firsts = FindFirstPoints(array);
    return true;
  }

  // The points come before the triangles, and both before their data.
  bool PlaceTriangles(vtkDataArray* array)
  {
    auto corners = vtkIntArray::SafeDownCast(array);
    if (!corners || corners->GetNumberOfComponents() != 3 || this->Mesh->GetNumberOfPolys() > 0)
    {
      return false;
    }
    vtkNew<vtkCellArray> triangles;
    for (vtkIdType t = 0; t < corners->GetNumberOfTuples(); ++t)
    {
      vtkIdType ids[3];
      for (int c = 0; c < 3; ++c)
      {
        ids[c] = corners->GetTypedComponent(t, c);
        if (ids[c] < 0 || ids[c] >= this->Mesh->GetNumberOfPoints())
        {
          return false;
        }
      }
      triangles->InsertNextCell(3, ids);
    }
    this->Mesh->SetPolys(triangles);
    return true;
  }

  static bool PlaceInData(
    const Entry& entry, vtkDataArray* array, vtkDataSetAttributes* data, vtkIdType tuples)
  {
    if (array->GetNumberOfTuples() != tuples || entry.Role > vtkDataSetAttributes::NUM_ATTRIBUTES)
    {
      return false;
    }
    const int index = data->AddArray(array);
    return entry.Role == 0 || data->SetActiveAttribute(index, entry.Role - 1) >= 0;
  }

  vtkPolyData* Mesh;
  MicroMesh Micro;
  std::vector<int> Firsts;               // points, per point
  std::vector<PackedTriangle> Triangles; // with merged corners
  std::vector<EdgeNumbers> Edges;
};
}

std::string PackMicroMesh(
  vtkPolyData* mesh, const MicroMesh& micro, std::vector<std::string>& leftOut)
{
  MicroPacker packer(micro, leftOut);
  packer.Pack(mesh);
  return packer.GetFile();
}

std::string UnpackMicroMesh(std::string_view file, vtkPolyData* mesh)
{
  std::vector<std::string> chunks;
  const std::string error = UnpackChunks(file, chunks);
  return error.empty() ? MicroUnpacker(mesh).Unpack(chunks) : error;
}
}

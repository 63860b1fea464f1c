// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MicroMeshFile.h"

#include "Data/MicroMeshArrays.h"
#include "Files/ArrayPacking.h"
#include "Files/ChunkFile.h"
#include "Files/LittleEndian.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <limits>

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

struct Entry
{
  int Owner = 0;
  int Type = 0;
  int Bits = 0;
  int Role = 0;
  std::uint64_t Components = 0;
  std::uint64_t Tuples = 0;
  std::string Name;
};

constexpr std::size_t EntrySize = 20; // without the name

void AppendEntry(const Entry& entry, std::string& table)
{
  for (int number : { entry.Owner, entry.Type, entry.Bits, entry.Role })
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
  for (int* number : { &entry.Owner, &entry.Type, &entry.Bits, &entry.Role })
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

class MicroPacker
{
public:
  explicit MicroPacker(std::vector<std::string>& leftOut)
    : LeftOut(leftOut)
    , Chunks(1)
  {
  }

  void Add(int owner, int role, vtkAbstractArray* abstract)
  {
    const std::string name = abstract->GetName() ? abstract->GetName() : "";
    vtkSmartPointer<vtkDataArray> array = vtkDataArray::SafeDownCast(abstract);
    if (!array || !IsPackedType(array->GetDataType()))
    {
      this->LeftOut.push_back(name);
      return;
    }
    if (!array->HasStandardMemoryLayout())
    {
      auto copy = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(array->GetDataType()));
      copy->DeepCopy(array);
      array = copy;
    }
    Entry entry;
    entry.Owner = owner;
    entry.Type = array->GetDataType();
    entry.Bits = FindBits(array);
    entry.Role = role;
    entry.Components = static_cast<std::uint64_t>(array->GetNumberOfComponents());
    entry.Tuples = static_cast<std::uint64_t>(array->GetNumberOfTuples());
    entry.Name = name;
    AppendEntry(entry, this->Chunks.front());
    this->Chunks.push_back(PackArray(array, entry.Bits));
  }

  void Add(int owner, vtkDataSetAttributes* data)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      this->Add(owner, data->IsArrayAnAttribute(i) + 1, data->GetAbstractArray(i));
    }
  }

  std::string Pack() const { return PackChunks(this->Chunks); }

private:
  std::vector<std::string>& LeftOut;
  std::vector<std::string> Chunks;
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
  bool MakeArray(
    const Entry& entry, const std::string& bytes, vtkSmartPointer<vtkDataArray>& array) const
  {
    if (!IsPackedType(entry.Type))
    {
      return false;
    }
    const int bits = 8 * vtkDataArray::GetDataTypeSize(entry.Type);
    const bool isSmall = entry.Type == VTK_SHORT && (entry.Bits == 8 || entry.Bits == 11);
    constexpr std::uint64_t mostComponents = 1 << 20;
    if ((entry.Bits != bits && !isSmall) || entry.Components == 0 ||
      entry.Components > mostComponents ||
      GetPackedSize(entry.Type, entry.Bits, entry.Components, entry.Tuples) != bytes.size())
    {
      return false;
    }
    array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(entry.Type));
    array->SetName(entry.Name.empty() ? nullptr : entry.Name.c_str());
    array->SetNumberOfComponents(static_cast<int>(entry.Components));
    array->SetNumberOfTuples(static_cast<vtkIdType>(entry.Tuples));
    UnpackArray(bytes, entry.Bits, array);
    return true;
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
};
}

std::string PackMicroMesh(vtkPolyData* mesh, std::vector<std::string>& leftOut)
{
  MicroPacker packer(leftOut);
  packer.Add(POINTS, 0, mesh->GetPoints()->GetData());
  vtkNew<vtkIntArray> triangles;
  triangles->SetNumberOfComponents(3);
  triangles->SetNumberOfTuples(mesh->GetNumberOfPolys());
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    vtkIdType size;
    const vtkIdType* corners;
    mesh->GetPolys()->GetCellAtId(t, size, corners);
    for (int c = 0; c < 3; ++c)
    {
      triangles->SetTypedComponent(t, c, static_cast<int>(corners[c]));
    }
  }
  packer.Add(TRIANGLES, 0, triangles);
  packer.Add(POINT_DATA, mesh->GetPointData());
  packer.Add(CELL_DATA, mesh->GetCellData());
  for (int i = 0; i < mesh->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    packer.Add(FIELD_DATA, 0, mesh->GetFieldData()->GetAbstractArray(i));
  }
  return packer.Pack();
}

std::string UnpackMicroMesh(std::string_view file, vtkPolyData* mesh)
{
  std::vector<std::string> chunks;
  const std::string error = UnpackChunks(file, chunks);
  return error.empty() ? MicroUnpacker(mesh).Unpack(chunks) : error;
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshSignature.h"

#include "Cells/MeshScalars.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtksys/MD5.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace relevo
{
namespace
{
constexpr size_t BytesOfChunk = size_t(1) << 20;
constexpr size_t BytesOfDigest = 32;
using Digest = std::array<char, BytesOfDigest>;

Digest ComputeDigest(const unsigned char* bytes, size_t count)
{
  Digest digest;
  vtksysMD5* sum = vtksysMD5_New();
  vtksysMD5_Initialize(sum);
  vtksysMD5_Append(sum, bytes, static_cast<int>(count));
  vtksysMD5_FinalizeHex(sum, digest.data());
  vtksysMD5_Delete(sum);
  return digest;
}

// A text of numbers and of the digests of arrays.
class Signature
{
public:
  template <typename T>
  void AddNumber(T number)
  {
    this->Text += std::to_string(number) + " ";
  }
  void AddDouble(double number) { this->AddBytes(&number, sizeof number); }
  void AddArray(vtkDataArray* array);
  /// Return nothing if an array cannot be read.
  std::string Finish() const;
  void Fail() { this->HasFailed = true; }

private:
  void AddBytes(const void* bytes, size_t count);

  std::string Text;
  bool HasFailed = false;
};

void Signature::AddBytes(const void* bytes, size_t count)
{
  const auto* first = static_cast<const unsigned char*>(bytes);
  std::vector<Digest> digests((count + BytesOfChunk - 1) / BytesOfChunk);
  vtkSMPTools::For(0, static_cast<vtkIdType>(digests.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const size_t from = static_cast<size_t>(i) * BytesOfChunk;
        digests[static_cast<size_t>(i)] =
          ComputeDigest(first + from, std::min(BytesOfChunk, count - from));
      }
    });
  this->AddNumber(count);
  for (const Digest& digest : digests)
  {
    this->Text.append(digest.begin(), digest.end());
  }
}

void Signature::AddArray(vtkDataArray* array)
{
  this->AddNumber(array ? array->GetDataType() : VTK_VOID);
  if (!array)
  {
    return;
  }
  if (!array->HasStandardMemoryLayout() || array->GetDataTypeSize() == 0) // such as bits
  {
    this->Fail();
    return;
  }
  this->AddNumber(array->GetNumberOfComponents());
  this->AddBytes(array->GetVoidPointer(0),
    static_cast<size_t>(array->GetNumberOfValues()) *
      static_cast<size_t>(array->GetDataTypeSize()));
}

std::string Signature::Finish() const
{
  if (this->HasFailed)
  {
    return "";
  }
  const Digest digest =
    ComputeDigest(reinterpret_cast<const unsigned char*>(this->Text.data()), this->Text.size());
  return std::string(digest.begin(), digest.end());
}

void AddCells(Signature& signature, vtkUnstructuredGrid* mesh)
{
  std::vector<unsigned char> types(static_cast<size_t>(mesh->GetNumberOfCells()));
  for (size_t i = 0; i < types.size(); ++i)
  {
    types[i] = static_cast<unsigned char>(mesh->GetCellType(static_cast<vtkIdType>(i)));
  }
  if (std::find(types.begin(), types.end(), VTK_POLYHEDRON) != types.end())
  {
    signature.Fail();
    return;
  }
  vtkNew<vtkUnsignedCharArray> array;
  array->SetArray(types.data(), mesh->GetNumberOfCells(), 1);
  signature.AddArray(array);
  vtkCellArray* cells = mesh->GetCells();
  signature.AddArray(cells ? cells->GetOffsetsArray() : nullptr);
  signature.AddArray(cells ? cells->GetConnectivityArray() : nullptr);
}

void AddExtent(Signature& signature, const int extent[6])
{
  for (int i = 0; i < 6; ++i)
  {
    signature.AddNumber(extent[i]);
  }
}

void AddImage(Signature& signature, vtkImageData* image)
{
  AddExtent(signature, image->GetExtent());
  for (int i = 0; i < 3; ++i)
  {
    signature.AddDouble(image->GetOrigin()[i]);
    signature.AddDouble(image->GetSpacing()[i]);
  }
  for (int i = 0; i < 9; ++i)
  {
    signature.AddDouble(image->GetDirectionMatrix()->GetData()[i]);
  }
}

void AddMesh(Signature& signature, vtkDataSet* mesh)
{
  signature.AddNumber(mesh->GetDataObjectType());
  signature.AddNumber(mesh->GetNumberOfPoints());
  signature.AddNumber(mesh->GetNumberOfCells());
  signature.AddArray(mesh->GetCellGhostArray());
  signature.AddArray(mesh->GetPointGhostArray());
  if (auto* points = vtkPointSet::SafeDownCast(mesh))
  {
    signature.AddArray(points->GetPoints() ? points->GetPoints()->GetData() : nullptr);
  }
  switch (mesh->GetDataObjectType())
  {
    case VTK_UNSTRUCTURED_GRID:
      AddCells(signature, vtkUnstructuredGrid::SafeDownCast(mesh));
      break;
    case VTK_STRUCTURED_GRID:
      AddExtent(signature, vtkStructuredGrid::SafeDownCast(mesh)->GetExtent());
      break;
    case VTK_IMAGE_DATA:
    case VTK_UNIFORM_GRID:
    case VTK_STRUCTURED_POINTS:
      AddImage(signature, vtkImageData::SafeDownCast(mesh));
      break;
    case VTK_RECTILINEAR_GRID:
    {
      auto* grid = vtkRectilinearGrid::SafeDownCast(mesh);
      AddExtent(signature, grid->GetExtent());
      signature.AddArray(grid->GetXCoordinates());
      signature.AddArray(grid->GetYCoordinates());
      signature.AddArray(grid->GetZCoordinates());
      break;
    }
    default:
      signature.Fail();
  }
}
}

std::string ComputeMeshSignature(const std::vector<MeshScalars>& meshes)
{
  Signature signature;
  for (const MeshScalars& mesh : meshes)
  {
    signature.AddNumber(mesh.AreOfCells);
    AddMesh(signature, mesh.Mesh);
  }
  return signature.Finish();
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/GLTFReader.h"

#include "Files/MeshPoints.h"
#include "GLTFCheck.h"
#include "Text/ViewerMessages.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkGLTFReader.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
// A primitive: triangles with one material.
struct Part
{
  vtkSmartPointer<vtkPolyData> Mesh;
  bool IsMirrored;
};

// VTK's reader stores the matrix of a node with the node's first primitive.
bool IsMirroring(vtkMultiBlockDataSet* blocks)
{
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    vtkDataObject* block = blocks->GetBlock(i);
    vtkDataArray* matrix = block ? block->GetFieldData()->GetArray("globalTransform") : nullptr;
    if (matrix && matrix->GetNumberOfValues() == 16)
    {
      double elements[16];
      for (int j = 0; j < 16; ++j)
      {
        elements[j] = matrix->GetVariantValue(j).ToDouble();
      }
      return vtkMatrix4x4::Determinant(elements) < 0.0;
    }
  }
  return false;
}

void FindParts(vtkMultiBlockDataSet* blocks, std::vector<Part>& parts)
{
  const bool isMirroring = IsMirroring(blocks);
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    if (auto* group = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(i)))
    {
      FindParts(group, parts);
    }
    else if (auto* mesh = vtkPolyData::SafeDownCast(blocks->GetBlock(i)))
    {
      parts.push_back({ mesh, isMirroring });
    }
  }
}

// Converts glTF's linear colours to sRGB.
unsigned char ToByte(double linear)
{
  const double c = std::clamp(linear, 0.0, 1.0);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255.0 * encoded));
}

std::array<double, 3> GetMaterialColor(vtkPolyData* mesh)
{
  std::array<double, 3> color{ { 1.0, 1.0, 1.0 } };
  vtkDataArray* factor = mesh->GetFieldData()->GetArray("BaseColorMultiplier");
  for (int c = 0; factor && c < std::min(3, factor->GetNumberOfComponents()); ++c)
  {
    color[c] = factor->GetComponent(0, c);
  }
  return color;
}

vtkDataArray* GetPointColors(vtkPolyData* mesh)
{
  vtkDataArray* colors = mesh->GetPointData()->GetScalars();
  return colors && colors->GetNumberOfComponents() >= 3 ? colors : nullptr;
}

bool HasColors(const Part& part)
{
  const std::array<double, 3> color = GetMaterialColor(part.Mesh);
  return GetPointColors(part.Mesh) || *std::min_element(color.begin(), color.end()) < 1.0;
}

// The product of the material's and the points' colours.
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(vtkPolyData* mesh)
{
  const std::array<double, 3> material = GetMaterialColor(mesh);
  vtkDataArray* points = GetPointColors(mesh);
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      colors->SetTypedComponent(
        i, c, ToByte(material[c] * (points ? points->GetComponent(i, c) : 1.0)));
    }
  }
  return colors;
}

// Triangles and strips only, with the winding of the scene, with or without colours.
vtkSmartPointer<vtkPolyData> MakeMesh(const Part& part, bool hasColors)
{
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(part.Mesh->GetPoints());
  mesh->SetPolys(part.Mesh->GetPolys());
  mesh->SetStrips(part.Mesh->GetStrips());
  mesh->GetPointData()->SetNormals(part.Mesh->GetPointData()->GetNormals());
  mesh->GetPointData()->SetTCoords(part.Mesh->GetPointData()->GetTCoords());
  if (hasColors)
  {
    mesh->GetPointData()->SetScalars(MakeColors(part.Mesh));
  }
  if (!part.IsMirrored)
  {
    return mesh;
  }
  vtkNew<vtkTriangleFilter> triangles; // reversing a strip does not always reverse its faces
  triangles->SetInputData(mesh);
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputConnection(triangles->GetOutputPort());
  reversed->Update();
  return reversed->GetOutput();
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadGLTF(const std::string& fileName, ViewerMessages& messages)
{
  CheckGLTF(fileName);
  vtkNew<vtkGLTFReader> reader;
  messages.Observe(reader, "reading");
  reader->SetFileName(fileName.c_str());
  reader->Update();
  messages.Check();
  std::vector<Part> parts;
  FindParts(reader->GetOutput(), parts);
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                [](const Part& part) { return part.Mesh->GetNumberOfPoints() == 0; }),
    parts.end());
  const bool hasColors = std::any_of(parts.begin(), parts.end(), HasColors);
  vtkNew<vtkAppendPolyData> append;
  messages.Observe(append);
  for (const Part& part : parts)
  {
    CheckCorners(part.Mesh); // AppendPolyData would turn invalid ids into points of other parts
    append->AddInputData(MakeMesh(part, hasColors));
  }
  if (!parts.empty())
  {
    append->Update();
  }
  return append->GetOutput();
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReader.h"

#ifdef VIEWER_HAS_EXODUS
#include "ExodusReader.h"
#endif
#include "MeshPoints.h"
#include "ViewerArguments.h"
#include "ViewerFile.h"
#include "ViewerMessages.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkGeometryFilter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"

#include <functional>
#include <map>

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;

template <typename Reader>
Mesh Read(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<Reader> reader;
  messages.Observe(reader, "reading");
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

Mesh ReadLegacy(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkGenericDataObjectReader> reader;
  messages.Observe(reader, "reading");
  reader->SetFileName(fileName.c_str());
  reader->Update();
  messages.Check();
  auto* data = vtkDataSet::SafeDownCast(reader->GetOutput());
  if (!data)
  {
    throw ViewerError("cannot read " + fileName + ": it holds no data set of points and cells");
  }
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh;
  }
  vtkNew<vtkGeometryFilter> surface;
  messages.Observe(surface, "taking the surface");
  surface->SetInputData(data);
  surface->Update();
  return surface->GetOutput();
}

using Function = std::function<Mesh(const std::string&, ViewerMessages&)>;
const std::map<std::string, Function>& GetReaders()
{
  static const std::map<std::string, Function> readers = {
#ifdef VIEWER_HAS_EXODUS
    { ".ex2", ReadExodus },
#endif
    { ".obj", Read<vtkOBJReader> },
    { ".ply", Read<vtkPLYReader> },
    { ".stl", Read<vtkSTLReader> },
    { ".vtk", ReadLegacy },
    { ".vtp", Read<vtkXMLPolyDataReader> },
  };
  return readers;
}

void CheckPoints(vtkPolyData* mesh, const std::string& fileName)
{
  vtkIdType number = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    number +=
      vtkMath::IsFinite(point[0]) && vtkMath::IsFinite(point[1]) && vtkMath::IsFinite(point[2]) ? 0
                                                                                                : 1;
  }
  if (number > 0)
  {
    throw ViewerError(fileName + ": " + std::to_string(number) + " of " +
      std::to_string(mesh->GetNumberOfPoints()) + " points are not finite");
  }
}
}

//------------------------------------------------------------------------------
bool IsMeshFile(const std::string& fileName)
{
  return GetReaders().count(GetExtension(fileName)) > 0;
}

//------------------------------------------------------------------------------
Mesh ReadMesh(const std::string& fileName, ViewerMessages& messages)
{
  CheckFile(fileName);
  Mesh mesh;
  try
  {
    mesh = GetReaders().at(GetExtension(fileName))(fileName, messages);
    messages.Check();
  }
  catch (const std::exception& error)
  {
    const std::string text = error.what();
    throw ViewerError(
      text.find(fileName) != std::string::npos ? text : "cannot read " + fileName + ": " + text);
  }
  if (!mesh || mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    throw ViewerError(fileName + " has no polygons to draw");
  }
  mesh = DropUnusedPoints(mesh);
  CheckPoints(mesh, fileName);
  return mesh;
}

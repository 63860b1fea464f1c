// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MeshReader.h"

#ifdef VIEWER_HAS_EXODUS
#include "Files/ExodusReader.h"
#endif
#include "FileEnd.h"
#include "Files/GLTFReader.h"
#include "Files/MeshPoints.h"
#include "Files/ViewerFile.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include "vtkBezierPatchReader.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkGeometryFilter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#if __has_include("vtkOFFReader.h")
#include "vtkOFFReader.h"
#endif
#include "vtkPLYReader.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersion.h"
#include "vtkXMLPUnstructuredGridReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <functional>
#include <map>
#include <set>
#include <vector>

namespace
{
using Data = vtkSmartPointer<vtkDataSet>;
using Mesh = vtkSmartPointer<vtkPolyData>;

template <typename Reader>
Data Read(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<Reader> reader;
  messages.Observe(reader, "reading");
  reader->SetFileName(fileName.c_str());
  reader->Update();
  messages.Check();
  return vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
}

bool HasCurvedCells(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    if ((type >= VTK_QUADRATIC_EDGE && type <= VTK_TRIQUADRATIC_PYRAMID) ||
      type >= VTK_HIGHER_ORDER_EDGE)
    {
      return true;
    }
  }
  return false;
}

template <typename Filter>
Mesh TakeSurface(vtkDataSet* data, ViewerMessages& messages)
{
  vtkNew<Filter> surface;
  messages.Observe(surface, "extracting the surface");
  surface->SetInputData(data);
  surface->Update();
  return surface->GetOutput();
}

// Returns the surface of a data set, which may itself be one.
Mesh TakeSurface(vtkDataSet* data, MeshCells cells, ViewerMessages& messages)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh;
  }
  if (auto* points = vtkPointSet::SafeDownCast(data))
  {
    CheckCorners(points);
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  const bool hasPatches =
    grid && (cells == MeshCells::Patches || (cells == MeshCells::Curved && HasCurvedCells(grid)));
  return hasPatches ? TakeSurface<vtkPatchSurfaceFilter>(grid, messages)
                    : TakeSurface<vtkGeometryFilter>(data, messages);
}

using ReaderFunction = std::function<Data(const std::string&, ViewerMessages&)>;
const std::map<std::string, ReaderFunction>& GetReaders()
{
  static const std::map<std::string, ReaderFunction> readers = {
    { ".bpt", Read<vtkBezierPatchReader> },
#ifdef VIEWER_HAS_EXODUS
    { ".ex2", ReadExodus },
#endif
    { ".glb", ReadGLTF },
    { ".gltf", ReadGLTF },
    { ".obj", Read<vtkOBJReader> },
#if __has_include("vtkOFFReader.h") // since VTK 9.4
    { ".off", Read<vtkOFFReader> },
#endif
    { ".ply", Read<vtkPLYReader> },
    { ".pvtu", Read<vtkXMLPUnstructuredGridReader> },
    { ".stl", Read<vtkSTLReader> },
    { ".vtk", Read<vtkGenericDataObjectReader> },
    { ".vtp", Read<vtkXMLPolyDataReader> },
    { ".vtu", Read<vtkXMLUnstructuredGridReader> },
  };
  return readers;
}

SurfaceMesh ReadFormat(const std::string& fileName, MeshCells cells, ViewerMessages& messages)
{
  const std::string extension = GetExtension(fileName);
  const auto reader = GetReaders().find(extension);
  if (reader != GetReaders().end())
  {
    const Data data = reader->second(fileName, messages);
    if (!data)
    {
      throw ViewerError("cannot read " + fileName + ": it has no data set with points and cells");
    }
    // For an Exodus file, the reader returns the surface.
    const bool isOfCells = extension == ".ex2" || !vtkPolyData::SafeDownCast(data);
    return { TakeSurface(data, cells, messages), isOfCells };
  }
  throw ViewerError("VTK " + std::string(vtkVersion::GetVTKVersion()) + " cannot read " +
    extension + " files; relevo-view reads meshes from " + GetMeshFormats());
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
  const std::string extension = GetExtension(fileName);
  // Includes meshes that this version of VTK cannot read.
  return GetReaders().count(extension) > 0 || extension == ".ex2" || extension == ".off";
}

//------------------------------------------------------------------------------
std::string GetMeshFormats()
{
  std::vector<std::string> extensions;
  for (const auto& reader : GetReaders())
  {
    extensions.push_back(reader.first);
  }
  return JoinWords(extensions) + " files";
}

//------------------------------------------------------------------------------
std::string AdviseFormat(const std::string& fileName, const std::string& formats)
{
  static const std::set<std::string> ofRasters = { ".asc", ".bil", ".dem", ".dt0", ".dt1", ".dt2",
    ".exr", ".flt", ".hgt", ".img", ".jp2", ".jpeg", ".jpg", ".png", ".tif", ".tiff", ".vrt" };
  static const std::set<std::string> ofExodus = { ".e", ".exo", ".exoii" };
  const std::string extension = GetExtension(fileName);
  if (ofExodus.count(extension) > 0)
  {
    return "; if it is an Exodus file, rename it to .ex2";
  }
  return ofRasters.count(extension) > 0 ? "" : "; relevo-view reads meshes from " + formats;
}

//------------------------------------------------------------------------------
SurfaceMesh ReadMesh(const std::string& fileName, MeshCells cells, ViewerMessages& messages)
{
  CheckFile(fileName);
  const ReadingGuard guard({ fileName });
  SurfaceMesh surface;
  Mesh& mesh = surface.Data;
  try
  {
    CheckFileEnd(fileName, [&messages](const std::string& text) { messages.Warn(text); });
    messages.StartReading();
    surface = ReadFormat(fileName, cells, messages);
    messages.CheckReading();
    if (mesh)
    {
      CheckCorners(mesh);
    }
  }
  catch (const std::exception&)
  {
    ThrowReadingError(fileName);
  }
  if (!mesh || mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    throw ViewerError(fileName + " has no polygons to draw");
  }
  mesh = DropUnusedPoints(mesh);
  CheckPoints(mesh, fileName);
  return surface;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ViewerExport.h"

#include "Files/GLBWriter.h"
#include "Files/ViewerFile.h"
#include "Files/WriteFile.h"
#include "Text/ViewerMessages.h"

#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPNGWriter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

namespace
{
// The files beside an .obj file.
struct CompanionNames
{
  struct Name
  {
    std::string Path;
    std::string Base; // without the folder
  };
  Name Material;
  Name Picture;

  explicit CompanionNames(const std::string& fileName)
  {
    const std::filesystem::path path(fileName);
    const std::string stem = path.stem().string();
    const auto make = [&](const std::string& base) {
      return Name{ (path.parent_path() / base).string(), base };
    };
    this->Material = make(stem + ".mtl");
    this->Picture = make(stem + "-imagery.png");
  }
};

// VTK's writers do not detect every full disk, so the written files are checked.

// The file has the length that its header gives.
bool IsWhole(vtkPLYWriter*, vtkPolyData* mesh, const std::string& fileName)
{
  const std::map<std::string, int> sizes = { { "float", 4 }, { "int", 4 }, { "uchar", 1 } };
  std::ifstream file(fileName, std::ios::binary);
  std::streamoff count = 0; // number of elements whose properties follow
  std::streamoff size = 0;
  std::string line;
  while (std::getline(file, line) && line != "end_header")
  {
    std::istringstream words(line);
    std::string word;
    std::string type;
    words >> word >> type;
    if (word == "element")
    {
      words >> count;
    }
    else if (type == "list")
    {
      size += count + 4 * mesh->GetPolys()->GetNumberOfConnectivityIds();
    }
    else if (word == "property" && sizes.count(type))
    {
      size += count * sizes.at(type);
    }
  }
  const std::streamoff header = file.tellg();
  file.seekg(0, std::ios::end);
  return file && file.tellg() - header >= size;
}

// One line per point, polygon and line. The last line must be complete.
bool IsWhole(vtkOBJWriter*, vtkPolyData* mesh, const std::string& fileName)
{
  std::map<std::string, vtkIdType> counts;
  std::ifstream file(fileName);
  bool endsWhole = false;
  for (std::string line; std::getline(file, line);)
  {
    ++counts[line.substr(0, line.find(' '))];
    endsWhole = !file.eof();
  }
  return endsWhole && counts["v"] == mesh->GetNumberOfPoints() &&
    counts["f"] >= mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() &&
    counts["l"] == mesh->GetNumberOfLines();
}

// A header with the number of triangles, and 50 bytes per triangle.
bool IsWhole(vtkSTLWriter*, vtkPolyData*, const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  unsigned char count[4] = {};
  file.seekg(80);
  file.read(reinterpret_cast<char*>(count), 4);
  std::uintmax_t triangles = 0;
  for (int i = 0; i < 4; ++i)
  {
    triangles |= static_cast<std::uintmax_t>(count[i]) << (8 * i);
  }
  file.seekg(0, std::ios::end);
  return file && static_cast<std::uintmax_t>(file.tellg()) == 84 + 50 * triangles;
}

bool IsWhole(vtkXMLPolyDataWriter*, vtkPolyData*, const std::string& fileName)
{
  return relevo::IsWholeXML(fileName);
}

// Formats with floats lose less of coordinates that are relative to the origin.
vtkSmartPointer<vtkPolyData> MoveToOrigin(const ExportedMesh& mesh)
{
  const std::array<double, 3>& origin = mesh.Origin;
  if (origin == std::array<double, 3>{ { 0.0, 0.0, 0.0 } })
  {
    return mesh.Mesh;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.Mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh.Mesh->GetPoint(i, point);
    points->SetPoint(i, point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]);
  }
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh.Mesh);
  moved->SetPoints(points);
  return moved;
}

// Lets a VTK writer write a file. Returns an error message, or an empty string.
template <typename Writer>
std::string Write(
  Writer* writer, vtkPolyData* mesh, const std::string& fileName, ViewerMessages& messages)
{
  messages.ObserveProgress(writer, "writing");
  writer->SetInputData(mesh);
  return relevo::WriteFile(
    fileName, writer, [&](const std::string& written) { return IsWhole(writer, mesh, written); });
}

std::string ExportPLY(
  const ExportedMesh& mesh, const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkPLYWriter> writer;
  for (const std::string& comment : mesh.Comments)
  {
    writer->AddComment(comment);
  }
  return Write(writer.Get(), MoveToOrigin(mesh), fileName, messages);
}

std::string ExportSTL(
  const ExportedMesh& mesh, const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToBinary();
  return Write(writer.Get(), MoveToOrigin(mesh), fileName, messages);
}

std::string ExportVTP(
  const ExportedMesh& mesh, const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  return Write(writer.Get(), mesh.Mesh, fileName, messages);
}

std::string ExportGLB(
  const ExportedMesh& mesh, const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkObject> progress;
  messages.ObserveProgress(progress, "writing");
  const std::string error = WriteGLB(mesh, fileName,
    [&progress](double share) { progress->InvokeEvent(vtkCommand::ProgressEvent, &share); });
  progress->InvokeEvent(vtkCommand::EndEvent);
  return error;
}

// Appends a file to another. Returns false after an error.
bool AppendFile(relevo::AtomicFile& file, const std::string& fileName)
{
  std::ifstream from(fileName, std::ios::binary);
  std::string bytes(1 << 20, '\0');
  while (from.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || from.gcount() > 0)
  {
    if (!file.Append({ bytes.data(), static_cast<std::size_t>(from.gcount()) }))
    {
      return false;
    }
  }
  return from.eof();
}

// VTK's writer names the material by the temporary file, so this function writes the lines.
std::string ExportOBJ(
  const ExportedMesh& mesh, const std::string& fileName, ViewerMessages& messages)
{
  const vtkSmartPointer<vtkPolyData> moved = MoveToOrigin(mesh);
  vtkNew<vtkOBJWriter> writer;
  messages.ObserveProgress(writer, "writing");
  writer->SetInputData(moved);
  relevo::AtomicFile body(fileName); // is not committed
  relevo::AtomicFile file(fileName);
  const CompanionNames names(fileName);
  std::string head;
  for (const std::string& comment : mesh.Comments)
  {
    head += "# " + comment + "\n";
  }
  head += mesh.Picture ? "mtllib " + names.Material.Base + "\nusemtl terrain\n" : "";
  if (!relevo::WriteFile(body, writer.Get(),
        [&](const std::string& written) { return IsWhole(writer.Get(), moved, written); }))
  {
    return body.GetError();
  }
  if (!file.Append(head) || !AppendFile(file, body.GetTemporaryName()) || !file.Finish())
  {
    file.Fail();
    return file.GetError();
  }
  if (!mesh.Picture)
  {
    file.Commit();
    return file.GetError();
  }
  relevo::AtomicFile material(names.Material.Path);
  relevo::AtomicFile picture(names.Picture.Path);
  vtkNew<vtkPNGWriter> png;
  png->SetInputData(mesh.Picture);
  relevo::WritePNG(picture, png.Get());
  material.Append(
    "newmtl terrain\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " + names.Picture.Base + "\n");
  for (relevo::AtomicFile* each : { &picture, &material, &file })
  {
    if (!each->Finish())
    {
      return each->GetFileName() + ": " + each->GetError();
    }
  }
  for (relevo::AtomicFile* each : { &picture, &material, &file })
  {
    if (!each->Commit())
    {
      return each->GetFileName() + ": " + each->GetError();
    }
  }
  return "";
}

using WriterFunction =
  std::function<std::string(const ExportedMesh&, const std::string&, ViewerMessages&)>;
const std::map<std::string, WriterFunction>& GetWriters()
{
  static const std::map<std::string, WriterFunction> writers = {
    { ".glb", ExportGLB },
    { ".obj", ExportOBJ },
    { ".ply", ExportPLY },
    { ".stl", ExportSTL },
    { ".vtp", ExportVTP },
  };
  return writers;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetExportExtensions()
{
  std::vector<std::string> extensions;
  for (const auto& writer : GetWriters())
  {
    extensions.push_back(writer.first);
  }
  return extensions;
}

//------------------------------------------------------------------------------
bool HasFloats(const std::string& fileName)
{
  return GetExtension(fileName) != ".vtp";
}

//------------------------------------------------------------------------------
bool CanHavePicture(const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
  return extension == ".glb" || extension == ".obj";
}

//------------------------------------------------------------------------------
std::vector<std::string> GetCompanions(const std::string& fileName)
{
  const CompanionNames names(fileName);
  return GetExtension(fileName) == ".obj"
    ? std::vector<std::string>{ names.Material.Path, names.Picture.Path }
    : std::vector<std::string>{};
}

//------------------------------------------------------------------------------
void WriteMesh(const ExportedMesh& mesh, const std::string& fileName, ViewerMessages& messages)
{
  const std::string error = GetWriters().at(GetExtension(fileName))(mesh, fileName, messages);
  if (!error.empty())
  {
    throw ViewerError("cannot write " + fileName + ": " + error);
  }
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ResultFormats.h"

#include "Files/AlgorithmReader.h"
#include "Files/CollectionReader.h"
#include "Files/GLTFReader.h"
#ifdef VIEWER_HAS_PARALLEL
#include "Files/Plot3DFile.h"
#endif
#include "Files/SeriesReader.h"
#include "Files/ViewerFile.h"
#include "Text/StandardError.h"
#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include "vtkBYUReader.h"
#include "vtkBezierPatchReader.h"
#ifdef VIEWER_HAS_CGNSREADER
#include "vtkCGNSReader.h"
#endif
#ifdef VIEWER_HAS_EXODUS
#include "vtkExodusIIReader.h"
#endif
#ifdef VIEWER_HAS_ENSIGHT
#include "vtkGenericEnSightReader.h"
#endif
#include "vtkGenericDataObjectReader.h"
#ifdef VIEWER_HAS_HDF
#include "vtkHDFReader.h"
#endif
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkMicroMeshReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#if __has_include("vtkOFFReader.h")
#include "vtkOFFReader.h"
#endif
#include "vtkOpenFOAMReader.h"
#include "vtkPLYReader.h"
#ifdef VIEWER_HAS_PARALLEL
#include "vtkPlot3DMetaReader.h"
#endif
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkVersion.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtkXMLHyperTreeGridReader.h"
#include "vtkXMLUniformGridAMRReader.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <set>

namespace
{
using Reader = std::unique_ptr<ResultReader>;

template <typename Algorithm>
Reader Open(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<Algorithm> reader;
  reader->SetFileName(fileName.c_str());
  return std::make_unique<AlgorithmReader>(reader, messages);
}

class GLTFFile : public ResultReader
{
public:
  GLTFFile(const std::string& fileName, ViewerMessages& messages)
    : FileName(fileName)
    , Messages(messages)
  {
  }
  vtkSmartPointer<vtkDataObject> Read(const std::optional<double>&) override
  {
    return ReadGLTF(this->FileName, this->Messages);
  }

private:
  std::string FileName;
  ViewerMessages& Messages;
};

template <typename Type>
Reader Make(const std::string& fileName, ViewerMessages& messages)
{
  return std::make_unique<Type>(fileName, messages);
}

#ifdef VIEWER_HAS_CGNSREADER
Reader OpenCGNS(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkCGNSReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->UpdateInformation(); // finds the names of bases and arrays
  reader->EnableAllBases();
  reader->EnableAllFamilies();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  return std::make_unique<AlgorithmReader>(reader, messages);
}
#endif

#ifdef VIEWER_HAS_ENSIGHT
Reader OpenEnSight(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkGenericEnSightReader> reader;
  reader->SetCaseFileName(fileName.c_str());
  return std::make_unique<AlgorithmReader>(reader, messages);
}
#endif

#ifdef VIEWER_HAS_EXODUS
Reader OpenExodus(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkExodusIIReader> reader;
  auto opened = std::make_unique<AlgorithmReader>(reader, messages);
  reader->SetFileName(fileName.c_str());
  reader->ApplyDisplacementsOff(); // --warp displaces points
  reader->UpdateInformation();     // finds the names of arrays
  messages.Check();
  for (int type : { vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK })
  {
    reader->SetAllArrayStatus(type, 1);
  }
  return opened;
}
#endif

// All levels; the reader's default is the coarsest one.
Reader OpenAMR(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkXMLUniformGridAMRReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->SetMaximumLevelsToReadByDefault(0);
  return std::make_unique<AlgorithmReader>(reader, messages);
}

// The leaves of the trees as hexahedra or quadrilaterals.
Reader OpenHyperTreeGrid(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkXMLHyperTreeGridReader> reader;
  messages.Observe(reader);
  reader->SetFileName(fileName.c_str());
  vtkNew<vtkHyperTreeGridToUnstructuredGrid> leaves;
  leaves->SetInputConnection(reader->GetOutputPort());
  return std::make_unique<AlgorithmReader>(leaves, messages);
}

Reader OpenOpenFOAM(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkOpenFOAMReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->CreateCellToPointOn();
  return std::make_unique<AlgorithmReader>(reader, messages);
}

// Exodus files are netCDF files, classic or of HDF5.
bool IsNetCDF(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  char bytes[4] = {};
  file.read(bytes, sizeof(bytes));
  const std::string start(bytes, bytes + file.gcount());
  return start.compare(0, 3, "CDF") == 0 || start == "\x89HDF";
}

// .g files are of Exodus, PLOT3D or Movie.BYU.
Reader OpenGeometry(const std::string& fileName, ViewerMessages& messages)
{
#ifdef VIEWER_HAS_EXODUS
  if (IsNetCDF(fileName))
  {
    return OpenExodus(fileName, messages);
  }
#endif
#ifdef VIEWER_HAS_PARALLEL
  if (IsPlot3D(fileName))
  {
    return OpenPlot3D(fileName, messages);
  }
#endif
  vtkNew<vtkBYUReader> reader;
  reader->SetGeometryFileName(fileName.c_str());
  return std::make_unique<AlgorithmReader>(reader, messages);
}

Reader OpenSeries(const std::string& fileName, ViewerMessages& messages)
{
  return std::make_unique<SeriesReader>(fileName, messages, MakeResultReader);
}

struct Format
{
  std::function<Reader(const std::string&, ViewerMessages&)> Open; // empty without a reader
  bool CanHaveVolumes;
};

const std::map<std::string, Format>& GetFormats()
{
  static const std::map<std::string, Format> formats = []
  {
    std::map<std::string, Format> all = {
      { ".bpt", { Open<vtkBezierPatchReader>, false } },
      { ".foam", { OpenOpenFOAM, true } },
      { ".g", { OpenGeometry, true } },
      { ".glb", { Make<GLTFFile>, false } },
      { ".gltf", { Make<GLTFFile>, false } },
      { ".htg", { OpenHyperTreeGrid, true } },
      { ".obj", { Open<vtkOBJReader>, false } },
      { ".ply", { Open<vtkPLYReader>, false } },
      { ".pvd", { Make<CollectionReader>, true } },
      { ".rmm", { Open<vtkMicroMeshReader>, false } },
      { ".series", { OpenSeries, true } },
      { ".stl", { Open<vtkSTLReader>, false } },
      { ".vth", { OpenAMR, true } },
      { ".vthb", { OpenAMR, true } },
      { ".vtk", { Open<vtkGenericDataObjectReader>, true } },
      // Formats that other programs convert.
      { ".med", { nullptr, true } },
      { ".mesh", { nullptr, true } },
      { ".meshb", { nullptr, true } },
      { ".msh", { nullptr, true } },
#ifdef VIEWER_HAS_PARALLEL
      { ".p3d", { Open<vtkPlot3DMetaReader>, true } },
      { "PLOT3D", { OpenPlot3D, true } },
#else
      { ".p3d", { nullptr, true } },
#endif
#if __has_include("vtkOFFReader.h") // since VTK 9.4
      { ".off", { Open<vtkOFFReader>, false } },
#else
      { ".off", { nullptr, false } },
#endif
#ifdef VIEWER_HAS_CGNSREADER
      { ".cgns", { OpenCGNS, true } },
#else
      { ".cgns", { nullptr, true } },
#endif
#ifdef VIEWER_HAS_ENSIGHT
      { ".case", { OpenEnSight, true } },
#else
      { ".case", { nullptr, true } },
#endif
#ifdef VIEWER_HAS_HDF
      { ".vtkhdf", { Open<vtkHDFReader>, true } },
#else
      { ".vtkhdf", { nullptr, true } },
#endif
    };
    for (const char* extension : { ".e", ".ex2", ".exo", ".exoii" })
    {
#ifdef VIEWER_HAS_EXODUS
      all[extension] = { OpenExodus, true };
#else
      all[extension] = { nullptr, true };
#endif
    }
    for (const char* extension : { ".pvtp", ".vtp" })
    {
      all[extension] = { Open<vtkXMLGenericDataObjectReader>, false };
    }
    for (const char* extension :
      { ".pvti", ".pvtr", ".pvts", ".pvtu", ".vti", ".vtm", ".vtr", ".vts", ".vtu" })
    {
      all[extension] = { Open<vtkXMLGenericDataObjectReader>, true };
    }
    return all;
  }();
  return formats;
}

// The format of a file by its extension, or by its content where the extension is ambiguous.
std::map<std::string, Format>::const_iterator FindFormat(const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
#ifdef VIEWER_HAS_PARALLEL
  static const std::set<std::string> ambiguous = { ".bin", ".grd", ".x", ".xyz" };
  if (ambiguous.count(extension) > 0 && IsPlot3D(fileName))
  {
    return GetFormats().find("PLOT3D");
  }
#endif
  return GetFormats().find(extension);
}

std::string ListFormats(bool areVolumes)
{
  std::vector<std::string> extensions;
  for (const auto& format : GetFormats())
  {
    if (format.second.Open && (format.second.CanHaveVolumes || !areVolumes))
    {
      extensions.push_back(format.first);
    }
  }
  return JoinWords(extensions) + " files";
}
}

//------------------------------------------------------------------------------
bool IsMeshFile(const std::string& fileName)
{
  return FindFormat(fileName) != GetFormats().end();
}

//------------------------------------------------------------------------------
bool IsVolumeFile(const std::string& fileName)
{
  const auto format = FindFormat(fileName);
  return format != GetFormats().end() && format->second.CanHaveVolumes;
}

//------------------------------------------------------------------------------
std::string GetMeshFormats()
{
  return ListFormats(false);
}

//------------------------------------------------------------------------------
std::string GetVolumeFormats()
{
  return ListFormats(true);
}

//------------------------------------------------------------------------------
bool IsMarkerFile(const std::string& fileName)
{
  return GetExtension(fileName) == ".foam";
}

//------------------------------------------------------------------------------
std::string AdviseFormat(const std::string& fileName, const std::string& formats)
{
  static const std::set<std::string> ofRasters = { ".asc", ".bil", ".dem", ".dt0", ".dt1", ".dt2",
    ".exr", ".flt", ".hgt", ".img", ".jp2", ".jpeg", ".jpg", ".png", ".tif", ".tiff", ".vrt" };
  const bool isRaster = ofRasters.count(GetExtension(fileName)) > 0;
  return isRaster ? "" : "; " + GetProgramName() + " reads meshes from " + formats;
}

//------------------------------------------------------------------------------
std::unique_ptr<ResultReader> MakeResultReader(
  const std::string& fileName, ViewerMessages& messages)
{
  const std::string extension = GetExtension(fileName);
  const auto format = FindFormat(fileName);
  static const std::map<std::string, std::string> converted = { { ".med", "MED" },
    { ".mesh", "MEDIT" }, { ".meshb", "MEDIT" }, { ".msh", "Gmsh" } };
  if (converted.count(extension) > 0)
  {
    const std::string name = vtksys::SystemTools::GetFilenameName(fileName);
    throw ViewerError("VTK has no reader for files of " + converted.at(extension) +
      "; convert it, for example with meshio: meshio convert " + name + " " +
      vtksys::SystemTools::GetFilenameWithoutLastExtension(name) + ".vtu");
  }
  if (format == GetFormats().end() || !format->second.Open)
  {
    throw ViewerError("VTK " + std::string(vtkVersion::GetVTKVersion()) + " cannot read " +
      extension + " files; " + GetProgramName() + " reads meshes from " + GetMeshFormats());
  }
  return format->second.Open(fileName, messages);
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/VolumeReader.h"

#ifdef VIEWER_HAS_EXODUS
#include "Files/ExodusReader.h"
#endif
#include "FileEnd.h"
#include "Files/MeshPoints.h"
#include "Files/ViewerFile.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkXMLPUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <functional>
#include <map>
#include <vector>

namespace
{
using Volume = vtkSmartPointer<vtkDataObject>;

template <typename Reader>
Volume Read(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<Reader> reader;
  messages.Observe(reader, "reading");
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutputDataObject(0);
}

using Function = std::function<Volume(const std::string&, ViewerMessages&)>;
const std::map<std::string, Function>& GetVolumeReaders()
{
  static const std::map<std::string, Function> readers = {
#ifdef VIEWER_HAS_EXODUS
    { ".ex2", ReadExodusBlocks },
#endif
    { ".pvtu", Read<vtkXMLPUnstructuredGridReader> },
    { ".vtk", Read<vtkGenericDataObjectReader> },
    { ".vtu", Read<vtkXMLUnstructuredGridReader> },
  };
  return readers;
}

vtkIdType GetNumberOfCells(vtkDataObject* data)
{
  return vtkDataSet::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data)
    ? data->GetNumberOfElements(vtkDataObject::CELL)
    : 0;
}
}

//------------------------------------------------------------------------------
std::string GetVolumeFormats()
{
  std::vector<std::string> extensions;
  for (const auto& reader : GetVolumeReaders())
  {
    extensions.push_back(reader.first);
  }
  return JoinWords(extensions) + " files";
}

//------------------------------------------------------------------------------
Volume ReadVolume(const std::string& fileName, ViewerMessages& messages)
{
  CheckFile(fileName);
  const auto reader = GetVolumeReaders().find(GetExtension(fileName));
  if (reader == GetVolumeReaders().end())
  {
    throw ViewerError("cannot read " + fileName + ": --volume reads " + GetVolumeFormats());
  }
  const ReadingGuard guard({ fileName });
  Volume data;
  try
  {
    CheckFileEnd(fileName, [&messages](const std::string& text) { messages.Warn(text); });
    messages.StartReading();
    data = reader->second(fileName, messages);
    messages.CheckReading();
    for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
    {
      if (auto* points = vtkPointSet::SafeDownCast(block))
      {
        CheckCorners(points);
      }
    }
  }
  catch (const std::exception&)
  {
    ThrowReadingError(fileName);
  }
  if (GetNumberOfCells(data) == 0)
  {
    throw ViewerError(fileName + " has no cells to draw");
  }
  return data;
}

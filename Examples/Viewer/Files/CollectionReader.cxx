// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/CollectionReader.h"

#include "FileEnd.h"
#include "Files/AlgorithmReader.h"
#include "Files/ViewerFile.h"
#include "Text/ViewerMessages.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtkXMLUtilities.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <cstring>

//------------------------------------------------------------------------------
CollectionReader::CollectionReader(const std::string& fileName, ViewerMessages& messages)
  : Messages(messages)
{
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
    vtkXMLUtilities::ReadElementFromFile(fileName.c_str()));
  vtkXMLDataElement* list = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!list)
  {
    throw ViewerError("it is not XML with a Collection of files");
  }
  const std::string folder = vtksys::SystemTools::GetFilenamePath(fileName);
  for (int i = 0; i < list->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* entry = list->GetNestedElement(i);
    if (!entry->GetName() || std::strcmp(entry->GetName(), "DataSet") != 0)
    {
      continue;
    }
    const char* name = entry->GetAttribute("file");
    if (!name || !*name)
    {
      throw ViewerError("entry " + std::to_string(i + 1) + " of its Collection names no file");
    }
    double time = 0.0;
    if (entry->GetAttribute("timestep") &&
      (!entry->GetScalarAttribute("timestep", time) || !std::isfinite(time)))
    {
      throw ViewerError("the time of " + std::string(name) + " is not a number");
    }
    const bool isWhole = vtksys::SystemTools::FileIsFullPath(name) || folder.empty();
    this->Files[time].push_back(isWhole ? name : folder + "/" + name);
  }
  if (this->Files.empty())
  {
    throw ViewerError("it lists no files");
  }
}

//------------------------------------------------------------------------------
std::vector<double> CollectionReader::GetTimes()
{
  std::vector<double> times;
  for (const auto& step : this->Files)
  {
    times.push_back(step.first);
  }
  return times;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> CollectionReader::Read(const std::optional<double>& time)
{
  std::vector<vtkSmartPointer<vtkDataObject>> parts;
  for (const std::string& name : this->Files.at(time.value_or(this->Files.begin()->first)))
  {
    CheckFile(name);
    try
    {
      CheckFileEnd(name, [this](const std::string& text) { this->Messages.Warn(text); });
      vtkNew<vtkXMLGenericDataObjectReader> reader;
      reader->SetFileName(name.c_str());
      parts.push_back(AlgorithmReader(reader, this->Messages).Read({}));
    }
    catch (const std::exception&)
    {
      ThrowReadingError(name);
    }
  }
  if (parts.size() == 1)
  {
    return parts.front();
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    blocks->SetBlock(static_cast<unsigned int>(i), parts[i]);
  }
  return blocks;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/DataChain.h"

#include "Files/ViewerFile.h"

#include "vtkAlgorithm.h"
#include "vtkBezierPatchReader.h"
#include "vtkDataObject.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkJPEGReader.h"
#include "vtkMicroMeshReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPNGReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <map>

namespace
{
using Reader = vtkSmartPointer<vtkAlgorithm>;

template <typename Type>
Reader MakeReader(const std::string& fileName)
{
  vtkNew<Type> reader;
  reader->SetFileName(fileName.c_str());
  return reader.Get();
}

using ReaderMaker = Reader (*)(const std::string&);

// Formats of one data set without time steps.
const std::map<std::string, ReaderMaker>& GetReaders()
{
  static const std::map<std::string, ReaderMaker> readers = {
    { ".bpt", MakeReader<vtkBezierPatchReader> },
    { ".jpeg", MakeReader<vtkJPEGReader> },
    { ".jpg", MakeReader<vtkJPEGReader> },
    { ".obj", MakeReader<vtkOBJReader> },
    { ".ply", MakeReader<vtkPLYReader> },
    { ".png", MakeReader<vtkPNGReader> },
    { ".rmm", MakeReader<vtkMicroMeshReader> },
    { ".stl", MakeReader<vtkSTLReader> },
    { ".vti", MakeReader<vtkXMLImageDataReader> },
    { ".vtk", MakeReader<vtkGenericDataObjectReader> },
    { ".vtp", MakeReader<vtkXMLPolyDataReader> },
    { ".vtr", MakeReader<vtkXMLRectilinearGridReader> },
    { ".vts", MakeReader<vtkXMLStructuredGridReader> },
    { ".vtu", MakeReader<vtkXMLUnstructuredGridReader> },
  };
  return readers;
}
}

//------------------------------------------------------------------------------
bool DataChain::Read(const std::string& fileName, const SceneCode& code)
{
  const auto reader = GetReaders().find(GetExtension(fileName));
  if (reader == GetReaders().end())
  {
    return false;
  }
  this->Add(reader->second(fileName), "reader", { { "SetFileName", { code.GetFile(fileName) } } });
  return true;
}

//------------------------------------------------------------------------------
void DataChain::Add(vtkAlgorithm* filter, const std::string& name, const Calls& calls)
{
  if (!this->Steps.empty())
  {
    filter->SetInputConnection(this->Steps.back().Filter->GetOutputPort());
  }
  this->Steps.push_back({ filter, name, calls });
}

//------------------------------------------------------------------------------
vtkDataObject* DataChain::GetOutput()
{
  vtkAlgorithm* last = this->Steps.back().Filter;
  last->Update();
  return last->GetOutputDataObject(0);
}

//------------------------------------------------------------------------------
std::vector<CodeValue> DataChain::Write(SceneCode& code) const
{
  std::vector<CodeValue> outputs;
  for (const Step& step : this->Steps)
  {
    const std::string variable = code.New(step.Filter->GetClassName(), step.Name);
    if (!outputs.empty())
    {
      code.Call(variable, "SetInputConnection", { outputs.back() });
    }
    for (const auto& call : step.Settings)
    {
      code.Call(variable, call.first, call.second);
    }
    outputs.push_back(CodeValue::Port(variable));
  }
  return outputs;
}

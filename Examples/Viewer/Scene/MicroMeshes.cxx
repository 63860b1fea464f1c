// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MicroMeshes.h"

#include "Options/ViewerOptions.h"
#include "Text/ViewerMessages.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMicroMeshFilter.h"
#include "vtkMicroMeshWriter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace
{
constexpr double DefaultShare = 0.001; // of the diagonal

double GetTolerance(const ViewerOptions& options, vtkPolyData* mesh)
{
  return options.Tolerance.value_or(
    options.ToleranceShare.value_or(DefaultShare) * mesh->GetLength());
}

std::string DescribeFile(const ViewerOptions& options)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const auto size = static_cast<double>(fs::file_size(options.MicroMesh, error));
  const auto inputSize = static_cast<double>(fs::file_size(options.Input, error));
  std::ostringstream text;
  text << options.MicroMesh << ": " << std::fixed << std::setprecision(1) << size / 1e3 << " kB";
  if (!error && inputSize > 0.0)
  {
    text << ", " << std::setprecision(3) << size / inputSize << " of " << options.Input;
  }
  return text.str();
}
}

//------------------------------------------------------------------------------
bool IsMicroMesh(vtkPolyData* mesh)
{
  return mesh->GetFieldData()->GetArray("MicroMeshDisplacements") != nullptr;
}

//------------------------------------------------------------------------------
std::string DescribeMicroMesh(vtkPolyData* micro, double diagonal)
{
  vtkDataArray* error = micro->GetFieldData()->GetArray("MicroMeshError");
  std::ostringstream text;
  text << "micro-mesh: " << micro->GetNumberOfCells() << " faces";
  if (error && error->GetNumberOfTuples() == 2)
  {
    const double toResult = error->GetComponent(0, 0);
    const double toInput = error->GetComponent(1, 0);
    text << std::setprecision(3) << ", error at most " << toResult << " from the mesh and "
         << toInput << " back, " << 100.0 * std::max(toResult, toInput) / diagonal
         << " % of the diagonal";
  }
  return text.str();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> EncodeMicroMesh(
  const ViewerOptions& options, vtkPolyData* mesh, ViewerMessages& messages, std::string& report)
{
  vtkNew<vtkMicroMeshFilter> filter;
  messages.Observe(filter, "encoding");
  filter->SetInputData(mesh);
  filter->SetTolerance(GetTolerance(options, mesh));
  filter->Update();
  messages.Check();
  vtkSmartPointer<vtkPolyData> micro = filter->GetOutput();
  if (micro->GetNumberOfCells() == 0)
  {
    throw ViewerError(options.Input + " has no triangles to encode");
  }
  vtkNew<vtkMicroMeshWriter> writer;
  messages.Observe(writer);
  writer->SetInputData(micro);
  writer->SetFileName(options.MicroMesh.c_str());
  writer->Write();
  messages.Check();
  std::ostringstream text;
  text << DescribeMicroMesh(micro, mesh->GetLength()) << "; the mesh has "
       << mesh->GetNumberOfCells() << " faces\n"
       << DescribeFile(options);
  report = text.str();
  return micro;
}

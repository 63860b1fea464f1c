// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/StreamlineActor.h"

#include "Options/ViewerOptions.h"
#include "Scene/VolumeArray.h"
#include "Text/ViewerMessages.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamTracer.h"
#include "vtkTubeFilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
// Shares of the diagonal.
const double Radius = 0.002;
const double LongestLine = 3.0; // in each direction

const int Sides = 8;
const int DefaultSeeds = 100;
const int MostSteps = 5000;

// Whether arrays of points must be made from those of cells. Throws ViewerError if the mesh has no
// vectors.
bool NeedsAverage(const ViewerOptions& options, vtkDataSet* mesh)
{
  const char* name = options.Streamlines.c_str();
  vtkDataArray* ofPoints = mesh->GetPointData()->GetArray(name);
  vtkDataArray* array = ofPoints ? ofPoints : mesh->GetCellData()->GetArray(name);
  if (!array)
  {
    throw ViewerError(
      options.Input + " has no array of numbers '" + options.Streamlines + "' for --streamlines");
  }
  if (array->GetNumberOfComponents() != 3)
  {
    throw ViewerError("--streamlines needs an array with 3 components, and '" +
      options.Streamlines + "' has " + std::to_string(array->GetNumberOfComponents()));
  }
  const bool isColouredByPoints = mesh->GetPointData()->HasArray(options.Array.c_str()) != 0;
  return !ofPoints || !(options.Array.empty() || isColouredByPoints);
}

// Returns points on the line of the options, or in the middles of cells that are evenly spaced in
// the order of the mesh: of 3D cells if there are some.
vtkSmartPointer<vtkPolyData> MakeSeeds(const ViewerOptions& options, vtkDataSet* mesh)
{
  vtkNew<vtkPoints> points;
  const int number = options.Seeds.value_or(DefaultSeeds);
  if (options.SeedLine)
  {
    const std::vector<double>& ends = *options.SeedLine;
    for (int i = 0; i < number; ++i)
    {
      const double share = number > 1 ? static_cast<double>(i) / (number - 1) : 0.5;
      points->InsertNextPoint(ends[0] + share * (ends[3] - ends[0]),
        ends[1] + share * (ends[4] - ends[1]), ends[2] + share * (ends[5] - ends[2]));
    }
  }
  else
  {
    std::vector<vtkIdType> solid;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      if (IsVolumeCell(mesh, cell))
      {
        solid.push_back(cell);
      }
    }
    const vtkIdType count =
      solid.empty() ? mesh->GetNumberOfCells() : static_cast<vtkIdType>(solid.size());
    const vtkIdType taken = std::min<vtkIdType>(number, count);
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < taken; ++i)
    {
      const vtkIdType place = (2 * i + 1) * count / (2 * taken);
      mesh->GetCellPoints(solid.empty() ? place : solid[static_cast<std::size_t>(place)], corners);
      double middle[3] = { 0.0, 0.0, 0.0 };
      for (vtkIdType corner = 0; corner < corners->GetNumberOfIds(); ++corner)
      {
        double point[3];
        mesh->GetPoint(corners->GetId(corner), point);
        vtkMath::Add(middle, point, middle);
      }
      vtkMath::MultiplyScalar(middle, 1.0 / std::max<vtkIdType>(corners->GetNumberOfIds(), 1));
      points->InsertNextPoint(middle);
    }
  }
  auto seeds = vtkSmartPointer<vtkPolyData>::New();
  seeds->SetPoints(points);
  return seeds;
}
}

//------------------------------------------------------------------------------
StreamlineActor::StreamlineActor(vtkRenderer* renderer, ViewerMessages& messages)
  : Messages(messages)
{
  messages.Observe(this->Average);
  messages.Observe(this->Tracer, "tracing streamlines");
  this->Tracer->SetIntegratorTypeToRungeKutta45();
  this->Tracer->SetIntegrationDirectionToBoth();
  this->Tracer->SetMaximumNumberOfSteps(MostSteps);
  this->Tracer->SetComputeVorticity(false);
  this->Tubes->SetInputConnection(this->Tracer->GetOutputPort());
  this->Tubes->SetNumberOfSides(Sides);
  this->Tubes->CappingOn();
  this->Mapper->SetInputConnection(this->Tubes->GetOutputPort());
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->SetInterpolationToPhong();
  this->Actor->GetProperty()->SetAmbient(0.3);
  this->Actor->GetProperty()->SetDiffuse(0.7);
  renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
StreamlineActor::~StreamlineActor() = default;

//------------------------------------------------------------------------------
void StreamlineActor::Trace(const ViewerOptions& options, vtkDataSet* mesh)
{
  if (NeedsAverage(options, mesh))
  {
    this->Average->SetInputData(mesh);
    this->Tracer->SetInputConnection(this->Average->GetOutputPort());
  }
  else
  {
    this->Tracer->SetInputData(mesh);
  }
  this->Tracer->SetSourceData(MakeSeeds(options, mesh));
  this->Tracer->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, options.Streamlines.c_str());
  this->Tracer->SetMaximumPropagation(LongestLine * mesh->GetLength());
  this->Tracer->SetSurfaceStreamlines(vtkPolyData::SafeDownCast(mesh) != nullptr);
  this->Tubes->SetRadius(Radius * mesh->GetLength());
  this->Tracer->Update();
  this->Messages.Check();
  if (this->Tracer->GetOutput()->GetNumberOfLines() == 0)
  {
    this->Messages.Warn("--streamlines shows none: no seed is where '" + options.Streamlines +
      "' has a direction; --seed-line and --seeds set other seeds");
  }
}

//------------------------------------------------------------------------------
void StreamlineActor::SetColours(const std::string& array, vtkScalarsToColors* table)
{
  this->Mapper->SetScalarModeToUsePointFieldData();
  this->Mapper->SelectColorArray(array.c_str());
  this->Mapper->SetLookupTable(table);
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Mapper->InterpolateScalarsBeforeMappingOn();
}

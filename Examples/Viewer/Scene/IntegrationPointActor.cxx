// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/IntegrationPointActor.h"

#include "vtkActor.h"
#include "vtkBitArray.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace
{
const char* const ShownName = "IsShown"; // array of points
const double Radius = 0.14;              // share of the diagonal of a cell with one point
const int Sides = 12;                    // of spheres

double GetMeanLength(vtkDataSet* mesh)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    mesh->GetCellBounds(cell, bounds);
    sum += std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  }
  return mesh->GetNumberOfCells() > 0 ? sum / static_cast<double>(mesh->GetNumberOfCells()) : 0.0;
}
}

//------------------------------------------------------------------------------
IntegrationPointActor::IntegrationPointActor(vtkRenderer* renderer)
{
  this->Sphere->SetThetaResolution(Sides);
  this->Sphere->SetPhiResolution(Sides);
  this->Mapper->SetInputData(this->Points);
  this->Mapper->SetSourceConnection(this->Sphere->GetOutputPort());
  this->Mapper->ScalingOff();
  this->Mapper->OrientOff();
  this->Mapper->SetMaskArray(ShownName);
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->SetAmbient(0.3);
  this->Actor->GetProperty()->SetDiffuse(0.7);
  renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
IntegrationPointActor::~IntegrationPointActor() = default;

//------------------------------------------------------------------------------
void IntegrationPointActor::SetPoints(vtkPolyData* points, vtkDataSet* mesh)
{
  this->Points->ShallowCopy(points);
  const double ofCell = static_cast<double>(points->GetNumberOfPoints()) /
    static_cast<double>(mesh->GetNumberOfCells());
  this->Sphere->SetRadius(Radius * GetMeanLength(mesh) / std::cbrt(std::fmax(ofCell, 1.0)));
}

//------------------------------------------------------------------------------
void IntegrationPointActor::Cut(vtkPlane* plane)
{
  vtkNew<vtkBitArray> shown;
  shown->SetName(ShownName);
  for (vtkIdType i = 0; plane && i < this->Points->GetNumberOfPoints(); ++i)
  {
    const bool isInFront = plane->EvaluateFunction(this->Points->GetPoint(i)) >= 0.0;
    shown->InsertNextValue(isInFront ? 1 : 0);
  }
  this->Mapper->SetMasking(plane != nullptr);
  if (plane)
  {
    this->Points->GetPointData()->AddArray(shown);
    this->Points->Modified();
  }
}

//------------------------------------------------------------------------------
void IntegrationPointActor::SetColours(const std::string& array, vtkScalarsToColors* table)
{
  this->Mapper->SetScalarModeToUsePointFieldData();
  this->Mapper->SelectColorArray(array.c_str());
  this->Mapper->SetLookupTable(table);
  this->Mapper->UseLookupTableScalarRangeOn();
}

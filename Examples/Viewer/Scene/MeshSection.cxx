// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MeshSection.h"

#include "Scene/SectionIsolines.h"
#include "Text/ViewerMessages.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCurvedCellCutter.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStaticCellLocator.h"

#include <cmath>

namespace
{
const double LineOffset = 5e-4; // towards the viewer, as a share of the diagonal
const double Ambient = 0.7;     // so that values can be read whichever way the cut faces
const double LineOpacity = 0.35;
}

//------------------------------------------------------------------------------
MeshSection::MeshSection(vtkPlane* plane, vtkRenderer* renderer, ViewerMessages& messages)
  : Plane(plane)
  , Renderer(renderer)
{
  messages.Observe(this->Cutter, "cutting");
  this->Cutter->SetCutFunction(plane);
  this->Faces->SetInputConnection(this->Cutter->GetOutputPort(0));
  this->Lines->SetInputConnection(this->Cutter->GetOutputPort(1));
  this->Lines->ScalarVisibilityOff();
  this->FaceActor->SetMapper(this->Faces);
  this->LineActor->SetMapper(this->Lines);
  this->LineActor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  this->LineActor->GetProperty()->SetOpacity(LineOpacity);
  this->LineActor->GetProperty()->LightingOff();
  renderer->AddActor(this->FaceActor);
  renderer->AddActor(this->LineActor);
}

//------------------------------------------------------------------------------
MeshSection::~MeshSection() = default;

//------------------------------------------------------------------------------
void MeshSection::SetMesh(vtkDataSet* mesh)
{
  this->Cutter->SetInputData(mesh);
  double offset[3];
  this->Plane->GetNormal(offset);
  vtkMath::MultiplyScalar(offset, -LineOffset * mesh->GetLength() / vtkMath::Norm(offset));
  this->LineActor->SetPosition(offset);
  if (this->Isolines)
  {
    this->Isolines->SetOffset(offset);
  }
}

//------------------------------------------------------------------------------
void MeshSection::SetIsolines(
  const std::string& array, bool isVector, double spacing, const double range[2])
{
  if (!this->Isolines)
  {
    this->Isolines =
      std::make_unique<SectionIsolines>(this->Cutter->GetOutputPort(0), this->Renderer);
    this->Isolines->SetOffset(this->LineActor->GetPosition());
  }
  this->Isolines->Set(array, isVector, spacing, range);
}

//------------------------------------------------------------------------------
void MeshSection::SetColours(vtkMapper* mapper, vtkProperty* property)
{
  this->Faces->SetScalarMode(mapper->GetScalarMode());
  this->Faces->SetScalarVisibility(mapper->GetScalarVisibility());
  this->Faces->SetInterpolateScalarsBeforeMapping(mapper->GetInterpolateScalarsBeforeMapping());
  this->Faces->SetLookupTable(mapper->GetLookupTable());
  this->Faces->SetUseLookupTableScalarRange(mapper->GetUseLookupTableScalarRange());
  if (mapper->GetArrayName())
  {
    this->Faces->SelectColorArray(mapper->GetArrayName());
  }
  this->FaceActor->GetProperty()->DeepCopy(property);
  this->FaceActor->GetProperty()->SetInterpolationToFlat();
  this->FaceActor->GetProperty()->SetAmbient(Ambient);
  this->FaceActor->GetProperty()->SetDiffuse(1.0 - Ambient);
  this->FaceActor->GetProperty()->SetSpecular(0.0);
  this->FaceActor->GetProperty()->SetRepresentationToSurface();
}

//------------------------------------------------------------------------------
vtkIdType MeshSection::Find(const double place[3], double distance, const std::string& array,
  bool isOfPoints, std::vector<double>& value)
{
  value.clear();
  double point[3] = { place[0], place[1], place[2] };
  if (std::abs(this->Plane->DistanceToPlane(point)) > distance)
  {
    return -1;
  }
  this->Cutter->Update();
  this->Locator->SetDataSet(this->Cutter->GetOutput());
  this->Locator->Update();
  double nearest[3];
  vtkNew<vtkGenericCell> cell;
  vtkIdType polygon = -1;
  int part = 0;
  double distance2 = 0.0;
  if (this->Cutter->GetOutput()->GetNumberOfCells() == 0 ||
    !this->Locator->FindClosestPointWithinRadius(
      point, distance, nearest, cell, polygon, part, distance2))
  {
    return -1;
  }
  vtkDataArray* cells = this->Cutter->GetOutput()->GetCellData()->GetArray("vtkOriginalCellIds");
  const auto id = static_cast<vtkIdType>(cells->GetComponent(polygon, 0));
  auto* mesh = vtkDataSet::SafeDownCast(this->Cutter->GetInput());
  vtkDataArray* values = isOfPoints ? mesh->GetPointData()->GetArray(array.c_str())
                                    : mesh->GetCellData()->GetArray(array.c_str());
  if (values)
  {
    vtkNew<vtkDoubleArray> result;
    result->SetNumberOfComponents(values->GetNumberOfComponents());
    result->SetNumberOfTuples(1);
    mesh->GetCell(id, cell);
    std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
    double closest[3];
    double parameters[3];
    cell->EvaluatePosition(nearest, closest, part, parameters, distance2, weights.data());
    isOfPoints ? result->InterpolateTuple(0, cell->GetPointIds(), values, weights.data())
               : result->SetTuple(0, id, values);
    value.resize(static_cast<std::size_t>(values->GetNumberOfComponents()));
    result->GetTuple(0, value.data());
  }
  return id;
}

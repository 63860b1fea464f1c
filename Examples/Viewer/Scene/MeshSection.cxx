// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MeshSection.h"

#include "Text/ViewerMessages.h"

#include "vtkActor.h"
#include "vtkCurvedCellCutter.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

namespace
{
const double LineOffset = 5e-4; // towards the viewer, as a share of the diagonal
const double Ambient = 0.7;     // so that values can be read whichever way the cut faces
const double LineOpacity = 0.35;
}

//------------------------------------------------------------------------------
MeshSection::MeshSection(vtkPlane* plane, vtkRenderer* renderer, ViewerMessages& messages)
  : Plane(plane)
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
}

//------------------------------------------------------------------------------
void MeshSection::SetColours(vtkMapper* mapper, vtkProperty* property)
{
  this->Faces->SetScalarMode(mapper->GetScalarMode());
  this->Faces->SetScalarVisibility(mapper->GetScalarVisibility());
  this->Faces->SetInterpolateScalarsBeforeMapping(mapper->GetInterpolateScalarsBeforeMapping());
  this->Faces->SetLookupTable(mapper->GetLookupTable());
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

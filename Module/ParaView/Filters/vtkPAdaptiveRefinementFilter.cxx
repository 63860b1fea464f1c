// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPAdaptiveRefinementFilter.h"

#include "PieceFilter.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkUnsignedCharArray.h"

namespace
{
// Convert the ids of the piece's cells, which its cells still have, to ids of the input.
void SetOriginalIds(vtkPolyData* output)
{
  vtkCellData* data = output->GetCellData();
  vtkDataArray* ids = data->GetArray(relevo::PieceFilter::CellIds);
  vtkDataArray* originals = data->GetArray("vtkOriginalCellIds");
  if (ids && originals)
  {
    originals->DeepCopy(ids);
    originals->SetName("vtkOriginalCellIds");
  }
}

// Ghosts of other processes are now part of this process's mesh.
void RemoveFlag(vtkDataSetAttributes* data, unsigned char flag)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  auto flags = vtkUnsignedCharArray::SafeDownCast(data->GetAbstractArray(name));
  if (!flags)
  {
    return;
  }
  bool hasOthers = false;
  for (vtkIdType i = 0; i < flags->GetNumberOfValues(); ++i)
  {
    const unsigned char left = flags->GetValue(i) & ~flag;
    flags->SetValue(i, left);
    hasOthers = hasOthers || left != 0;
  }
  if (!hasOthers)
  {
    data->RemoveArray(name);
  }
}
}

vtkStandardNewMacro(vtkPAdaptiveRefinementFilter);

vtkPAdaptiveRefinementFilter::vtkPAdaptiveRefinementFilter()
  : Pieces(new relevo::PieceFilter)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPAdaptiveRefinementFilter::~vtkPAdaptiveRefinementFilter() = default;

bool vtkPAdaptiveRefinementFilter::HasRecipe()
{
  if (!this->GetRefinement())
  {
    vtkErrorMacro("There is no recipe: call SetRefinement() with a vtkAdaptiveRefinement.");
    return false;
  }
  return true;
}

void vtkPAdaptiveRefinementFilter::SetMetric(vtkDepthTagMetric* metric)
{
  if (this->HasRecipe())
  {
    this->GetRefinement()->SetMetric(metric);
  }
}

void vtkPAdaptiveRefinementFilter::SetSurface(vtkRefinementSurface* surface)
{
  if (this->HasRecipe())
  {
    this->GetRefinement()->SetSurface(surface);
  }
}

void vtkPAdaptiveRefinementFilter::SetDisplacement(vtkDisplacement* displacement)
{
  if (this->HasRecipe())
  {
    this->GetRefinement()->SetDisplacement(displacement);
  }
}

int vtkPAdaptiveRefinementFilter::FillInputPortInformation(int, vtkInformation* info)
{
  relevo::PieceFilter::FillInput(info);
  return 1;
}

int vtkPAdaptiveRefinementFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  relevo::PieceFilter::FillOutput(info);
  return 1;
}

vtkTypeBool vtkPAdaptiveRefinementFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return relevo::PieceFilter::MakeOutput(inputVector, outputVector) ? 1 : 0;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkPAdaptiveRefinementFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto refine = [this](vtkPolyData*, vtkPolyData* piece, vtkPolyData* output)
  {
    if (!this->Refine(piece, output))
    {
      return;
    }
    SetOriginalIds(output);
    output->GetCellData()->RemoveArray(relevo::PieceFilter::CellIds);
    RemoveFlag(output->GetPointData(), vtkDataSetAttributes::DUPLICATEPOINT);
    RemoveFlag(output->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
  };
  this->Pieces->Run(this, "the refined mesh", inputVector, outputVector, this->Controller, refine);
  return 1;
}

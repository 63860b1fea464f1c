// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Picking/PickedPolyData.h"

#include "Intersection/CoarseCell.h"
#include "Mesh/RefinementMesh.h"
#include "vtkDataSetAttributes.h"
#include "vtkEmptyCell.h"
#include "vtkGenericCell.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace relevo
{
// The cell that a picker gets for a face, inside its vtkGenericCell. It answers one line and is
// then deleted.
class PickedPolyData::FaceCell : public vtkEmptyCell
{
public:
  static FaceCell* New() { VTK_STANDARD_NEW_BODY(FaceCell); }

  void PutInto(vtkGenericCell* cell, PickedPolyData* data)
  {
    this->Data = data;
    this->Holder = cell;
    Slot::Get(cell) = this;
  }

  // The cell has no type, so that vtkGenericCell::SetCellType() replaces it.
  int GetCellType() override { return -1; }

  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId) override
  {
    vtkGenericCell* holder = this->Holder;
    holder->SetCellTypeToEmptyCell();
    return this->Data->Answer(p1, p2, tol, t, x, pcoords, subId);
  }

private:
  // Gives access to the cell inside a generic cell, which can otherwise be set by type only.
  struct Slot : vtkGenericCell
  {
    static vtkCell*& Get(vtkGenericCell* cell) { return cell->*(&Slot::Cell); }
  };

  PickedPolyData* Data = nullptr;
  vtkGenericCell* Holder = nullptr;
};

PickedPolyData* PickedPolyData::New()
{
  VTK_STANDARD_NEW_BODY(PickedPolyData);
}

PickedPolyData::PickedPolyData()
  : Face(vtkSmartPointer<FaceCell>::New())
{
}
PickedPolyData::~PickedPolyData() = default;

void PickedPolyData::Synchronize(vtkPolyData* input)
{
  Dependencies dependencies;
  dependencies.AddObject(input);
  if (this->SourceDependencies.Update(dependencies))
  {
    this->ShallowCopy(input);
    this->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
    this->FirstFaceCell = input->GetNumberOfVerts() + input->GetNumberOfLines();
    this->LastCell = input->GetNumberOfCells() - 1;
  }
  if (this->Points != input->GetPoints())
  {
    this->SetPoints(input->GetPoints());
  }
}

void PickedPolyData::Take(const PickedSurface& surface)
{
  this->State = NOT_ASKED;
  this->Synchronize(surface.Input);
  this->Asked = surface;
}

void PickedPolyData::Ask()
{
  this->State = ASKED;
}

vtkTypeBool PickedPolyData::IsA(const char* type)
{
  return this->State == ASKED && !std::strcmp(type, "vtkPolyData") ? 0 : vtkPolyData::IsA(type);
}

int PickedPolyData::GetCellType(vtkIdType cellId)
{
  const bool isTried = this->State == ASKED || this->State == HIT_KNOWN;
  if ((isTried && this->IsFace(cellId)) || (this->State == ALL_TRIED && cellId == this->HitCellId))
  {
    return VTK_TRIANGLE; // not a strip, which pickers split into triangles
  }
  // If another cell is requested afterwards, it is nearer.
  this->State = this->State == ALL_TRIED ? NOT_ASKED : this->State;
  return relevo::GetCellType(this, cellId);
}

void PickedPolyData::GetCellPoints(vtkIdType cellId, vtkIdList* points)
{
  relevo::GetCellPoints(this, cellId, points);
}

void PickedPolyData::GetCell(vtkIdType cellId, vtkGenericCell* cell)
{
  if (this->IsFace(cellId) && (this->State == ASKED || this->State == HIT_KNOWN))
  {
    this->CellId = cellId;
    if (this->State == ASKED || cellId == this->HitCellId)
    {
      this->Face->PutInto(cell, this);
    }
    else
    {
      this->EndCell();
    }
  }
  else if (this->State == ALL_TRIED && cellId == this->HitCellId)
  {
    cell->SetCellType(this->HitCell->GetCellType());
    cell->DeepCopy(this->HitCell);
    this->State = NOT_ASKED;
  }
  else
  {
    // unlike VTK's method, this supports cells with too few points
    relevo::GetCell(this, cellId, cell);
  }
}

// The tested cell has returned its intersection.
void PickedPolyData::EndCell()
{
  this->State = this->CellId == this->LastCell ? ALL_TRIED : HIT_KNOWN;
}

int PickedPolyData::Answer(const double start[3], const double end[3], double tolerance, double& t,
  double position[3], double pcoords[3], int& subId)
{
  if (this->State == ASKED)
  {
    const PickedSurface& asked = this->Asked;
    this->HitCellId = -1;
    if (asked.Surface->Intersect(*asked.Selection, start, end, tolerance, this->Hit))
    {
      const CoarseCell coarse(asked.Input, *asked.Mesh, this->Hit, this->HitCell);
      TurnCell(this->HitCell, this->Hit.Normal);
      this->HitCellId = coarse.CellId;
      this->HitSubId = coarse.SubId;
      std::copy_n(coarse.PCoords, 3, this->HitPCoords);
    }
  }
  this->EndCell();
  if (this->CellId != this->HitCellId)
  {
    return 0;
  }
  t = this->Hit.T;
  std::copy_n(this->Hit.Position, 3, position);
  std::copy_n(this->HitPCoords, 3, pcoords);
  subId = this->HitSubId;
  return 1;
}

vtkIdType PickedPolyData::GetNumberOfPoints()
{
  if (this->State == ASKED)
  {
    this->MovePoints();
    this->State = POINTS_MOVED;
  }
  return vtkPolyData::GetNumberOfPoints();
}

void PickedPolyData::MovePoints()
{
  const PickedSurface& asked = this->Asked;
  vtkPoints* given = asked.Input->GetPoints();
  Dependencies dependencies = this->SourceDependencies;
  dependencies.Add(asked.Surface->GetTime());
  if (this->MovedDependencies.Update(dependencies))
  {
    this->MovedPoints->SetDataType(given->GetDataType());
    this->MovedPoints->DeepCopy(given);
    // Points without surface are moved out of reach, because VTK treats NaN as near.
    const double nowhere[3] = { VTK_FLOAT_MAX, VTK_FLOAT_MAX, VTK_FLOAT_MAX };
    for (vtkIdType point = 0; point < given->GetNumberOfPoints(); ++point)
    {
      const double* p = given->GetPoint(point);
      if (!std::all_of(p, p + 3, [](double x) { return std::isfinite(x); }))
      {
        this->MovedPoints->SetPoint(point, nowhere);
      }
    }
    std::vector<bool> isMoved(static_cast<size_t>(given->GetNumberOfPoints()), false);
    for (size_t face = 0; face < asked.Mesh->Faces.size(); ++face)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const int point = asked.Mesh->Faces[face].Corners[corner];
        double position[3];
        if (!isMoved[static_cast<size_t>(point)])
        {
          isMoved[static_cast<size_t>(point)] = true;
          const bool exists = asked.Surface->GetCorner(static_cast<int>(face), corner, position);
          this->MovedPoints->SetPoint(point, exists ? position : nowhere);
        }
      }
    }
  }
  this->SetPoints(this->MovedPoints);
}

void PickedPolyData::ComputeBounds()
{
  std::copy_n(this->Asked.Bounds, 6, this->Bounds);
}
}

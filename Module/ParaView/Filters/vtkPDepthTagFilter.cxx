// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPDepthTagFilter.h"

#include "PieceFilter.h"
#include "Position.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <utility>

namespace
{
// Ids of the merged points of a mesh: each point has the id of the first point at its position.
class Places
{
public:
  explicit Places(vtkPolyData* mesh)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      relevo::Position position;
      if (relevo::GetPosition(mesh, i, position))
      {
        this->Ids.emplace(position, i);
      }
    }
  }

  // Return the merged point of a point of any mesh; -1 if there is none.
  vtkIdType Find(vtkPolyData* mesh, vtkIdType point) const
  {
    relevo::Position position;
    if (!relevo::GetPosition(mesh, point, position))
    {
      return -1;
    }
    const auto found = this->Ids.find(position);
    return found == this->Ids.end() ? -1 : found->second;
  }

private:
  std::map<relevo::Position, vtkIdType> Ids;
};

// Call f(triangle, i, edge) for the i-th edge of all triangles with valid points; the edge is given
// by the merged points of its ends.
template <typename Function>
void ForEachEdge(vtkPolyData* mesh, const Places& places, Function&& f)
{
  mesh->BuildCells();
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* points;
    mesh->GetCellPoints(cell, size, points);
    const bool isTriangle = mesh->GetCellType(cell) == VTK_TRIANGLE &&
      std::all_of(
        points, points + size, [mesh](vtkIdType point) { return relevo::HasPoint(mesh, point); });
    for (int i = 0; isTriangle && i < 3; ++i)
    {
      f(cell, i,
        std::minmax({ places.Find(mesh, points[i]), places.Find(mesh, points[(i + 1) % 3]) }));
    }
  }
}

// Copy the tags of a piece with ghosts, in its order, to the original piece.
void CopyTags(vtkPolyData* piece, vtkPolyData* own)
{
  const Places places(piece);
  vtkDataArray* pieceTags = piece->GetPointData()->GetArray("DepthTag");
  vtkNew<vtkFloatArray> tags;
  tags->SetName("DepthTag");
  tags->SetNumberOfValues(own->GetNumberOfPoints());
  tags->FillValue(0.0f);
  for (vtkIdType i = 0; i < own->GetNumberOfPoints(); ++i)
  {
    const vtkIdType place = places.Find(own, i);
    if (place >= 0)
    {
      tags->SetTuple(i, place, pieceTags);
    }
  }
  own->GetPointData()->AddArray(tags);

  vtkDataArray* pieceLevels = piece->GetCellData()->GetArray("EdgeLevels");
  std::map<std::pair<vtkIdType, vtkIdType>, double> levelsOfEdges;
  ForEachEdge(piece, places,
    [&](vtkIdType cell, int i, const std::pair<vtkIdType, vtkIdType>& edge)
    { levelsOfEdges[edge] = pieceLevels->GetComponent(cell, i); });
  vtkNew<vtkIntArray> levels;
  levels->SetName("EdgeLevels");
  levels->SetNumberOfComponents(3);
  levels->SetNumberOfTuples(own->GetNumberOfCells());
  levels->FillValue(-1);
  ForEachEdge(own, places,
    [&](vtkIdType cell, int i, const std::pair<vtkIdType, vtkIdType>& edge)
    {
      const auto level = levelsOfEdges.find(edge);
      levels->SetComponent(cell, i, level == levelsOfEdges.end() ? 0.0 : level->second);
    });
  own->GetCellData()->AddArray(levels);
}
}

vtkStandardNewMacro(vtkPDepthTagFilter);

vtkPDepthTagFilter::vtkPDepthTagFilter()
  : Pieces(new relevo::PieceFilter)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPDepthTagFilter::~vtkPDepthTagFilter() = default;

int vtkPDepthTagFilter::FillInputPortInformation(int, vtkInformation* info)
{
  relevo::PieceFilter::FillInput(info);
  return 1;
}

int vtkPDepthTagFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  relevo::PieceFilter::FillOutput(info);
  return 1;
}

vtkTypeBool vtkPDepthTagFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return relevo::PieceFilter::MakeOutput(inputVector, outputVector) ? 1 : 0;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkPDepthTagFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto addTags = [this](vtkPolyData* own, vtkPolyData* piece, vtkPolyData* output)
  {
    vtkNew<vtkPolyData> tagged;
    if (this->AddTags(piece, tagged) && own)
    {
      output->ShallowCopy(own);
      output->GetCellData()->RemoveArray(relevo::PieceFilter::CellIds);
      CopyTags(tagged, output);
    }
  };
  this->Pieces->Run(
    this, "the levels of the mesh", inputVector, outputVector, this->Controller, addTags);
  return 1;
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GhostFaces.h"

#include "Arrays/GhostCells.h"
#include "CellSubset.h"
#include "FacePolygons.h"
#include "Mesh/SurfaceEdges.h"
#include "Parallel/ProcessReduction.h"
#include "Points/MergedPoints.h"
#include "Position.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace relevo
{
namespace
{
// A cell array with unique ids of all faces of all processes.
constexpr const char* FaceIds = "relevo::FaceIds";

using Positions = std::set<Position>; // of finite coordinates
using Pieces = std::vector<vtkSmartPointer<vtkPolyData>>;

// A piece of a process.
struct PieceNumber
{
  std::size_t Process;
  std::size_t Piece;
};

struct PositionHash
{
  std::size_t operator()(const Position& position) const
  {
    return static_cast<std::size_t>(HashPoint(position.data()));
  }
};
// The pieces that need the faces at each position.
using Requests = std::unordered_map<Position, std::vector<PieceNumber>, PositionHash>;

// Calls f(cell, position) for the finite corners of all cells.
template <typename Function>
void ForEachCorner(vtkPolyData* mesh, Function&& f)
{
  mesh->BuildCells();
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* points;
    mesh->GetCellPoints(cell, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      Position position;
      if (GetPosition(mesh, points[i], position))
      {
        f(cell, position);
      }
    }
  }
}

// Return the ends of edges that do not have two faces in the piece.
Positions FindBorderPositions(vtkPolyData* piece)
{
  Positions border;
  if (piece->GetNumberOfCells() == 0)
  {
    return border;
  }
  // The edges of curved faces have nodes between their corners.
  const bool isCurved = FaceCornerCounter(piece).HasTypes();
  const vtkSmartPointer<vtkPolyData> corners =
    isCurved ? MakeCornerPolygons(piece) : vtkSmartPointer<vtkPolyData>(piece);
  const SurfaceEdges edges(corners);
  for (const SurfaceEdgeSides& sides : edges.GetSides())
  {
    for (vtkIdType end : edges.GetEdges()[static_cast<std::size_t>(sides.Edge)].MergedPoints)
    {
      Position position;
      if (sides.Type == SurfaceEdgeSides::OPEN && GetPosition(piece, end, position))
      {
        border.insert(position);
      }
    }
  }
  return border;
}

// Return the positions of corners of ghosts that are not corners of the piece itself.
Positions FindOuterPositions(vtkPolyData* piece)
{
  const GhostCells ghosts(piece);
  Positions outer;
  ForEachCorner(piece,
    [&](vtkIdType cell, const Position& position)
    {
      if (ghosts.Has(cell))
      {
        outer.insert(position);
      }
    });
  ForEachCorner(piece,
    [&](vtkIdType cell, const Position& position)
    {
      if (!ghosts.Has(cell))
      {
        outer.erase(position);
      }
    });
  return outer;
}

// Send the positions of each process's pieces to all processes. `numbers` gets the number of pieces
// of each process.
Requests ShareRequests(const std::vector<Positions>& ofPieces, const PieceReduction& processes,
  std::vector<std::size_t>& numbers)
{
  std::vector<double> values(1, static_cast<double>(ofPieces.size()));
  for (const Positions& positions : ofPieces)
  {
    values.push_back(static_cast<double>(positions.size()));
    for (const Position& position : positions)
    {
      values.insert(values.end(), position.begin(), position.end());
    }
  }
  values = processes.Collect(std::move(values));
  Requests requests;
  numbers.clear();
  for (auto value = values.begin(); value != values.end();)
  {
    const std::size_t process = numbers.size();
    numbers.push_back(static_cast<std::size_t>(*value++));
    for (std::size_t piece = 0; piece < numbers.back(); ++piece)
    {
      for (auto left = static_cast<std::size_t>(*value++); left > 0; --left, value += 3)
      {
        requests[{ value[0], value[1], value[2] }].push_back({ process, piece });
      }
    }
  }
  return requests;
}

// A message for each process: a block for each of its pieces, with the faces that it needs.
std::vector<vtkSmartPointer<vtkMultiBlockDataSet>> MakeMessages(
  const Pieces& own, const Requests& requests, const std::vector<std::size_t>& numbers)
{
  std::vector<std::vector<Pieces>> found;
  for (std::size_t number : numbers)
  {
    found.emplace_back(number);
  }
  for (vtkPolyData* piece : own)
  {
    std::vector<std::vector<std::vector<bool>>> isNeeded;
    for (std::size_t number : numbers)
    {
      isNeeded.emplace_back(number);
    }
    ForEachCorner(piece,
      [&](vtkIdType cell, const Position& position)
      {
        const auto request = requests.find(position);
        if (request == requests.end())
        {
          return;
        }
        for (const PieceNumber& to : request->second)
        {
          std::vector<bool>& cells = isNeeded[to.Process][to.Piece];
          cells.resize(static_cast<std::size_t>(piece->GetNumberOfCells()), false);
          cells[static_cast<std::size_t>(cell)] = true;
        }
      });
    for (std::size_t process = 0; process < numbers.size(); ++process)
    {
      for (std::size_t i = 0; i < numbers[process]; ++i)
      {
        if (!isNeeded[process][i].empty())
        {
          found[process][i].push_back(ExtractCells(piece, isNeeded[process][i]));
        }
      }
    }
  }
  std::vector<vtkSmartPointer<vtkMultiBlockDataSet>> messages;
  for (const std::vector<Pieces>& blocks : found)
  {
    messages.push_back(vtkSmartPointer<vtkMultiBlockDataSet>::New());
    messages.back()->SetNumberOfBlocks(static_cast<unsigned int>(blocks.size()));
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      messages.back()->SetBlock(static_cast<unsigned int>(i), AppendMeshes(blocks[i]));
    }
  }
  return messages;
}

vtkIdTypeArray* GetFaceIds(vtkPolyData* mesh)
{
  return vtkIdTypeArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(FaceIds));
}

// Add all arrays of other data, for a number of tuples.
void AddArraysOf(vtkDataSetAttributes* others, vtkDataSetAttributes* data, vtkIdType number)
{
  for (int i = 0; i < others->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* other = others->GetAbstractArray(i);
    if (other->GetName() && !data->GetAbstractArray(other->GetName()))
    {
      auto array = vtk::TakeSmartPointer(other->NewInstance());
      array->SetName(other->GetName());
      array->SetNumberOfComponents(other->GetNumberOfComponents());
      array->SetNumberOfTuples(number);
      if (auto numbers = vtkDataArray::SafeDownCast(array))
      {
        numbers->Fill(0.0);
      }
      data->AddArray(array);
    }
  }
  // All processes must agree on the active attributes.
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* attribute = others->GetAbstractAttribute(type);
    data->SetActiveAttribute(attribute ? attribute->GetName() : nullptr, type);
  }
}

// Add faces that the piece lacks, as ghosts.
void AddMissing(const Pieces& faces, vtkSmartPointer<vtkPolyData>& piece)
{
  std::unordered_set<vtkIdType> known;
  vtkIdTypeArray* own = GetFaceIds(piece);
  for (vtkIdType cell = 0; own && cell < own->GetNumberOfValues(); ++cell)
  {
    known.insert(own->GetValue(cell));
  }
  Pieces parts(1, piece);
  for (vtkPolyData* mesh : faces)
  {
    vtkIdTypeArray* ids = GetFaceIds(mesh);
    std::vector<bool> isMissing(
      static_cast<std::size_t>(ids ? ids->GetNumberOfValues() : vtkIdType(0)));
    for (std::size_t cell = 0; cell < isMissing.size(); ++cell)
    {
      isMissing[cell] = known.insert(ids->GetValue(static_cast<vtkIdType>(cell))).second;
    }
    if (std::find(isMissing.begin(), isMissing.end(), true) != isMissing.end())
    {
      vtkSmartPointer<vtkPolyData> ghosts = ExtractCells(mesh, isMissing);
      SetGhostTypes(ghosts,
        std::vector<unsigned char>(static_cast<std::size_t>(ghosts->GetNumberOfCells()),
          vtkDataSetAttributes::DUPLICATECELL));
      AddArraysOf(piece->GetPointData(), ghosts->GetPointData(), ghosts->GetNumberOfPoints());
      AddArraysOf(piece->GetCellData(), ghosts->GetCellData(), ghosts->GetNumberOfCells());
      parts.push_back(ghosts);
    }
  }
  if (parts.size() > 1)
  {
    if (!piece->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()))
    {
      SetGhostTypes(
        piece, std::vector<unsigned char>(static_cast<std::size_t>(piece->GetNumberOfCells()), 0));
    }
    piece = AppendMeshes(parts);
  }
}

void AddFaceIds(const Pieces& own, const PieceReduction& processes, int process)
{
  std::vector<double> numbers(1, 0.0);
  for (vtkPolyData* piece : own)
  {
    numbers[0] += static_cast<double>(piece->GetNumberOfCells());
  }
  numbers = processes.Collect(std::move(numbers));
  // The first id of this process.
  auto next =
    static_cast<vtkIdType>(std::accumulate(numbers.begin(), numbers.begin() + process, 0.0));
  for (vtkPolyData* piece : own)
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(FaceIds);
    ids->SetNumberOfValues(piece->GetNumberOfCells());
    std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), next);
    next += ids->GetNumberOfValues();
    piece->GetCellData()->AddArray(ids);
  }
}

// Add the faces at these positions, one set for each piece.
void AddFacesAt(const std::vector<Positions>& positions, const Pieces& own, Pieces& pieces,
  const PieceReduction& processes, vtkMultiProcessController* controller)
{
  std::vector<std::size_t> numbers;
  const Requests requests = ShareRequests(positions, processes, numbers);
  const std::vector<vtkSmartPointer<vtkMultiBlockDataSet>> toProcesses =
    MakeMessages(own, requests, numbers);
  for (std::size_t process = 0; process < toProcesses.size(); ++process)
  {
    std::vector<vtkSmartPointer<vtkDataObject>> messages(1, toProcesses[process]);
    const int receiver = static_cast<int>(process);
    if (controller &&
      (!controller->Gather(toProcesses[process], messages, receiver) ||
        controller->GetLocalProcessId() != receiver))
    {
      continue;
    }
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      Pieces faces;
      for (vtkDataObject* each : messages)
      {
        auto blocks = vtkMultiBlockDataSet::SafeDownCast(each);
        auto mesh = blocks
          ? vtkPolyData::SafeDownCast(blocks->GetBlock(static_cast<unsigned int>(i)))
          : nullptr;
        if (mesh)
        {
          faces.emplace_back(mesh);
        }
      }
      AddMissing(faces, pieces[i]);
    }
  }
}
}

void AddGhostFaces(Pieces& pieces, int numberOfLayers, vtkMultiProcessController* controller)
{
  const std::unique_ptr<PieceReduction> processes(
    controller ? new ProcessReduction(controller) : new PieceReduction);
  const Pieces own = pieces;
  AddFaceIds(own, *processes, controller ? controller->GetLocalProcessId() : 0);
  for (int layer = 0; layer < numberOfLayers; ++layer)
  {
    std::vector<Positions> positions;
    std::transform(pieces.begin(), pieces.end(), std::back_inserter(positions),
      [layer](vtkPolyData* piece)
      { return layer == 0 ? FindBorderPositions(piece) : FindOuterPositions(piece); });
    AddFacesAt(positions, own, pieces, *processes, controller);
  }
  for (vtkPolyData* piece : pieces)
  {
    piece->GetCellData()->RemoveArray(FaceIds);
  }
}
}

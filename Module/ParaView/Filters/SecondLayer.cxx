// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SecondLayer.h"

#include "Arrays/GhostCells.h"
#include "CellSubset.h"
#include "Parallel/ProcessReduction.h"
#include "Position.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <set>

namespace relevo
{
namespace
{
using Positions = std::set<Position>; // of finite coordinates
using Pieces = std::vector<vtkSmartPointer<vtkPolyData>>;

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

// Send the positions of each process's pieces to all processes.
std::vector<std::vector<Positions>> ShareOuterPositions(
  const Pieces& pieces, const PieceReduction& processes)
{
  std::vector<double> values(1, static_cast<double>(pieces.size()));
  for (vtkPolyData* piece : pieces)
  {
    const Positions positions = FindOuterPositions(piece);
    values.push_back(static_cast<double>(positions.size()));
    for (const Position& position : positions)
    {
      values.insert(values.end(), position.begin(), position.end());
    }
  }
  values = processes.Collect(std::move(values));
  std::vector<std::vector<Positions>> all;
  for (auto value = values.begin(); value != values.end();)
  {
    all.emplace_back(static_cast<std::size_t>(*value++));
    for (Positions& positions : all.back())
    {
      for (auto left = static_cast<std::size_t>(*value++); left > 0; --left, value += 3)
      {
        positions.insert({ value[0], value[1], value[2] });
      }
    }
  }
  return all;
}

// Return the faces with corners at these positions.
vtkSmartPointer<vtkPolyData> FindFaces(const Pieces& own, const Positions& positions)
{
  Pieces found;
  vtkBoundingBox box;
  for (const Position& position : positions)
  {
    box.AddPoint(position[0], position[1], position[2]);
  }
  for (vtkPolyData* piece : own)
  {
    if (!box.IsValid() || !box.Intersects(vtkBoundingBox(piece->GetBounds())))
    {
      continue;
    }
    std::vector<bool> touches(static_cast<std::size_t>(piece->GetNumberOfCells()), false);
    ForEachCorner(piece,
      [&](vtkIdType cell, const Position& position)
      {
        if (box.ContainsPoint(position[0], position[1], position[2]) &&
          positions.count(position) > 0)
        {
          touches[static_cast<std::size_t>(cell)] = true;
        }
      });
    if (std::find(touches.begin(), touches.end(), true) != touches.end())
    {
      found.push_back(ExtractCells(piece, touches));
    }
  }
  return AppendMeshes(found);
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
  std::set<vtkIdType> known;
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
    piece = AppendMeshes(parts);
  }
}
}

void AddFaceIds(const Pieces& own, vtkMultiProcessController* controller)
{
  double first = 0.0; // of this process
  if (controller)
  {
    std::vector<double> numbers(1, 0.0);
    for (vtkPolyData* piece : own)
    {
      numbers[0] += static_cast<double>(piece->GetNumberOfCells());
    }
    numbers = ProcessReduction(controller).Collect(std::move(numbers));
    first =
      std::accumulate(numbers.begin(), numbers.begin() + controller->GetLocalProcessId(), 0.0);
  }
  auto next = static_cast<vtkIdType>(first);
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

void CompleteSecondLayer(const Pieces& own, Pieces& pieces, vtkMultiProcessController* controller)
{
  const std::unique_ptr<PieceReduction> processes(
    controller ? new ProcessReduction(controller) : new PieceReduction);
  const std::vector<std::vector<Positions>> outer = ShareOuterPositions(pieces, *processes);
  for (std::size_t process = 0; process < outer.size(); ++process)
  {
    // The message has a block for each of the process's pieces.
    auto message = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    message->SetNumberOfBlocks(static_cast<unsigned int>(outer[process].size()));
    for (std::size_t i = 0; i < outer[process].size(); ++i)
    {
      message->SetBlock(static_cast<unsigned int>(i), FindFaces(own, outer[process][i]));
    }
    std::vector<vtkSmartPointer<vtkDataObject>> messages(1, message);
    const int receiver = static_cast<int>(process);
    if (controller &&
      (!controller->Gather(message, messages, receiver) ||
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

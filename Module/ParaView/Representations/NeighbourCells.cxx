// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NeighbourCells.h"

#include "Parallel/ProcessReduction.h"
#include "RankExchange.h"
#include "VolumePiece.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace relevo
{
namespace
{
using Position = std::array<double, 3>;
using Ranks = std::set<std::size_t>;
using Pieces = std::vector<vtkSmartPointer<vtkDataObject>>;

bool IsGhost(vtkDataSet* set, vtkIdType cell)
{
  vtkUnsignedCharArray* types = set->GetCellGhostArray();
  return types && (types->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

bool HasGhosts(vtkDataSet* set)
{
  bool hasGhosts = false;
  for (vtkIdType cell = 0; cell < set->GetNumberOfCells() && !hasGhosts; ++cell)
  {
    hasGhosts = IsGhost(set, cell);
  }
  return hasGhosts;
}

// Return the positions of the points on the surfaces of the data sets.
std::vector<double> FindBorder(const std::vector<vtkDataSet*>& sets)
{
  std::vector<double> border;
  for (vtkDataSet* set : sets)
  {
    if (HasGhosts(set))
    {
      return {};
    }
    vtkNew<vtkGeometryFilter> surface;
    surface->SetInputData(set);
    surface->Update();
    vtkPolyData* faces = surface->GetOutput();
    for (vtkIdType i = 0; i < faces->GetNumberOfPoints(); ++i)
    {
      Position at;
      faces->GetPoint(i, at.data());
      border.insert(border.end(), at.begin(), at.end());
    }
  }
  return border;
}

// Return the ranks that have a point on their surface, by position.
std::map<Position, Ranks> ShareBorders(
  const std::vector<double>& own, const RankExchange& ranks, vtkMultiProcessController* controller)
{
  const std::vector<vtkIdType> sizes = ranks.Share(static_cast<vtkIdType>(own.size()));
  const std::vector<double> all = ProcessReduction(controller).Collect(own);
  std::map<Position, Ranks> borders;
  std::size_t at = 0;
  for (std::size_t rank = 0; rank < sizes.size(); ++rank)
  {
    for (vtkIdType i = 0; i < sizes[rank]; i += 3, at += 3)
    {
      borders[{ { all[at], all[at + 1], all[at + 2] } }].insert(rank);
    }
  }
  return borders;
}

// Return the cells of a data set that touch the surface of each rank.
std::vector<vtkSmartPointer<vtkIdList>> FindTouching(
  vtkDataSet* set, const std::map<Position, Ranks>& borders, std::size_t numberOfRanks)
{
  std::vector<const Ranks*> ofPoints;
  for (vtkIdType point = 0; point < set->GetNumberOfPoints(); ++point)
  {
    Position at;
    set->GetPoint(point, at.data());
    const auto found = borders.find(at);
    ofPoints.push_back(found == borders.end() ? nullptr : &found->second);
  }
  std::vector<vtkSmartPointer<vtkIdList>> touching;
  for (std::size_t rank = 0; rank < numberOfRanks; ++rank)
  {
    touching.push_back(vtkSmartPointer<vtkIdList>::New());
  }
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < set->GetNumberOfCells(); ++cell)
  {
    Ranks ranks;
    set->GetCellPoints(cell, points);
    for (vtkIdType i = 0; i < points->GetNumberOfIds() && !IsGhost(set, cell); ++i)
    {
      if (const Ranks* more = ofPoints[static_cast<std::size_t>(points->GetId(i))])
      {
        ranks.insert(more->begin(), more->end());
      }
    }
    for (std::size_t rank : ranks)
    {
      touching[rank]->InsertNextId(cell);
    }
  }
  return touching;
}

// Return cells with the array only, as ghost cells.
vtkSmartPointer<vtkUnstructuredGrid> MakeGhosts(
  vtkDataSet* set, vtkIdList* cells, const std::string& array)
{
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(set);
  extract->SetCellList(cells);
  extract->Update();
  vtkSmartPointer<vtkUnstructuredGrid> ghosts = extract->GetOutput();
  vtkSmartPointer<vtkDataArray> values = ghosts->GetPointData()->GetArray(array.c_str());
  ghosts->GetPointData()->Initialize();
  ghosts->GetPointData()->AddArray(values);
  ghosts->GetCellData()->Initialize();
  ghosts->GetFieldData()->Initialize();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetName(vtkDataSetAttributes::GhostArrayName());
  types->SetNumberOfValues(ghosts->GetNumberOfCells());
  types->Fill(vtkDataSetAttributes::DUPLICATECELL);
  ghosts->GetCellData()->AddArray(types);
  return ghosts;
}

Bytes Marshal(vtkPartitionedDataSet* parts)
{
  vtkNew<vtkCharArray> text;
  if (parts->GetNumberOfPartitions() == 0 || !vtkCommunicator::MarshalDataObject(parts, text))
  {
    return {};
  }
  const char* begin = text->GetPointer(0);
  return Bytes(begin, begin + text->GetNumberOfValues());
}

// Return the data sets of a message.
std::vector<vtkSmartPointer<vtkDataSet>> Unmarshal(const Bytes& bytes)
{
  std::vector<vtkSmartPointer<vtkDataSet>> sets;
  if (bytes.empty())
  {
    return sets;
  }
  vtkNew<vtkCharArray> text;
  text->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), text->GetPointer(0));
  const auto parts = vtkCommunicator::UnMarshalDataObject(text);
  for (vtkDataSet* set : VolumePiece::GetDataSets(parts))
  {
    sets.push_back(set);
  }
  return sets;
}

// Add ghost cells to a piece as a further block.
vtkSmartPointer<vtkDataObject> AddBlock(
  vtkDataObject* piece, const std::vector<vtkSmartPointer<vtkDataSet>>& ghosts)
{
  vtkNew<vtkPartitionedDataSet> block;
  for (const auto& set : ghosts)
  {
    block->SetPartition(block->GetNumberOfPartitions(), set);
  }
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(piece))
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), block);
    return piece;
  }
  if (auto* blocks = vtkPartitionedDataSetCollection::SafeDownCast(piece))
  {
    blocks->SetPartitionedDataSet(blocks->GetNumberOfPartitionedDataSets(), block);
    return piece;
  }
  const std::vector<vtkDataSet*> own = VolumePiece::GetDataSets(piece);
  for (vtkDataSet* set : own)
  {
    block->SetPartition(block->GetNumberOfPartitions(), set);
  }
  return block;
}
}

vtkSmartPointer<vtkDataObject> AddNeighbourCells(
  vtkDataObject* piece, const std::string& array, vtkMultiProcessController* controller)
{
  const RankExchange ranks(controller);
  const auto count = static_cast<std::size_t>(ranks.GetNumberOfRanks());
  const std::vector<vtkDataSet*> sets = vtkUniformGridAMR::SafeDownCast(piece)
    ? std::vector<vtkDataSet*>()
    : VolumePiece::GetDataSets(piece);
  const std::map<Position, Ranks> borders = ShareBorders(FindBorder(sets), ranks, controller);
  std::vector<vtkSmartPointer<vtkPartitionedDataSet>> messages;
  for (std::size_t rank = 0; rank < count; ++rank)
  {
    messages.push_back(vtkSmartPointer<vtkPartitionedDataSet>::New());
  }
  const auto own = static_cast<std::size_t>(controller->GetLocalProcessId());
  for (vtkDataSet* set : sets)
  {
    if (!set->GetPointData()->GetArray(array.c_str()))
    {
      continue;
    }
    const std::vector<vtkSmartPointer<vtkIdList>> touching = FindTouching(set, borders, count);
    for (std::size_t rank = 0; rank < count; ++rank)
    {
      if (rank != own && touching[rank]->GetNumberOfIds() > 0)
      {
        messages[rank]->SetPartition(
          messages[rank]->GetNumberOfPartitions(), MakeGhosts(set, touching[rank], array));
      }
    }
  }
  std::vector<vtkSmartPointer<vtkDataSet>> ghosts;
  for (std::size_t rank = 0; rank < count; ++rank)
  {
    for (const Bytes& bytes : ranks.Gather(Marshal(messages[rank]), static_cast<int>(rank)))
    {
      const auto received = Unmarshal(bytes);
      ghosts.insert(ghosts.end(), received.begin(), received.end());
    }
  }
  return ghosts.empty() ? piece : AddBlock(piece, ghosts).Get();
}
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SharedFaces.h"

#include "Arrays/GhostCells.h"
#include "CellSubset.h"
#include "FacePolygons.h"
#include "Parallel/ProcessReduction.h"
#include "Position.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace relevo
{
namespace
{
// Two hashes of the corners, which are whole numbers.
using FaceKey = std::array<double, 2>;

struct KeyedFace
{
  std::size_t Piece;
  vtkIdType Cell;
  FaceKey Key;
  vtkBoundingBox Box;
};

// The finalizer of MurmurHash3, by Austin Appleby, which is in the public domain.
std::uint64_t Mix(std::uint64_t value)
{
  value = (value ^ (value >> 33)) * 0xff51afd7ed558ccdULL;
  value = (value ^ (value >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return value ^ (value >> 33);
}

FaceKey GetKey(std::vector<Position> corners)
{
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  FaceKey key;
  for (std::size_t k = 0; k < key.size(); ++k)
  {
    std::uint64_t hash = Mix(k + 1);
    for (const Position& corner : corners)
    {
      for (double coordinate : corner)
      {
        const double value = coordinate + 0.0; // of -0
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof(bits));
        hash = Mix(hash + bits);
      }
    }
    key[k] = static_cast<double>(hash >> 12);
  }
  return key;
}

std::vector<KeyedFace> FindFaces(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces)
{
  std::vector<KeyedFace> faces;
  std::vector<Position> corners;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    vtkPolyData* piece = pieces[i];
    const FaceCornerCounter counter(piece);
    for (vtkIdType cell = 0; cell < piece->GetNumberOfCells(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      if (!counter.IsOfSolid(cell))
      {
        continue;
      }
      piece->GetPolys()->GetCellAtId(cell, size, points);
      corners.resize(static_cast<std::size_t>(counter.Count(cell, size)));
      KeyedFace face{ i, cell, {}, {} };
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        GetPosition(piece, points[k], corners[k]);
        face.Box.AddPoint(corners[k].data());
      }
      face.Key = GetKey(corners);
      faces.push_back(face);
    }
  }
  return faces;
}

// Return the bounds of the faces of each process.
std::vector<vtkBoundingBox> ShareBounds(
  const std::vector<KeyedFace>& faces, const PieceReduction& processes)
{
  vtkBoundingBox own;
  for (const KeyedFace& face : faces)
  {
    own.AddBox(face.Box);
  }
  std::vector<double> values(6);
  own.GetBounds(values.data()); // inverted without faces
  values = processes.Collect(std::move(values));
  std::vector<vtkBoundingBox> boxes;
  for (std::size_t i = 0; i + 5 < values.size(); i += 6)
  {
    boxes.emplace_back(values[i] <= values[i + 1] ? vtkBoundingBox(&values[i]) : vtkBoundingBox());
  }
  return boxes;
}

// Count how often each key occurs on all processes. Faces outside the bounds of other processes
// are not sent.
std::map<FaceKey, int> CountKeys(const std::vector<KeyedFace>& faces,
  const std::vector<vtkBoundingBox>& boxes, std::size_t process, const PieceReduction& processes)
{
  std::map<FaceKey, int> numbers;
  std::vector<double> sent;
  for (const KeyedFace& face : faces)
  {
    bool isNear = false;
    for (std::size_t other = 0; other < boxes.size() && !isNear; ++other)
    {
      isNear = other != process && boxes[other].IsValid() && boxes[other].Intersects(face.Box) != 0;
    }
    if (isNear)
    {
      sent.insert(sent.end(), face.Key.begin(), face.Key.end());
    }
    else
    {
      ++numbers[face.Key];
    }
  }
  sent = processes.Collect(std::move(sent));
  for (std::size_t i = 0; i + 1 < sent.size(); i += 2)
  {
    ++numbers[{ sent[i], sent[i + 1] }];
  }
  return numbers;
}
}

void RemoveSharedFaces(
  std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkMultiProcessController* controller)
{
  const std::unique_ptr<PieceReduction> processes(
    controller ? new ProcessReduction(controller) : new PieceReduction);
  const std::vector<KeyedFace> faces = FindFaces(pieces);
  const std::vector<vtkBoundingBox> boxes = ShareBounds(faces, *processes);
  const auto process = static_cast<std::size_t>(controller ? controller->GetLocalProcessId() : 0);
  const std::map<FaceKey, int> numbers = CountKeys(faces, boxes, process, *processes);
  std::vector<std::vector<bool>> kept(pieces.size());
  for (const KeyedFace& face : faces)
  {
    if (numbers.at(face.Key) > 1)
    {
      std::vector<bool>& ofPiece = kept[face.Piece];
      ofPiece.resize(static_cast<std::size_t>(pieces[face.Piece]->GetNumberOfCells()), true);
      ofPiece[static_cast<std::size_t>(face.Cell)] = false;
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    if (!kept[i].empty())
    {
      pieces[i] = ExtractCells(pieces[i], kept[i]);
    }
  }
}

vtkSmartPointer<vtkPolyData> RemoveRepeatedGhosts(vtkPolyData* mesh)
{
  const GhostCells ghosts(mesh);
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const vtkIdType number = mesh->GetNumberOfPolys();
  if (!ghosts.AreAmong(first, first + number))
  {
    return mesh;
  }
  const auto getKey = [mesh](vtkIdType face)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    mesh->GetPolys()->GetCellAtId(face, size, points);
    std::vector<Position> positions(static_cast<std::size_t>(size));
    for (std::size_t k = 0; k < positions.size(); ++k)
    {
      GetPosition(mesh, points[k], positions[k]);
    }
    return GetKey(std::move(positions));
  };
  std::set<FaceKey> known;
  for (vtkIdType face = 0; face < number; ++face)
  {
    if (!ghosts.Has(first + face))
    {
      known.insert(getKey(face));
    }
  }
  std::vector<bool> kept(static_cast<std::size_t>(mesh->GetNumberOfCells()), true);
  for (vtkIdType face = 0; face < number; ++face)
  {
    if (ghosts.Has(first + face))
    {
      kept[static_cast<std::size_t>(first + face)] = known.insert(getKey(face)).second;
    }
  }
  return std::find(kept.begin(), kept.end(), false) == kept.end()
    ? vtkSmartPointer<vtkPolyData>(mesh)
    : ExtractCells(mesh, kept);
}
}

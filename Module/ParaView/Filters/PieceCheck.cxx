// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceCheck.h"

#include "Arrays/GhostCells.h"
#include "Position.h"
#include "SurfaceLeaves.h"
#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace relevo
{
namespace
{
// Kinds of facts about a surface.
constexpr char Name = 'n';
constexpr char Faces = 'f';
constexpr char NotFinite = 'x';
constexpr char PointArray = 'p';
constexpr char CellArray = 'c';

// Facts end with a null character, which names cannot contain.
void AddFact(std::string& facts, std::size_t surface, char kind, const std::string& value)
{
  facts += std::to_string(surface) + kind + value + '\0';
}

std::string GetName(vtkDataObjectTree* parent, vtkDataObjectTreeIterator* node)
{
  const bool isNamed =
    parent->HasMetaData(node) && parent->GetMetaData(node)->Has(vtkCompositeDataSet::NAME());
  const char* name =
    isNamed ? parent->GetMetaData(node)->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

// Add the names of the surfaces of a tree, in the order of ForEachLeaf(). `name` is that of the
// tree.
void AddNames(vtkDataObjectTree* tree, const std::string& name, std::vector<std::string>& names)
{
  if (vtkPartitionedDataSet::SafeDownCast(tree) || vtkMultiPieceDataSet::SafeDownCast(tree))
  {
    names.push_back(name);
    return;
  }
  auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
  iterator->SkipEmptyNodesOff();
  iterator->VisitOnlyLeavesOff();
  iterator->TraverseSubTreeOff();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const std::string own = GetName(tree, iterator);
    if (auto subTree = vtkDataObjectTree::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      AddNames(subTree, own.empty() ? name : own, names);
    }
    else
    {
      names.push_back(own.empty() ? name : own);
    }
  }
}

struct FaceNumbers
{
  vtkIdType All = 0;
  vtkIdType NotFinite = 0;
};

// Count the faces of a mesh that are not ghosts.
FaceNumbers CountFaces(vtkPolyData* mesh)
{
  FaceNumbers numbers;
  const GhostCells ghosts(mesh);
  vtkIdType cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* points;
      iterator->GetCurrentCell(size, points);
      if (!ghosts.Has(cell++))
      {
        ++numbers.All;
        numbers.NotFinite += IsFinite(mesh, size, points) ? 0 : 1;
      }
    }
  }
  return numbers;
}

std::set<std::string> GetArrayNames(vtkDataSetAttributes* data)
{
  std::set<std::string> names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetAbstractArray(i)->GetName();
    names.insert(name ? name : "");
  }
  return names;
}

// Return the facts about a process's leaves of a surface.
std::string DescribeSurface(std::size_t surface, const PieceCheck::Leaves& leaves)
{
  std::string facts;
  FaceNumbers sums;
  std::set<std::string> arrays[2]; // that all leaves with faces have: of points, of cells
  for (vtkPolyData* mesh : leaves)
  {
    const FaceNumbers numbers = mesh ? CountFaces(mesh) : FaceNumbers();
    if (numbers.All == 0)
    {
      continue;
    }
    for (int k = 0; k < 2; ++k)
    {
      const std::set<std::string> own = GetArrayNames(
        k == 0 ? static_cast<vtkDataSetAttributes*>(mesh->GetPointData()) : mesh->GetCellData());
      std::set<std::string> common;
      std::set_intersection(own.begin(), own.end(), arrays[k].begin(), arrays[k].end(),
        std::inserter(common, common.end()));
      arrays[k] = sums.All == 0 ? own : common;
    }
    sums.All += numbers.All;
    sums.NotFinite += numbers.NotFinite;
  }
  if (sums.All > 0)
  {
    AddFact(facts, surface, Faces, "");
    AddFact(facts, surface, NotFinite, std::to_string(sums.NotFinite));
  }
  for (int k = 0; k < 2; ++k)
  {
    for (const std::string& name : arrays[k])
    {
      AddFact(facts, surface, k == 0 ? PointArray : CellArray, name);
    }
  }
  return facts;
}

// Return the texts of all processes.
std::vector<std::string> Collect(const std::string& own, vtkMultiProcessController* controller)
{
  if (!controller)
  {
    return { own };
  }
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(lengths.size(), 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  std::vector<char> all(static_cast<std::size_t>(offsets.back() + lengths.back()) + 1);
  controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    texts.emplace_back(all.data() + offsets[i], static_cast<std::size_t>(lengths[i]));
  }
  return texts;
}

std::string Join(const std::vector<int>& ranks)
{
  std::string text;
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == ranks.size() ? " and " : ", ") + std::to_string(ranks[i]);
  }
  return text;
}
}

bool IsFinite(vtkPolyData* mesh, vtkIdType size, const vtkIdType* points)
{
  return std::all_of(points, points + size,
    [mesh](vtkIdType point)
    {
      Position position;
      return GetPosition(mesh, point, position);
    });
}

void PieceCheck::Add(const std::string& facts, int process)
{
  for (std::size_t start = 0; start < facts.size();)
  {
    const std::size_t end = facts.find('\0', start);
    std::size_t digits = 0;
    const std::string fact = facts.substr(start, end - start);
    const auto number = static_cast<std::size_t>(std::stoul(fact, &digits));
    const char kind = fact[digits];
    const std::string value = fact.substr(digits + 1);
    this->Surfaces.resize(std::max(this->Surfaces.size(), number + 1));
    Surface& surface = this->Surfaces[number];
    switch (kind)
    {
      case Name:
        surface.Name = surface.Name.empty() ? value : surface.Name;
        break;
      case Faces:
        surface.Processes.insert(process);
        break;
      case NotFinite:
        surface.NotFinite[process] = static_cast<vtkIdType>(std::stoll(value));
        break;
      default:
        surface.Arrays[{ kind == CellArray, value }].insert(process);
    }
    start = end + 1;
  }
}

void PieceCheck::Update(vtkDataObjectTree* tree, const std::vector<Leaves>& surfaces,
  vtkMultiProcessController* controller)
{
  std::string own;
  std::vector<std::string> names;
  if (tree)
  {
    AddNames(tree, "", names);
  }
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    AddFact(own, i, Name, names[i]);
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    own += DescribeSurface(i, surfaces[i]);
  }
  this->HasProcesses = controller != nullptr;
  this->Surfaces.clear();
  const std::vector<std::string> all = Collect(own, controller);
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    this->Add(all[process], static_cast<int>(process));
  }
}

std::string PieceCheck::DescribeMissing(const std::vector<Array>& used) const
{
  std::string text;
  for (const Array& array : used)
  {
    for (const Surface& surface : this->Surfaces)
    {
      const auto found = surface.Arrays.find({ array.IsOfCells, array.Name });
      if (found == surface.Arrays.end())
      {
        continue;
      }
      std::vector<int> lacking;
      std::set_difference(surface.Processes.begin(), surface.Processes.end(), found->second.begin(),
        found->second.end(), std::back_inserter(lacking));
      if (!lacking.empty())
      {
        text += text.empty() ? "" : " ";
        text += std::string(array.IsOfCells ? "The cell" : "The point") + " array \"" + array.Name +
          "\" of " + array.Property +
          (lacking.size() == 1 ? " is missing on rank " : " is missing on ranks ") + Join(lacking) +
          (surface.Name.empty() ? std::string() : " in block \"" + surface.Name + "\"") +
          ", but other ranks have it. The faces there are drawn without it.";
      }
    }
  }
  return text;
}

std::string PieceCheck::DescribeNotFinite() const
{
  std::string text;
  for (const Surface& surface : this->Surfaces)
  {
    vtkIdType number = 0;
    std::vector<int> processes;
    for (const auto& each : surface.NotFinite)
    {
      number += each.second;
      if (each.second > 0)
      {
        processes.push_back(each.first);
      }
    }
    if (number > 0)
    {
      text += text.empty() ? "" : " ";
      text +=
        (surface.Name.empty() ? std::string("The surface") : "Block \"" + surface.Name + "\"") +
        " has " + std::to_string(number) +
        (number == 1 ? " face with points that are not finite"
                     : " faces with points that are not finite") +
        (this->HasProcesses ? (processes.size() == 1 ? " on rank " : " on ranks ") + Join(processes)
                            : std::string()) +
        (number == 1 ? ". It is left out." : ". They are left out.") +
        " Repair the coordinates of the points.";
    }
  }
  return text;
}
}

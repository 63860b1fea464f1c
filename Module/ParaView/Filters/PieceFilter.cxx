// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceFilter.h"

#include "Checks/MemoryGuard.h"
#include "Parallel/ProcessReduction.h"
#include "SurfaceLeaves.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

namespace relevo
{
namespace
{
void AddCellIds(vtkPolyData* mesh)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(PieceFilter::CellIds);
  ids->SetNumberOfValues(mesh->GetNumberOfCells());
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), 0);
  mesh->GetCellData()->AddArray(ids);
}

struct Leaf
{
  vtkSmartPointer<vtkPolyData> Own;
  vtkSmartPointer<vtkPolyData> Piece = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkPolyData> Output = vtkSmartPointer<vtkPolyData>::New();
};
using Surface = std::vector<Leaf>;

// Return the leaves of a tree. Meshes are replaced by the future pieces. Ghosts are removed if new
// ones will be added.
std::vector<Surface> FindSurfaces(vtkDataObjectTree* tree, bool hasProcesses)
{
  std::vector<Surface> surfaces;
  ForEachLeaf(
    tree, [&] { surfaces.emplace_back(); },
    [&](vtkDataObjectTree* parent, vtkDataObjectTreeIterator* iterator)
    {
      Leaf leaf;
      if (auto mesh = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        leaf.Own = vtkSmartPointer<vtkPolyData>::New();
        leaf.Own->ShallowCopy(mesh);
        AddCellIds(leaf.Own);
        if (hasProcesses && IsSound(leaf.Own))
        {
          leaf.Own->RemoveGhostCells();
        }
        leaf.Piece->ShallowCopy(leaf.Own);
        parent->SetDataSet(iterator, leaf.Piece);
      }
      surfaces.back().push_back(leaf);
    });
  return surfaces;
}

// Calls f(leaf, parent, node) for the tree in which the surfaces were found.
template <typename Function>
void ForEachNode(vtkDataObjectTree* tree, std::vector<Surface>& surfaces, Function&& f)
{
  std::size_t surface = 0; // counted from 1
  std::size_t leaf = 0;
  ForEachLeaf(
    tree,
    [&]
    {
      ++surface;
      leaf = 0;
    },
    [&](vtkDataObjectTree* parent, vtkDataObjectTreeIterator* node)
    { f(surfaces[surface - 1][leaf++], parent, node); });
}

// Give all processes the same number of surfaces and leaves.
void MakeEven(std::vector<Surface>& surfaces, const PieceReduction& pieces)
{
  std::vector<double> number(1, static_cast<double>(surfaces.size()));
  pieces.TakeLargest(number);
  surfaces.resize(static_cast<std::size_t>(number[0]));
  std::vector<double> leaves;
  std::transform(surfaces.begin(), surfaces.end(), std::back_inserter(leaves),
    [](const Surface& surface) { return static_cast<double>(surface.size()); });
  pieces.TakeLargest(leaves);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    surfaces[i].resize(static_cast<std::size_t>(leaves[i]));
  }
}
}

void PieceFilter::FillInput(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
}

void PieceFilter::FillOutput(vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
}

bool PieceFilter::MakeOutput(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  if (input && !(output && output->IsA(input->GetClassName())))
  {
    outputVector->GetInformationObject(0)->Set(
      vtkDataObject::DATA_OBJECT(), vtk::TakeSmartPointer(input->NewInstance()));
  }
  return input != nullptr;
}

void PieceFilter::Run(vtkAlgorithm* filter, const char* purpose, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, vtkMultiProcessController* controller, const Work& work)
{
  const auto run = [&]
  {
    this->RunPieces(inputVector, outputVector, controller, work);
    return 1;
  };
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    run();
  }
  else
  {
    RequestWithinMemory(filter, outputVector, purpose, run);
  }
}

void PieceFilter::RunPieces(vtkInformationVector** inputVector, vtkInformationVector* outputVector,
  vtkMultiProcessController* controller, const Work& work)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  vtkSmartPointer<vtkDataObjectTree> tree = vtkDataObjectTree::SafeDownCast(output);
  if (tree)
  {
    tree->ShallowCopy(input);
  }
  else
  {
    const auto single = vtkSmartPointer<vtkPartitionedDataSet>::New();
    single->SetPartition(0, input);
    tree = single;
  }

  const bool hasProcesses = controller && controller->GetNumberOfProcesses() > 1;
  std::vector<Surface> surfaces = FindSurfaces(tree, hasProcesses);
  this->Pieces.Update(tree, controller);
  ForEachNode(tree, surfaces,
    [](Leaf& leaf, vtkDataObjectTree*, vtkDataObjectTreeIterator* node)
    {
      auto made = vtkPolyData::SafeDownCast(node->GetCurrentDataObject());
      if (made && made->GetNumberOfCells() > 0) // an empty mesh may have lost its arrays
      {
        leaf.Piece = made;
      }
    });
  if (hasProcesses)
  {
    MakeEven(surfaces, ProcessReduction(controller));
  }
  for (Surface& surface : surfaces)
  {
    for (Leaf& leaf : surface)
    {
      if (leaf.Own || hasProcesses)
      {
        work(leaf.Own, leaf.Piece, leaf.Output);
      }
    }
  }
  ForEachNode(tree, surfaces,
    [](Leaf& leaf, vtkDataObjectTree* parent, vtkDataObjectTreeIterator* node)
    { parent->SetDataSet(node, leaf.Own ? leaf.Output.Get() : nullptr); });
  if (tree != output)
  {
    output->ShallowCopy(surfaces[0][0].Output);
  }
}
}

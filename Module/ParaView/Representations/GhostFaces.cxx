// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GhostFaces.h"

#include "SurfaceLeaves.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkGhostCellsGenerator.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleStrip.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
vtkIdType CountCellsBeforeFaces(vtkPolyData* mesh)
{
  return mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
}

// The faces of a mesh as polygons: vtkGhostCellsGenerator mixes up the cell data of other cells.
vtkSmartPointer<vtkPolyData> ExtractFaces(vtkPolyData* mesh)
{
  auto faces = vtkSmartPointer<vtkPolyData>::New();
  faces->ShallowCopy(mesh);
  const vtkIdType first = CountCellsBeforeFaces(mesh);
  if (first + mesh->GetNumberOfStrips() == 0)
  {
    return faces;
  }
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(mesh->GetPolys());
  vtkNew<vtkIdList> cells; // of the mesh, for each polygon
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    cells->InsertNextId(first + i);
  }
  vtkIdType cell = first + polygons->GetNumberOfCells();
  auto strips = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    strips->GetCurrentCell(size, ids);
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(size), ids, polygons);
    while (cells->GetNumberOfIds() < polygons->GetNumberOfCells())
    {
      cells->InsertNextId(cell);
    }
  }
  faces->SetVerts(nullptr);
  faces->SetLines(nullptr);
  faces->SetStrips(nullptr);
  faces->SetPolys(polygons);
  vtkCellData* data = faces->GetCellData();
  data->Initialize();
  data->CopyAllOn();
  data->CopyAllocate(mesh->GetCellData(), cells->GetNumberOfIds());
  for (vtkIdType i = 0; i < cells->GetNumberOfIds(); ++i)
  {
    data->CopyData(mesh->GetCellData(), cells->GetId(i), i);
  }
  return faces;
}

// Gives a mesh of faces the vertices and lines of the mesh that they were extracted from.
void AddVerticesAndLines(vtkPolyData* faces, vtkPolyData* mesh)
{
  const vtkIdType first = CountCellsBeforeFaces(mesh);
  if (first == 0)
  {
    return;
  }
  vtkNew<vtkCellData> own;
  own->ShallowCopy(mesh->GetCellData());
  vtkCellData* ofFaces = faces->GetCellData();
  if (ofFaces->HasArray(vtkDataSetAttributes::GhostArrayName()) &&
    !own->HasArray(vtkDataSetAttributes::GhostArrayName()))
  {
    vtkNew<vtkUnsignedCharArray> none;
    none->SetName(vtkDataSetAttributes::GhostArrayName());
    none->SetNumberOfTuples(mesh->GetNumberOfCells());
    none->FillValue(0);
    own->AddArray(none);
  }
  const vtkIdType numberOfFaces = faces->GetNumberOfPolys();
  vtkNew<vtkCellData> all;
  vtkDataSetAttributes::FieldList fields;
  fields.IntersectFieldList(own);
  fields.IntersectFieldList(ofFaces);
  fields.CopyAllocate(all, vtkDataSetAttributes::PASSDATA, first + numberOfFaces, 0);
  fields.CopyData(0, own, 0, first, all, 0);
  fields.CopyData(1, ofFaces, 0, numberOfFaces, all, first);
  faces->SetVerts(mesh->GetVerts());
  faces->SetLines(mesh->GetLines());
  ofFaces->ShallowCopy(all);
}

// Points at borders have got the data of another process; but its ids are not those of this one.
void KeepPointIds(vtkPolyData* faces, vtkPolyData* mesh)
{
  const char* name = "vtkOriginalPointIds";
  vtkDataArray* own = mesh->GetPointData()->GetArray(name);
  vtkDataArray* ids = faces->GetPointData()->GetArray(name);
  if (own && ids)
  {
    ids->InsertTuples(0, own->GetNumberOfTuples(), 0, own);
  }
}

// Pieces of one surface, and the leaves of the tree that they come from.
struct Surface
{
  vtkSmartPointer<vtkPartitionedDataSet> Pieces = vtkSmartPointer<vtkPartitionedDataSet>::New();
  std::vector<vtkPolyData*> Leaves;

  void AddLeaf(vtkPolyData* mesh)
  {
    this->Pieces->SetPartition(static_cast<unsigned int>(this->Leaves.size()),
      mesh ? ExtractFaces(mesh).Get() : vtkNew<vtkPolyData>().Get());
    this->Leaves.push_back(mesh);
  }
};

void AddGhosts(vtkPartitionedDataSet* pieces)
{
  vtkNew<vtkGhostCellsGenerator> generator;
  generator->SetInputData(pieces);
  generator->BuildIfRequiredOff();
  generator->SetNumberOfGhostLayers(1);
  generator->Update();
  pieces->ShallowCopy(generator->GetOutputDataObject(0));
}
}

void AddGhostFaces(vtkDataObjectTree* tree, vtkMultiProcessController* controller)
{
  std::vector<Surface> surfaces;
  ForEachLeaf(
    tree, [&] { surfaces.emplace_back(); },
    [&](vtkDataObjectTree*, vtkDataObjectTreeIterator* leaf)
    { surfaces.back().AddLeaf(vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject())); });

  // Where processes have other trees, they still take part in all exchanges.
  const int own = static_cast<int>(surfaces.size());
  int most = own;
  controller->AllReduce(&own, &most, 1, vtkCommunicator::MAX_OP);
  surfaces.resize(static_cast<std::size_t>(most));
  for (Surface& surface : surfaces)
  {
    if (surface.Leaves.empty())
    {
      surface.AddLeaf(nullptr);
    }
    AddGhosts(surface.Pieces);
  }

  auto surface = surfaces.begin();
  unsigned int piece = 0;
  bool isFirst = true;
  ForEachLeaf(
    tree,
    [&]
    {
      surface += isFirst ? 0 : 1;
      isFirst = false;
      piece = 0;
    },
    [&](vtkDataObjectTree* parent, vtkDataObjectTreeIterator* leaf)
    {
      vtkPolyData* mesh = surface->Leaves[piece];
      auto faces = vtkPolyData::SafeDownCast(surface->Pieces->GetPartitionAsDataObject(piece));
      if (mesh && faces)
      {
        AddVerticesAndLines(faces, mesh);
        KeepPointIds(faces, mesh);
        parent->SetDataSet(leaf, faces);
      }
      ++piece;
    });
}
}

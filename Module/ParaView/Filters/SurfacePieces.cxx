// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePieces.h"

#include "Arrays/GhostCells.h"
#include "FaceOrder.h"
#include "GhostFaces.h"
#include "SharedFaces.h"
#include "SurfaceLeaves.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleStrip.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace relevo
{
namespace
{
bool HasArraysOfLength(vtkFieldData* data, vtkIdType length)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() < length)
    {
      return false;
    }
  }
  return true;
}

vtkIdType CountCellsBeforeFaces(vtkPolyData* mesh)
{
  return mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
}

// The faces of a mesh to leave out.
struct LeftOutFaces
{
  LeftOutFaces(vtkPolyData* mesh, bool ghosts, bool notFinite)
    : Mesh(mesh)
    , Ghosts(mesh)
    , HasGhosts(ghosts && this->Ghosts.AreAmong(0, mesh->GetNumberOfCells()))
    , HasNotFinite(notFinite && this->HasPointThatIsNotFinite())
  {
  }

  bool Has(vtkIdType cell, vtkIdType size, const vtkIdType* points) const
  {
    return (this->HasGhosts && this->Ghosts.Has(cell)) ||
      (this->HasNotFinite && !IsFinite(this->Mesh, size, points));
  }

  vtkPolyData* Mesh;
  GhostCells Ghosts;
  bool HasGhosts;
  bool HasNotFinite;

private:
  bool HasPointThatIsNotFinite() const
  {
    for (vtkIdType point = 0; point < this->Mesh->GetNumberOfPoints(); ++point)
    {
      if (!IsFinite(this->Mesh, 1, &point))
      {
        return true;
      }
    }
    return false;
  }
};

// Return the faces of a mesh as polygons, with all points.
vtkSmartPointer<vtkPolyData> ExtractFaces(vtkPolyData* mesh, const LeftOutFaces& leftOut)
{
  auto faces = vtkSmartPointer<vtkPolyData>::New();
  faces->ShallowCopy(mesh);
  const vtkIdType first = CountCellsBeforeFaces(mesh);
  if (first + mesh->GetNumberOfStrips() == 0 && !leftOut.HasGhosts && !leftOut.HasNotFinite)
  {
    return faces;
  }
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> cells; // cell of the mesh for each polygon
  const auto add = [&](vtkIdType cell, vtkCellArrayIterator* iterator)
  {
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    if (!leftOut.Has(cell, size, ids))
    {
      polygons->InsertNextCell(size, ids);
      cells->InsertNextId(cell);
    }
  };
  vtkIdType cell = first;
  auto polys = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell(), ++cell)
  {
    add(cell, polys);
  }
  auto strips = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    strips->GetCurrentCell(size, ids);
    vtkNew<vtkCellArray> ofStrip;
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(size), ids, ofStrip);
    auto triangles = vtk::TakeSmartPointer(ofStrip->NewIterator());
    for (triangles->GoToFirstCell(); !triangles->IsDoneWithTraversal(); triangles->GoToNextCell())
    {
      add(cell, triangles);
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

// Add vertices and lines of a mesh to the faces that were extracted from it.
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

// The pieces of one surface, and their leaves in the tree.
struct SplitSurface
{
  std::vector<vtkSmartPointer<vtkPolyData>> Pieces; // the faces of the leaves
  std::vector<vtkPolyData*> Leaves;                 // nullptr for nothing to exchange

  void AddLeaf(vtkPolyData* mesh)
  {
    // The mapper gets invalid meshes unchanged, and reports the error.
    this->Leaves.push_back(mesh && IsSound(mesh) ? mesh : nullptr);
  }

  void ExtractPieces(bool leaveOutGhosts, bool leaveOutNotFinite)
  {
    std::transform(this->Leaves.begin(), this->Leaves.end(), std::back_inserter(this->Pieces),
      [=](vtkPolyData* mesh)
      {
        return mesh ? ExtractFaces(mesh, LeftOutFaces(mesh, leaveOutGhosts, leaveOutNotFinite))
                    : vtkSmartPointer<vtkPolyData>::New();
      });
  }
};

// Values at the border depend on the normals and curvatures of the points around it, and these on
// the faces around those points. Hence two layers are needed.
constexpr int NumberOfLayers = 2;

// Add the modification times and addresses of all parts of a mesh.
void AddTimes(vtkPolyData* mesh, std::vector<vtkMTimeType>& times)
{
  const auto add = [&times](vtkObject* object)
  {
    times.push_back(reinterpret_cast<std::size_t>(object));
    times.push_back(object ? object->GetMTime() : 0);
  };
  add(mesh->GetPoints());
  for (vtkObject* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    add(cells);
  }
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      add(data->GetAbstractArray(i));
    }
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      times.push_back(reinterpret_cast<std::size_t>(data->GetAbstractAttribute(type)));
    }
  }
}
}

bool IsSound(vtkPolyData* mesh)
{
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    double range[2] = { 0.0, -1.0 };
    if (cells->GetNumberOfConnectivityIds() > 0)
    {
      cells->GetConnectivityArray()->GetRange(range);
    }
    if (range[0] < 0.0 || range[1] >= static_cast<double>(mesh->GetNumberOfPoints()))
    {
      return false;
    }
  }
  return HasArraysOfLength(mesh->GetPointData(), mesh->GetNumberOfPoints()) &&
    HasArraysOfLength(mesh->GetCellData(), mesh->GetNumberOfCells());
}

// Return whether the surfaces differ from the last call.
bool SurfacePieces::FindOwn(vtkDataObjectTree* tree)
{
  Leaves own;
  std::vector<vtkMTimeType> times;
  ForEachLeaf(tree,
    [&](vtkDataObjectTree*, vtkDataObjectTreeIterator* leaf)
    {
      auto mesh = vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject());
      // If the tree has not been recreated, it contains the replaced surfaces.
      const std::size_t i = own.size();
      const bool isMade = mesh && i < this->Made.size() && this->Made[i] == mesh;
      own.emplace_back(isMade ? this->Own[i].Get() : mesh);
      times.push_back(own.size());
      if (own.back())
      {
        AddTimes(own.back(), times);
      }
    });
  const bool changed = times != this->OwnTimes || own.size() != this->Made.size();
  this->Own = own;
  this->OwnTimes = times;
  return changed;
}

void SurfacePieces::Make(vtkDataObjectTree* tree, vtkMultiProcessController* controller)
{
  std::vector<SplitSurface> surfaces;
  auto own = this->Own.begin();
  ForEachLeaf(
    tree, [&] { surfaces.emplace_back(); },
    [&](vtkDataObjectTree*, vtkDataObjectTreeIterator*) { surfaces.back().AddLeaf(*own++); });
  if (controller)
  {
    // Processes whose trees differ still take part in all exchanges.
    const int number = static_cast<int>(surfaces.size());
    int most = number;
    controller->AllReduce(&number, &most, 1, vtkCommunicator::MAX_OP);
    surfaces.resize(static_cast<std::size_t>(most));
  }
  if (this->IsChecked)
  {
    std::vector<PieceCheck::Leaves> leaves;
    std::transform(surfaces.begin(), surfaces.end(), std::back_inserter(leaves),
      [](const SplitSurface& surface) { return surface.Leaves; });
    this->Check.Update(tree, leaves, controller);
  }
  this->Made.clear();
  for (SplitSurface& surface : surfaces)
  {
    const std::size_t leaves = surface.Leaves.size();
    const bool isExchanged = controller || leaves > 1;
    surface.ExtractPieces(isExchanged, this->IsChecked);
    if (this->AreSharedFacesRemoved)
    {
      RemoveSharedFaces(surface.Pieces, controller);
    }
    std::vector<vtkIdType> ownPoints;
    for (vtkPolyData* piece : surface.Pieces)
    {
      ownPoints.push_back(piece->GetNumberOfPoints());
    }
    if (isExchanged)
    {
      AddGhostFaces(surface.Pieces, NumberOfLayers, controller);
    }
    for (std::size_t i = 0; i < leaves; ++i)
    {
      vtkPolyData* mesh = surface.Leaves[i];
      vtkPolyData* faces = surface.Pieces[i];
      if (mesh)
      {
        AddVerticesAndLines(faces, mesh);
        SortByPosition(faces, ownPoints[i]);
      }
      this->Made.emplace_back(mesh ? faces : nullptr);
    }
  }
}

void SurfacePieces::Update(vtkDataObjectTree* tree, vtkMultiProcessController* controller)
{
  if (controller && controller->GetNumberOfProcesses() < 2)
  {
    controller = nullptr;
  }
  const int own = this->FindOwn(tree) ? 1 : 0;
  int changed = own;
  if (controller)
  {
    controller->AllReduce(&own, &changed, 1, vtkCommunicator::MAX_OP);
  }
  if (changed != 0)
  {
    this->Make(tree, controller);
  }
  auto made = this->Made.begin();
  ForEachLeaf(tree,
    [&](vtkDataObjectTree* parent, vtkDataObjectTreeIterator* leaf)
    {
      if (*made && leaf->GetCurrentDataObject() != *made)
      {
        parent->SetDataSet(leaf, *made);
      }
      ++made;
    });
}
}

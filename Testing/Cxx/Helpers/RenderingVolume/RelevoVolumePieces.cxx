// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoVolumePieces.h"

#include "RelevoDice.h"
#include "Segments/SegmentMerger.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{
using Cells = std::vector<vtkIdType>;

using Chooser = std::function<int(const RelevoPoint&)>;

// Return a number from 0 to 1 across the mesh.
double FindSlab(const RelevoPoint& center, const double bounds[6])
{
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    sum += (center[c] - bounds[2 * c]) / (bounds[2 * c + 1] - bounds[2 * c]) / 3.0;
  }
  return sum;
}

int FindNearest(const RelevoPoint& center, const std::vector<RelevoPoint>& seeds)
{
  const auto getDistance = [&](const RelevoPoint& seed)
  { return std::hypot(seed[0] - center[0], seed[1] - center[1], seed[2] - center[2]); };
  const auto nearest = std::min_element(seeds.begin(), seeds.end(),
    [&](const RelevoPoint& a, const RelevoPoint& b) { return getDistance(a) < getDistance(b); });
  return static_cast<int>(nearest - seeds.begin());
}

std::vector<RelevoPoint> MakeSeeds(const double bounds[6], int count)
{
  RelevoDice dice(static_cast<unsigned int>(17 + count));
  std::vector<RelevoPoint> seeds;
  for (int i = 0; i < count; ++i)
  {
    RelevoPoint seed;
    for (int c = 0; c < 3; ++c)
    {
      seed[c] = bounds[2 * c] + dice.Share() * (bounds[2 * c + 1] - bounds[2 * c]);
    }
    seeds.push_back(seed);
  }
  return seeds;
}

std::vector<Cells> ChooseCells(vtkUnstructuredGrid* mesh, const Chooser& choose, int count)
{
  std::vector<Cells> chosen(static_cast<size_t>(count));
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    double box[6];
    mesh->GetCellBounds(cell, box);
    const int piece =
      choose({ { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]) } });
    chosen[static_cast<size_t>(piece)].push_back(cell);
  }
  return chosen;
}

std::vector<Cells> ChooseCells(vtkUnstructuredGrid* mesh, RelevoDealing dealing, int count)
{
  const double* bounds = mesh->GetBounds();
  if (dealing == RelevoDealing::Slabs)
  {
    return ChooseCells(
      mesh,
      [=](const RelevoPoint& center)
      { return std::min(static_cast<int>(count * FindSlab(center, bounds)), count - 1); },
      count);
  }
  if (dealing == RelevoDealing::Blobs)
  {
    const std::vector<RelevoPoint> seeds = MakeSeeds(bounds, count);
    return ChooseCells(
      mesh, [&](const RelevoPoint& center) { return FindNearest(center, seeds); }, count);
  }
  RelevoDice dice(static_cast<unsigned int>(count));
  const bool isAwkward = dealing == RelevoDealing::Awkward;
  std::vector<Cells> chosen = ChooseCells(
    mesh, [&](const RelevoPoint&) { return dice.Throw(isAwkward ? count - 2 : count); }, count);
  if (isAwkward)
  {
    chosen[static_cast<size_t>(count) - 2].push_back(chosen.front().back());
    chosen.front().pop_back();
  }
  return chosen;
}

// Points and cells are in reverse order, with points as the cells need them.
vtkSmartPointer<vtkUnstructuredGrid> CopyCells(vtkUnstructuredGrid* mesh, const Cells& cells)
{
  auto piece = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  piece->SetPoints(points);
  piece->Allocate(static_cast<vtkIdType>(cells.size()));
  piece->GetPointData()->CopyAllocate(mesh->GetPointData());
  piece->GetCellData()->CopyAllocate(mesh->GetCellData());
  std::map<vtkIdType, vtkIdType> copied;
  vtkNew<vtkIdList> ids;
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell)
  {
    mesh->GetCellPoints(*cell, ids);
    for (vtkIdType i = ids->GetNumberOfIds() - 1; i >= 0; --i)
    {
      const vtkIdType id = ids->GetId(i);
      const auto found = copied.emplace(id, points->GetNumberOfPoints());
      if (found.second)
      {
        points->InsertNextPoint(mesh->GetPoint(id));
        piece->GetPointData()->CopyData(mesh->GetPointData(), id, found.first->second);
      }
      ids->SetId(i, found.first->second);
    }
    const vtkIdType added = piece->InsertNextCell(mesh->GetCellType(*cell), ids);
    piece->GetCellData()->CopyData(mesh->GetCellData(), *cell, added);
  }
  return piece;
}

std::vector<vtkSmartPointer<vtkUnstructuredGrid>> CopyPieces(
  vtkUnstructuredGrid* mesh, const std::vector<Cells>& pieces)
{
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> copies;
  for (const Cells& cells : pieces)
  {
    copies.push_back(CopyCells(mesh, cells));
  }
  return copies;
}

// Return the other cells that share a point with these.
Cells FindGhosts(vtkUnstructuredGrid* mesh, const Cells& cells)
{
  const std::set<vtkIdType> own(cells.begin(), cells.end());
  std::set<vtkIdType> points;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell : cells)
  {
    mesh->GetCellPoints(cell, ids);
    points.insert(ids->begin(), ids->end());
  }
  Cells ghosts;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    const bool isNear =
      std::any_of(ids->begin(), ids->end(), [&](vtkIdType id) { return points.count(id) > 0; });
    if (isNear && own.count(cell) == 0)
    {
      ghosts.push_back(cell);
    }
  }
  return ghosts;
}

class MixedCells
{
public:
  MixedCells(int n, const RelevoField& field)
    : Size(n)
    , Field(field)
  {
    this->Scalars->SetName("field");
    RelevoDice dice(5);
    for (int i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
    {
      RelevoPoint at;
      for (int c = 0, rest = i; c < 3; ++c, rest /= n + 1)
      {
        at[c] = (rest % (n + 1) + 0.2 * dice.Signed()) / n;
      }
      this->AddPoint(at);
    }
    this->Mesh->SetPoints(this->Points);
    this->Mesh->GetPointData()->SetScalars(this->Scalars);
    this->Mesh->Allocate(n * n * n);
    for (int i = 0; i < n * n * n; ++i)
    {
      this->AddCube(i % n, i / n % n, i / n / n);
    }
  }
  vtkSmartPointer<vtkUnstructuredGrid> GetMesh() const { return this->Mesh; }

private:
  vtkIdType AddPoint(const RelevoPoint& at)
  {
    this->Scalars->InsertNextValue(this->Field(at));
    return this->Points->InsertNextPoint(at.data());
  }
  void Add(int type, const std::vector<vtkIdType>& ids)
  {
    this->Mesh->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  }
  // The kind of cells is the same in a column, so that all faces match.
  void AddCube(int x, int y, int z)
  {
    const int n = this->Size + 1;
    const vtkIdType a = x + n * (y + n * z);
    const vtkIdType b = a + n * n;
    const std::vector<vtkIdType> p = { a, a + 1, a + n + 1, a + n, b, b + 1, b + n + 1, b + n };
    const int kind = (x + 2 * y) % 3;
    if (kind == 0)
    {
      this->Add(VTK_HEXAHEDRON, p);
    }
    else if (kind == 1)
    {
      this->Add(VTK_WEDGE, { p[0], p[2], p[1], p[4], p[6], p[5] });
      this->Add(VTK_WEDGE, { p[0], p[3], p[2], p[4], p[7], p[6] });
    }
    else
    {
      RelevoPoint middle = { { 0.0, 0.0, 0.0 } };
      for (vtkIdType id : p)
      {
        for (int c = 0; c < 3; ++c)
        {
          middle[c] += 0.125 * this->Points->GetPoint(id)[c];
        }
      }
      const vtkIdType apex = this->AddPoint(middle);
      const int faces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
        { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
      for (const int* f : faces)
      {
        this->Add(VTK_PYRAMID, { p[f[3]], p[f[2]], p[f[1]], p[f[0]], apex });
      }
    }
  }

  const int Size;
  const RelevoField& Field;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Scalars;
  vtkNew<vtkUnstructuredGrid> Mesh;
};
}

vtkSmartPointer<vtkUnstructuredGrid> MakeMixedCells(int n, const RelevoField& field)
{
  return MixedCells(n, field).GetMesh();
}

std::vector<vtkSmartPointer<vtkUnstructuredGrid>> DealCells(
  vtkUnstructuredGrid* mesh, RelevoDealing dealing, int numberOfPieces)
{
  return CopyPieces(mesh, ChooseCells(mesh, dealing, numberOfPieces));
}

std::vector<vtkSmartPointer<vtkUnstructuredGrid>> DealCells(
  vtkUnstructuredGrid* mesh, const Chooser& choose, int numberOfPieces)
{
  return CopyPieces(mesh, ChooseCells(mesh, choose, numberOfPieces));
}

std::vector<vtkSmartPointer<vtkUnstructuredGrid>> DealCellsWithGhosts(
  vtkUnstructuredGrid* mesh, RelevoDealing dealing, int numberOfPieces)
{
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> pieces;
  for (const Cells& own : ChooseCells(mesh, dealing, numberOfPieces))
  {
    const Cells ghosts = FindGhosts(mesh, own);
    Cells all = own;
    all.insert(all.end(), ghosts.begin(), ghosts.end());
    const auto piece = CopyCells(mesh, all);
    vtkUnsignedCharArray* flags = piece->AllocateCellGhostArray();
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(ghosts.size()); ++i)
    {
      flags->SetValue(i, vtkDataSetAttributes::DUPLICATECELL); // the order is reversed
    }
    pieces.push_back(piece);
  }
  return pieces;
}

RelevoVolumePieces::RelevoVolumePieces(
  RelevoVolumeScene& scene, const std::vector<vtkSmartPointer<vtkUnstructuredGrid>>& pieces)
  : Scene(scene)
{
  vtkGPUUnstructuredGridVolumeMapper* from = scene.GetMapper();
  for (vtkUnstructuredGrid* piece : pieces)
  {
    auto mapper = vtkSmartPointer<vtkGPUUnstructuredGridVolumeMapper>::New();
    mapper->SetInputDataObject(piece);
    mapper->SetScalarMode(from->GetScalarMode());
    mapper->SetVectorMode(from->GetVectorMode());
    mapper->SetBlendMode(from->GetBlendMode());
    mapper->SetIsoSurfaces(from->GetIsoSurfaces());
    mapper->SetIntegration(from->GetIntegration());
    mapper->SetMaximumSegments(from->GetMaximumSegments());
    mapper->SetClippingPlanes(from->GetClippingPlanes());
    this->Mappers.push_back(mapper);
  }
  this->Segments.resize(pieces.size());
}

relevo::MeshExtent RelevoVolumePieces::Measure()
{
  relevo::MeshExtent whole;
  for (vtkGPUUnstructuredGridVolumeMapper* mapper : this->Mappers)
  {
    whole.Add(mapper->MeasurePiece(this->Scene.GetRenderer(), this->Scene.GetVolume()));
  }
  return whole;
}

void RelevoVolumePieces::Cast()
{
  vtkVolume* volume = this->Scene.GetVolume();
  const bool isVisible = volume->GetVisibility() != 0;
  volume->VisibilityOff();
  this->Background = this->Scene.Draw();
  const int* size = this->Scene.GetWindow()->GetSize();
  vtkNew<vtkFloatArray> depths;
  this->Scene.GetWindow()->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths);
  volume->SetVisibility(isVisible);
  this->Request.Depths.assign(depths->Begin(), depths->End());
  this->Request.Whole = this->Measure();
  for (size_t i = 0; i < this->Mappers.size(); ++i)
  {
    this->Mappers[i]->CastSegments(
      this->Scene.GetRenderer(), volume, this->Request, this->Segments[i]);
  }
}

std::vector<RelevoColor> RelevoVolumePieces::Merge(bool arePacked)
{
  std::vector<relevo::RaySegments> received(this->Segments.size());
  std::vector<const relevo::RaySegments*> pieces;
  for (size_t i = 0; i < this->Segments.size(); ++i)
  {
    if (arePacked)
    {
      received[i].Unpack(this->Segments[i].Pack());
    }
    pieces.push_back(arePacked ? &received[i] : &this->Segments[i]);
  }
  relevo::TransferFunctions functions;
  std::string error;
  std::string warning;
  functions.Read(
    this->Scene.GetVolume()->GetProperty(), this->Request.Whole.NumberOfComponents, error, warning);
  const std::vector<float> colors =
    relevo::MapSegments(relevo::MergeSegments(pieces), functions, this->Request.Whole);
  std::vector<RelevoColor> picture = this->Background;
  for (size_t i = 0; i < picture.size() && 4 * i < colors.size(); ++i)
  {
    for (size_t c = 0; c < 3; ++c)
    {
      const double color = colors[4 * i + c] + (1.0 - colors[4 * i + 3]) * picture[i][c];
      picture[i][c] = std::round(255.0 * std::min(color, 1.0)) / 255.0;
    }
  }
  return picture;
}

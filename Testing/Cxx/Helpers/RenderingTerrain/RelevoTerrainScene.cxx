// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoTerrainScene.h"

#include "Bisection/FaceHeights.h"
#include "View/TerrainViewpoint.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

using relevo::HeightTile;
using relevo::TerrainFace;

RelevoTerrainRaster::RelevoTerrainRaster(int columns, int rows, const Function& height)
  : Columns(columns)
  , Rows(rows)
  , Height(height)
{
}

float RelevoTerrainRaster::GetSample(std::int64_t column, std::int64_t row) const
{
  return this->Height(static_cast<int>(std::clamp<std::int64_t>(column, 0, this->Columns - 1)),
    static_cast<int>(std::clamp<std::int64_t>(row, 0, this->Rows - 1)));
}

const HeightTile* RelevoTerrainRaster::Get(
  int level, int column, int row, double, float& visibility)
{
  visibility = 1.0f;
  HeightTile& tile = this->Tiles[{ level, column, row }];
  if (tile.Heights.empty())
  {
    tile.Level = level;
    tile.Column = column;
    tile.Row = row;
    for (int j = -1; j < HeightTile::Stride - 1; ++j)
    {
      for (int i = -1; i < HeightTile::Stride - 1; ++i)
      {
        const std::int64_t x = static_cast<std::int64_t>(HeightTile::CellsPerTile) * column + i;
        const std::int64_t y = static_cast<std::int64_t>(HeightTile::CellsPerTile) * row + j;
        tile.Heights.push_back(
          this->GetSample(x * (std::int64_t(1) << level), y * (std::int64_t(1) << level)));
      }
    }
  }
  return &tile;
}

float RelevoHills(int column, int row)
{
  double height = 0.0;
  double size = 20.0;
  double length = 60.0;
  double along = column;
  double across = row;
  for (int i = 0; i < 6; ++i)
  {
    height += size * std::sin(along / length + i) * std::cos(across / length - 2.0 * i);
    size *= 0.4;
    length *= 0.5;
    const double turned = 0.8 * along - 0.6 * across;
    across = 0.6 * along + 0.8 * across;
    along = turned;
  }
  return static_cast<float>(height);
}

vtkStandardNewMacro(RelevoTerrainMapper);

// There is no input.
int RelevoTerrainMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

void RelevoTerrainMapper::SetRaster(const std::shared_ptr<RelevoTerrainRaster>& raster,
  const relevo::ElevationRanges::Range& range, float errorOfLevel0)
{
  this->Raster = raster;
  this->Ranges = relevo::ElevationRanges(range);
  this->Errors = relevo::BlockErrors::Estimate(
    relevo::BlockErrors::GetRootLevel(raster->Columns, raster->Rows), errorOfLevel0);
  this->Bisection.reset(
    new relevo::TerrainBisection(raster->Columns, raster->Rows, this->Errors, this->Ranges));
  this->Settings.Dimensions = { { raster->Columns, raster->Rows } };
}

void RelevoTerrainMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  const relevo::TerrainViewpoint viewpoint(renderer, actor);
  this->Bisection->Select(
    viewpoint.MakeView(this->Settings.Placement), this->Tolerance, *this->Raster);
  this->Painter->SetClippingPlanes(this->ClippingPlanes);
  this->Error =
    this->Painter->Prepare(renderer, actor, this->GetFaces(), this->Shading, this->Settings);
  if (!this->Error.empty())
  {
    return;
  }
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    selector->BeginRenderProp();
    this->Painter->AnnounceIds(selector);
    if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
    {
      selector->RenderCompositeIndex(1);
    }
  }
  this->Painter->RenderPiece(renderer, actor);
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    selector->EndRenderProp();
  }
}

void RelevoTerrainMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Painter->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

double* RelevoTerrainMapper::GetBounds()
{
  const auto heights = this->Ranges.Get(0, { { 0.0, 1e9 } }, { { 0.0, 1e9 } });
  vtkMath::UninitializeBounds(this->Bounds);
  for (int i = 0; i < 8; ++i)
  {
    const auto corner = this->Settings.Placement.ToWorld((i & 1) * (this->Raster->Columns - 1),
      (i >> 1 & 1) * (this->Raster->Rows - 1), heights[i >> 2 & 1]);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Bounds[2 * axis] =
        i == 0 ? corner[axis] : std::min(this->Bounds[2 * axis], corner[axis]);
      this->Bounds[2 * axis + 1] =
        i == 0 ? corner[axis] : std::max(this->Bounds[2 * axis + 1], corner[axis]);
    }
  }
  return this->Bounds;
}

vtkSmartPointer<vtkPolyData> RelevoTerrainMapper::MakeTriangles() const
{
  constexpr int segments = TerrainFace::Segments;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Face");
  vtkNew<vtkFloatArray> values;
  values->SetName("Height");
  vtkIdType index = 0;
  for (const TerrainFace& face : this->GetFaces())
  {
    const relevo::FaceHeights heights(face);
    vtkIdType vertices[segments + 2][segments + 2];
    for (int b = 0; b <= segments; ++b)
    {
      for (int a = 0; a <= segments - b; ++a)
      {
        const float height = heights.GetHeight(a, b);
        const auto place = this->Settings.Placement.ToWorld(
          std::ldexp(
            static_cast<double>(face.Apex[0] + a * face.Step1[0] + b * face.Step2[0]), face.Level),
          std::ldexp(
            static_cast<double>(face.Apex[1] + a * face.Step1[1] + b * face.Step2[1]), face.Level),
          static_cast<double>(height));
        vertices[a][b] = std::isnan(height) ? -1 : points->InsertNextPoint(place.data());
        if (!std::isnan(height))
        {
          values->InsertNextValue(height);
        }
      }
    }
    const bool isUp = face.IsPositive() ==
      (this->Settings.Placement.Column[0] * this->Settings.Placement.Row[1] -
          this->Settings.Placement.Column[1] * this->Settings.Placement.Row[0] >
        0.0);
    const auto add = [&](vtkIdType i, vtkIdType j, vtkIdType k)
    {
      if (i >= 0 && j >= 0 && k >= 0)
      {
        triangles->InsertNextCell({ i, isUp ? j : k, isUp ? k : j });
        ids->InsertNextValue(index);
      }
    };
    for (const auto& [a, b, c] : TerrainFace::GetPattern())
    {
      add(vertices[a[0]][a[1]], vertices[b[0]][b[1]], vertices[c[0]][c[1]]);
    }
    ++index;
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(triangles);
  result->GetPointData()->SetScalars(values);
  result->GetCellData()->AddArray(ids);
  return result;
}

RelevoTerrainScene::RelevoTerrainScene(
  int columns, int rows, const RelevoTerrainRaster::Function& height, float errorOfLevel0)
{
  this->Mapper->SetRaster(std::make_shared<RelevoTerrainRaster>(columns, rows, height),
    { { -40.0f, 40.0f } }, errorOfLevel0);
  this->Actor->SetMapper(this->Mapper);
  this->Renderer->AddActor(this->Actor);
  this->Renderer->SetBackground(0.0, 0.0, 0.0);
  this->Window->AddRenderer(this->Renderer);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(400, 300);
}

RelevoPicture RelevoTerrainScene::Draw()
{
  this->Window->Render();
  return RelevoPicture(this->Window);
}

RelevoPicture RelevoTerrainScene::DrawTwin(vtkScalarsToColors* heightColors)
{
  vtkNew<vtkPolyDataMapper> twin;
  twin->SetInputData(this->Mapper->MakeTriangles());
  twin->SetScalarVisibility(heightColors != nullptr);
  if (heightColors)
  {
    twin->SetLookupTable(heightColors);
    twin->UseLookupTableScalarRangeOn();
    twin->InterpolateScalarsBeforeMappingOn();
  }
  twin->SetClippingPlanes(this->Mapper->GetClippingPlanes());
  this->Actor->SetMapper(twin);
  this->Window->Render();
  const RelevoPicture picture(this->Window);
  this->Actor->SetMapper(this->Mapper);
  return picture;
}

std::vector<vtkIdType> RelevoTerrainScene::SelectCells()
{
  const int* size = this->Window->GetSize();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(this->Renderer);
  selector->SetArea(0, 0, size[0] - 1, size[1] - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->CaptureBuffers();
  std::vector<vtkIdType> ids;
  for (unsigned int y = 0; y < static_cast<unsigned int>(size[1]); ++y)
  {
    for (unsigned int x = 0; x < static_cast<unsigned int>(size[0]); ++x)
    {
      const unsigned int position[2] = { x, y };
      const auto pixel = selector->GetPixelInformation(position);
      ids.push_back(pixel.Valid && pixel.Prop == this->Actor ? pixel.AttributeID : -1);
    }
  }
  return ids;
}

std::vector<vtkIdType> RelevoTerrainScene::SelectFaces()
{
  return this->SelectCells();
}

std::vector<vtkIdType> RelevoTerrainScene::SelectFacesOfTwin()
{
  vtkNew<vtkPolyDataMapper> twin;
  auto triangles = this->Mapper->MakeTriangles();
  auto* faces = vtkIdTypeArray::SafeDownCast(triangles->GetCellData()->GetArray("Face"));
  twin->SetInputData(triangles);
  this->Actor->SetMapper(twin);
  std::vector<vtkIdType> ids = this->SelectCells();
  this->Actor->SetMapper(this->Mapper);
  std::transform(ids.begin(), ids.end(), ids.begin(),
    [faces](vtkIdType id) { return id < 0 ? id : faces->GetValue(id); });
  return ids;
}

void RelevoTerrainScene::Look(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  const relevo::TerrainPlacement& placement = this->Mapper->Settings.Placement;
  const auto eye = placement.ToWorld(from[0], from[1], from[2]);
  const auto target = placement.ToWorld(to[0], to[1], to[2]);
  this->GetCamera()->SetPosition(eye.data());
  this->GetCamera()->SetFocalPoint(target.data());
  this->GetCamera()->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCameraClippingRange();
}

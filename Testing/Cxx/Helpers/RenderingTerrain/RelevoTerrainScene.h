// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Bisected terrains of a given function, drawn by the painter of terrains, and the same triangles
// as polydata.
#ifndef RelevoTerrainScene_h
#define RelevoTerrainScene_h

#include "RelevoScene.h"

#include "Bisection/HeightTileSource.h"
#include "Bisection/TerrainBisection.h"
#include "Drawing/TerrainPainter.h"
#include "Lattice/BlockErrors.h"
#include "Lattice/ElevationRanges.h"
#include "vtkMapper.h"

#include <functional>
#include <map>
#include <memory>
#include <tuple>

// A raster whose samples are a function of column and row. The lattices of all levels have samples
// of it.
class RelevoTerrainRaster : public relevo::HeightTileSource
{
public:
  using Function = std::function<float(int column, int row)>;

  RelevoTerrainRaster(int columns, int rows, const Function& height);
  const relevo::HeightTile* Get(
    int level, int column, int row, double error, float& visibility) override;
  // The height of the sample; those of the border continue beyond it.
  float GetSample(std::int64_t column, std::int64_t row) const;

  const int Columns;
  const int Rows;

private:
  Function Height;
  std::map<std::tuple<int, int, int>, relevo::HeightTile> Tiles;
};

// Hills of all sizes, from -40 to 40.
float RelevoHills(int column, int row);

class RelevoTerrainMapper : public vtkMapper
{
public:
  static RelevoTerrainMapper* New();
  vtkTypeMacro(RelevoTerrainMapper, vtkMapper);

  // The range contains all heights. The error of the squares of level 0 defines the other errors.
  void SetRaster(const std::shared_ptr<RelevoTerrainRaster>& raster,
    const relevo::ElevationRanges::Range& range, float errorOfLevel0);

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  bool GetSupportsSelection() override { return true; }

  const std::vector<relevo::TerrainFace>& GetFaces() const { return this->Bisection->GetFaces(); }
  // The triangles of the faces, without those that lack data. Point data are the heights, cell data
  // the indices of faces.
  vtkSmartPointer<vtkPolyData> MakeTriangles() const;

  relevo::TerrainPainter::Settings Settings;
  std::vector<relevo::MipmapTiles::Item> Shading;
  double Tolerance = 1.0;
  std::string Error;
  vtkNew<relevo::TerrainPainter> Painter;

protected:
  RelevoTerrainMapper() = default;
  ~RelevoTerrainMapper() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  std::shared_ptr<RelevoTerrainRaster> Raster;
  relevo::ElevationRanges Ranges;
  relevo::BlockErrors Errors;
  std::unique_ptr<relevo::TerrainBisection> Bisection;
};

// A black window without multisampling.
class RelevoTerrainScene
{
public:
  explicit RelevoTerrainScene(int columns = 513, int rows = 513,
    const RelevoTerrainRaster::Function& height = RelevoHills, float errorOfLevel0 = 0.1f);

  RelevoPicture Draw();
  // The triangles of the last picture, drawn by vtkPolyDataMapper.
  RelevoPicture DrawTwin(vtkScalarsToColors* heightColors = nullptr);
  // The face at each pixel, from a hardware selection of cells; -1 for the background.
  std::vector<vtkIdType> SelectFaces();
  std::vector<vtkIdType> SelectFacesOfTwin();

  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }
  vtkProperty* GetProperty() { return this->Actor->GetProperty(); }
  // Looks from a column, row and height to others.
  void Look(const std::array<double, 3>& from, const std::array<double, 3>& to);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<RelevoTerrainMapper> Mapper;

private:
  std::vector<vtkIdType> SelectCells();
};

#endif

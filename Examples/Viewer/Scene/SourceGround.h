// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SourceGround
 * @brief   the ground of a terrain mesh that is refined by levels
 */
#ifndef SourceGround_h
#define SourceGround_h

#include "Scene/TerrainGround.h"
#include "Scene/TerrainProbe.h"

#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkTerrainSource;

class SourceGround : public TerrainGround
{
public:
  /// Takes a source that has been updated, and its mesh.
  SourceGround(vtkTerrainSource* source, vtkPolyData* mesh);
  ~SourceGround() override;

  /// Sets the levels at one of which the ground near the camera is drawn.
  void SetLevels(int lowest, int highest);

  bool GetHeight(double x, double y, double& height) override;
  double GetZ(double height) override;
  bool GetHighestGround(double x, double y, double spacing, double& z) override;
  void MoveOnto(double place[2]) override;
  std::array<double, 4> GetExtent() override;
  bool HasCoordinateSystem() override;
  bool IsGeographic() override;
  double GetVerticalUnit() override;
  bool ToRaster(const double place[2], double coordinates[2]) override;
  bool FromRaster(const double coordinates[2], double place[2]) override;
  bool FromDegrees(const double degrees[2], double place[2]) override;
  bool ToDegrees(const double place[2], double degrees[2]) override;

private:
  vtkSmartPointer<vtkTerrainSource> Source;
  vtkSmartPointer<vtkPolyData> Mesh;
  TerrainProbe Probe;
  int LowestLevel = 0;
  int HighestLevel = 0;
};

#endif

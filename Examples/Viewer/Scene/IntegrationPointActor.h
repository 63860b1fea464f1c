// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   IntegrationPointActor
 * @brief   spheres at integration points of cells
 */
#ifndef IntegrationPointActor_h
#define IntegrationPointActor_h

#include "vtkNew.h"

#include <string>

class vtkActor;
class vtkDataSet;
class vtkGlyph3DMapper;
class vtkPlane;
class vtkPolyData;
class vtkRenderer;
class vtkScalarsToColors;
class vtkSphereSource;

class IntegrationPointActor
{
public:
  /// Adds the spheres to a renderer.
  explicit IntegrationPointActor(vtkRenderer* renderer);
  ~IntegrationPointActor();

  /// Shows these points of a mesh, which determines the size of the spheres.
  void SetPoints(vtkPolyData* points, vtkDataSet* mesh);

  /// Shows only points on the positive side of a plane; nullptr shows all.
  void Cut(vtkPlane* plane);

  /// Colours the spheres by a point array.
  void SetColours(const std::string& array, vtkScalarsToColors* table);

private:
  vtkNew<vtkPolyData> Points;
  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkGlyph3DMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

#endif

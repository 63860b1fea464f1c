// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContactScene
 * @brief   two meshes and their intersection
 */
#ifndef ContactScene_h
#define ContactScene_h

#include "Scene/ViewerScene.h"

#include "vtkSmartPointer.h"
#include "vtkSurfaceIntersectionFilter.h"

class vtkAdaptiveRefinement;
class vtkPolyData;
class vtkMapper;

class ContactScene : public ViewerScene
{
public:
  /// Reads the files and intersects them. Throws ViewerError.
  ContactScene(const ViewerOptions& options, ViewerMessages& messages);
  ~ContactScene() override;

  /// Prints the results on stdout.
  void Report() override;
  std::string Describe(const double[3], double) override { return ""; }
  void Draw(vtkRenderWindow* window) override;

private:
  void AddDataCode(SceneCode& code) override;
  void ReadMeshes();
  /// For curved cells, the curved surfaces are intersected.
  void RefineCurvedMeshes();
  void AddMeshes();
  vtkSmartPointer<vtkMapper> MakeMapper(int mesh);
  void AddCurves(double radius);

  vtkNew<vtkSurfaceIntersectionFilter> Filter;
  vtkSmartPointer<vtkPolyData> Meshes[2];
  vtkSmartPointer<vtkAdaptiveRefinement> Recipes[2]; // for curved cells, otherwise nullptr
};

#endif

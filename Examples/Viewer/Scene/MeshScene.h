// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshScene
 * @brief   a mesh on a curved surface, moved by a height map, in the colours of an array or a
 * picture
 */
#ifndef MeshScene_h
#define MeshScene_h

#include "Scene/SurfaceScene.h"

#include "vtkSmartPointer.h"

#include <string>

class MeshProbe;
class vtkDataArray;
class vtkDisplacement;

class MeshScene : public SurfaceScene
{
public:
  /// Reads the files; throws ViewerError.
  MeshScene(const ViewerOptions& options, ViewerMessages& messages);
  ~MeshScene() override;

  /// On stdout: the surface, where the options leave it open and it is not the mesh's own shape;
  /// the arrays of a mesh that is drawn without.
  void Report() override;
  std::string Describe(const double point[3], double resolution) override;

private:
  void ReadMesh();
  void TakePatches();
  void ChooseSurface(bool isOfCells);
  void ReadHeights();
  void ChooseArray();
  void ChooseVectors();
  /// Whether refinement would not change the picture, and is not asked for.
  bool IsAsItIs() const;
  int GetDefaultLevel();
  vtkSmartPointer<vtkDepthTagMetric> MakeMeshMetric();
  void SetColours();
  void SetArrayColours();
  vtkDataArray* GetArray();
  std::optional<std::array<double, 3>> GetCentre();
  vtkSmartPointer<vtkPolyData> GetSurface();

  vtkNew<vtkDisplacement> Displacement;
  std::string CurvedBy; // what Report() says of the surface
  // The array that colours the mesh: empty for none, and whether its numbers are of points.
  std::string ArrayName;
  bool HasPointArray = false;
  std::unique_ptr<MeshProbe> Probe; // of that array, from the first question on
  vtkSmartPointer<vtkActor> Hair;   // nullptr for none
  // Vectors of the streaks; nullptr for none.
  vtkSmartPointer<vtkDataArray> Vectors;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeScene
 * @brief   a volume coloured by an array, with isosurfaces and a clipping plane
 */
#ifndef VolumeScene_h
#define VolumeScene_h

#include "Files/TransferFile.h"
#include "Scene/CutPlane.h"
#include "Scene/PictureMarks.h"
#include "Scene/ViewerScene.h"
#include "Scene/VolumeArray.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class TimeSteps;
class vtkDataObject;
class vtkGPUUnstructuredGridVolumeMapper;
class vtkVolume;
class vtkVolumeProbe;
class vtkVolumeProperty;

class VolumeScene : public ViewerScene
{
public:
  /// Reads the files. Throws ViewerError.
  VolumeScene(const ViewerOptions& options, ViewerMessages& messages);
  ~VolumeScene() override;

  std::string Describe(const double[3], double) override { return ""; }
  std::string DescribePixel(const int pixel[2]) override;
  bool FindPoint(const int pixel[2], double point[3]) override;
  std::string Change(char key) override;
  int GetNumberOfTimeSteps() override;
  void SetTimeStep(int step) override;
  void Draw(vtkRenderWindow* window) override;
  SceneContent GetContent() override;
  SceneFigures GetFigures() override;

private:
  void AddDataCode(SceneCode& code) override;
  OptionNames GetUpdatedOptions() override;
  bool ApplyOptions(const OptionNames& changed) override;
  bool ApplyCut();
  void ApplyMethod();
  std::vector<double> CountValues() const;
  vtkSmartPointer<vtkDataObject> ReadStep();
  /// Extends the range of the array by those of all time steps.
  void ExtendRangeByAllSteps();
  /// Extends the range of the colours by that of an array, with new functions.
  void ExtendRange(const VolumeArray& array);
  void Measure(vtkDataObject* data);
  void ChooseFunctions(vtkDataObject* data);
  void SetFunctions();
  bool IsByLength() const;
  void ChangeOpacity(double factor);
  void MoveIsoSurfaces(double share);
  std::string MoveCut(char key);
  /// Labels the largest and the smallest visible value if the options request it.
  void ShowExtremes();

  std::unique_ptr<TimeSteps> Steps;
  vtkNew<vtkGPUUnstructuredGridVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkVolumeProbe> Probe;
  VolumeArray Array;
  std::array<double, 2> WholeRange; // of the array, without that of the options
  double Bounds[6];
  double Diagonal = 0.0;
  double CellsOfSide = 0.0;
  double Thickness = 0.0; // mean chord of the mesh, share of the diagonal
  std::vector<TransferNode> Nodes;
  double OpacityFactor = 1.0; // for blend modes where opacity does not depend on length
  std::vector<double> IsoSurfaces;
  const std::string GivenArray; // by the options: an array, or a quantity of one
  PictureMarks Extremes;
  CutPlane Cut;
};

#endif

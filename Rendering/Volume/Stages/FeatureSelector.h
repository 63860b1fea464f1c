// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FeatureSelector
 * @brief   the stage that determines the features of shaders, with their planes and lights
 *
 * Private to the module.
 */
#ifndef FeatureSelector_h
#define FeatureSelector_h

#include "Checks/StageReport.h"
#include "Shaders/VolumeShader.h"
#include "View/MeshPlanes.h"
#include "View/VolumeLights.h"

#include <string>

class vtkPlaneCollection;
class vtkRenderer;
class vtkVolumeProperty;

namespace relevo
{
struct VolumeFunctions;
struct VolumeMesh;

struct FeatureRequest
{
  vtkRenderer* Renderer;
  vtkVolumeProperty* Property;
  vtkPlaneCollection* Planes;
  const VolumeMesh& Mesh;
  const VolumeFunctions& Functions;
  const dmat4& MeshToWorld;
  BlendMode Blending;
  bool HasSurfaces;    // isosurfaces inside the volume, with composite blending
  int TableDimensions; // of the pre-integration table, 0 for none
  SegmentOutput Segments = SegmentOutput::None;
};

struct VolumeFeatures
{
  VolumeShaderOptions Options;
  MeshPlanes Planes;
  VolumeLights Lights;
};

class FeatureSelector
{
public:
  /// Determine the features of this frame. Requested features that are not available are reported
  /// once.
  void Update(const FeatureRequest& request, StageReport& report);

  const VolumeFeatures& GetFeatures() const { return this->Features; }

private:
  void FindSurfaces(const FeatureRequest& request, StageReport& report);
  void FindPlanes(const FeatureRequest& request, StageReport& report);
  void FindTable(const FeatureRequest& request, StageReport& report);

  VolumeFeatures Features;
  // The messages, as reported.
  std::string MissingSurfaces;
  std::string PlaneError;
  std::string TableError;
};
}

#endif

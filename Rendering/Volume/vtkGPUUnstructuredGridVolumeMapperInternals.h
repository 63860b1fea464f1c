// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a vtkGPUUnstructuredGridVolumeMapper keeps
 *
 * Private to the mapper's own sources.
 */
#ifndef vtkGPUUnstructuredGridVolumeMapperInternals_h
#define vtkGPUUnstructuredGridVolumeMapperInternals_h

#include "Buffers/FunctionBuffers.h"
#include "Buffers/IntegralTable.h"
#include "Buffers/ProjectedCells.h"
#include "Buffers/SurfaceBuffer.h"
#include "Buffers/VolumeMeshBuffers.h"
#include "Cells/VolumeCells.h"
#include "Integral/TransferFunctions.h"
#include "Mesh/RayCastMesh.h"
#include "OpenGL/ContextWatch.h"
#include "OpenGL/RenderClock.h"
#include "Passes/ScreenPass.h"
#include "Shaders/VolumeShader.h"
#include "Targets/RenderTarget.h"
#include "View/MeshPlanes.h"
#include "View/OpaqueDepth.h"
#include "View/QuadBatches.h"
#include "View/RayEntries.h"
#include "View/RayView.h"
#include "View/VolumeLights.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>

class vtkShaderProgram;

namespace relevo
{
// Scalar mode, access mode, number and name, as of vtkAbstractVolumeMapper.
using ArrayChoice = std::tuple<int, int, int, std::string>;
}

struct vtkGPUUnstructuredGridVolumeMapper::vtkInternals
{
  // The mesh, whose arrays go once they are on the GPU.
  relevo::RayCastMesh Mesh;
  relevo::ScalarChoice Choice;
  vtkDataObject* MeshInput = nullptr; // never followed
  vtkMTimeType MeshTime = 0;
  relevo::ArrayChoice Array;
  /// The mesh and its time: what is wrong with it is reported once, though settings rebuild it.
  std::pair<vtkDataObject*, vtkMTimeType> WarnedOf;
  bool IsWarned() const
  {
    return this->WarnedOf == std::make_pair(this->MeshInput, this->MeshTime);
  }
  std::string LeftOut;                   // blocks, as reported
  vtkDataObject* CheckedInput = nullptr; // never followed
  std::string TypeProblem;               // as reported
  bool HasMesh = false;
  bool HasCorners = false; // for cell projection
  int NumberOfComponents = 1;
  bool HasCellScalars = false;
  bool HasGradients = false; // as of the last build, whatever the scalars
  bool AreIndependent = true;
  bool HasTetrahedra = false;
  bool HasCurvedCells = false;
  vtkIdType NumberOfDrawnCells = 0;

  relevo::TransferFunctions Functions;
  vtkMTimeType FunctionsTime = 0;
  bool AreFunctionsTried = false; // at that time, for this mesh
  bool HasFunctions = false;
  vtkMTimeType WarningTime = 0; // of the settings that were complained about
  bool IsPreIntegrated = false;
  relevo::VolumeShaderOptions Options;
  vtkMTimeType PlanesTime = 0; // when there were too many
  std::string MissingSurfaces; // as reported

  // Of one context.
  vtkNew<relevo::ContextWatch> Context;
  vtkOpenGLRenderWindow* GetWindow() const { return this->Context->GetContext(); }
  relevo::VolumeMeshBuffers MeshBuffers;
  relevo::ProjectedCells Projected;
  relevo::FunctionBuffers FunctionBuffers;
  relevo::SurfaceBuffer Surfaces;
  relevo::IntegralTable Integrals;
  relevo::OpaqueDepth Depth;
  relevo::RayEntries Entries;
  relevo::RenderTarget Limits;
  relevo::RenderTarget Projection;
  relevo::RayView View;
  relevo::MeshPlanes Planes;
  relevo::VolumeLights Lights;
  std::map<std::string, vtkShaderProgram*> Programs; // of the window's cache, by their text
  relevo::ScreenPass Screen;
  relevo::QuadBatches Quads; // of cells
  void ActivateTextures(vtkShaderProgram* program);
  void DeactivateTextures();
  void FinishRays();

  std::array<int, 2> LayersSize = { { 0, 0 } }; // of the viewport of the last render
  int NumberOfLayers = -1;                      // not known
  std::array<int, 2> SampledSize = { { 1, 1 } };
  double SampleDistance = 1.0; // in use
  double WholeTime = 0.0;      // seconds that a ray for each pixel takes
  relevo::RenderClock Clock;

  vtkIdType NumberOfBufferBuilds = 0;
  vtkIdType NumberOfShaderBuilds = 0;
  vtkIdType NumberOfTableBuilds = 0;
};

#endif

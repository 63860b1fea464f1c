// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumePrograms
 * @brief   the programs of a volume mapper in one context
 *
 * The source of a shader is composed when its options are first requested. Private to the module.
 */
#ifndef VolumePrograms_h
#define VolumePrograms_h

#include "Changes/Dependencies.h"
#include "Shaders/VolumeShader.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <utility>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace relevo
{
class RenderPasses;

enum class VolumeShader
{
  Entries,      // find where rays enter the mesh, by drawing its border
  EntryCounts,  // find the same by a search
  Ranges,       // find the ranges of cells
  Active,       // mark the faces of active cells
  Outlines,     // find the outlines of these faces
  FirstVisible, // find where rays enter the first visible cell
  LastVisible,  // find a depth behind the last visible cell
  Nearest,      // draw the nearest isosurface
  Rays,
  RayLimits,  // depth limits of cell projection
  Projection, // project cells
  Finish,     // convert the data of projected cells to an image
  Picture     // show an image
};

class VolumePrograms
{
public:
  static constexpr const char* Error = "The shaders cannot be built on this OpenGL.";

  /// Return a program and make it current; nullptr if it cannot be built, which is not tried again.
  vtkShaderProgram* Ready(
    vtkOpenGLRenderWindow* window, VolumeShader shader, const VolumeShaderOptions& options);

  /// Return the program of rays, as the render passes change it.
  vtkShaderProgram* ReadyRays(
    vtkOpenGLRenderWindow* window, const VolumeShaderOptions& options, const RenderPasses& passes);

  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }
  void ReleaseGraphicsResources();

private:
  using Sources = std::pair<std::string, std::string>; // of vertex and fragment shader
  vtkShaderProgram* Build(vtkOpenGLRenderWindow* window, const Sources& sources);

  std::map<Dependencies, vtkShaderProgram*> Programs; // all are owned by the window's cache
  /// Different options may give the same source. So may render passes, which change in each frame.
  std::map<Sources, vtkShaderProgram*> Built;
  std::map<Dependencies, std::string> RayShaders; // before render passes change them
  vtkIdType NumberOfBuilds = 0;
};
}

#endif

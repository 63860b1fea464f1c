// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumePrograms
 * @brief   the programs of a volume mapper in one context
 *
 * The text of a shader is composed when its options are asked for the first time. Private to the
 * module.
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
  Entries,     // where rays enter the mesh, by drawing its border
  EntryCounts, // the same by looking for it
  Rays,
  RayLimits,  // between which depths cells are projected
  Projection, // of cells
  Finish,     // makes a picture of what projected cells stored
  Picture     // shows a picture
};

class VolumePrograms
{
public:
  static constexpr const char* Error = "This OpenGL cannot build the shader.";

  /// A program, in use; nullptr if it cannot be built, which is not tried again.
  vtkShaderProgram* Ready(
    vtkOpenGLRenderWindow* window, VolumeShader shader, const VolumeShaderOptions& options);

  /// That of rays, as the render passes change it.
  vtkShaderProgram* ReadyRays(
    vtkOpenGLRenderWindow* window, const VolumeShaderOptions& options, const RenderPasses& passes);

  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }
  void ReleaseGraphicsResources();

private:
  using Sources = std::pair<std::string, std::string>; // of vertex and fragment shader
  vtkShaderProgram* Build(vtkOpenGLRenderWindow* window, const Sources& sources);

  std::map<Dependencies, vtkShaderProgram*> Programs; // of the window's cache, as all
  /// Different options may give the same text, as may render passes, which change in each frame.
  std::map<Sources, vtkShaderProgram*> Built;
  std::map<Dependencies, std::string> RayShaders; // before render passes change them
  vtkIdType NumberOfBuilds = 0;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobeVertices
 * @brief   the positions of the vertices of faces in the geocentric frame, on the GPU
 *
 * They are floats relative to an origin near the eye. Private to the module.
 */
#ifndef GlobeVertices_h
#define GlobeVertices_h

#include "Bisection/GlobeFaces.h"
#include "Buffers/BufferTexture.h"

#include <array>
#include <cstdint>
#include <string> // for errors
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace relevo
{
class GlobeVertices
{
public:
  /// The bytes of a face.
  static constexpr int BytesPerFace = GlobeFaces::VerticesPerFace * 12 * sizeof(float);

  /// Positions are computed again if one of these settings changes.
  struct Settings
  {
    std::array<double, 3> Origin; // positions are relative to it
    double Height;                // of the positions, in metres
    double Exaggeration;
    std::uint64_t NumberOfComputedFaces; // see GlobeFaces

    bool operator==(const Settings& other) const
    {
      return this->Origin == other.Origin && this->Height == other.Height &&
        this->Exaggeration == other.Exaggeration &&
        this->NumberOfComputedFaces == other.NumberOfComputedFaces;
    }
  };

  /**
   * Upload the vertices of faces, in the order of TerrainInstances. Return an error, or "". Nothing
   * is uploaded that has not changed.
   */
  std::string Upload(vtkOpenGLRenderWindow* window, const std::vector<unsigned int>& order,
    const std::vector<const GlobeFaces::Vertices*>& vertices, const Settings& settings);
  /// Forget what was uploaded, because faces come from another source.
  void Clear() { this->Uploaded.clear(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const { return this->Texture.GetMemorySize(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::vector<const GlobeFaces::Vertices*> Uploaded; // in the order of drawing
  Settings Last{};
  BufferTexture Texture;
};
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/GlobeVertices.h"

#include "Buffers/TerrainInstances.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>

namespace relevo
{
namespace
{
// Of relevoTerrainGlobeVS.glsl: position, up, derivatives.
constexpr int FloatsPerVertex = 12;
constexpr int TexelsPerFace = GlobeFaces::VerticesPerFace * FloatsPerVertex / 4;
}

std::string GlobeVertices::Upload(vtkOpenGLRenderWindow* window,
  const std::vector<unsigned int>& order, const std::vector<const GlobeFaces::Vertices*>& vertices,
  const std::array<double, 3>& origin, double height, double exaggeration)
{
  std::vector<float> floats(order.size() * 4 * TexelsPerFace, 0.0f);
  vtkSMPTools::For(0, static_cast<vtkIdType>(order.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      float* values = floats.data() + first * 4 * TexelsPerFace;
      for (vtkIdType face = first; face < end; ++face)
      {
        for (const GlobeShape::Vertex& vertex : *vertices[order[face]])
        {
          const std::array<double, 3> world = vertex.ToWorld(height, exaggeration);
          for (int axis = 0; axis < 3; ++axis)
          {
            values[axis] = static_cast<float>(world[axis] - origin[axis]);
            values[4 + axis] = static_cast<float>(vertex.Up[axis]);
          }
          std::copy(vertex.Derivatives.begin(), vertex.Derivatives.end(), values + 8);
          values += FloatsPerVertex;
        }
      }
    });
  // Compares bits, because positions may be NaN.
  const bool isSame = !this->Texture.IsEmpty() && floats.size() == this->Floats.size() &&
    (floats.empty() ||
      std::memcmp(floats.data(), this->Floats.data(), floats.size() * sizeof(float)) == 0);
  if (isSame)
  {
    return "";
  }
  this->Floats.swap(floats);
  return this->Texture.Upload(window, this->Floats, 4)
    ? ""
    : "The frame has too many faces for a buffer texture of this OpenGL: at most " +
      std::to_string(TerrainInstances::GetMaximumNumberOfFaces() / TexelsPerFace) +
      ". Set a larger screen-space error.";
}

void GlobeVertices::Activate(vtkShaderProgram* program)
{
  this->Texture.Activate(program, "relevoGlobeVertices");
}

void GlobeVertices::Deactivate()
{
  this->Texture.Deactivate();
}

void GlobeVertices::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture.ReleaseGraphicsResources(window);
}
}

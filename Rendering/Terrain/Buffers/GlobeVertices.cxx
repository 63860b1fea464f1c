// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/GlobeVertices.h"

#include "Buffers/TerrainInstances.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Of relevoTerrainGlobeVS.glsl: position, up, derivatives.
constexpr int FloatsPerVertex = 12;
constexpr int TexelsPerFace = GlobeFaces::VerticesPerFace * FloatsPerVertex / 4;
}

static_assert(GlobeVertices::BytesPerFace == 4 * TexelsPerFace * static_cast<int>(sizeof(float)),
  "the size of a face");

std::string GlobeVertices::Upload(vtkOpenGLRenderWindow* window,
  const std::vector<unsigned int>& order, const std::vector<const GlobeFaces::Vertices*>& vertices,
  const Settings& settings)
{
  std::vector<const GlobeFaces::Vertices*> faces;
  faces.reserve(order.size());
  for (const unsigned int face : order)
  {
    faces.push_back(vertices[face]);
  }
  if (!this->Texture.IsEmpty() && faces == this->Uploaded && settings == this->Last)
  {
    return "";
  }
  std::vector<float> floats(faces.size() * 4 * TexelsPerFace, 0.0f);
  vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      float* values = floats.data() + first * 4 * TexelsPerFace;
      for (vtkIdType face = first; face < end; ++face)
      {
        for (const GlobeShape::Vertex& vertex : *faces[face])
        {
          const std::array<double, 3> world =
            vertex.ToWorld(settings.Height, settings.Exaggeration);
          for (int axis = 0; axis < 3; ++axis)
          {
            values[axis] = static_cast<float>(world[axis] - settings.Origin[axis]);
            values[4 + axis] = static_cast<float>(vertex.Up[axis]);
          }
          std::copy(vertex.Derivatives.begin(), vertex.Derivatives.end(), values + 8);
          values += FloatsPerVertex;
        }
      }
    });
  this->Uploaded.swap(faces);
  this->Last = settings;
  return this->Texture.Upload(window, floats, 4)
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Captures the vertices that the GPU computes for an actor, bit for bit, from any shader stage.
#ifndef RelevoVertexCapture_h
#define RelevoVertexCapture_h

#include "RelevoScene.h"

#include <array>
#include <set>

// Edits VTK's vertex shader so that it stores every vertex. Requires OpenGL 4.3.
class RelevoVertexCapture
{
public:
  // All coordinates are below 1e30.
  using Points = std::set<std::array<float, 3>>;

  RelevoVertexCapture(vtkActor* actor, size_t maximumVertices);

  // The vertices of one frame.
  Points Capture(RelevoCheck& check, RelevoScene& scene);

private:
  size_t Most;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The vertices that the GPU computes for an actor, to the bit, whichever shader stage does it.
#ifndef RelevoVertexCapture_h
#define RelevoVertexCapture_h

#include "RelevoScene.h"

#include <array>
#include <set>

// Adds to VTK's vertex shader that it writes down every vertex. Needs OpenGL 4.3.
class RelevoVertexCapture
{
public:
  // No coordinates are larger than 1e30.
  using Points = std::set<std::array<float, 3>>;

  RelevoVertexCapture(vtkActor* actor, size_t maximumVertices);

  // Those of one frame.
  Points Capture(RelevoCheck& check, RelevoScene& scene);

private:
  size_t Most;
};

#endif

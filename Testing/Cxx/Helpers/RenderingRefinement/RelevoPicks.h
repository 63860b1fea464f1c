// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The results of hardware selection at each pixel of a scene.
#ifndef RelevoPicks_h
#define RelevoPicks_h

#include "RelevoScene.h"

#include "vtkProp.h"

#include <vector>

namespace RelevoPicks
{
// Actor, composite index and id at a pixel, all -1 for the background.
struct Hit
{
  int Actor = -1;
  int Block = -1;
  vtkIdType Id = -1;
  bool operator==(const Hit& other) const;
};

int FindActor(RelevoScene& scene, vtkProp* prop);

std::vector<Hit> SelectPixels(RelevoScene& scene, int association);
}

#endif

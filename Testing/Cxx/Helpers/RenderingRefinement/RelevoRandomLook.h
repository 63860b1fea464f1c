// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random properties, places and textures of actors, and cameras, for RelevoRandomScene.h.
#ifndef RelevoRandomLook_h
#define RelevoRandomLook_h

#include "RelevoRandomMapping.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace RelevoRandomLook
{
using RelevoRandomMapping::Choice;

// What is drawn in one place: an actor, or the twin's for each block, of the same property.
struct Look
{
  std::vector<vtkSmartPointer<vtkActor>> Actors;

  vtkProperty* GetProperty() const { return this->Actors.front()->GetProperty(); }
};

void AddTexture(const Choice& choice, const Look& look);

// With `anyOrder` faces are drawn in another order than VTK's: where they overlap at one depth, as
// their lines and points do, others are seen.
void FillProperty(const Choice& choice, vtkProperty* property, bool anyOrder);

void PlaceActors(const Choice& choice, const Look& look, bool always);

// From outside, from near by, from inside, or cut by the near plane. The numbers do not depend on
// bounds, which the two kinds of mapper need not agree on.
void PlaceCamera(const Choice& choice, vtkCamera* camera);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random properties, positions and textures of actors, and random cameras, for RelevoRandomScene.h.
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

// The actors at one position: one actor, or in the twin one actor per block with the same
// property.
struct Look
{
  std::vector<vtkSmartPointer<vtkActor>> Actors;

  vtkProperty* GetProperty() const { return this->Actors.front()->GetProperty(); }
};

void AddTexture(const Choice& choice, const Look& look);

// With `anyOrder`, faces are drawn in another order than VTK's. Where faces, lines or points
// overlap at the same depth, others are visible.
void FillProperty(const Choice& choice, vtkProperty* property, bool anyOrder);

void PlaceActors(const Choice& choice, const Look& look, bool always);

// From outside, close by or inside, or clipped by the near plane. The numbers do not depend on
// bounds, which may differ between the mappers.
void PlaceCamera(const Choice& choice, vtkCamera* camera);
}

#endif

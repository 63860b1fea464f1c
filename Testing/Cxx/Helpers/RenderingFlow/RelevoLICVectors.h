// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Vectors for test meshes, and mappers that show them.
#ifndef RelevoLICVectors_h
#define RelevoLICVectors_h

#include "RelevoScene.h"

#include "vtkAdaptiveLICMapper.h"
#include "vtkPolyData.h"

#include <array>
#include <functional>

namespace RelevoLICVectors
{
using Field = std::function<std::array<double, 3>(const double*)>;

// A screw about the z axis, never zero near the origin.
std::array<double, 3> Screw(const double* p);

// Active vectors of points, by their place.
void AddVectors(vtkPolyData* mesh, const Field& field = Screw, const char* name = "Flow");

// Of all blocks that have none.
void AddVectors(vtkDataObject* data);

// For RelevoScene::NewMapper: a LIC that is made but has no share in the colours.
vtkAdaptiveRefinementMapper* NewInvisible(vtkDataObject* data);

// For RelevoScene::NewMapper: the LIC with enhancements off, so that it is the same where nothing
// differs nearby.
vtkAdaptiveRefinementMapper* NewVisible(vtkDataObject* data);

vtkAdaptiveLICMapper* GetMapper(vtkActor* actor);
}

#endif

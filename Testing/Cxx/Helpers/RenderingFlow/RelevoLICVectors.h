// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Vectors for test meshes, and mappers that draw them.
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

// A screw motion about the z axis, nonzero near the origin.
std::array<double, 3> Screw(const double* p);

// Adds active point vectors by position.
void AddVectors(vtkPolyData* mesh, const Field& field = Screw, const char* name = "Flow");

// Adds vectors to all blocks without any.
void AddVectors(vtkDataObject* data);

// For RelevoScene::NewMapper: a LIC that is computed, but does not contribute to the colours.
vtkAdaptiveRefinementMapper* NewInvisible(vtkDataObject* data);

// For RelevoScene::NewMapper: the LIC without enhancements, so that it depends only on its
// surroundings.
vtkAdaptiveRefinementMapper* NewVisible(vtkDataObject* data);

vtkAdaptiveLICMapper* GetMapper(vtkActor* actor);
}

#endif

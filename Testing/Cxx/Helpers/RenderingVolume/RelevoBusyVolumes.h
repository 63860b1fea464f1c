// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A mesh and a volume property in which much happens.
#ifndef RelevoBusyVolumes_h
#define RelevoBusyVolumes_h

#include "RelevoVolumes.h"

#include "vtkDoubleArray.h"

class vtkPointSet;

// From 0 to 1.
double GetWaves(const RelevoPoint& at);

// Of each component nodes here and there from 0 to 1, some of them close to each other.
vtkSmartPointer<vtkVolumeProperty> MakeBusyProperty(double unitDistance, int components = 1);

// Tetrahedra of points in a ball of radius 1 around (low, low, low), slivers among them, with
// waves.
vtkSmartPointer<vtkUnstructuredGrid> MakeBall(int numberOfPoints, double low = 0.0);

// For its points, "busy", components that differ, from 0 to 1.
vtkSmartPointer<vtkDoubleArray> MakeBusyArray(vtkPointSet* mesh, int components);

#endif

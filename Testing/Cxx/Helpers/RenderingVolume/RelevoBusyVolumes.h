// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A mesh and a volume property with many features.
#ifndef RelevoBusyVolumes_h
#define RelevoBusyVolumes_h

#include "RelevoVolumes.h"

#include "vtkDoubleArray.h"

class vtkPointSet;

// From 0 to 1.
double GetWaves(const RelevoPoint& at);

// Random nodes from 0 to 1 for each component, some of them close together.
vtkSmartPointer<vtkVolumeProperty> MakeBusyProperty(double unitDistance, int components = 1);

// Tetrahedra between points in a ball of radius 1 around (low, low, low), including slivers, with
// waves as scalars.
vtkSmartPointer<vtkUnstructuredGrid> MakeBall(int numberOfPoints, double low = 0.0);

// The point array "busy", whose components differ, from 0 to 1.
vtkSmartPointer<vtkDoubleArray> MakeBusyArray(vtkPointSet* mesh, int components);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   coarse meshes with the numbers of faces of published measurements
 *
 * Triangles face outwards, with point normals split at creases. Lengths are about one unit, except
 * for the bunny.
 */
#ifndef BenchmarkMeshes_h
#define BenchmarkMeshes_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

namespace BenchmarkMeshes
{
/// A closed unit sphere by longitude and latitude with 2 x sectors x rings faces and analytic
/// normals.
vtkSmartPointer<vtkPolyData> MakeSphere(int sectors, int rings);

/// The same with at least `faces` faces, and about as many sectors as rings.
vtkSmartPointer<vtkPolyData> MakeSphere(double faces);

/// A closed torus about the z axis with analytic normals and 2 x sectors x rings faces. A ring runs
/// around the tube.
vtkSmartPointer<vtkPolyData> MakeTorus(double radius, double tubeRadius, int sectors, int rings);

/// A closed sphere with a wedge of 60 degrees, the mouth, cut out. Its two sides meet at
/// `axisPoints` points. It has 2 x (sectors x rings + rings + axisPoints) faces.
vtkSmartPointer<vtkPolyData> MakePacMan(int sectors, int rings, int axisPoints);

/// Fuselage, wings, tail planes and a fin, 303 faces. The fuselage is closed; attached parts are
/// open where they enter it.
vtkSmartPointer<vtkPolyData> MakeJet();

/// The Stanford bunny from RELEVO_TEST_DATA, or nullptr if the file is missing.
vtkSmartPointer<vtkPolyData> ReadBunny();

/// The mesh of ReadBunny(), reduced to at most this many faces, with normals.
vtkSmartPointer<vtkPolyData> Decimate(vtkPolyData* bunny, int faces);
}

#endif

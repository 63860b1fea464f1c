// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   coarse meshes with the numbers of faces that published figures were measured with
 *
 * Triangles that wind outwards, with point normals that are split at creases. Lengths are about one
 * unit, but the bunny's.
 */
#ifndef BenchmarkMeshes_h
#define BenchmarkMeshes_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

namespace BenchmarkMeshes
{
/// A closed unit sphere by longitude and latitude: 2 x sectors x rings faces, analytic normals.
vtkSmartPointer<vtkPolyData> MakeSphere(int sectors, int rings);

/// The same with at least `faces` faces, of about the same number of sectors as of rings.
vtkSmartPointer<vtkPolyData> MakeSphere(double faces);

/// A closed torus about the z axis with analytic normals: 2 x sectors x rings faces; a ring goes
/// around the tube.
vtkSmartPointer<vtkPolyData> MakeTorus(double radius, double tubeRadius, int sectors, int rings);

/// A closed sphere with a wedge cut out, the mouth, of 60 degrees. `axisPoints` are where its two
/// sides meet. 2 x (sectors x rings + rings + axisPoints) faces.
vtkSmartPointer<vtkPolyData> MakePacMan(int sectors, int rings, int axisPoints);

/// Fuselage, wings, tail planes and a fin, 303 faces. The fuselage is closed; what is attached to
/// it is open where it enters.
vtkSmartPointer<vtkPolyData> MakeJet();

/// The Stanford bunny from RELEVO_TEST_DATA; nullptr without the file.
vtkSmartPointer<vtkPolyData> ReadBunny();

/// What ReadBunny() gives, reduced to that many faces at most, with normals.
vtkSmartPointer<vtkPolyData> Decimate(vtkPolyData* bunny, int faces);
}

#endif

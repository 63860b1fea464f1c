// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the isosurfaces that blocks of a volume have
 */
#ifndef ContourSettings_h
#define ContourSettings_h

#include <string> // for members
#include <vector> // for members

class vtkDataArray;
class vtkDataSet;
class vtkPointData;
class vtkPolyData;

namespace relevo
{
/// The array that marks points on common borders of blocks.
constexpr const char* FixedPointsName = "MicroMeshFixedPoints";

struct ContourSettings
{
  std::string Scalars; // the name of a point array
  std::vector<double> Values;
  bool Attributes;
  bool Gradients;
  bool ContourValues; // whether the isovalue is a point array
};

/// Find the scalars. Returns nullptr and an error for the user if they are missing or invalid.
vtkDataArray* FindScalars(vtkDataSet* volume, const ContourSettings& settings, std::string& error);

/**
 * Copy the scalars, as active ones, and the other arrays that are interpolated. Arrays with too few
 * tuples, texts and ids are left out.
 */
void CopyContourArrays(
  vtkDataSet* volume, vtkDataArray* scalars, const ContourSettings& settings, vtkPointData* to);

/**
 * Remove triangles with points that are not finite, and give arrays the types that they have in the
 * volume. Contouring converts integers to floats.
 */
void CleanContour(vtkPointData* volume, vtkPolyData* surface);
}

#endif

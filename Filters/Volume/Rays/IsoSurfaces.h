// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   IsoSurfaces
 * @brief   where a ray meets the isosurfaces of a volume
 *
 * A scalar is on one side of a surface if it is less than its value, else on the other; a ray meets
 * the surface where the side changes inside a cell. So a border of cells that has the value counts
 * for one of them, and where the scalar has the value all along, nothing is met. The lowest value
 * has no surface, the highest only on faces that have it.
 *
 * Private to the module's own sources.
 */
#ifndef IsoSurfaces_h
#define IsoSurfaces_h

#include "Cells/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <string>
#include <vector>

class vtkVolumeProperty;

namespace relevo
{
struct IsoCrossing
{
  size_t Part;
  double Share; // of the part, from its front
  double Value;
};

/// The drawn data: values of cells, or of points in a range.
struct SurfaceData
{
  bool AreOfCells;
  double Low;
  double High;
};

class RELEVOFILTERSVOLUME_EXPORT IsoSurfaces
{
public:
  /// Of the ray's largest scalar: cells that touch may differ so much, as floats of several blocks
  /// do.
  static constexpr double Same = 1e-6;

  /// None.
  IsoSurfaces() = default;
  /// Of the property's values, those that are numbers.
  IsoSurfaces(vtkVolumeProperty* property, const TransferFunctions& functions);

  /**
   * Sentences on why some of the property's values, or all, have no surface; empty if all have.
   * Values at the ends of the range have as much of one as vtkContourFilter finds.
   */
  static std::string DescribeMissing(vtkVolumeProperty* property, const SurfaceData& data);

  /// Front to back.
  std::vector<IsoCrossing> Cross(const std::vector<RayPart>& parts) const;

  /// Straight colour and opacity, and which of the functions' curves gives the colour.
  dvec4 GetColor(
    const TransferFunctions& functions, const RayPart& part, const IsoCrossing& crossing) const;
  size_t GetCurve() const { return this->Curve; }

  /// In ascending order.
  const std::vector<double>& GetValues() const { return this->Values; }
  /// Whose values these are.
  int GetComponent() const { return this->Component; }

private:
  // Between the ends of a part.
  void Cross(const IsoCrossing& front, const IsoCrossing& back, double rounding,
    std::vector<IsoCrossing>& crossings) const;

  std::vector<double> Values; // in ascending order
  int Component = 0;
  size_t Curve = 0;
};
}

#endif

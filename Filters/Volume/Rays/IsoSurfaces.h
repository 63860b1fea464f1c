// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   IsoSurfaces
 * @brief   intersects rays with the isosurfaces of a volume
 *
 * A scalar is on one side of a surface if it is less than the isovalue, and on the other side
 * otherwise. A ray hits the surface where the side changes inside of a cell. A face with the
 * isovalue is therefore hit in one of its cells, and cells of constant value are not hit. The
 * smallest scalar has no surface, and the largest only on faces that have this value.
 *
 * Private to the module.
 */
#ifndef IsoSurfaces_h
#define IsoSurfaces_h

#include "Integral/Ray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <string>
#include <vector>

class vtkVolumeProperty;

namespace relevo
{
struct IsoCrossing
{
  size_t Part;
  double Share; // fraction of the part, from its front
  double Value;
};

/// The range of the scalars that are drawn.
struct SurfaceData
{
  double Low;
  double High;
};

class RELEVOFILTERSVOLUME_EXPORT IsoSurfaces
{
public:
  /// Relative to the largest scalar of the ray. Scalars of adjacent cells can differ by this much,
  /// for example between blocks with float arrays.
  static constexpr double Same = 1e-6;

  /// No isosurfaces.
  IsoSurfaces() = default;
  /// The isovalues of the property, without NaN.
  IsoSurfaces(vtkVolumeProperty* property, const TransferFunctions& functions);

  /**
   * Returns sentences on why some or all isovalues have no surface, or "" if all have one. Values
   * at the ends of the range have as much surface as vtkContourFilter finds.
   */
  static std::string DescribeMissing(vtkVolumeProperty* property, const SurfaceData& data);

  /// Returns the hits from front to back.
  std::vector<IsoCrossing> Cross(const std::vector<RayPart>& parts) const;

  /// Returns straight colour and opacity, and the index of the curve that provides the colour.
  dvec4 GetColor(
    const TransferFunctions& functions, const RayPart& part, const IsoCrossing& crossing) const;
  size_t GetCurve() const { return this->Curve; }

  /// In ascending order.
  const std::vector<double>& GetValues() const { return this->Values; }
  /// The component of the isovalues.
  int GetComponent() const { return this->Component; }

private:
  // Adds hits between the ends of a part.
  void Cross(const IsoCrossing& front, const IsoCrossing& back, double rounding,
    std::vector<IsoCrossing>& crossings) const;

  std::vector<double> Values; // in ascending order
  int Component = 0;
  size_t Curve = 0;
};
}

#endif

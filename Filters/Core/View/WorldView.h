// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   a RefinementView in numbers: where the mesh lies and where the eye is
 */
#ifndef WorldView_h
#define WorldView_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersCoreModule.h" // for export macro

#include <string> // for errors

class vtkMatrix4x4;

namespace relevo
{
struct FiniteBox;
struct RefinementView;
/// Identity for nullptr.
RELEVOFILTERSCORE_EXPORT dmat4 MakeMatrix(vtkMatrix4x4* matrix);

/// Pixels of a length of 1 seen from the front at a distance of 1, by the camera's view angle.
RELEVOFILTERSCORE_EXPORT double GetPixelsAtUnitDistance(const RefinementView& view);

/// Where the actor's matrix puts the mesh; identity without one.
struct RELEVOFILTERSCORE_EXPORT Placement
{
  explicit Placement(const RefinementView& view);

  dvec3 GetPoint(const dvec3& x) const { return dvec3(this->ModelToWorld * dvec4(x, 1.0)); }
  /// A normal in world coordinates, of any length; its sign may be wrong under a singular or
  /// mirroring matrix.
  dvec3 GetNormal(const dvec3& n) const { return this->NormalToWorld * n; }
  /// The diagonal of a box in the mesh's coordinates after the matrix: unlike that of the world's
  /// box it stays the same when the actor turns.
  double GetDiagonal(const FiniteBox& box) const;

  /// The effect of the matrix on angles and proportions, apart from rotation and scale:
  /// lengths l of the world are those of the mesh by l^2 = Scale^2 e . Shape e.
  dmat3 GetShape() const;
  double GetScale() const;
  /// Whether the shape is one that was given before, but for rounding.
  bool HasShape(const dmat3& shape) const;

  dmat4 ModelToWorld;
  dmat3 NormalToWorld;
};

/// The vector over its length; zero when it has none or is not finite.
RELEVOFILTERSCORE_EXPORT dvec3 UnitOrZero(const dvec3& v);

/// Where the camera looks from.
class RELEVOFILTERSCORE_EXPORT Eye
{
public:
  /// Returns false and sets error when there is no camera or it has no direction.
  bool Set(const RefinementView& view, std::string& error);

  bool IsParallel() const { return this->Parallel; }
  /// In world coordinates.
  const dvec3& GetPosition() const { return this->Position; }
  /// The unit vector against the direction of view.
  const dvec3& GetBackwards() const { return this->Backwards; }

private:
  bool Parallel = false;
  dvec3 Position{ 0.0 };
  dvec3 Backwards{ 0.0 };
};
}

#endif

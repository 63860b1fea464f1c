// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the numbers of a RefinementView: placement of the mesh and position of the eye
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
/// The identity for nullptr.
RELEVOFILTERSCORE_EXPORT dmat4 MakeMatrix(vtkMatrix4x4* matrix);

/// The length in pixels of a unit length seen from the front at a distance of 1, from the camera's
/// view angle.
RELEVOFILTERSCORE_EXPORT double GetPixelsAtUnitDistance(const RefinementView& view);

/// The transformation by the actor's matrix; the identity without one.
struct RELEVOFILTERSCORE_EXPORT Placement
{
  explicit Placement(const RefinementView& view);

  dvec3 GetPoint(const dvec3& x) const { return dvec3(this->ModelToWorld * dvec4(x, 1.0)); }
  /// A normal in world coordinates, of any length. Its sign may be wrong for singular or mirroring
  /// matrices.
  dvec3 GetNormal(const dvec3& n) const { return this->NormalToWorld * n; }
  /// The diagonal of a box in the mesh's coordinates after transformation. Unlike the diagonal of
  /// the box in world coordinates, it does not change when the actor rotates.
  double GetDiagonal(const FiniteBox& box) const;

  /// The effect of the matrix on angles and proportions, without rotation and scale. The world
  /// length l of a vector e of the mesh is given by l^2 = Scale^2 e . Shape e.
  dmat3 GetShape() const;
  double GetScale() const;
  /// Whether the shape equals a given one, up to rounding.
  bool HasShape(const dmat3& shape) const;

  dmat4 ModelToWorld;
  dmat3 NormalToWorld;
};

/// The normalised vector, or 0 if it has no length or is not finite.
RELEVOFILTERSCORE_EXPORT dvec3 UnitOrZero(const dvec3& v);

/// The position of the camera.
class RELEVOFILTERSCORE_EXPORT Eye
{
public:
  /// Returns false and sets error if there is no camera or it has no direction.
  bool Set(const RefinementView& view, std::string& error);

  bool IsParallel() const { return this->Parallel; }
  /// In world coordinates.
  const dvec3& GetPosition() const { return this->Position; }
  /// The unit vector opposite to the direction of view.
  const dvec3& GetBackwards() const { return this->Backwards; }

private:
  bool Parallel = false;
  dvec3 Position{ 0.0 };
  dvec3 Backwards{ 0.0 };
};
}

#endif

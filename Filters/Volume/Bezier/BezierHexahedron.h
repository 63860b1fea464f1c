// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BezierHexahedron
 * @brief   positions and scalars as polynomials of three parameters from 0 to 1
 *
 * A tensor product of Bernstein polynomials, optionally rational. Curved cells of all shapes are
 * converted to such hexahedra, see CurvedCellConversion.
 *
 * Private to the modules.
 */
#ifndef BezierHexahedron_h
#define BezierHexahedron_h

#include "Integral/Ray.h"
#include "Mathematics/BezierDegree.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <array>
#include <vector>

namespace relevo
{
/// A point of a Bézier hexahedron.
struct BezierPoint
{
  dvec3 Position;
  Scalars Values;
};

class RELEVOFILTERSVOLUME_EXPORT BezierHexahedron
{
public:
  /// The first components of a coefficient: x, y and z times the weight, and the weight. Scalars
  /// times the weight follow.
  static constexpr int FirstScalar = 4;
  static constexpr int MaximumStride = FirstScalar + MaximumComponents;

  BezierHexahedron(const ivec3& degrees, int numberOfScalars);

  const ivec3& GetDegrees() const { return this->Degrees; }
  int GetNumberOfScalars() const { return this->Stride - FirstScalar; }
  int GetStride() const { return this->Stride; }
  int GetNumberOfCoefficients() const;
  /// Coefficients are ordered along the first direction first.
  double* GetCoefficient(int i)
  {
    return &this->Coefficients[static_cast<size_t>(i * this->Stride)];
  }
  const double* GetCoefficient(int i) const
  {
    return &this->Coefficients[static_cast<size_t>(i * this->Stride)];
  }
  int GetIndex(int i, int j, int k) const
  {
    return i + (this->Degrees.x + 1) * (j + (this->Degrees.y + 1) * k);
  }

  void Move(const dvec3& offset);

  /// Returns the Bernstein polynomials of all coefficients.
  static std::vector<double> GetBasis(const ivec3& degrees, const dvec3& parameters);

  BezierPoint Evaluate(const dvec3& parameters) const;
  dvec3 GetPosition(const dvec3& parameters) const;
  /// Returns the derivatives of the position by the parameters in columns.
  dmat3 Derive(const dvec3& parameters) const;
  /// Computes position and derivatives together.
  void Derive(const dvec3& parameters, dvec3& position, dmat3& derivatives) const;
  /// Returns the gradients of the scalars by position; 0 where the derivatives are singular.
  Gradients ComputeGradients(const dvec3& parameters) const;

  /// Computes a box that contains the hexahedron.
  void FindBounds(dvec3& low, dvec3& high) const;
  /// Computes the range of a scalar at 64 points, including the corners.
  void FindRange(int component, double& low, double& high) const;

  /**
   * Returns upper bounds of the length of the second derivative of the position (index 0), and of
   * the second derivatives of the scalars (index 1 + component), by one parameter.
   */
  std::array<double, 1 + MaximumComponents> BoundSecondDerivatives(int direction) const;

  /// Parameters inside the hexahedron at which its shape is sampled: 27 points.
  static constexpr int NumberOfSamples = 27;
  static dvec3 GetSample(int i);

private:
  using Values = std::array<double, MaximumStride>;
  using Basis = std::array<double, LargestDegree + 1>;

  Values Sum(const Basis& u, const Basis& v, const Basis& w) const;
  void SumAll(const dvec3& parameters, std::array<Values, 4>& sums) const;

  ivec3 Degrees;
  int Stride;
  std::vector<double> Coefficients;
};
}

#endif

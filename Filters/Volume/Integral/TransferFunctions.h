// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TransferFunctions
 * @brief   colour and extinction along a ray, according to a vtkVolumeProperty
 *
 * The functions are evaluated as in VTK (colour space, midpoint, sharpness, clamping) and
 * approximated by linear pieces. A segment of a ray with linear scalars is cut at the nodes of
 * these pieces. Colour and extinction are linear in between.
 *
 * With independent components, extinction is the sum of the extinctions, and colour the mean of the
 * colours, weighted by extinction. Pieces are short enough for this mean to be linear. With two
 * dependent components, the first gives colour and the second extinction. Four dependent components
 * are red, green, blue and opacity, in [0, 1]. 2D functions of dependent components only use the
 * last component.
 *
 * Private to the module.
 */
#ifndef TransferFunctions_h
#define TransferFunctions_h

#include "Changes/Dependencies.h"
#include "Integral/LinearPieces.h"
#include "Integral/TransferFunction2D.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <algorithm> // for inline functions
#include <array>     // for the scalars
#include <cmath>     // for inline functions
#include <string>    // for messages
#include <vector>    // for members

class vtkVolumeProperty;

namespace relevo
{
constexpr int MaximumComponents = 4;
using Scalars = std::array<double, MaximumComponents>;

inline bool IsFinite(const Scalars& scalars)
{
  return std::all_of(
    scalars.begin(), scalars.end(), [](double value) { return std::isfinite(value); });
}

inline Scalars Interpolate(const Scalars& front, const Scalars& back, double share)
{
  Scalars result;
  for (size_t i = 0; i < result.size(); ++i)
  {
    result[i] = (1.0 - share) * front[i] + share * back[i];
  }
  return result;
}

/// Lighting of each curve: the factor for its colour, and the amount of white to add. 1 and 0 for
/// curves without a colour.
using Lights = std::array<dvec2, MaximumComponents>;

/// A segment of a ray along which the scalars are linear.
struct RELEVOFILTERSVOLUME_EXPORT Segment
{
  Scalars Front;
  Scalars Back;
  double Length;
  Scalars Steepness = {}; // gradient magnitudes of the components
  bool IsLit = false;
  Lights FrontLights = {}; // also linear along the segment
  Lights BackLights = {};

  /// Returns the segment between two fractions of the length.
  Segment Cut(double begin, double end) const;
};

class RELEVOFILTERSVOLUME_EXPORT TransferFunctions
{
public:
  /// Functions of a component. For two dependent components, the second has the opacity.
  struct Curve
  {
    int Component;
    double UnitDistance;
    LinearPieces Pieces;          // empty with a 2D function
    LinearPieces GradientOpacity; // in w; without nodes if there is none
    TransferFunction2D Table;     // empty if there is none
  };

  /**
   * Reads the functions. Returns false with an `error`, as a continuation of "The volume property
   * ", if they are invalid. An invalid unit distance is replaced by 1 with a `warning`.
   */
  bool Read(
    vtkVolumeProperty* property, int numberOfComponents, std::string& error, std::string& warning);

  /// Returns the dependencies of Read() on a property.
  static Dependencies FindDependencies(vtkVolumeProperty* property, int numberOfComponents);

  /// Whether the scalars are red, green, blue and opacity.
  bool AreColors() const { return this->Mode == Mixing::Four; }
  /// Whether colour and opacity come from two components.
  bool AreDependent() const { return this->Mode == Mixing::Two; }
  bool AreIndependent() const { return this->Mode == Mixing::Independent; }
  int GetNumberOfComponents() const { return this->NumberOfComponents; }
  /// Empty if the scalars are colours.
  const std::vector<Curve>& GetCurves() const { return this->Curves; }
  //@{
  /// Functions for scalars that are colours.
  double GetUnitDistance() const { return this->Direct.UnitDistance; }
  const LinearPieces& GetGradientOpacity() const { return this->Direct.GradientOpacity; }
  //@}

  /// Whether gradient magnitudes of segments are used.
  bool NeedSteepness() const;

  /// Whether a segment depends on one scalar at each end and the length only.
  bool DependOnOneScalar() const { return this->Curves.size() == 1 && !this->NeedSteepness(); }

  /// Returns the component whose gradients shade the colour of a curve, or the colours.
  int GetShadedComponent(size_t curve) const;

  //@{
  /// Return the colour and alpha of a segment, premultiplied.
  dvec4 Integrate(const Segment& segment) const;
  dvec4 Integrate(const Scalars& front, const Scalars& back, double length) const
  {
    return this->Integrate({ front, back, length });
  }
  //@}

  /// Returns the integrals of colour times extinction, and of extinction, without absorption.
  dvec4 Sum(const Segment& segment) const;

  /// Returns the fractions of a segment at which a function may have a kink or jump, including 0
  /// and 1.
  std::vector<double> FindCuts(const Scalars& front, const Scalars& back) const;

  /// Returns straight colour and extinction at the ends of a segment without cuts.
  std::array<dvec4, 2> Evaluate(const Segment& segment) const;

  /**
   * Returns straight colour and opacity, at most 1, of scalars, independent of length. Independent
   * components are mixed by opacity. Only 2D functions use the gradient magnitude.
   */
  dvec4 Map(const Scalars& scalars, const Scalars& steepness) const;

  /// Returns the same for a single independent component.
  dvec4 MapCurve(size_t curve, const Scalars& scalars, const Scalars& steepness) const;

private:
  enum class Mixing
  {
    Independent,
    Two,
    Four
  };
  using Ends = std::array<dvec4, 2>;
  using AllEnds = std::array<Ends, MaximumComponents>;
  bool ReadCurves(vtkVolumeProperty* property, std::string& error, std::string& warning);
  bool ReadTables(vtkVolumeProperty* property, std::string& error, std::string& warning);
  AllEnds EvaluateAll(const Segment& segment) const;
  static Ends EvaluateCurve(const Curve& curve, const Segment& segment);
  Ends Mix(const AllEnds& all) const;
  Ends MixIndependent(const AllEnds& all) const;
  //@{
  /// Calls add(ends, length), from front to back, for each piece along which colour and extinction
  /// are linear.
  template <typename Add>
  void AddPieces(const Segment& piece, int depth, const Add& add) const;
  template <typename Add>
  void AddAllPieces(const Segment& segment, const Add& add) const;
  //@}

  Mixing Mode = Mixing::Independent;
  int NumberOfComponents = 1;
  std::vector<Curve> Curves; // dependent components in order
  Curve Direct = {};         // used for colours, without pieces
};
}

#endif

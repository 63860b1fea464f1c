// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TransferFunctions
 * @brief   colour and extinction of scalars, as a vtkVolumeProperty gives them, along a ray
 *
 * The functions are taken as they evaluate themselves (colour space, midpoint, sharpness,
 * clamping), in linear pieces. A part of a ray along which the scalars are linear is cut wherever
 * one of them passes an end of a piece; on what is left colour and extinction count as linear.
 *
 * Independent components: extinction is the sum of theirs, colour the mean by extinction, at every
 * place: pieces are short enough that this mean is linear along them. Two
 * dependent: colour by the first, extinction by the second. Four dependent: red, green, blue and
 * opacity, from 0 to 1. With 2D functions the last of dependent components counts alone.
 *
 * Private to the module's own sources.
 */
#ifndef TransferFunctions_h
#define TransferFunctions_h

#include "Changes/Dependencies.h"
#include "Integral/LinearPieces.h"
#include "Integral/TransferFunction2D.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <array>  // for the scalars
#include <string> // for messages
#include <vector> // for members

class vtkVolumeProperty;

namespace relevo
{
constexpr int MaximumComponents = 4;
using Scalars = std::array<double, MaximumComponents>;

inline Scalars Interpolate(const Scalars& front, const Scalars& back, double share)
{
  Scalars result;
  for (size_t i = 0; i < result.size(); ++i)
  {
    result[i] = (1.0 - share) * front[i] + share * back[i];
  }
  return result;
}

/// What light does to each curve's colour: it is multiplied, and white is added. 1 and 0 for curves
/// without a colour.
using Lights = std::array<dvec2, MaximumComponents>;

/// A part of a ray along which the scalars are linear.
struct RELEVOFILTERSVOLUME_EXPORT Segment
{
  Scalars Front;
  Scalars Back;
  double Length;
  Scalars Steepness = {}; // lengths of the components' gradients
  bool IsLit = false;
  Lights FrontLights = {}; // linear between the ends, too
  Lights BackLights = {};

  /// Of shares of its length.
  Segment Cut(double begin, double end) const;
};

class RELEVOFILTERSVOLUME_EXPORT TransferFunctions
{
public:
  /// A component's colour and opacity; of two dependent components the second has the opacity.
  struct Curve
  {
    int Component;
    double UnitDistance;
    LinearPieces Pieces;          // none if there is a 2D function
    LinearPieces GradientOpacity; // in w; without nodes for none
    TransferFunction2D Table;     // empty if there is none
  };

  /**
   * false with words that follow "The volume property " where the functions cannot be used. Where a
   * unit distance cannot be, it is taken as 1, and `warning` says so.
   */
  bool Read(
    vtkVolumeProperty* property, int numberOfComponents, std::string& error, std::string& warning);

  /// The dependencies of Read() on a property.
  static Dependencies FindDependencies(vtkVolumeProperty* property, int numberOfComponents);

  /// Whether the scalars themselves are red, green, blue and opacity.
  bool AreColors() const { return this->Mode == Mixing::Four; }
  /// Whether colour and opacity come from two components.
  bool AreDependent() const { return this->Mode == Mixing::Two; }
  bool AreIndependent() const { return this->Mode == Mixing::Independent; }
  int GetNumberOfComponents() const { return this->NumberOfComponents; }
  /// None if the scalars are colours.
  const std::vector<Curve>& GetCurves() const { return this->Curves; }
  //@{
  /// Of scalars that are colours.
  double GetUnitDistance() const { return this->Direct.UnitDistance; }
  const LinearPieces& GetGradientOpacity() const { return this->Direct.GradientOpacity; }
  //@}

  /// Whether the steepness of segments counts.
  bool NeedSteepness() const;

  /// Whether what is seen of a segment follows from one scalar at each end, and the length.
  bool DependOnOneScalar() const { return this->Curves.size() == 1 && !this->NeedSteepness(); }

  /// Of which component the gradients count for the colour of a curve, or of colours.
  int GetShadedComponent(size_t curve) const;

  //@{
  /// What is seen of a segment: premultiplied.
  dvec4 Integrate(const Segment& segment) const;
  dvec4 Integrate(const Scalars& front, const Scalars& back, double length) const
  {
    return this->Integrate({ front, back, length });
  }
  //@}

  /// The integrals of colour times extinction, and of extinction: what nothing hides.
  dvec4 Sum(const Segment& segment) const;

  /// Where one of the functions may bend or jump: as shares of a segment, with 0 and 1.
  std::vector<double> FindCuts(const Scalars& front, const Scalars& back) const;

  /// Straight colour and extinction at the ends of a segment that no cut lies in.
  std::array<dvec4, 2> Evaluate(const Segment& segment) const;

  /**
   * Straight colour and opacity, whatever the length, of scalars; independent components mix by
   * their opacities. At most opaque. The steepness counts for 2D functions only.
   */
  dvec4 Map(const Scalars& scalars, const Scalars& steepness) const;

  /// The same of one of the independent components alone.
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
  /// Calls add(ends, length) for each piece along which colour and extinction are linear, front to
  /// back.
  template <typename Add>
  void AddPieces(const Segment& piece, int depth, const Add& add) const;
  template <typename Add>
  void AddAllPieces(const Segment& segment, const Add& add) const;
  //@}

  Mixing Mode = Mixing::Independent;
  int NumberOfComponents = 1;
  std::vector<Curve> Curves; // of two dependent components one after the other
  Curve Direct = {};         // of colours: all but the pieces
};
}

#endif

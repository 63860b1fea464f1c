// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/TransferFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relevo
{
namespace
{
// Of colours, opacities and thus optical depths over a unit distance. Much finer than the 1/512
// that pictures need: this is what they are measured against.
constexpr double Tolerance = 1e-5;

// Nodes and, between them, midpoints, where functions of VTK bend or jump. A midpoint next to a
// node is taken as 0.00001 of the interval away from it, as they do.
template <int Size, typename TransferFunction>
void AddKinks(TransferFunction* function, std::vector<double>& kinks)
{
  double last[Size] = {};
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[Size];
    function->GetNodeValue(i, node);
    if (std::isfinite(node[0]))
    {
      kinks.push_back(node[0]);
      if (i > 0 && last[0] < node[0] && std::isfinite(last[0]))
      {
        const double midpoint = std::clamp(last[Size - 2], 1e-5, 1.0 - 1e-5);
        kinks.push_back(last[0] + midpoint * (node[0] - last[0]));
      }
    }
    std::copy(node, node + Size, last);
  }
}

// A component's functions, which may lack nodes.
struct Functions
{
  vtkColorTransferFunction* Color = nullptr; // or
  vtkPiecewiseFunction* Gray = nullptr;
  vtkPiecewiseFunction* Opacity = nullptr;

  Functions(vtkVolumeProperty* property, int component)
  {
    if (property->GetColorChannels(component) == 1)
    {
      this->Gray = property->GetGrayTransferFunction(component);
    }
    else
    {
      this->Color = property->GetRGBTransferFunction(component);
    }
    this->Opacity = property->GetScalarOpacity(component);
  }

  const char* FindEmpty() const
  {
    const int colors = this->Gray ? this->Gray->GetSize() : this->Color->GetSize();
    return colors == 0 ? "colour" : this->Opacity->GetSize() == 0 ? "scalar opacity" : nullptr;
  }
  void AddColorKinks(std::vector<double>& kinks) const
  {
    if (this->Gray)
    {
      AddKinks<4>(this->Gray, kinks);
    }
    else
    {
      AddKinks<6>(this->Color, kinks);
    }
  }
  dvec3 GetColor(double x) const
  {
    if (this->Gray)
    {
      return dvec3(this->Gray->GetValue(x));
    }
    dvec3 color;
    this->Color->GetColor(x, &color.x);
    return color;
  }
  double GetOpacity(double x) const { return std::max(this->Opacity->GetValue(x), 0.0); }
};

LinearPieces MakeColors(const Functions& functions)
{
  std::vector<double> kinks;
  functions.AddColorKinks(kinks);
  return LinearPieces(
    [&](double x) { return dvec4(functions.GetColor(x), 0.0); }, kinks, Tolerance);
}

LinearPieces MakeOpacities(const Functions& functions)
{
  std::vector<double> kinks;
  AddKinks<4>(functions.Opacity, kinks);
  return LinearPieces(
    [&](double x) { return dvec4(0.0, 0.0, 0.0, functions.GetOpacity(x)); }, kinks, Tolerance);
}

LinearPieces MakeBoth(const Functions& functions)
{
  std::vector<double> kinks;
  functions.AddColorKinks(kinks);
  AddKinks<4>(functions.Opacity, kinks);
  return LinearPieces([&](double x)
    { return dvec4(functions.GetColor(x), functions.GetOpacity(x)); },
    kinks, Tolerance);
}

double ReadUnitDistance(vtkVolumeProperty* property, int component, std::string& warning)
{
  const double distance = property->GetScalarOpacityUnitDistance(component);
  if (distance > 0.0 && std::isfinite(distance))
  {
    return distance;
  }
  std::ostringstream text;
  text << "has a ScalarOpacityUnitDistance of " << distance << " for component " << component
       << ", which must be more than 0: 1 is used";
  warning = text.str();
  return 1.0;
}
}

bool TransferFunctions::Read(
  vtkVolumeProperty* property, int numberOfComponents, std::string& error, std::string& warning)
{
  const bool isIndependent = property->GetIndependentComponents() != 0 || numberOfComponents == 1;
  if (numberOfComponents > MostComponents ||
    (!isIndependent && numberOfComponents != 2 && numberOfComponents != MostComponents))
  {
    std::ostringstream text;
    text << "has " << (isIndependent ? "independent components, at most 4" : "dependent components")
         << (isIndependent ? "" : ", 2 or 4") << ", but the array has " << numberOfComponents;
    error = text.str();
    return false;
  }
  this->Mode = isIndependent  ? Mixing::Independent
    : numberOfComponents == 2 ? Mixing::Two
                              : Mixing::Four;
  this->NumberOfComponents = numberOfComponents;
  this->Curves.clear();
  if (this->Mode == Mixing::Four)
  {
    this->UnitDistance = ReadUnitDistance(property, 0, warning);
    return true;
  }
  const int sets = isIndependent ? numberOfComponents : 1;
  for (int i = 0; i < sets; ++i)
  {
    const Functions functions(property, i);
    if (const char* empty = functions.FindEmpty())
    {
      std::ostringstream text;
      text << "has a " << empty << " function without nodes for component " << i;
      error = text.str();
      return false;
    }
    const double unit = ReadUnitDistance(property, i, warning);
    if (isIndependent)
    {
      this->Curves.push_back({ i, unit, MakeBoth(functions) });
    }
    else
    {
      this->Curves.push_back({ 0, unit, MakeColors(functions) });
      this->Curves.push_back({ 1, unit, MakeOpacities(functions) });
    }
  }
  return true;
}

dvec4 TransferFunctions::Integrate(const Scalars& front, const Scalars& back, double length) const
{
  const std::vector<double> cuts = this->FindCuts(front, back);
  dvec4 seen(0.0);
  for (size_t i = 1; i < cuts.size(); ++i)
  {
    const auto ends =
      this->Evaluate(Interpolate(front, back, cuts[i - 1]), Interpolate(front, back, cuts[i]));
    seen = frontOverBack(seen, linearSegment(ends[0], ends[1], (cuts[i] - cuts[i - 1]) * length));
  }
  return seen;
}

dvec4 TransferFunctions::Sum(const Scalars& front, const Scalars& back, double length) const
{
  const std::vector<double> cuts = this->FindCuts(front, back);
  dvec4 sum(0.0);
  for (size_t i = 1; i < cuts.size(); ++i)
  {
    const auto ends =
      this->Evaluate(Interpolate(front, back, cuts[i - 1]), Interpolate(front, back, cuts[i]));
    sum += linearSegmentSum(ends[0], ends[1], (cuts[i] - cuts[i - 1]) * length);
  }
  return sum;
}

std::vector<double> TransferFunctions::FindCuts(const Scalars& front, const Scalars& back) const
{
  std::vector<double> cuts = { 0.0, 1.0 };
  for (const Curve& curve : this->Curves)
  {
    const double begin = front[curve.Component];
    const double end = back[curve.Component];
    const std::vector<double>& nodes = curve.Pieces.GetNodes();
    const double highest = std::max(begin, end);
    for (auto node = std::upper_bound(nodes.begin(), nodes.end(), std::min(begin, end));
         node != nodes.end() && *node < highest; ++node)
    {
      cuts.push_back((*node - begin) / (end - begin));
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

std::array<dvec4, 2> TransferFunctions::Evaluate(const Scalars& front, const Scalars& back) const
{
  AllEnds all = this->EvaluateAll(front, back);
  for (int end = 0; end < 2; ++end)
  {
    all[0][end].w /= this->Mode == Mixing::Four ? this->UnitDistance : 1.0;
    for (size_t i = 0; i < this->Curves.size(); ++i)
    {
      all[i][end].w /= this->Curves[i].UnitDistance;
    }
  }
  return this->Mix(all);
}

dvec4 TransferFunctions::Map(const Scalars& scalars) const
{
  const dvec4 mixed = this->Mix(this->EvaluateAll(scalars, scalars))[0];
  return dvec4(dvec3(mixed), std::min(mixed.w, 1.0));
}

dvec4 TransferFunctions::MapCurve(size_t curve, const Scalars& scalars) const
{
  const dvec4 value = EvaluateCurve(this->Curves[curve], scalars, scalars)[0];
  return dvec4(dvec3(value), std::min(value.w, 1.0));
}

// Straight colours and opacities.
TransferFunctions::AllEnds TransferFunctions::EvaluateAll(
  const Scalars& front, const Scalars& back) const
{
  AllEnds all;
  if (this->Mode == Mixing::Four)
  {
    const auto get = [](const Scalars& s)
    { return max(dvec4(s[0], s[1], s[2], s[3]), dvec4(0.0)); };
    all[0] = { { get(front), get(back) } };
  }
  for (size_t i = 0; i < this->Curves.size(); ++i)
  {
    all[i] = EvaluateCurve(this->Curves[i], front, back);
  }
  return all;
}

// By the piece that the middle lies in, as the ends may be where pieces meet.
TransferFunctions::Ends TransferFunctions::EvaluateCurve(
  const Curve& curve, const Scalars& front, const Scalars& back)
{
  const double begin = front[curve.Component];
  const double end = back[curve.Component];
  const size_t piece = curve.Pieces.FindPiece(0.5 * begin + 0.5 * end);
  const auto get = [&](double at)
  {
    return max(curve.Pieces.Evaluate(piece, at), dvec4(0.0)); // rounding may be below
  };
  return { { get(begin), get(end) } };
}

TransferFunctions::Ends TransferFunctions::Mix(const AllEnds& all) const
{
  if (this->Mode == Mixing::Two)
  {
    return { { all[0][0] + all[1][0], all[0][1] + all[1][1] } };
  }
  return this->Curves.size() <= 1 ? all[0] : this->MixIndependent(all);
}

// Where no component has any extinction, its share in the colour is the one that it has next to
// there: what it has at the other end.
TransferFunctions::Ends TransferFunctions::MixIndependent(const AllEnds& all) const
{
  dvec2 sums(0.0);
  for (size_t i = 0; i < this->Curves.size(); ++i)
  {
    sums += dvec2(all[i][0].w, all[i][1].w);
  }
  Ends mixed = { { dvec4(0.0, 0.0, 0.0, sums[0]), dvec4(0.0, 0.0, 0.0, sums[1]) } };
  for (int end = 0; end < 2; ++end)
  {
    const int weighing = sums[end] > 0.0 ? end : 1 - end;
    for (size_t i = 0; i < this->Curves.size() && sums[weighing] > 0.0; ++i)
    {
      const double share = all[i][weighing].w / sums[weighing];
      mixed[end] += share * dvec4(dvec3(all[i][end]), 0.0);
    }
  }
  return mixed;
}
}

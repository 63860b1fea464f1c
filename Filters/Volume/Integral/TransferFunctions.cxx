// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/TransferFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace relevo
{
namespace
{
// Of colours and opacities, and thus of optical depths over a unit distance. Much smaller than the
// 1/512 that images require, because tests compare images with this reference.
constexpr double Tolerance = 1e-5;
// 2^8 pieces are sufficient for the steepest mixture of two colours.
constexpr int DeepestHalving = 8;

// Adds the nodes and midpoints of a VTK function, where it can have kinks or jumps. Like VTK, keeps
// midpoints at least 0.00001 of the interval away from nodes.
template <int Size, typename TransferFunction>
void AddKinks(TransferFunction* function, std::vector<double>& kinks)
{
  double last[Size] = {};
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[Size];
    function->GetNodeValue(i, node);
    kinks.push_back(node[0]);
    if (i > 0 && last[0] < node[0])
    {
      const double midpoint = std::clamp(last[Size - 2], 1e-5, 1.0 - 1e-5);
      kinks.push_back(last[0] + midpoint * (node[0] - last[0]));
    }
    std::copy(node, node + Size, last);
  }
}

// Describes the first node with a value that is not finite, or returns "".
template <int Size, typename TransferFunction>
std::string FindBadNode(TransferFunction* function)
{
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[Size];
    function->GetNodeValue(i, node);
    if (!std::all_of(node, node + Size, [](double number) { return std::isfinite(number); }))
    {
      std::ostringstream text;
      text << "with a number that is not finite at node " << i;
      return text.str();
    }
  }
  return "";
}

// Returns "without nodes", the description of an invalid node, or "" for a valid function.
template <int Size, typename TransferFunction>
std::string FindError(TransferFunction* function)
{
  return function->GetSize() == 0 ? "without nodes" : FindBadNode<Size>(function);
}

// The message continues "The volume property ".
std::string DescribeError(const char* kind, const std::string& error, int component)
{
  std::ostringstream text;
  text << "has a " << kind << " function " << error << " for component " << component;
  return text.str();
}

// The functions of a component, possibly without nodes.
struct Functions
{
  vtkColorTransferFunction* Color = nullptr; // or Gray
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

  // Returns the kind and the error of the first invalid function.
  std::pair<const char*, std::string> FindError() const
  {
    const std::string ofColor =
      this->Gray ? relevo::FindError<4>(this->Gray) : relevo::FindError<6>(this->Color);
    return ofColor.empty() ? std::make_pair("scalar opacity", relevo::FindError<4>(this->Opacity))
                           : std::make_pair("colour", ofColor);
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

// `pieces` has no nodes if gradient opacity is off.
bool ReadGradientOpacity(
  vtkVolumeProperty* property, int component, LinearPieces& pieces, std::string& error)
{
  pieces = LinearPieces();
  if (!property->HasGradientOpacity(component) || property->GetDisableGradientOpacity(component))
  {
    return true;
  }
  vtkPiecewiseFunction* function = property->GetGradientOpacity(component);
  const std::string reason = FindError<4>(function);
  if (!reason.empty())
  {
    error = DescribeError("gradient opacity", reason, component);
    return false;
  }
  std::vector<double> kinks;
  AddKinks<4>(function, kinks);
  pieces = LinearPieces([=](double x)
    { return dvec4(0.0, 0.0, 0.0, std::max(function->GetValue(x), 0.0)); },
    kinks, Tolerance);
  return true;
}

double ComputeGradientOpacity(const LinearPieces& pieces, double steepness)
{
  return pieces.GetNodes().empty() ? 1.0
                                   : pieces.Evaluate(pieces.FindPiece(steepness), steepness).w;
}

const std::vector<double>& GetNodes(const TransferFunctions::Curve& curve)
{
  return curve.Table.IsEmpty() ? curve.Pieces.GetNodes() : curve.Table.GetColumns();
}

// Returns whether a node is inside of a segment.
bool HasCut(const std::vector<TransferFunctions::Curve>& curves, const Segment& segment)
{
  return std::any_of(curves.begin(), curves.end(),
    [&](const TransferFunctions::Curve& curve)
    {
      const auto ends = std::minmax(segment.Front[curve.Component], segment.Back[curve.Component]);
      const std::vector<double>& nodes = GetNodes(curve);
      const auto node = std::upper_bound(nodes.begin(), nodes.end(), ends.first);
      return node != nodes.end() && *node < ends.second;
    });
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
       << "; it must be more than 0, and 1 is used instead";
  warning = text.str();
  return 1.0;
}
}

Segment Segment::Cut(double begin, double end) const
{
  const auto interpolate = [this](double share)
  {
    Lights lights;
    for (size_t i = 0; i < lights.size(); ++i)
    {
      lights[i] = mix(this->FrontLights[i], this->BackLights[i], share);
    }
    return lights;
  };
  return { Interpolate(this->Front, this->Back, begin), Interpolate(this->Front, this->Back, end),
    (end - begin) * this->Length, this->Steepness, this->IsLit, interpolate(begin),
    interpolate(end) };
}

bool TransferFunctions::Read(
  vtkVolumeProperty* property, int numberOfComponents, std::string& error, std::string& warning)
{
  const bool isIndependent = property->GetIndependentComponents() != 0 || numberOfComponents == 1;
  if (numberOfComponents > MaximumComponents ||
    (!isIndependent && numberOfComponents != 2 && numberOfComponents != MaximumComponents))
  {
    std::ostringstream text;
    text << "has "
         << (isIndependent ? "independent components, which can be at most 4"
                           : "dependent components, which must be 2 or 4")
         << ", but the array has " << numberOfComponents;
    error = text.str();
    return false;
  }
  this->Mode = isIndependent  ? Mixing::Independent
    : numberOfComponents == 2 ? Mixing::Two
                              : Mixing::Four;
  this->NumberOfComponents = numberOfComponents;
  this->Curves.clear();
  this->Direct = {};
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    return this->ReadTables(property, error, warning);
  }
  if (this->Mode == Mixing::Four)
  {
    this->Direct.UnitDistance = ReadUnitDistance(property, 0, warning);
    return ReadGradientOpacity(property, 0, this->Direct.GradientOpacity, error);
  }
  return this->ReadCurves(property, error, warning);
}

Dependencies TransferFunctions::FindDependencies(
  vtkVolumeProperty* property, int numberOfComponents)
{
  const int mode = property->GetTransferFunctionMode();
  const bool isIndependent = property->GetIndependentComponents() != 0;
  Dependencies found = Dependencies::On(numberOfComponents, isIndependent, mode);
  for (int i = 0; i < (isIndependent ? std::min(numberOfComponents, MaximumComponents) : 1); ++i)
  {
    found.Add(property->GetScalarOpacityUnitDistance(i));
    if (mode == vtkVolumeProperty::TF_2D)
    {
      found.AddObject(property->GetTransferFunction2D(i));
      continue;
    }
    const Functions functions(property, i);
    found.AddObject(functions.Color);
    found.AddObject(functions.Gray);
    found.AddObject(functions.Opacity);
    const bool hasGradientOpacity =
      property->HasGradientOpacity(i) && !property->GetDisableGradientOpacity(i);
    found.AddObject(hasGradientOpacity ? property->GetGradientOpacity(i) : nullptr);
  }
  return found;
}

bool TransferFunctions::ReadCurves(
  vtkVolumeProperty* property, std::string& error, std::string& warning)
{
  const int sets = this->Mode == Mixing::Independent ? this->NumberOfComponents : 1;
  for (int i = 0; i < sets; ++i)
  {
    const Functions functions(property, i);
    const std::pair<const char*, std::string> reason = functions.FindError();
    if (!reason.second.empty())
    {
      error = DescribeError(reason.first, reason.second, i);
      return false;
    }
    const double unit = ReadUnitDistance(property, i, warning);
    LinearPieces gradients;
    if (!ReadGradientOpacity(property, i, gradients, error))
    {
      return false;
    }
    if (this->Mode == Mixing::Independent)
    {
      this->Curves.push_back({ i, unit, MakeBoth(functions), gradients, {} });
    }
    else
    {
      this->Curves.push_back({ 0, unit, MakeColors(functions), {}, {} });
      this->Curves.push_back({ 1, unit, MakeOpacities(functions), gradients, {} });
    }
  }
  return true;
}

bool TransferFunctions::ReadTables(
  vtkVolumeProperty* property, std::string& error, std::string& warning)
{
  const bool isIndependent = this->Mode == Mixing::Independent;
  const int sets = isIndependent ? this->NumberOfComponents : 1;
  this->Mode = Mixing::Independent;
  for (int i = 0; i < sets; ++i)
  {
    vtkImageData* image = property->GetTransferFunction2D(i);
    Curve curve = { isIndependent ? i : this->NumberOfComponents - 1,
      ReadUnitDistance(property, i, warning), {}, {}, {} };
    std::string reason;
    if (!image || !curve.Table.Read(image, reason))
    {
      std::ostringstream text;
      text << "has " << (image ? "a" : "no") << " 2D transfer function " << reason
           << (image ? " " : "") << "for component " << i
           << (image ? "" : "; call SetTransferFunction2D()");
      error = text.str();
      return false;
    }
    this->Curves.push_back(curve);
  }
  return true;
}

bool TransferFunctions::NeedSteepness() const
{
  return !this->Direct.GradientOpacity.GetNodes().empty() ||
    std::any_of(this->Curves.begin(), this->Curves.end(),
      [](const Curve& curve)
      { return !curve.Table.IsEmpty() || !curve.GradientOpacity.GetNodes().empty(); });
}

int TransferFunctions::GetShadedComponent(size_t curve) const
{
  return this->Mode == Mixing::Independent ? this->Curves[curve].Component
                                           : this->NumberOfComponents - 1;
}

// The mixed colour of independent components is a quotient of linear functions. Pieces are halved
// until it is nearly linear.
template <typename Add>
void TransferFunctions::AddPieces(const Segment& piece, int depth, const Add& add) const
{
  const Ends ends = this->Evaluate(piece);
  if (this->Mode == Mixing::Independent && this->Curves.size() > 1 && depth < DeepestHalving)
  {
    const Segment first = piece.Cut(0.0, 0.5);
    const dvec4 middle = this->Evaluate(first)[1];
    const dvec3 miss = abs(dvec3(middle) - 0.5 * (dvec3(ends[0]) + dvec3(ends[1])));
    const double seen = std::min(middle.w * piece.Length, 1.0);
    if (std::max({ miss.x, miss.y, miss.z }) * seen > Tolerance)
    {
      this->AddPieces(first, depth + 1, add);
      this->AddPieces(piece.Cut(0.5, 1.0), depth + 1, add);
      return;
    }
  }
  add(ends, piece.Length);
}

template <typename Add>
void TransferFunctions::AddAllPieces(const Segment& segment, const Add& add) const
{
  if (!HasCut(this->Curves, segment))
  {
    this->AddPieces(segment, 0, add);
    return;
  }
  const std::vector<double> cuts = this->FindCuts(segment.Front, segment.Back);
  for (size_t i = 1; i < cuts.size(); ++i)
  {
    this->AddPieces(segment.Cut(cuts[i - 1], cuts[i]), 0, add);
  }
}

dvec4 TransferFunctions::Integrate(const Segment& segment) const
{
  dvec4 seen(0.0);
  this->AddAllPieces(segment,
    [&seen](const Ends& ends, double length)
    { seen = frontOverBack(seen, linearSegment(ends[0], ends[1], length)); });
  return seen;
}

dvec4 TransferFunctions::Sum(const Segment& segment) const
{
  dvec4 sum(0.0);
  this->AddAllPieces(segment,
    [&sum](const Ends& ends, double length) { sum += linearSegmentSum(ends[0], ends[1], length); });
  return sum;
}

std::vector<double> TransferFunctions::FindCuts(const Scalars& front, const Scalars& back) const
{
  std::vector<double> cuts = { 0.0, 1.0 };
  for (const Curve& curve : this->Curves)
  {
    const double begin = front[curve.Component];
    const double end = back[curve.Component];
    const std::vector<double>& nodes = GetNodes(curve);
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

std::array<dvec4, 2> TransferFunctions::Evaluate(const Segment& segment) const
{
  AllEnds all = this->EvaluateAll(segment);
  const size_t count = std::max<size_t>(this->Curves.size(), 1);
  for (size_t i = 0; i < count; ++i)
  {
    const Curve& curve = this->Curves.empty() ? this->Direct : this->Curves[i];
    const double steepness =
      segment.Steepness[this->Curves.empty() ? MaximumComponents - 1 : curve.Component];
    const double share =
      ComputeGradientOpacity(curve.GradientOpacity, steepness) / curve.UnitDistance;
    for (int end = 0; end < 2; ++end)
    {
      dvec4& ends = all[i][end];
      const dvec2& light = (end == 0 ? segment.FrontLights : segment.BackLights)[i];
      ends = dvec4(segment.IsLit ? lightenColor(dvec3(ends), light) : dvec3(ends), ends.w * share);
    }
  }
  return this->Mix(all);
}

dvec4 TransferFunctions::Map(const Scalars& scalars, const Scalars& steepness) const
{
  const dvec4 mixed = this->Mix(this->EvaluateAll({ scalars, scalars, 0.0, steepness }))[0];
  return dvec4(dvec3(mixed), std::min(mixed.w, 1.0));
}

dvec4 TransferFunctions::MapCurve(
  size_t curve, const Scalars& scalars, const Scalars& steepness) const
{
  const dvec4 value = EvaluateCurve(this->Curves[curve], { scalars, scalars, 0.0, steepness })[0];
  return dvec4(dvec3(value), std::min(value.w, 1.0));
}

// Returns straight colours and opacities of all curves.
TransferFunctions::AllEnds TransferFunctions::EvaluateAll(const Segment& segment) const
{
  AllEnds all;
  if (this->Mode == Mixing::Four)
  {
    const auto get = [](const Scalars& s)
    { return max(dvec4(s[0], s[1], s[2], s[3]), dvec4(0.0)); };
    all[0] = { { get(segment.Front), get(segment.Back) } };
  }
  for (size_t i = 0; i < this->Curves.size(); ++i)
  {
    all[i] = EvaluateCurve(this->Curves[i], segment);
  }
  return all;
}

// Uses the piece at the middle, because both ends may be at nodes.
TransferFunctions::Ends TransferFunctions::EvaluateCurve(const Curve& curve, const Segment& segment)
{
  const double begin = segment.Front[curve.Component];
  const double end = segment.Back[curve.Component];
  if (!curve.Table.IsEmpty())
  {
    const double steepness = segment.Steepness[curve.Component];
    return { { curve.Table.Evaluate(begin, steepness), curve.Table.Evaluate(end, steepness) } };
  }
  const size_t piece = curve.Pieces.FindPiece(0.5 * begin + 0.5 * end);
  const auto get = [&](double at)
  {
    return max(curve.Pieces.Evaluate(piece, at), dvec4(0.0)); // rounding errors can be negative
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

// If no component has extinction at one end, the mixed colour uses the weights of the other end,
// which are those of the limit.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeFunctions.h"

#include "Options/ViewerOptions.h"
#include "Scene/MeshColours.h"
#include "Scene/VolumeArray.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkScalarsToColors.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace
{
const int Nodes = 9;
const double LowestShare = 0.03; // opacity at the lowest value, relative to the highest
const double Depth = 20.0;       // optical depth of a diagonal at the highest value
const double OpacityOfOneValue = 0.8;
const double MinimumThickness = 1e-3; // relative to the diagonal
const double PeakWidth = 2e-4;        // relative to the range

// Share of values below each value, 0 to 1. Of equal quantiles the last one is used.
std::map<double, double> GetRanks(const VolumeArray& array)
{
  std::map<double, double> ranks = { { array.Range[0], 0.0 }, { array.Range[1], 1.0 } };
  for (std::size_t i = 0; i < array.Quantiles.size(); ++i)
  {
    if (array.Quantiles[i] >= array.Range[0] && array.Quantiles[i] <= array.Range[1])
    {
      ranks[array.Quantiles[i]] = static_cast<double>(i) / (array.Quantiles.size() - 1);
    }
  }
  return ranks;
}

double Interpolate(const std::map<double, double>& ranks, double value)
{
  const auto after = ranks.lower_bound(value);
  if (after == ranks.begin() || after == ranks.end())
  {
    return after == ranks.end() ? 1.0 : after->second;
  }
  const auto before = std::prev(after);
  const double t = (value - before->first) / (after->first - before->first);
  return before->second + t * (after->second - before->second);
}

// Interpolates between the nodes before and after the value.
TransferNode Interpolate(const std::vector<TransferNode>& nodes, double value)
{
  const auto after = std::lower_bound(nodes.begin(), nodes.end(), value,
    [](const TransferNode& node, double limit) { return node.Value < limit; });
  TransferNode node = after == nodes.end() ? nodes.back() : *after;
  if (after != nodes.begin() && after != nodes.end())
  {
    const TransferNode& before = *std::prev(after);
    const double t = (value - before.Value) / (after->Value - before.Value);
    for (int c = 0; c < 3; ++c)
    {
      node.Color[c] = before.Color[c] + t * (after->Color[c] - before.Color[c]);
    }
    node.Opacity = before.Opacity + t * (after->Opacity - before.Opacity);
  }
  node.Value = value;
  return node;
}
}

//------------------------------------------------------------------------------
std::vector<TransferNode> MakeTransferNodes(
  const ViewerOptions& options, const VolumeArray& array, double cellsOfSide, double thickness)
{
  using Mapper = vtkVolumeMapper;
  const bool isByLength =
    options.BlendMode == Mapper::COMPOSITE_BLEND || options.BlendMode == Mapper::ADDITIVE_BLEND;
  // Additive blending saturates early.
  const double depth = options.BlendMode == Mapper::ADDITIVE_BLEND ? 0.2 * Depth : Depth;
  const double cube = 2.0 / 3.0 / std::sqrt(3.0); // mean chord of a cube, relative to its diagonal
  const double thinness =
    thickness > 0.0 ? std::max(cube / std::max(thickness, MinimumThickness), 1.0) : 1.0;
  // Coarse blocks have at most opacity 1. Thin parts have few cells, however fine these are.
  const double highest = std::min(depth * thinness / cellsOfSide, thinness * thinness);
  const std::map<double, double> ranks = GetRanks(array);
  std::set<double> values;
  for (int i = 0; i < Nodes; ++i)
  {
    const double value = options.HasLogColors
      ? array.Range[0] *
        std::pow(array.Range[1] / array.Range[0], static_cast<double>(i) / (Nodes - 1))
      : array.Range[0] + i * (array.Range[1] - array.Range[0]) / (Nodes - 1);
    values.insert(std::min(value, array.Range[1]));
  }
  for (const auto& rank : ranks)
  {
    values.insert(rank.first);
  }
  const auto colours = MakeColourFunction(options, array.Range);
  // Opacities follow the scale of the colours.
  const auto getShare = [&](double value)
  {
    return options.HasLogColors
      ? std::log(value / array.Range[0]) / std::log(array.Range[1] / array.Range[0])
      : (value - array.Range[0]) / (array.Range[1] - array.Range[0]);
  };
  std::vector<TransferNode> nodes;
  for (double value : values)
  {
    TransferNode node;
    node.Value = value;
    colours->GetColor(value, node.Color.data());
    // Values show the distribution; ranks show every part despite outliers.
    const double share = getShare(value);
    const double rank = Interpolate(ranks, value);
    const double height = 0.7 * share * share + 0.3 * rank * rank;
    node.Opacity =
      isByLength ? highest * (LowestShare + (1.0 - LowestShare) * height) : OpacityOfOneValue;
    nodes.push_back(node);
  }
  return nodes;
}

//------------------------------------------------------------------------------
std::vector<TransferNode> AddPeaks(
  std::vector<TransferNode> nodes, const std::vector<double>& values, double opacity)
{
  const double reach = 0.5 * PeakWidth * (nodes.back().Value - nodes.front().Value);
  const std::vector<TransferNode> plain = nodes;
  for (double value : values)
  {
    // Removes other nodes within the peak.
    nodes.erase(std::remove_if(nodes.begin(), nodes.end(),
                  [=](const TransferNode& node)
                  { return node.Value >= value - reach && node.Value <= value + reach; }),
      nodes.end());
    for (int side = -1; side <= 1; ++side)
    {
      TransferNode node = Interpolate(plain, value + side * reach);
      node.Opacity = side == 0 ? std::max(std::min(node.Opacity, 1.0), opacity) : node.Opacity;
      nodes.push_back(node);
    }
  }
  std::sort(nodes.begin(), nodes.end(),
    [](const TransferNode& a, const TransferNode& b) { return a.Value < b.Value; });
  return nodes;
}

//------------------------------------------------------------------------------
void SetTransferNodes(vtkVolumeProperty* property, const std::vector<TransferNode>& nodes,
  double factor, vtkColorTransferFunction* colours)
{
  vtkNew<vtkColorTransferFunction> ofNodes;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (const TransferNode& node : nodes)
  {
    ofNodes->AddRGBPoint(node.Value, node.Color[0], node.Color[1], node.Color[2]);
    opacities->AddPoint(node.Value, std::min(factor * node.Opacity, std::max(node.Opacity, 1.0)));
  }
  if (!colours)
  {
    colours = ofNodes;
  }
  // The legend follows the function. VTK 9.1 does not copy the colours out of range.
  vtkColorTransferFunction* own = property->GetRGBTransferFunction();
  own->DeepCopy(colours);
  own->SetUseBelowRangeColor(colours->GetUseBelowRangeColor());
  own->SetBelowRangeColor(colours->GetBelowRangeColor());
  own->SetUseAboveRangeColor(colours->GetUseAboveRangeColor());
  own->SetAboveRangeColor(colours->GetAboveRangeColor());
  property->SetColor(own);
  property->SetScalarOpacity(opacities);
}

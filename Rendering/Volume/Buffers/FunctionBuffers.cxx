// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/FunctionBuffers.h"

#include "Buffers/VisibleIntervals.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>

namespace relevo
{
namespace
{
constexpr float Infinity = std::numeric_limits<float>::max();

float Round(double value)
{
  return static_cast<float>(
    std::clamp(value, -static_cast<double>(Infinity), static_cast<double>(Infinity)));
}

// Add a piece for scalars from begin to end, with its values at both ends.
void AddPiece(
  float begin, float end, const dvec4& first, const dvec4& last, std::vector<float>& all)
{
  const bool isOpen = begin == -Infinity || end == Infinity || end <= begin;
  for (float value : { begin, end, isOpen ? 0.0f : 1.0f / (end - begin), 0.0f })
  {
    all.push_back(value);
  }
  for (const dvec4& value : { first, last - first })
  {
    for (int i = 0; i < 4; ++i)
    {
      all.push_back(Round(value[i]));
    }
  }
}

// Return the pieces of a function, and the nodes where they meet. If the function has opacity,
// adjacent transparent pieces become one, because their colours have no effect.
std::vector<size_t> FindPieces(
  const LinearPieces& pieces, bool hasOpacity, std::vector<double>& nodes)
{
  const std::vector<double>& all = pieces.GetNodes();
  std::vector<size_t> kept = { 0 };
  bool wasTransparent = hasOpacity && IsTransparent(pieces, 0);
  for (size_t piece = 1; piece <= all.size(); ++piece)
  {
    const bool isTransparent = hasOpacity && IsTransparent(pieces, piece);
    const bool isNeeded = piece == all.size() && nodes.empty(); // at least one node
    if (!(wasTransparent && isTransparent) || isNeeded)
    {
      nodes.push_back(all[piece - 1]);
      kept.push_back(piece);
    }
    wasTransparent = isTransparent;
  }
  return kept;
}

// The functions are constant before the first node and after the last.
template <typename Position, typename Get>
void AddAll(const std::vector<double>& nodes, const Position& position, const Get& get,
  std::vector<float>& all)
{
  for (size_t i = 0; i <= nodes.size(); ++i)
  {
    const double begin = nodes[i == 0 ? 0 : i - 1];
    const double end = nodes[i == nodes.size() ? i - 1 : i];
    AddPiece(i == 0 ? -Infinity : position(begin), i == nodes.size() ? Infinity : position(end),
      get(i, begin), get(i, end), all);
  }
}
}

// Rays need not be split in transparent parts.
void FunctionBuffers::AddPieces(
  const TransferFunctions::Curve& curve, bool hasOpacity, double low, double size)
{
  std::vector<double> nodes;
  const std::vector<size_t> kept = FindPieces(curve.Pieces, hasOpacity, nodes);
  this->Curves.First.push_back(static_cast<int>(this->Texels.size() / 12));
  this->Curves.Sizes.push_back(static_cast<int>(nodes.size()));
  const auto get = [&](size_t piece, double at)
  {
    const dvec4 value = max(curve.Pieces.Evaluate(kept[piece], at), dvec4(0.0));
    return dvec4(dvec3(value), value.w / curve.UnitDistance);
  };
  AddAll(
    nodes, [=](double node) { return Round((node - low) / size); }, get, this->Texels);
}

// Add a row of pieces for each row of the image.
void FunctionBuffers::AddTable(
  const TransferFunctions::Curve& curve, double low, double size, double steepness)
{
  const std::vector<double>& nodes = curve.Table.GetColumns();
  const std::vector<double>& rows = curve.Table.GetRows();
  this->Curves.First.push_back(static_cast<int>(this->Texels.size() / 12));
  this->Curves.Sizes.push_back(static_cast<int>(nodes.size()));
  const double distance = rows.size() > 1 ? rows[1] - rows[0] : 1.0;
  this->Rows.push_back(Round(rows[0] / steepness));
  this->Rows.push_back(Round(steepness / distance));
  this->Rows.push_back(static_cast<float>(rows.size() - 1));
  for (double row : rows)
  {
    const auto get = [&](size_t, double at)
    {
      const dvec4 value = curve.Table.Evaluate(at, row);
      return dvec4(dvec3(value), value.w / curve.UnitDistance);
    };
    AddAll(
      nodes, [=](double node) { return Round((node - low) / size); }, get, this->Texels);
  }
}

// Without a function, the gradient opacity is 1.
void FunctionBuffers::AddGradientOpacity(const LinearPieces& pieces, double steepness)
{
  this->Gradients.First.push_back(static_cast<int>(this->Texels.size() / 12));
  this->Gradients.Sizes.push_back(static_cast<int>(pieces.GetNodes().size()));
  if (pieces.GetNodes().empty())
  {
    AddPiece(-Infinity, Infinity, dvec4(1.0), dvec4(1.0), this->Texels);
    return;
  }
  AddAll(
    pieces.GetNodes(), [=](double node) { return Round(node / steepness); },
    [&](size_t piece, double at) { return pieces.Evaluate(piece, at); }, this->Texels);
}

bool FunctionBuffers::Upload(vtkOpenGLRenderWindow* window, const TransferFunctions& functions,
  const Scalars& low, const Scalars& size, double radius)
{
  this->Texels.clear();
  this->Curves = {};
  this->Gradients = {};
  this->Rows.clear();
  this->UnitDistances.clear();
  for (const TransferFunctions::Curve& curve : functions.GetCurves())
  {
    const int c = curve.Component;
    curve.Table.IsEmpty() ? this->AddPieces(curve, !functions.AreDependent(), low[c], size[c])
                          : this->AddTable(curve, low[c], size[c], size[c] / radius);
    this->AddGradientOpacity(curve.GradientOpacity, size[c] / radius);
    this->UnitDistances.push_back(Round(curve.UnitDistance));
  }
  if (functions.AreColors())
  {
    for (int i = 0; i < MaximumComponents; ++i)
    {
      const double unit = i == MaximumComponents - 1 ? functions.GetUnitDistance() : 1.0;
      this->ColorLow[i] = Round(low[i] / unit);
      this->ColorSize[i] = Round(size[i] / unit);
    }
    this->AddGradientOpacity(functions.GetGradientOpacity(), size[MaximumComponents - 1] / radius);
    this->UnitDistances.push_back(Round(functions.GetUnitDistance()));
  }
  const bool isUploaded = this->Pieces.Upload(window, this->Texels, 4);
  this->Texels = {};
  return isUploaded;
}

void FunctionBuffers::Ranges::Set(vtkShaderProgram* program, const std::string& name) const
{
  if (program->IsUniformUsed((name + "First").c_str()))
  {
    const int count = static_cast<int>(this->First.size());
    program->SetUniform1iv((name + "First").c_str(), count, this->First.data());
    program->SetUniform1iv((name + "Sizes").c_str(), count, this->Sizes.data());
  }
}

void FunctionBuffers::Activate(vtkShaderProgram* program)
{
  this->Pieces.Activate(program, "functionPieces");
  this->Curves.Set(program, "curve");
  this->Gradients.Set(program, "gradient");
  if (program->IsUniformUsed("unitDistances"))
  {
    program->SetUniform1fv(
      "unitDistances", static_cast<int>(this->UnitDistances.size()), this->UnitDistances.data());
  }
  if (program->IsUniformUsed("curveRows"))
  {
    program->SetUniform3fv("curveRows", static_cast<int>(this->Rows.size() / 3), this->Rows.data());
  }
  if (program->IsUniformUsed("scalarLow"))
  {
    program->SetUniform4f("scalarLow", this->ColorLow);
    program->SetUniform4f("scalarSize", this->ColorSize);
  }
}
}

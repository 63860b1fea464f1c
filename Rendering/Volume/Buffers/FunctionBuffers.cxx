// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/FunctionBuffers.h"

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

// A piece's scalars from begin to end, and what it has there.
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
}

bool FunctionBuffers::Upload(vtkOpenGLRenderWindow* window, const TransferFunctions& functions,
  const Scalars& low, const Scalars& size)
{
  for (int i = 0; i < MostComponents; ++i)
  {
    const double unit = i == MostComponents - 1 ? functions.GetUnitDistance() : 1.0;
    this->ColorLow[i] = Round(low[i] / unit);
    this->ColorSize[i] = Round(size[i] / unit);
  }
  this->First.clear();
  this->Sizes.clear();
  std::vector<float> texels;
  for (const TransferFunctions::Curve& curve : functions.GetCurves())
  {
    const std::vector<double>& nodes = curve.Pieces.GetNodes();
    this->First.push_back(static_cast<int>(texels.size() / 12));
    this->Sizes.push_back(static_cast<int>(nodes.size()));
    const auto place = [&](double node)
    { return Round((node - low[curve.Component]) / size[curve.Component]); };
    const auto get = [&](size_t piece, double at)
    {
      const dvec4 value = max(curve.Pieces.Evaluate(piece, at), dvec4(0.0));
      return dvec4(dvec3(value), value.w / curve.UnitDistance);
    };
    for (size_t i = 0; i <= nodes.size(); ++i)
    {
      const double begin = nodes[i == 0 ? 0 : i - 1];
      const double end = nodes[i == nodes.size() ? i - 1 : i];
      AddPiece(i == 0 ? -Infinity : place(begin), i == nodes.size() ? Infinity : place(end),
        get(i, begin), get(i, end), texels);
    }
  }
  return this->Pieces.Upload(window, texels, 4);
}

void FunctionBuffers::Activate(vtkShaderProgram* program)
{
  this->Pieces.Activate(program, "functionPieces");
  if (!this->First.empty())
  {
    const int count = static_cast<int>(this->First.size());
    program->SetUniform1iv("curveFirst", count, this->First.data());
    program->SetUniform1iv("curveSizes", count, this->Sizes.data());
  }
  else
  {
    program->SetUniform4f("scalarLow", this->ColorLow);
    program->SetUniform4f("scalarSize", this->ColorSize);
  }
}
}

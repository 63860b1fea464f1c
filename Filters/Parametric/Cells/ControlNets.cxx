// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/ControlNets.h"

#include "Mathematics/LagrangeToBezier.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Converts the values of one patch to coefficients. All components of a node are stored together.
class NetConverter
{
public:
  NetConverter(const NodeNet& net, int components, std::vector<double>&& values)
    : Components(components)
    , Degrees(net.Degrees)
    , IsTriangle(net.IsTriangle)
    , Values(std::move(values))
  {
    if (net.Basis == NodeBasis::Serendipity)
    {
      this->FillMiddle();
    }
    if (net.Basis == NodeBasis::Bubble)
    {
      this->ConvertBubble();
    }
    else if (net.Basis != NodeBasis::Bezier)
    {
      this->ConvertNodes();
    }
  }

  // Raises degree 2 to degree 3.
  void RaiseDegrees()
  {
    if (this->IsTriangle)
    {
      if (this->Degrees.x == 2)
      {
        this->RaiseTriangle();
      }
      return;
    }
    if (this->Degrees.x == 2)
    {
      this->RaiseDirection(this->Degrees.y + 1, 1, 3);
      this->Degrees.x = 3;
    }
    if (this->Degrees.y == 2)
    {
      this->RaiseDirection(this->Degrees.x + 1, this->Degrees.x + 1, 1);
      this->Degrees.y = 3;
    }
  }

  const std::vector<double>& GetCoefficients() const { return this->Values; }

private:
  double* At(std::size_t point) { return &this->Values[point * this->Components]; }

  void FillMiddle()
  {
    for (int c = 0; c < this->Components; ++c)
    {
      const auto at = [&](std::size_t i) { return this->At(i)[c]; };
      this->At(4)[c] =
        0.5 * (at(1) + at(3) + at(5) + at(7)) - 0.25 * (at(0) + at(2) + at(6) + at(8));
    }
  }

  void ConvertNodes()
  {
    if (this->IsTriangle)
    {
      ConvertLagrangeTriangleToBezier(this->Degrees.x, this->Components, this->Values.data());
      return;
    }
    const int width = this->Degrees.x + 1;
    const int height = this->Degrees.y + 1;
    for (int j = 0; j < height; ++j)
    {
      ConvertLagrangeToBezier(
        this->Degrees.x, this->Components, this->At(j * width), this->Components);
    }
    for (int i = 0; i < width; ++i)
    {
      ConvertLagrangeToBezier(
        this->Degrees.y, this->Components, this->At(i), width * this->Components);
    }
  }

  // The middle node adds a multiple of the cubic Bernstein polynomial, which has the value 2/9
  // there.
  void ConvertBubble()
  {
    const std::vector<double> nodes = this->Values;
    this->Values.resize(6 * this->Components);
    this->ConvertNodes();
    this->RaiseTriangle();
    for (int c = 0; c < this->Components; ++c)
    {
      const auto at = [&](int i) { return nodes[i * this->Components + c]; };
      const double middle = (4.0 * (at(1) + at(3) + at(4)) - (at(0) + at(2) + at(5))) / 9.0;
      this->At(5)[c] += 4.5 * (at(6) - middle);
    }
  }

  // The result does not depend on the direction, to the bit, as in ConvertLagrangeToBezier().
  double RaiseOne(double near, double inner) const { return (near + 2.0 * inner) / 3.0; }

  void RaiseTriangle()
  {
    const std::vector<double> old = this->Values;
    this->Values.resize(10 * this->Components);
    this->Degrees = ivec2(3);
    for (int c = 0; c < this->Components; ++c)
    {
      const auto at = [&](int i) { return old[i * this->Components + c]; };
      const double values[10] = { at(0), RaiseOne(at(0), at(1)), RaiseOne(at(2), at(1)), at(2),
        RaiseOne(at(0), at(3)), (at(1) + at(3) + at(4)) / 3.0, RaiseOne(at(2), at(4)),
        RaiseOne(at(5), at(3)), RaiseOne(at(5), at(4)), at(5) };
      for (int i = 0; i < 10; ++i)
      {
        this->At(i)[c] = values[i];
      }
    }
  }

  // Raises `curves` from 3 points to 4. The points of a curve are `step` apart. Curves along u
  // (step 1) are stored one after the other (rowStep 3), curves along v side by side.
  void RaiseDirection(int curves, int step, int rowStep)
  {
    const std::vector<double> old = this->Values;
    this->Values.resize(4 * curves * this->Components);
    for (int k = 0; k < curves; ++k)
    {
      const int newStart = rowStep == 1 ? k : 4 * k;
      for (int c = 0; c < this->Components; ++c)
      {
        const auto at = [&](int i) { return old[(k * rowStep + i * step) * this->Components + c]; };
        const double values[4] = { at(0), RaiseOne(at(0), at(1)), RaiseOne(at(2), at(1)), at(2) };
        for (int i = 0; i < 4; ++i)
        {
          this->At(newStart + i * step)[c] = values[i];
        }
      }
    }
  }

  int Components;
  ivec2 Degrees;
  bool IsTriangle;
  std::vector<double> Values;
};
}

ControlNets::ControlNets(NodeNets&& nodes)
  : Nodes(std::move(nodes))
{
  this->RaisesDegrees = std::any_of(this->Nodes.Nets.begin(), this->Nodes.Nets.end(),
    [](const NodeNet& net) { return net.Basis == NodeBasis::Bubble; });
  this->NumberPatches();
}

void ControlNets::NumberPatches()
{
  this->Patches.clear();
  this->NumberOfControlPoints = 0;
  for (const NodeNet& net : this->Nodes.Nets)
  {
    FacePatch patch{ { net.IsTriangle, net.Degrees, this->NumberOfControlPoints }, net.Cell,
      net.InnerBorders };
    for (int c = 0; c < 2 && this->RaisesDegrees && net.Basis != NodeBasis::Bezier; ++c)
    {
      patch.Degrees[c] = net.Degrees[c] == 2 ? 3 : net.Degrees[c];
    }
    this->NumberOfControlPoints += patch.GetNumberOfPoints();
    this->Patches.push_back(patch);
  }
}

vtkIdType ControlNets::GetCornerPoint(std::size_t patch, int corner) const
{
  const NodeNet& net = this->Nodes.Nets[patch];
  const FacePatch shape{ { net.IsTriangle, net.Degrees, 0 }, net.Cell };
  return this->Nodes.Nodes[net.First + shape.GetBorder(corner)[0]];
}

std::vector<double> ControlNets::Convert(vtkDataArray* array) const
{
  const int components = array->GetNumberOfComponents();
  std::vector<double> coefficients(this->NumberOfControlPoints * components);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Patches.size()),
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType i = first; i < end; ++i)
      {
        const NodeNet& net = this->Nodes.Nets[i];
        const vtkIdType last = i + 1 < static_cast<vtkIdType>(this->Nodes.Nets.size())
          ? this->Nodes.Nets[i + 1].First
          : static_cast<vtkIdType>(this->Nodes.Nodes.size());
        std::vector<double> values((last - net.First) * components);
        for (vtkIdType node = net.First; node < last; ++node)
        {
          array->GetTuple(this->Nodes.Nodes[node], values.data() + (node - net.First) * components);
        }
        NetConverter converter(net, components, std::move(values));
        if (this->RaisesDegrees && net.Basis != NodeBasis::Bezier)
        {
          converter.RaiseDegrees();
        }
        std::copy(converter.GetCoefficients().begin(), converter.GetCoefficients().end(),
          coefficients.begin() + this->Patches[i].FirstPoint * components);
      }
    });
  return coefficients;
}

std::vector<dvec4> ControlNets::ConvertPoints(vtkUnstructuredGrid* grid) const
{
  const std::vector<double> places = this->Convert(grid->GetPoints()->GetData());
  std::vector<dvec4> points(places.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = dvec4(places[3 * i], places[3 * i + 1], places[3 * i + 2], 1.0);
  }
  vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
  for (std::size_t i = 0; weights && i < this->Patches.size(); ++i)
  {
    const NodeNet& net = this->Nodes.Nets[i];
    const int number = net.Basis == NodeBasis::Bezier ? this->Patches[i].GetNumberOfPoints() : 0;
    for (int k = 0; k < number; ++k)
    {
      points[this->Patches[i].FirstPoint + k].w =
        weights->GetComponent(this->Nodes.Nodes[net.First + k], 0);
    }
  }
  return points;
}

void ControlNets::Keep(const std::vector<unsigned char>& isKept)
{
  NodeNets kept;
  for (std::size_t i = 0; i < this->Nodes.Nets.size(); ++i)
  {
    if (isKept[i])
    {
      NodeNet net = this->Nodes.Nets[i];
      const auto first = this->Nodes.Nodes.begin() + net.First;
      const auto last = i + 1 < this->Nodes.Nets.size()
        ? this->Nodes.Nodes.begin() + this->Nodes.Nets[i + 1].First
        : this->Nodes.Nodes.end();
      net.First = static_cast<vtkIdType>(kept.Nodes.size());
      kept.Nodes.insert(kept.Nodes.end(), first, last);
      kept.Nets.push_back(net);
    }
  }
  this->Nodes = std::move(kept);
  this->NumberPatches();
}
}

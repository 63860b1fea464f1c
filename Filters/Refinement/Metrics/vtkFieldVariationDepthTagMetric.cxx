// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFieldVariationDepthTagMetric.h"

#include "Arrays/GhostCells.h"
#include "Arrays/VectorData.h"
#include "Changes/Dependencies.h"
#include "Checks/SettingChecks.h"
#include "Levels/LevelFunctions.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/SurfaceEdges.h"
#include "Metrics/CollectOnce.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/MetricMesh.h"
#include "Parallel/PieceReduction.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr double AutomaticQuantile = 0.95;
constexpr double SmallestAutomaticMaximum = 1e-6;
constexpr double ShortestDirection = 1e-6; // relative to the longest vector

// The tuples of an array as doubles, and their differences.
class Field
{
public:
  Field(vtkDataArray* array, double noDataMagnitude)
    : NumberOfComponents(array->GetNumberOfComponents())
    , Values(static_cast<std::size_t>(array->GetNumberOfValues()))
    , Lengths(static_cast<std::size_t>(array->GetNumberOfTuples()))
  {
    const bool scalar = this->NumberOfComponents == 1;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      double* tuple = this->Values.data() + i * this->NumberOfComponents;
      array->GetTuple(i, tuple);
      double squared = 0.0;
      const bool hasData =
        scalar || relevo::IsVectorData(tuple, this->NumberOfComponents, noDataMagnitude);
      for (int c = 0; c < this->NumberOfComponents; ++c)
      {
        squared += tuple[c] * tuple[c];
      }
      this->Lengths[i] = !hasData ? vtkMath::Nan() : scalar ? tuple[0] : std::sqrt(squared);
    }
  }

  // Returns the smallest value, negated, and the largest value of the points or cells of a surface.
  // Other points and cells are not drawn and therefore ignored.
  std::vector<double> GetLimits(const relevo::SurfaceTriangles& surface, bool ofCells) const
  {
    double lowest = VTK_DOUBLE_MAX;
    double highest = -VTK_DOUBLE_MAX;
    const auto include = [&](vtkIdType i)
    {
      if (std::isfinite(this->Lengths[i]))
      {
        lowest = std::min(lowest, this->Lengths[i]);
        highest = std::max(highest, this->Lengths[i]);
      }
    };
    for (std::size_t t = 0; t < surface.GetTriangles().size(); ++t)
    {
      const auto triangle = static_cast<vtkIdType>(t);
      for (vtkIdType point : surface.GetPoints(triangle))
      {
        include(ofCells ? surface.GetCell(triangle) : point);
      }
    }
    return { -lowest, highest };
  }

  // Sets the extent from the limits of the whole surface.
  void SetExtent(const std::vector<double>& limits)
  {
    this->Extent = this->NumberOfComponents == 1 ? limits[1] + limits[0] : limits[1];
  }

  // In [0, 1].
  double GetVariation(vtkIdType i, vtkIdType j) const
  {
    const double difference = std::abs(this->Lengths[i] - this->Lengths[j]);
    if (i == j || !std::isfinite(difference) || !(this->Extent > 0.0))
    {
      return 0.0;
    }
    const double relative = std::min(difference / this->Extent, 1.0);
    return this->NumberOfComponents == 1 ? relative
                                         : std::max(relative, this->GetAngle(i, j) / vtkMath::Pi());
  }

private:
  double GetAngle(vtkIdType i, vtkIdType j) const
  {
    const double shortest = ShortestDirection * this->Extent;
    if (!(this->Lengths[i] > shortest && this->Lengths[j] > shortest))
    {
      return 0.0;
    }
    const double* a = this->Values.data() + i * this->NumberOfComponents;
    const double* b = this->Values.data() + j * this->NumberOfComponents;
    // This is accurate at all angles, in any dimension: with unit vectors a and b, half the angle
    // has the tangent |a - b| / |a + b|.
    double difference = 0.0;
    double sum = 0.0;
    for (int c = 0; c < this->NumberOfComponents; ++c)
    {
      const double unitA = a[c] / this->Lengths[i];
      const double unitB = b[c] / this->Lengths[j];
      difference += (unitA - unitB) * (unitA - unitB);
      sum += (unitA + unitB) * (unitA + unitB);
    }
    return 2.0 * std::atan2(std::sqrt(difference), std::sqrt(sum));
  }

  int NumberOfComponents;
  std::vector<double> Values;
  std::vector<double> Lengths; // signed for scalars
  double Extent = 0.0;
};

double GetAutomaticMaximum(std::vector<double> variations)
{
  if (variations.empty())
  {
    return SmallestAutomaticMaximum;
  }
  const auto quantile = variations.begin() +
    static_cast<std::ptrdiff_t>(AutomaticQuantile * static_cast<double>(variations.size() - 1));
  std::nth_element(variations.begin(), quantile, variations.end());
  return std::max(*quantile, SmallestAutomaticMaximum);
}

// Computes the variation of each edge.
std::vector<double> ComputeVariations(
  const relevo::SurfaceEdges& edges, const Field& field, bool ofCells)
{
  const relevo::SurfaceTriangles& surface = edges.GetTriangles();
  std::vector<double> variations(edges.GetNumberOfEdges(), 0.0);
  vtkSMPTools::For(0, edges.GetNumberOfEdges(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int edge = static_cast<int>(begin); edge < end; ++edge)
      {
        if (!ofCells)
        {
          const int* places = edges.GetEdges()[edge].MergedPoints;
          variations[edge] = field.GetVariation(places[0], places[1]);
          continue;
        }
        edges.ForEachSides(edge,
          [&](int i)
          {
            const int* triangles = edges.GetSides()[i].Triangles;
            if (triangles[1] >= 0)
            {
              variations[edge] = std::max(variations[edge],
                field.GetVariation(surface.GetCell(triangles[0]), surface.GetCell(triangles[1])));
            }
          });
      }
    });
  return variations;
}

// Finds the array of a name in the points or cells of a mesh.
struct FoundArray
{
  vtkDataArray* Array = nullptr;
  bool OfCells = false;
};

class FieldVariationEvaluator : public relevo::MetricEvaluator
{
public:
  FieldVariationEvaluator(
    vtkFieldVariationDepthTagMetric* metric, const std::shared_ptr<relevo::MetricMesh>& mesh)
    : MetricEvaluator(metric, mesh)
    , Metric(metric)
  {
  }

  bool ComputeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    vtkNew<vtkFloatArray> edgeTags;
    if (!this->ComputeEdgeTags(view, maximumLevel, edgeTags))
    {
      return false;
    }
    this->GetMesh().GetEdges()->TagPoints(edgeTags->GetPointer(0), tags);
    return true;
  }

  bool ComputeEdgeTags(
    const relevo::RefinementView& view, int maximumLevel, vtkFloatArray* tags) override
  {
    const FoundArray found = this->CheckParameters() ? this->FindArray() : FoundArray();
    if (!found.Array)
    {
      return false;
    }
    const std::vector<double> numbers = this->GetNumbers(view);
    this->UpdateVariations(found, numbers);
    const float low = static_cast<float>(this->Metric->GetMinimumVariation());
    const float high = static_cast<float>(numbers[2]);
    relevo::TagEdges(*this->GetMesh().GetEdges(), tags,
      [&](int edge)
      {
        return relevo::rangeLevel(
          static_cast<float>(this->Variations[edge]), low, high, maximumLevel);
      });
    return true;
  }

protected:
  // Computes the limits of the field and the variation of the highest level.
  std::vector<double> ComputeNumbers(
    const relevo::RefinementView& view, const relevo::PieceReduction& pieces) override;

private:
  bool CheckParameters();
  FoundArray FindArray();
  FoundArray FindUsableArray(std::string* error = nullptr);
  void UpdateLimits(const FoundArray& found);
  void UpdateVariations(const FoundArray& found, const std::vector<double>& limits);
  std::vector<int> FindOwnEdges();

  vtkSmartPointer<vtkFieldVariationDepthTagMetric> Metric;
  std::vector<double> Limits; // of this mesh's field
  relevo::Dependencies LimitDependencies;
  std::vector<double> Variations; // of edges
  relevo::Dependencies VariationDependencies;
};

bool FieldVariationEvaluator::CheckParameters()
{
  if (!this->Metric->GetArrayName()[0])
  {
    vtkErrorWithObjectMacro(this->Metric.Get(), "There is no array name: call SetArrayName().");
    return false;
  }
  const double minimum = this->Metric->GetMinimumVariation();
  const double maximum = this->Metric->GetMaximumVariation();
  if (minimum > maximum)
  {
    vtkErrorWithObjectMacro(this->Metric.Get(),
      "MinimumVariation " << minimum << " is above MaximumVariation " << maximum << ".");
    return false;
  }
  return true;
}

FoundArray FieldVariationEvaluator::FindUsableArray(std::string* error)
{
  vtkPolyData* mesh = this->GetMesh().GetPolyData();
  const char* name = this->Metric->GetArrayName();
  FoundArray found;
  found.Array = mesh->GetPointData()->GetArray(name);
  found.OfCells = !found.Array;
  if (found.OfCells)
  {
    found.Array = mesh->GetCellData()->GetArray(name);
  }
  std::ostringstream text;
  const vtkIdType expected = found.OfCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  if (!found.Array)
  {
    text << "The mesh has no point or cell array of numbers named \"" << name << "\".";
  }
  else if (found.Array->GetNumberOfTuples() != expected || found.Array->GetNumberOfComponents() < 1)
  {
    text << "The array \"" << name << "\" has " << found.Array->GetNumberOfTuples() << " tuples of "
         << found.Array->GetNumberOfComponents() << " components, but there are " << expected
         << (found.OfCells ? " cells." : " points.");
    found.Array = nullptr;
  }
  if (error)
  {
    *error = text.str();
  }
  return found;
}

FoundArray FieldVariationEvaluator::FindArray()
{
  std::string error;
  const FoundArray found = this->FindUsableArray(&error);
  if (!found.Array)
  {
    vtkErrorWithObjectMacro(this->Metric.Get(), << error);
  }
  return found;
}

void FieldVariationEvaluator::UpdateLimits(const FoundArray& found)
{
  const double noDataMagnitude = this->Metric->GetNoDataMagnitude();
  relevo::Dependencies dependencies =
    relevo::Dependencies::On(this->GetMesh().GetTime(), found.OfCells, noDataMagnitude);
  dependencies.AddObject(found.Array);
  if (this->LimitDependencies.Update(dependencies))
  {
    this->Limits =
      Field(found.Array, noDataMagnitude).GetLimits(*this->GetMesh().GetTriangles(), found.OfCells);
  }
}

void FieldVariationEvaluator::UpdateVariations(
  const FoundArray& found, const std::vector<double>& limits)
{
  const double noDataMagnitude = this->Metric->GetNoDataMagnitude();
  relevo::Dependencies dependencies = relevo::Dependencies::On(
    this->GetMesh().GetTime(), found.OfCells, noDataMagnitude, limits[0], limits[1]);
  dependencies.AddObject(found.Array);
  if (this->VariationDependencies.Update(dependencies))
  {
    Field field(found.Array, noDataMagnitude);
    field.SetExtent(limits);
    this->Variations = ComputeVariations(*this->GetMesh().GetEdges(), field, found.OfCells);
  }
}

// Returns the edges of faces that are not ghost cells.
std::vector<int> FieldVariationEvaluator::FindOwnEdges()
{
  const relevo::SurfaceEdges& edges = *this->GetMesh().GetEdges();
  const relevo::GhostCells ghosts(this->GetMesh().GetPolyData());
  std::vector<int> own;
  own.reserve(edges.GetEdges().size());
  for (int edge = 0; edge < edges.GetNumberOfEdges(); ++edge)
  {
    bool isOwn = false;
    edges.ForEachSides(edge,
      [&](int i)
      {
        for (int t : edges.GetSides()[i].Triangles)
        {
          isOwn = isOwn || (t >= 0 && !ghosts.Has(edges.GetTriangles().GetCell(t)));
        }
      });
    if (isOwn)
    {
      own.push_back(edge);
    }
  }
  return own;
}

std::vector<double> FieldVariationEvaluator::ComputeNumbers(
  const relevo::RefinementView&, const relevo::PieceReduction& pieces)
{
  const FoundArray found = this->FindUsableArray();
  std::vector<double> numbers{ -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  if (found.Array)
  {
    this->UpdateLimits(found);
    numbers = this->Limits;
  }
  pieces.TakeLargest(numbers);
  double highest = this->Metric->GetMaximumVariation();
  if (!(highest > 0.0))
  {
    const relevo::SurfaceEdges& edges = *this->GetMesh().GetEdges();
    std::vector<int> own;
    std::vector<double> variations;
    if (found.Array)
    {
      this->UpdateVariations(found, numbers);
      own = this->FindOwnEdges();
      std::transform(own.begin(), own.end(), std::back_inserter(variations),
        [this](int edge) { return this->Variations[edge]; });
    }
    highest = GetAutomaticMaximum(relevo::CollectOnce(pieces, std::move(variations),
      [&](std::size_t i)
      { return relevo::HashEdge(edges.GetTriangles(), edges.GetEdges()[own[i]].MergedPoints); }));
  }
  numbers.push_back(highest);
  return numbers;
}
}

vtkStandardNewMacro(vtkFieldVariationDepthTagMetric);

vtkFieldVariationDepthTagMetric::vtkFieldVariationDepthTagMetric() = default;
vtkFieldVariationDepthTagMetric::~vtkFieldVariationDepthTagMetric() = default;

void vtkFieldVariationDepthTagMetric::SetArrayName(const char* name)
{
  const std::string given = name ? name : "";
  if (this->ArrayName != given)
  {
    this->ArrayName = given;
    this->Modified();
  }
}

void vtkFieldVariationDepthTagMetric::SetMinimumVariation(double variation)
{
  relevo::SetInRange(this, "MinimumVariation", this->MinimumVariation, variation, 0.0, 1.0);
}

void vtkFieldVariationDepthTagMetric::SetMaximumVariation(double variation)
{
  relevo::SetInRange(this, "MaximumVariation", this->MaximumVariation, variation, 0.0, 1.0);
}

void vtkFieldVariationDepthTagMetric::SetNoDataMagnitude(double magnitude)
{
  relevo::SetNoDataMagnitude(this, this->NoDataMagnitude, magnitude);
}

std::unique_ptr<relevo::MetricEvaluator> vtkFieldVariationDepthTagMetric::NewEvaluator(
  const std::shared_ptr<relevo::MetricMesh>& mesh)
{
  return std::make_unique<FieldVariationEvaluator>(this, mesh);
}

void vtkFieldVariationDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "MinimumVariation: " << this->MinimumVariation << "\n";
  os << indent << "MaximumVariation: " << this->MaximumVariation << "\n";
  os << indent << "NoDataMagnitude: " << this->NoDataMagnitude << "\n";
}

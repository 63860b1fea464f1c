// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Encoding/MicroMeshEncoder.h"

#include "Base/EdgeCollapse.h"
#include "Encoding/ErrorMeasure.h"
#include "Encoding/SurfaceSampling.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace relevo
{
namespace
{
// The length of a displacement of 1, relative to the tolerance, at most.
constexpr double StepOfTolerance = 0.25;
// Deviation of grids from finer grids, relative to the tolerance: at first, and where they fail.
constexpr double DeviationOfTolerance = 0.9;
constexpr double StrictDeviationOfTolerance = 0.5;
// Deviation of grids from those of the next lower level, relative to the tolerance, above which
// levels are raised, and above which the highest level is not enough.
constexpr double UnevenOfTolerance = 1.4;
constexpr double HopelessOfTolerance = 2.5;
constexpr int MostRaises = 2;
// Deviation of lines from the edges of the coarse mesh, relative to the tolerance.
constexpr double LineOfTolerance = 0.9;
// Each failure divides the size of clusters by this, until triangles of the dense mesh are kept.
// After this many simplifications, the whole mesh is kept.
constexpr int LimitDivisor = 4;
constexpr int MostSimplifications = 100;
// Coarse triangles near the border, per fixed vertex: small ones that become larger away from it.
constexpr double TrianglesOfFixedVertices = 0.4;

class Encoder
{
public:
  Encoder(const DenseMesh& dense, const MicroMeshSettings& settings,
    const std::function<bool(double)>& goOn)
    : Dense(dense)
    , Settings(settings)
    , GoOn(goOn)
    , Tolerance(settings.Tolerance / dense.Scale)
    , Step(std::exp2(std::floor(std::log2(StepOfTolerance * this->Tolerance))))
    , Surface(dense.Points, dense.Triangles)
    , Limits(dense.Points.size(), std::numeric_limits<int>::max())
  {
  }

  std::unique_ptr<EncodedMesh> Run()
  {
    ErrorMeasure measure(this->Dense, this->Surface, this->Tolerance);
    MicroMesh mesh;
    while (true)
    {
      if (this->Simplifications > MostSimplifications)
      {
        std::fill(this->Limits.begin(), this->Limits.end(), 1);
      }
      EdgeCollapse collapse(this->Dense, this->Limits, LineOfTolerance * this->Tolerance);
      if (!this->Simplify(collapse))
      {
        return nullptr;
      }
      ++this->Simplifications;
      BaseMesh base(this->Dense, collapse, this->Step);
      collapse.FreeMesh();
      this->TakeRaises(base);
      bool isLimited = false;
      while (!isLimited)
      {
        if (!this->Sample(base))
        {
          return nullptr;
        }
        std::vector<char> failed = FindUneven(base.Mesh, HopelessOfTolerance * this->Tolerance);
        if (this->HasHopeless(base, failed))
        {
          isLimited = this->LimitClusters(collapse, base, failed, {});
          continue;
        }
        mesh = ReduceLevels(base.Mesh, this->Deviations);
        if (!measure.Run(base, mesh, this->IsAborted))
        {
          return nullptr;
        }
        ++this->Round;
        if (!measure.HasFailed())
        {
          return std::make_unique<EncodedMesh>(EncodedMesh{ std::move(base), std::move(mesh),
            measure.GetInputToResult() * this->Dense.Scale,
            measure.GetResultToInput() * this->Dense.Scale, this->Round });
        }
        failed = measure.FailedFaces;
        const bool isRaised = this->RaiseLevels(base, failed);
        isLimited =
          this->LimitClusters(collapse, base, failed, measure.FailedTriangles) || !isRaised;
      }
    }
  }

private:
  bool Simplify(EdgeCollapse& collapse)
  {
    double error = this->Error;
    int fixed = 0;
    for (int v = 0; v < static_cast<int>(this->Dense.Points.size()); ++v)
    {
      fixed += this->Dense.IsFixed(v) && collapse.IsKept(v) ? 1 : 0;
    }
    const double target =
      (1.0 - this->Settings.TargetReduction) * double(this->Dense.Triangles.size()) +
      TrianglesOfFixedVertices * double(fixed);
    collapse.Repeat(this->Moves);
    const bool isDone =
      collapse.Run(this->Simplifications == 0 ? static_cast<std::size_t>(target) : 0, error,
        [this](double share) { return this->Report(0.3 * share); });
    this->Error = this->Simplifications == 0 ? error : this->Error;
    this->Moves = collapse.GetMoves();
    return isDone;
  }

  // Takes the raises and deviations of faces of the last base.
  void TakeRaises(const BaseMesh& base)
  {
    const std::vector<int> last = std::move(this->Raises);
    this->Raises.assign(base.Mesh.Faces.size(), 0);
    const std::vector<double> lastDeviations = std::move(this->Deviations);
    this->Deviations.assign(base.Mesh.Faces.size(), DeviationOfTolerance * this->Tolerance);
    this->Matches.assign(base.Mesh.Faces.size(), -1);
    for (std::size_t f = 0; f < base.Mesh.Faces.size() && this->SampledFaces; ++f)
    {
      this->Matches[f] = this->SampledFaces->Find(base, base.Mesh.Faces[f]);
      if (this->Matches[f] >= 0)
      {
        this->Raises[f] = last[static_cast<std::size_t>(this->Matches[f])];
        this->Deviations[f] = lastDeviations[static_cast<std::size_t>(this->Matches[f])];
      }
    }
    this->SampledFaces = std::make_unique<FaceMatch>(base);
  }

  bool CanRaise(const BaseMesh& base, std::size_t face) const
  {
    return base.Mesh.Faces[face].Level < this->Settings.MaximumLevel &&
      this->Raises[face] < MostRaises && !base.IsOriginal(base.Mesh.Faces[face]);
  }

  // Samples, and raises levels until grids differ little from those of the next lower level.
  // Returns false after an abort.
  bool Sample(BaseMesh& base)
  {
    bool isRaised = true;
    while (isRaised)
    {
      base.ChooseLevels(this->Settings.MaximumLevel, this->Raises);
      NumberSamples(base.Mesh);
      const SampledParts sampled = CopyEqualSamples(base.Mesh, this->Sampled, this->Matches);
      if (!SampleSurface(base.Mesh, sampled, this->Surface, this->IsAborted) || !this->Report(0.5))
      {
        return false;
      }
      this->Sampled = base.Mesh;
      std::iota(this->Matches.begin(), this->Matches.end(), 0);
      const std::vector<char> areUneven =
        FindUneven(base.Mesh, UnevenOfTolerance * this->Tolerance);
      isRaised = false;
      for (std::size_t f = 0; f < areUneven.size(); ++f)
      {
        if (areUneven[f] != 0 && sampled.Faces[f] == 0 && this->CanRaise(base, f))
        {
          ++this->Raises[f];
          isRaised = true;
        }
      }
    }
    return true;
  }

  // Whether any faces fail that cannot have higher levels. Faces that can have them do not fail.
  bool HasHopeless(const BaseMesh& base, std::vector<char>& failed) const
  {
    bool isAny = false;
    for (std::size_t f = 0; f < failed.size(); ++f)
    {
      failed[f] = failed[f] != 0 && !this->CanRaise(base, f) ? 1 : 0;
      isAny = isAny || failed[f] != 0;
    }
    return isAny;
  }

  // Changes levels of faces that failed: first less reduction, then more samples. What then remains
  // of them cannot have higher levels. Returns whether any changed.
  bool RaiseLevels(const BaseMesh& base, std::vector<char>& failed)
  {
    const double strict = StrictDeviationOfTolerance * this->Tolerance;
    bool isAny = false;
    for (std::size_t f = 0; f < failed.size(); ++f)
    {
      if (failed[f] != 0 && this->Deviations[f] > strict)
      {
        this->Deviations[f] = strict;
        failed[f] = 0;
        isAny = true;
      }
      else if (failed[f] != 0 && this->CanRaise(base, f))
      {
        ++this->Raises[f];
        failed[f] = 0;
        isAny = true;
      }
    }
    return isAny;
  }

  // Rounds take less and less of the progress, which never goes back.
  bool Report(double share)
  {
    const double rest = std::exp2(-double(this->Round));
    this->Progress = std::max(this->Progress, 1.0 - rest + 0.5 * share * rest);
    this->HasStopped = this->HasStopped || !this->GoOn(this->Progress);
    return !this->HasStopped;
  }

  // Limits the clusters at the corners of faces that failed, and at those of triangles, unless the
  // nearest face is raised. Returns whether any are limited.
  bool LimitClusters(EdgeCollapse& collapse, const BaseMesh& base,
    const std::vector<char>& failedFaces, const std::vector<std::pair<int, int>>& failedTriangles)
  {
    std::vector<char> hasFailed(this->Dense.Points.size(), 0); // per root
    for (std::size_t f = 0; f < base.Mesh.Faces.size(); ++f)
    {
      for (int corner : base.Mesh.Faces[f].Corners)
      {
        hasFailed[static_cast<std::size_t>(base.Vertices[static_cast<std::size_t>(corner)])] |=
          failedFaces[f];
      }
    }
    for (const auto& failed : failedTriangles)
    {
      if (failed.second < 0 || failedFaces[static_cast<std::size_t>(failed.second)] != 0)
      {
        for (int vertex : this->Dense.Triangles[static_cast<std::size_t>(failed.first)])
        {
          hasFailed[static_cast<std::size_t>(collapse.FindRoot(vertex))] = 1;
        }
      }
    }
    bool isAny = false;
    for (std::size_t v = 0; v < this->Limits.size(); ++v)
    {
      const int root = collapse.FindRoot(static_cast<int>(v));
      if (hasFailed[static_cast<std::size_t>(root)] != 0)
      {
        isAny = isAny || collapse.GetClusterSize(root) > 1;
        const int smaller = std::max(1, collapse.GetClusterSize(root) / LimitDivisor);
        this->Limits[v] = std::min(this->Limits[v], smaller);
      }
    }
    return isAny;
  }

  const DenseMesh& Dense;
  const MicroMeshSettings& Settings;
  const std::function<bool(double)>& GoOn;
  std::atomic<bool> HasStopped{ false };
  std::function<bool()> IsAborted = [this] { return this->HasStopped.load(); };
  double Tolerance;
  double Step;
  TriangleTree Surface;
  std::vector<int> Limits;
  MicroMesh Sampled; // of the last round
  std::unique_ptr<FaceMatch> SampledFaces;
  EdgeCollapse::Moves Moves;                              // of the last simplification
  std::vector<int> Raises;                                // of levels, per face
  std::vector<double> Deviations;                         // of grids, per face
  std::vector<int> Matches;                               // faces of the last base
  double Error = std::numeric_limits<double>::infinity(); // of the steps of the first round
  double Progress = 0.0;
  int Round = 0;
  int Simplifications = 0;
};
}

std::unique_ptr<EncodedMesh> EncodeMicroMesh(const DenseMesh& dense,
  const MicroMeshSettings& settings, const std::function<bool(double)>& goOn)
{
  return Encoder(dense, settings, goOn).Run();
}
}

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

namespace relevo
{
namespace
{
// The length of a displacement of 1, relative to the tolerance, at most.
constexpr double StepOfTolerance = 0.25;
// Deviation of grids from finer grids, relative to the tolerance.
constexpr double DeviationOfTolerance = 0.35;
// Deviation of lines from the edges of the coarse mesh, relative to the tolerance.
constexpr double LineOfTolerance = 0.9;
// Each failure divides the size of clusters by this. After some simplifications, clusters are
// dissolved, and in the end the whole mesh is kept.
constexpr int LimitDivisor = 4;
constexpr int DividingSimplifications = 5;
constexpr int MostSimplifications = 10;

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
    , Raises(dense.Points.size(), 0)
  {
  }

  std::unique_ptr<EncodedMesh> Run()
  {
    ErrorMeasure measure(this->Dense, this->Surface, this->Tolerance);
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
      MicroMesh mesh;
      bool isRaised = true;
      while (isRaised)
      {
        if (!this->Displace(base, mesh, measure))
        {
          return nullptr;
        }
        if (!measure.HasFailed())
        {
          return std::make_unique<EncodedMesh>(EncodedMesh{ std::move(base), std::move(mesh),
            measure.GetInputToResult() * this->Dense.Scale,
            measure.GetResultToInput() * this->Dense.Scale, this->Round });
        }
        isRaised = this->RaiseLevels(base, measure);
      }
      this->LimitClusters(collapse, base, measure);
    }
  }

private:
  bool Simplify(EdgeCollapse& collapse)
  {
    double error = this->Error;
    const double target =
      (1.0 - this->Settings.TargetReduction) * double(this->Dense.Triangles.size());
    collapse.Repeat(this->Moves);
    const bool isDone =
      collapse.Run(this->Simplifications == 0 ? static_cast<std::size_t>(target) : 0, error,
        [this](double share) { return this->Report(0.3 * share); });
    this->Error = this->Simplifications == 0 ? error : this->Error;
    this->Moves = collapse.GetMoves();
    return isDone;
  }

  // Displaces, reduces and measures. Returns false after an abort.
  bool Displace(BaseMesh& base, MicroMesh& mesh, ErrorMeasure& measure)
  {
    base.ChooseLevels(this->Settings.MaximumLevel, this->Raises);
    NumberSamples(base.Mesh);
    std::vector<int> matches(base.Mesh.Faces.size(), -1);
    for (std::size_t f = 0; f < matches.size() && this->SampledFaces; ++f)
    {
      matches[f] = this->SampledFaces->Find(base, base.Mesh.Faces[f]);
    }
    const SampledParts sampled = CopyEqualSamples(base.Mesh, this->Sampled, matches);
    if (!SampleSurface(base.Mesh, sampled, this->Surface, this->IsAborted) || !this->Report(0.5))
    {
      return false;
    }
    mesh = ReduceLevels(base.Mesh, DeviationOfTolerance * this->Tolerance);
    this->Sampled = base.Mesh;
    this->SampledFaces = std::make_unique<FaceMatch>(base);
    const bool isMeasured = measure.Run(base, mesh, this->IsAborted);
    ++this->Round;
    return isMeasured && this->Report(0.0);
  }

  // Raises the levels of faces that failed. Returns false if all of them have the highest level.
  bool RaiseLevels(const BaseMesh& base, const ErrorMeasure& measure)
  {
    std::vector<char> isRaised(this->Dense.Points.size(), 0);
    bool isAny = false;
    for (std::size_t f = 0; f < base.Mesh.Faces.size(); ++f)
    {
      const MicroMesh::Face& face = base.Mesh.Faces[f];
      const bool canRaise = face.Level < this->Settings.MaximumLevel && !base.IsOriginal(face);
      if (measure.FailedFaces[f] != 0 && canRaise)
      {
        isAny = true;
        for (int corner : face.Corners)
        {
          isRaised[static_cast<std::size_t>(base.Vertices[static_cast<std::size_t>(corner)])] = 1;
        }
      }
    }
    for (std::size_t v = 0; v < isRaised.size(); ++v)
    {
      this->Raises[v] += isRaised[v];
    }
    return isAny;
  }

  // Rounds take less and less of the progress.
  bool Report(double share)
  {
    const double done = 1.0 - std::exp2(-double(this->Round));
    this->HasStopped =
      this->HasStopped || !this->GoOn(done + share * std::exp2(-double(this->Round + 1)));
    return !this->HasStopped;
  }

  void LimitClusters(EdgeCollapse& collapse, const BaseMesh& base, const ErrorMeasure& measure)
  {
    std::vector<char> hasFailed(this->Dense.Points.size(), 0); // per root
    for (std::size_t f = 0; f < base.Mesh.Faces.size(); ++f)
    {
      for (int corner : base.Mesh.Faces[f].Corners)
      {
        hasFailed[static_cast<std::size_t>(base.Vertices[static_cast<std::size_t>(corner)])] |=
          measure.FailedFaces[f];
      }
    }
    for (std::size_t t = 0; t < this->Dense.Triangles.size(); ++t)
    {
      for (int vertex : this->Dense.Triangles[t])
      {
        hasFailed[static_cast<std::size_t>(collapse.FindRoot(vertex))] |=
          measure.FailedTriangles[t];
      }
    }
    for (std::size_t v = 0; v < this->Limits.size(); ++v)
    {
      const int root = collapse.FindRoot(static_cast<int>(v));
      if (hasFailed[static_cast<std::size_t>(root)] != 0)
      {
        const int smaller = this->Simplifications <= DividingSimplifications
          ? collapse.GetClusterSize(root) / LimitDivisor
          : 1;
        this->Limits[v] = std::min(this->Limits[v], std::max(1, smaller));
      }
    }
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
  std::vector<int> Raises;                                // of levels, per vertex
  double Error = std::numeric_limits<double>::infinity(); // of the steps of the first round
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

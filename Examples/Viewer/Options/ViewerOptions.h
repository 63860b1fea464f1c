// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the options of relevo-view
 */
#ifndef ViewerOptions_h
#define ViewerOptions_h

#include "Files/FramePattern.h"
#include "Options/SessionFile.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

struct ViewerOptions
{
  enum class MetricType
  {
    Distance,
    ScreenEdge,
    Curvature,
    Silhouette,
    Contour,
    ViewDependent,
    Field,
    Region,
    Error,
    ControlNet,
    Height
  };
  enum class SurfaceType
  {
    Linear,
    PNTriangle,
    Phong,
    ScalarTagged,
    Procedural,
    G1,
    Patch,
    MicroMesh
  };
  enum class ColorType
  {
    Own, // the colours of the terrain or the mesh
    Level,
    Pattern,
    Metric,
    Height,
    Slope,
    Aspect,
    Hillshade
  };
  enum class MappingType
  {
    Automatic,
    Sphere,
    Plane
  };
  enum class ReliefType
  {
    Box,
    Sphere,
    View
  };
  static constexpr double DefaultPixels = 4.0;

  std::string Input; // height map, mesh or folder of reliefs
  bool IsMesh = false;
  bool IsDatabase = false;

  // The surface.
  std::optional<SurfaceType> Surface;
  std::optional<double> Alpha;     // for Phong
  std::optional<double> Amplitude; // for Procedural
  std::optional<double> Frequency; // for Procedural
  std::string Imagery;
  bool FillNoData = false;
  std::optional<double> NoDataValue; // may be NaN

  // Colours: the values of the first and the last.
  std::optional<std::array<double, 2>> Range;
  bool HasRangeOfAllSteps = false; // the first step decides otherwise, later ones extend the range
  bool HasLogColors = false;
  std::optional<std::array<double, 3>> BelowColor; // of values below the range; red, green, blue
  std::optional<std::array<double, 3>> AboveColor;

  // Only for terrain.
  int ImageryBands[3] = { 0, 0, 0 }; // as in vtkTerrainSource
  bool Stretch = false;
  std::optional<double> Exaggeration;
  std::optional<int> Resolution;
  std::string Palette;            // empty: that of the colours
  std::optional<double> Contours; // unit of the heights
  bool ContourLabels = false;
  std::optional<double> SeaLevel; // unit of the heights
  std::optional<int> Memory;      // MiB
  std::string Flight;
  bool Globe = false;   // geocentric coordinates
  bool IsTiled = false; // whether tiles are drawn, without levels of detail
  std::string TiledBy;  // an option that needs tiles, or empty

  // Only for meshes.
  std::optional<double> Time;
  std::string Warp; // an array of points that moves them; empty for none
  std::string Heights;
  std::optional<double> Scale;
  std::optional<double> Offset;
  MappingType Mapping = MappingType::Automatic;
  std::string Array;
  std::optional<double> FeatureAngle; // degrees
  int UpAxis = 1;                     // 0 for x, 1 for y, 2 for z

  // Curved cells of meshes.
  int Isolines = 0;
  bool PatchEdges = false;
  int Hairs = 0;

  // Dense meshes as coarse meshes with displacements.
  std::string MicroMesh;                // output file
  std::optional<double> ToleranceShare; // of the diagonal

  // Additions to pictures of meshes and volumes.
  bool HasExtremes = false; // labels of the largest and the smallest value
  bool HasAxes = false;
  bool HasScaleBar = false;
  std::optional<std::vector<double>> Ruler; // two points

  // Streamlines through meshes. Without an array there are none.
  std::string Streamlines;
  std::optional<int> Seeds;
  std::optional<std::vector<double>> SeedLine; // two points

  std::string IntegrationPoints; // an array or a quantity of one; empty for none

  // Streaks along vectors of meshes. Without an array there are none.
  std::string Vectors;
  std::optional<int> LICSteps;
  std::optional<double> LICStepSize; // pixels
  std::optional<int> LICContrast;    // as in vtkLICSettings
  std::optional<int> LICMode;        // as in vtkLICSettings
  std::optional<double> LICIntensity;
  double LICPhase = 0.0;

  // Volumes of meshes.
  bool IsVolume = false;
  std::string VolumeArray; // empty: the active scalars
  std::string Transfer;
  std::optional<double> UnitDistance;
  std::vector<double> IsoSurfaces;
  std::optional<std::vector<double>> Clip; // point, normal
  int VolumeMethod = 0;                    // as in vtkGPUUnstructuredGridVolumeMapper
  int Integration = 0;                     // as in vtkGPUUnstructuredGridVolumeMapper
  int BlendMode = 0;                       // as in vtkGPUUnstructuredGridVolumeMapper
  std::optional<double> ShapeTolerance;    // of curved cells, share of the diagonal
  std::optional<double> FieldTolerance;    // share of the range

  // Intersection of two meshes.
  std::string Against; // the other mesh
  std::optional<double> ContactDistance;

  // Reliefs: how the surface is captured, and how captures are drawn.
  std::optional<ReliefType> Relief;
  std::string Capture;             // output folder for captures
  std::optional<int> ReliefMethod; // as in vtkReliefMapper
  std::optional<int> ReliefSearch; // as in vtkReliefMapper

  // Levels of detail.
  std::optional<int> MaximumLevel;
  std::optional<int> UniformLevel;
  std::optional<MetricType> Metric;
  std::optional<double> Pixels;              // for ScreenEdge
  std::optional<double> Error;               // pixels, for Error and Height
  std::optional<double> Tolerance;           // length, for Height and micro-meshes
  std::optional<double> Base;                // unit of the heights, for a solid
  std::optional<double> Reach;               // for Distance
  std::optional<std::vector<double>> Region; // centre (x, y, for meshes z), radius
  int Method = 0;                            // as in vtkAdaptiveRefinementMapper
  bool PerEdge = false;
  std::optional<bool> WholeSegments;
  bool Geomorphing = true;
  int Budget = 0; // triangles; 0 for no limit

  // View and output.
  std::optional<std::array<double, 2>> View;          // azimuth, elevation in degrees
  std::optional<std::vector<double>> Center;          // x, y, z; for terrain also x, y
  std::optional<std::array<double, 2>> CenterDegrees; // for terrain: longitude, latitude
  std::optional<std::array<double, 2>> HeightAt;      // longitude, latitude
  double Zoom = 1.0;
  std::optional<std::array<double, 2>> Light; // azimuth, elevation in degrees
  ColorType Color = ColorType::Own;
  bool Legend = true;
  bool Wireframe = false;
  bool Statistics = false;
  int Size[2] = { 1280, 800 };
  std::string Output; // a file, or a pattern for several
  std::string Export;
  std::optional<int> Serve;            // port
  std::string SaveSession;             // output file
  std::string SaveScript;              // output file
  std::string SaveSource;              // output folder
  std::optional<SessionCamera> Camera; // of a session
  // The options for SaveSession, with their values.
  std::map<std::string, std::optional<std::string>> Given;
  bool Help = false;
  bool Version = false;

  bool IsColoredByLevel() const
  {
    return this->Color == ColorType::Level || this->Color == ColorType::Pattern ||
      this->Color == ColorType::Metric;
  }
  /// Whether several pictures are written, numbered by the name of the output.
  bool IsSeries() const { return IsFramePattern(this->Output); }
  /// Whether the range of the colours covers the values of all time steps.
  bool CoversAllSteps() const { return this->IsSeries() || this->HasRangeOfAllSteps; }
  bool IsTerrain() const { return !this->IsMesh && !this->IsDatabase; }
  /// Whether curved cells are requested. By default, a file that contains some is drawn this way.
  bool IsPatch() const { return this->Surface == SurfaceType::Patch; }
  bool IsMicroMesh() const { return this->Surface == SurfaceType::MicroMesh; }
  bool AsksForPatches() const { return this->IsPatch() || this->PatchEdges || this->Isolines > 0; }
  MetricType GetMetric() const
  {
    const bool hasError = this->IsPatch() || this->IsMicroMesh();
    const MetricType ofMeshes = hasError ? MetricType::Error : MetricType::ScreenEdge;
    return this->Metric.value_or(this->IsMesh ? ofMeshes : MetricType::Height);
  }
  /// Whether the vectors of the streaks determine where to refine.
  bool IsFlowMetric() const { return !this->Vectors.empty() && !this->Metric; }
  SurfaceType GetSurface() const
  {
    return this->Surface.value_or(this->IsMesh ? SurfaceType::PNTriangle : SurfaceType::Linear);
  }
};

#endif

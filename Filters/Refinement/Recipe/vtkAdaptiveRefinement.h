// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinement
 * @brief   the recipe: how deep a coarse mesh is refined, and to what
 *
 * A recipe names the levels (a metric, or an array of depth-tags), the surface that refined points
 * lie on and the displacement that moves them. vtkAdaptiveRefinementFilter evaluates it on the
 * CPU into a vtkPolyData, vtkAdaptiveRefinementMapper on the GPU without storing anything: same
 * recipe, same triangles, same points to float accuracy.
 *
 * @sa vtkAdaptiveRefinementFilter vtkAdaptiveRefinementMapper vtkDepthTagMetric
 * vtkRefinementSurface vtkDisplacement
 */
#ifndef vtkAdaptiveRefinement_h
#define vtkAdaptiveRefinement_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for members

#include <string> // for DepthTagArrayName

class vtkDepthTagMetric;
class vtkDisplacement;
class vtkRefinementPatternTable;
class vtkRefinementSurface;

class RELEVOFILTERSREFINEMENT_EXPORT vtkAdaptiveRefinement : public vtkObject
{
public:
  static vtkAdaptiveRefinement* New();
  vtkTypeMacro(vtkAdaptiveRefinement, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The highest level of an edge, 0 to 7, default 3: an edge has at most 2^level segments. A value
   * outside, or above a MaximumLevel that the pattern table was given or has read from a file, is
   * an error and changes nothing. Where the table gets a lower one afterwards, or another table has
   * one, that holds until the table goes higher again; if it is a file's, a warning says so when a
   * surface is refined.
   */
  void SetMaximumLevel(int level);
  int GetMaximumLevel();
  //@}

  //@{
  /**
   * Name of the point array of depth-tags, one float level per point, default "DepthTag". If the
   * mesh has it, it is used and the metric is not. An edge takes the mean of its two points' tags,
   * rounded half up and clamped to [0, MaximumLevel]. NaN is an error.
   */
  void SetDepthTagArrayName(const char* name);
  const char* GetDepthTagArrayName();
  //@}

  //@{
  /**
   * The metric that gives the levels. With neither metric nor array: MaximumLevel everywhere.
   */
  void SetMetric(vtkDepthTagMetric* metric);
  vtkDepthTagMetric* GetMetric();
  //@}

  //@{
  /**
   * Where a metric sets levels: vtkDepthTagMetric::PER_VERTEX (0, the default; an edge takes the
   * mean of its points' tags) or vtkDepthTagMetric::PER_EDGE (1; an edge's level comes from the
   * edge alone: fewer triangles for segments of the same length, but an edge of low level is not
   * refined because its neighbours are). Another value is an error and changes nothing.
   * Depth-tags of an array are always per point.
   */
  void SetLevelRule(int rule);
  vtkGetMacro(LevelRule, int);
  void SetLevelRuleToPerVertex() { this->SetLevelRule(0); }
  void SetLevelRuleToPerEdge() { this->SetLevelRule(1); }
  //@}

  //@{
  /**
   * Added to the tags of all edges before they are rounded and clamped, in levels, -16 to 16;
   * default 0. One level more doubles the segments of every edge, as half the ReferenceLength of a
   * vtkScreenEdgeDepthTagMetric does within its range.
   * Another value is an error and changes nothing.
   */
  void SetLevelOffset(double levels);
  vtkGetMacro(LevelOffset, double);
  double GetLevelOffsetMinValue() const { return -16.0; }
  double GetLevelOffsetMaxValue() const { return 16.0; }
  //@}

  /**
   * How many segments an edge may be cut into.
   */
  enum SegmentPolicies
  {
    POWERS_OF_TWO = 0,
    WHOLE_NUMBERS = 1
  };

  //@{
  /**
   * POWERS_OF_TWO (0, the default): 2^level segments. WHOLE_NUMBERS (1): 2^tag segments, rounded
   * half up to a whole number; above 16 to one of 9 to 16 times 2, 4 or 8. Segments are closer to
   * the wanted length, at the price of many more patterns and draw calls, and without geomorphing.
   * A pattern table that has read a file lacks most of these patterns: an error when a surface is
   * refined. Another value is an error and changes nothing.
   */
  void SetSegmentPolicy(int policy);
  vtkGetMacro(SegmentPolicy, int);
  void SetSegmentPolicyToPowersOfTwo() { this->SetSegmentPolicy(POWERS_OF_TWO); }
  void SetSegmentPolicyToWholeNumbers() { this->SetSegmentPolicy(WHOLE_NUMBERS); }
  //@}

  /**
   * When refined vertices slide into place.
   */
  enum GeomorphingModes
  {
    GEOMORPHING_OFF = 0,
    GEOMORPHING_ON = 1,
    GEOMORPHING_AUTOMATIC = 2
  };

  //@{
  /**
   * Whether the surface is a continuous function of the tags, so that nothing pops when the camera
   * moves: a vertex that a higher level adds starts at an existing vertex and slides to its own
   * place while the tag rises from half a level below to half a level above (for the last level: to
   * MaximumLevel). GEOMORPHING_OFF (0), GEOMORPHING_ON (1), or GEOMORPHING_AUTOMATIC (2, the
   * default): on for metrics that depend on the view, where patterns can morph. Edges have the same
   * segments as without; the triangles within a face differ. Needs SegmentPolicy POWERS_OF_TWO:
   * with WHOLE_NUMBERS nothing morphs, and GEOMORPHING_ON is a warning when a surface is refined.
   * The patterns of a file cannot morph: with those, GEOMORPHING_ON is an error when a surface is
   * refined. Another value is an error and changes nothing.
   */
  void SetGeomorphing(int mode);
  vtkGetMacro(Geomorphing, int);
  void GeomorphingOn() { this->SetGeomorphing(GEOMORPHING_ON); }
  void GeomorphingOff() { this->SetGeomorphing(GEOMORPHING_OFF); }
  //@}

  //@{
  /**
   * The surface that refined points lie on; none means linear.
   */
  void SetSurface(vtkRefinementSurface* surface);
  vtkRefinementSurface* GetSurface();
  //@}

  //@{
  /**
   * What moves the refined points; none by default.
   */
  void SetDisplacement(vtkDisplacement* displacement);
  vtkDisplacement* GetDisplacement();
  //@}

  //@{
  /**
   * A vector, a tuple of 2 or 3 components, stands for "no data" if the absolute value of a
   * component is at least this, as in (-1e9, 0, 0); more than 0, default 1e8, infinity for never.
   * Vectors and single numbers that are not finite always stand for it. Where point data are
   * interpolated between points of which one has no data, the result has none either: it is NaN, or
   * in arrays of integers the value of the nearest of those points. The input's points keep their
   * values. Normals, tangents and texture coordinates always count as data. Another value is an
   * error and changes nothing.
   */
  void SetNoDataMagnitude(double magnitude);
  vtkGetMacro(NoDataMagnitude, double);
  //@}

  //@{
  /**
   * The patterns, shared by all that evaluate this recipe; by default those of a table of its own
   * that has all levels. A pattern of these default tables is made once and kept once for all
   * recipes, as one is of a table that recipes are given. nullptr brings a new default table.
   */
  void SetPatternTable(vtkRefinementPatternTable* table);
  vtkRefinementPatternTable* GetPatternTable();
  //@}

  /**
   * Latest change of the recipe or of any of its parts.
   */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  /**
   * What SetMaximumLevel() was given, though the pattern table may not go so high.
   */
  int GetAskedMaximumLevel() const
  {
    return this->MaximumLevel;
  }
#endif

protected:
  vtkAdaptiveRefinement();
  ~vtkAdaptiveRefinement() override;

  int MaximumLevel = 3; // 64 triangles for a face: a first frame that nobody waits for
  std::string DepthTagArrayName = "DepthTag";
  int LevelRule = 0;
  double LevelOffset = 0.0;
  int SegmentPolicy = POWERS_OF_TWO;
  int Geomorphing = GEOMORPHING_AUTOMATIC;
  double NoDataMagnitude = 1e8;
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  vtkSmartPointer<vtkRefinementSurface> Surface;
  vtkSmartPointer<vtkDisplacement> Displacement;
  vtkSmartPointer<vtkRefinementPatternTable> PatternTable;

private:
  vtkAdaptiveRefinement(const vtkAdaptiveRefinement&) = delete;
  void operator=(const vtkAdaptiveRefinement&) = delete;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinement
 * @brief   the recipe: how far to refine a coarse mesh, and towards which surface
 *
 * A recipe specifies the refinement levels (a metric or an array of depth-tags), the surface that
 * refined points lie on, and the displacement that moves them. vtkAdaptiveRefinementFilter
 * evaluates the recipe on the CPU and outputs a vtkPolyData. vtkAdaptiveRefinementMapper evaluates
 * it on the GPU and stores no refined mesh. Both create the same triangles. Points agree to float
 * accuracy.
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
   * Set the highest level of an edge, 0 to 7. The default is 3. An edge has at most 2^level
   * segments. Values out of range are rejected with an error, and so are values above a
   * MaximumLevel that you set on the pattern table or that it read from a file. If the table gets a
   * lower level later, or you set another table with a lower level, that level limits the recipe.
   * If it comes from a file, a warning is issued when a surface is refined. The value set here
   * applies again once the table has a higher level.
   */
  void SetMaximumLevel(int level);
  int GetMaximumLevel();
  //@}

  //@{
  /**
   * Set the name of the point array of depth-tags, with one float level per point. The default is
   * "DepthTag". If the mesh has this array, the metric is not used. The tag of an edge is the mean
   * of its two points' tags, rounded half up and clamped to [0, MaximumLevel]. NaN is an error.
   */
  void SetDepthTagArrayName(const char* name);
  const char* GetDepthTagArrayName();
  //@}

  //@{
  /**
   * Set the metric that computes the levels. If there is neither a metric nor an array, all edges
   * have MaximumLevel.
   */
  void SetMetric(vtkDepthTagMetric* metric);
  vtkDepthTagMetric* GetMetric();
  //@}

  //@{
  /**
   * Set the rule by which edges get levels from a metric. With vtkDepthTagMetric::PER_VERTEX (0,
   * the default) the tag of an edge is the mean of its points' tags. With
   * vtkDepthTagMetric::PER_EDGE (1) the metric computes a level for each edge. This takes fewer
   * triangles for segments of the same length, but edges of low level are not refined with their
   * neighbours. Other values are rejected with an error. Depth-tags of an array are always per
   * point.
   */
  void SetLevelRule(int rule);
  vtkGetMacro(LevelRule, int);
  void SetLevelRuleToPerVertex() { this->SetLevelRule(0); }
  void SetLevelRuleToPerEdge() { this->SetLevelRule(1); }
  //@}

  //@{
  /**
   * Set the offset that is added to the tags of all edges before they are rounded and clamped, in
   * levels, -16 to 16. The default is 0. An offset of 1 doubles the segments of each edge. Halving
   * the ReferenceLength of a vtkScreenEdgeDepthTagMetric has the same effect within its range.
   * Values out of range are rejected with an error.
   */
  void SetLevelOffset(double levels);
  vtkGetMacro(LevelOffset, double);
  double GetLevelOffsetMinValue() const { return -16.0; }
  double GetLevelOffsetMaxValue() const { return 16.0; }
  //@}

  /**
   * The numbers of segments that an edge can have.
   */
  enum SegmentPolicies
  {
    POWERS_OF_TWO = 0,
    WHOLE_NUMBERS = 1
  };

  //@{
  /**
   * Set the numbers of segments that an edge can have. POWERS_OF_TWO (0, the default) means 2^level
   * segments. WHOLE_NUMBERS (1) means 2^tag segments, rounded half up to a whole number. Above 16,
   * the number is one of 9 to 16 multiplied by 2, 4 or 8. WHOLE_NUMBERS matches the requested
   * length more closely, but takes many more patterns and draw calls and does not support
   * geomorphing. A pattern table that was read from a file lacks most of these patterns, which is
   * an error when a surface is refined. Other values are rejected with an error.
   */
  void SetSegmentPolicy(int policy);
  vtkGetMacro(SegmentPolicy, int);
  void SetSegmentPolicyToPowersOfTwo() { this->SetSegmentPolicy(POWERS_OF_TWO); }
  void SetSegmentPolicyToWholeNumbers() { this->SetSegmentPolicy(WHOLE_NUMBERS); }
  //@}

  /**
   * When refined vertices move smoothly between levels.
   */
  enum GeomorphingModes
  {
    GEOMORPHING_OFF = 0,
    GEOMORPHING_ON = 1,
    GEOMORPHING_AUTOMATIC = 2
  };

  //@{
  /**
   * Set whether refined vertices move smoothly when levels change, so that nothing pops when the
   * camera moves. A vertex that a higher level adds starts at an existing vertex and slides to its
   * position while the tag rises from half a level below to half a level above (at the last level:
   * to MaximumLevel). The modes are GEOMORPHING_OFF (0), GEOMORPHING_ON (1) and
   * GEOMORPHING_AUTOMATIC (2, the default), which is on for view-dependent metrics if the patterns
   * support it. Geomorphing keeps the segments of edges but uses other triangles inside a face.
   * With SegmentPolicy WHOLE_NUMBERS nothing morphs, and GEOMORPHING_ON causes a warning when a
   * surface is refined. Patterns from a file cannot morph, and GEOMORPHING_ON with such a table is
   * an error when a surface is refined. Other values are rejected with an error.
   */
  void SetGeomorphing(int mode);
  vtkGetMacro(Geomorphing, int);
  void GeomorphingOn() { this->SetGeomorphing(GEOMORPHING_ON); }
  void GeomorphingOff() { this->SetGeomorphing(GEOMORPHING_OFF); }
  //@}

  //@{
  /**
   * Set the surface that refined points lie on. None, the default, means linear.
   */
  void SetSurface(vtkRefinementSurface* surface);
  vtkRefinementSurface* GetSurface();
  //@}

  //@{
  /**
   * Set the displacement of the refined points. There is none by default.
   */
  void SetDisplacement(vtkDisplacement* displacement);
  vtkDisplacement* GetDisplacement();
  //@}

  //@{
  /**
   * Set the magnitude at and above which vectors are missing values ("no data"). A vector, which is
   * a tuple of 2 or 3 components, is a missing value if a component has at least this absolute
   * value, as in (-1e9, 0, 0). The default is 1e8. Infinity turns this off. Values of 0 or less are
   * rejected with an error. Non-finite vectors and numbers are always missing values. If one of the
   * points that point data are interpolated from has a missing value, the result is NaN, or in
   * integer arrays the value of the nearest of these points. Input points keep their values.
   * Normals, tangents and texture coordinates are never missing values.
   */
  void SetNoDataMagnitude(double magnitude);
  vtkGetMacro(NoDataMagnitude, double);
  //@}

  //@{
  /**
   * Set the table of patterns, shared by all filters and mappers that evaluate this recipe. The
   * default is a table with all levels. All default tables share one cache of patterns, which are
   * generated on first use. nullptr restores the default.
   */
  void SetPatternTable(vtkRefinementPatternTable* table);
  vtkRefinementPatternTable* GetPatternTable();
  //@}

  /**
   * Return the time of the latest change of the recipe or its parts.
   */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  /**
   * Return the value given to SetMaximumLevel(), even if the pattern table has a lower one.
   */
  int GetAskedMaximumLevel() const
  {
    return this->MaximumLevel;
  }
#endif

protected:
  vtkAdaptiveRefinement();
  ~vtkAdaptiveRefinement() override;

  int MaximumLevel = 3; // 64 triangles per face, so that the first frame is fast
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

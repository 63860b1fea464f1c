// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMicroMeshFilter
 * @brief   encode a dense mesh as a coarse mesh with displacements, within a tolerance
 *
 * The input is a dense triangle mesh, such as a scan or an isosurface. The output is a micro-mesh:
 * a coarse mesh of some of its points, with a triangular grid of displacements on each face. A
 * recipe with a vtkMicroMeshSurface evaluates it, on the CPU and on the graphics card.
 *
 * All points of the input are within the tolerance of the result, and all points of the result
 * within the tolerance of the input. The filter measures bounds of both distances on the stored
 * displacements. They hold between samples too. Where displacements cannot meet the tolerance, the
 * filter keeps more triangles of the input, and in the end all of them. The result is the surface
 * at the levels of the micro-mesh; vtkAdaptiveRefinement::SetMaximumLevel() to MaximumLevel or more
 * evaluates it.
 *
 * Lines stay within the tolerance of edges of the coarse mesh: borders, edges sharper than
 * FeatureAngle, borders between materials, and seams, at which the input has several points at the
 * same place. Their ends and branches are points of the output.
 *
 * The input can be open, and can have several parts. Edges of more than two triangles and edges
 * with inconsistent winding are kept as they are, with a warning. Triangles with coincident corners
 * and duplicates of triangles are left out, with a warning. Polygons are split into fans, and
 * strips into triangles. Vertices and lines are ignored.
 *
 * The output is a vtkPolyData, which can be saved as a .vtp file:
 *
 * - Points have the type of the input. Those that represent others are rounded to multiples of a
 *   power of two that is at most 1/16 of the tolerance, so that files are small. All others have
 *   the coordinates of the input. Points are split at seams and at sharp edges. Point arrays are
 *   those of the input at these points, and "Normals" (float), those of the displaced surface.
 *   "MicroMeshDirections" (float, 3 components) is the displacement for a sample of 1.
 * - Cell arrays are those of the input, of one of the triangles at the coarse triangle, and
 *   "MicroMeshFaces" (int, 5 components). "vtkOriginalCellIds" (PassThroughCellIdsOn()) is the
 *   id of this triangle. The values of "MicroMeshFaces" are, for the edges from corner 0 to 1, 1
 *   to 2 and 2 to 0, the index of the edge times 2, plus 1 if the samples of the edge run in the
 *   opposite direction; the first sample inside of the triangle; the level L. The triangle has a
 *   grid of 2^L segments per edge. Its samples inside are in rows from the edge 0, each from
 *   corner 0 to corner 1. "MicroMeshLevelErrors" (float) has, for each level from 0, how far the
 *   triangle at this level can be from the surface, as a length. At higher levels than it has
 *   components, this is 0.
 * - Field arrays are "MicroMeshEdges" (int, 2 components), the first sample and the level of
 *   each edge; "MicroMeshDisplacements" (signed char or short), the samples; "MicroMeshError"
 *   (double, 2 values), the bounds of the distances from the input to the result and back, as
 *   lengths; "MicroMeshInputBounds" (double, 6 values), the bounds of the input;
 *   "MicroMeshPointData:NAME", the values of the point array NAME at the (2^L + 1) (2^L + 2) / 2
 *   grid points of each triangle, corners included, in rows from the edge 0 (AttributesOn());
 *   "MicroMeshCellData:NAME", the values of the cell array NAME at the 4^L triangles of each
 *   grid, in rows from the edge 0, each of the triangle of the input nearest to the centre
 *   (AttributesOn()).
 *
 * A grid point lies at the weighted mean of the corners, plus its sample times the weighted mean of
 * their directions. Corners are not displaced. The level of an edge is at most that of its
 * triangles, which agree on it; between its samples, the edge is straight.
 *
 * The result does not depend on the number of threads.
 *
 * If more than a tenth of the edges are sharper than FeatureAngle, as in noisy scans, and therefore
 * more than a tenth of the triangles are left, a warning counts them.
 *
 * A tolerance that is not set, points that are not finite, cells with points that do not exist and
 * a missing array of materials or fixed points are errors, and the output is empty. Arrays with too
 * few tuples are left out with a warning.
 *
 * Sources: M. Garland, P. Heckbert, "Surface Simplification Using Quadric Error Metrics", SIGGRAPH
 * 1997, for the coarse mesh. The layout follows the idea of NVIDIA's micro-meshes (A. Maggiordomo,
 * H. Moreton, M. Tarini, "Micro-Mesh Construction", ACM Transactions on Graphics 42(4), 2023).
 *
 * @sa vtkMicroMeshSurface vtkAdaptiveRefinement vtkQuadricDecimation
 */
#ifndef vtkMicroMeshFilter_h
#define vtkMicroMeshFilter_h

#include "RelevoFiltersMicroMeshModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for members

namespace relevo
{
class DenseMesh;
}

class vtkDataArray;

class RELEVOFILTERSMICROMESH_EXPORT vtkMicroMeshFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkMicroMeshFilter* New();
  vtkTypeMacro(vtkMicroMeshFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the largest distance between input and result, a length above 0. It must be set.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  //@}

  //@{
  /**
   * Set the part of the triangles to remove for the coarse mesh, from 0 to 1. The default is 0.99.
   * The tolerance and lines have priority: the coarse mesh can have more triangles.
   */
  void SetTargetReduction(double reduction);
  vtkGetMacro(TargetReduction, double);
  //@}

  //@{
  /**
   * Set the highest level of grids, from 0 to 7. A grid of level L has 4^L triangles. The default
   * is 5.
   */
  void SetMaximumLevel(int level);
  vtkGetMacro(MaximumLevel, int);
  //@}

  //@{
  /**
   * Set the angle between the normals of two triangles above which their edge is sharp, in degrees
   * from 0 to 180. The default is 60. With 180, no edges are sharp.
   */
  void SetFeatureAngle(double degrees);
  vtkGetMacro(FeatureAngle, double);
  //@}

  //@{
  /**
   * Set the name of a numeric cell array. Edges between triangles with different values are kept as
   * lines. The default is an empty name: there are no materials.
   */
  void SetMaterialArrayName(const char* name);
  const char* GetMaterialArrayName() const { return this->MaterialArrayName.c_str(); }
  //@}

  //@{
  /**
   * Set the name of a numeric point array with 1 or 4 components. Points with a first component
   * other than 0 are fixed: they are points of the output, and edges between two of them at the
   * border of the mesh are edges of the output. A point with the value 2 between two fixed points
   * of the border can be left out, as on other borders, within the tolerance.
   *
   * The other components are the direction at the point, as in the array MicroMeshDirections of
   * another micro-mesh, or 0. Pieces of a surface that are encoded separately match if the points
   * of their common borders are fixed with the value 1 and the same directions. The array is not
   * sampled on the grids. The default is an empty name: no points are fixed.
   */
  void SetFixedPointArrayName(const char* name);
  const char* GetFixedPointArrayName() const { return this->FixedPointArrayName.c_str(); }
  //@}

  //@{
  /**
   * Set whether numeric arrays of the input's points and cells, except normals and ids, are sampled
   * on the grids too. On by default. Off, they have values only at the coarse points and triangles.
   */
  vtkSetMacro(Attributes, bool);
  vtkGetMacro(Attributes, bool);
  vtkBooleanMacro(Attributes, bool);
  //@}

  //@{
  /**
   * Set whether the output has the cell array "vtkOriginalCellIds". Off by default.
   */
  vtkSetMacro(PassThroughCellIds, bool);
  vtkGetMacro(PassThroughCellIds, bool);
  vtkBooleanMacro(PassThroughCellIds, bool);
  //@}

  /**
   * Return the larger bound of the distances from the input to the result and back, of the last
   * update, as a length.
   */
  vtkGetMacro(Error, double);

protected:
  vtkMicroMeshFilter();
  ~vtkMicroMeshFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Tolerance = 0.0;
  double TargetReduction = 0.99;
  int MaximumLevel = 5;
  double FeatureAngle = 60.0;
  std::string MaterialArrayName;
  std::string FixedPointArrayName;
  bool Attributes = true;
  bool PassThroughCellIds = false;
  double Error = 0.0;

private:
  vtkMicroMeshFilter(const vtkMicroMeshFilter&) = delete;
  void operator=(const vtkMicroMeshFilter&) = delete;

  bool CheckInput(vtkPolyData* input);
  bool FindMaterials(vtkPolyData* input, vtkDataArray*& materials);
  bool FindFixedPoints(vtkPolyData* input, vtkDataArray*& fixed);
  void RemoveShortArrays(vtkPolyData* mesh);
  void WarnOfTriangles(const relevo::DenseMesh& dense);
  void WarnOfSharpEdges(const relevo::DenseMesh& dense, vtkIdType faces);
  int Encode(vtkPolyData* input, vtkPolyData* output);
};

#endif

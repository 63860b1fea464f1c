// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefWarper
 * @brief   warp a relief to an image on its plane that looks correct from a camera
 *
 * Each texel moves to the intersection of the relief's plane with the line from the eye through the
 * texel's point, so that a single textured quad draws the relief (M. Oliveira, G. Bishop, D.
 * McAllister, "Relief Texture Mapping", 2000). For column u and row v this is u' = (u + k1 d) / (1
 * + k3 d), v' = (v + k2 d) / (1 + k3 d), where d is the depth relative to the plane. The plane is
 * at depth 0, in perspective at the nearest valid texel (and 1 / d replaces d). The filter warps
 * rows first, then columns. Each pass is exact at integer positions of the surface. The nearest
 * surface is visible; at equal depth, that of the lower row, then of the lower column. Connected
 * surfaces have no pinholes. Borders extend to the nearest integer position, so that isolated
 * texels remain. Surfaces behind a fold of one row can be lost where their row folds too.
 *
 * Input: a relief, which is a vtkImageData with the point arrays "Color" (unsigned char, 3 or 4
 * components), "Depth" (float, NaN without surface) and optionally "Normals" (float, 3 components),
 * and the field arrays "ReliefProjection" and "ReliefMatrix".
 *
 * Output: a vtkImageData of the same dimensions with the same point arrays, seen from the camera.
 * Depths are those of the source. Where the camera sees no surface, they are NaN, and colours and
 * normals are 0. Texels that move out of the image are dropped. Field arrays are "ReliefProjection"
 * and "ReliefMatrix" of the source, and "ReliefWarp" (4 doubles): k1, k2, k3 and the height w0 of
 * the plane. With w = d, in perspective w = 1 / d, the texel (u', v') shows the column u = u' (1 +
 * k3 (w - w0)) - k1 (w - w0) and row v = v' (1 + k3 (w - w0)) - k2 (w - w0) of the source, at depth
 * d. The output is not a relief and is rejected as an input.
 *
 * The result depends on the position of the eye, in parallel projection on the viewing direction.
 * Rotating the camera about its position and zooming need no new warp. If the eye is in the plane
 * or behind it, all depths are NaN, and a warning is issued when this begins; see CanWarp().
 *
 * The filter reports an error and produces an empty output if there is no camera, the input is not
 * a relief, or memory is insufficient.
 */
#ifndef vtkReliefWarper_h
#define vtkReliefWarper_h

#include "RelevoFiltersReliefModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <memory> // for members

class vtkCamera;

class RELEVOFILTERSRELIEF_EXPORT vtkReliefWarper : public vtkImageAlgorithm
{
public:
  static vtkReliefWarper* New();
  vtkTypeMacro(vtkReliefWarper, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the camera. Required.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Set the distance of adjacent texels, in texel widths at the depth of the nearer one, beyond
   * which the surface is open between them; at least 0, default 8.
   */
  void SetMaximumStretch(double stretch);
  vtkGetMacro(MaximumStretch, double);
  //@}

  enum PolicyType
  {
    SEQUENTIAL,
    PARALLEL,
    MULTI_THREADED,
    ROWS_AND_COLUMNS
  };

  //@{
  /**
   * Set how to distribute the work. All policies produce bitwise identical images.
   *
   * - Sequential (0, default): in Update().
   * - Parallel (1): in a separate thread, while the last image is drawn. Update() only waits for
   *   the first image of the given dimensions. Otherwise it takes the latest finished image, and
   *   starts the next one if something has changed. GetMTime() increases when an image is finished:
   *   call Update() until GetState() is FINAL. The input may change meanwhile.
   * - Multi-threaded (2): in Update(), with NumberOfThreads threads. Each thread warps a band of
   *   rows to a separate image; the images are merged. This needs memory for one image per thread.
   * - Rows and columns (3): in Update(), threads share the rows of the first pass and then the
   *   columns of the second. The result of the first pass needs about 35 bytes per texel.
   */
  void SetPolicy(int policy);
  vtkGetMacro(Policy, int);
  void SetPolicyToSequential() { this->SetPolicy(SEQUENTIAL); }
  void SetPolicyToParallel() { this->SetPolicy(PARALLEL); }
  void SetPolicyToMultiThreaded() { this->SetPolicy(MULTI_THREADED); }
  void SetPolicyToRowsAndColumns() { this->SetPolicy(ROWS_AND_COLUMNS); }
  //@}

  //@{
  /**
   * Set the number of threads of MULTI_THREADED and ROWS_AND_COLUMNS, 0 to 64. 0 (default) is the
   * default of vtkMultiThreader, one per processor.
   */
  void SetNumberOfThreads(int number);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  enum StateType
  {
    INITIAL, ///< before the first warp
    WARPING, ///< the thread of the parallel policy is warping
    WAITING, ///< a finished image waits for the next Update()
    FINAL    ///< the output shows the state at the last Update()
  };

  /// Return the state, a StateType. All policies except PARALLEL go from INITIAL to FINAL.
  int GetState();

  /// Return the number of warps of all policies so far.
  int GetNumberOfWarps();
  /// Return the time of the last warp in seconds, 0 before the first.
  double GetWarpTime();

  /// Return whether the camera is in front of the plane of the last input. If not, Update()
  /// produces an image without surface. Returns false before the first Update().
  bool CanWarp();

  /// Include the modification time of the camera. It increases while a finished image is WAITING.
  vtkMTimeType GetMTime() override;

protected:
  vtkReliefWarper();
  ~vtkReliefWarper() override;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkReliefWarper(const vtkReliefWarper&) = delete;
  void operator=(const vtkReliefWarper&) = delete;

  bool Read(vtkImageData* input);
  void Warp(vtkImageData* output);

  class Internals;
  std::unique_ptr<Internals> Own;
  vtkSmartPointer<vtkCamera> Camera;
  double MaximumStretch = 8.0;
  int Policy = SEQUENTIAL;
  int NumberOfThreads = 0;
};

#endif

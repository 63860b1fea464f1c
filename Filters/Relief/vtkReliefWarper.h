// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefWarper
 * @brief   a relief as a picture on its own plane that looks right from a camera
 *
 * Each texel goes to where the line from the camera's eye to its point meets the relief's plane:
 * what is left to draw is one textured quad (M. Oliveira, G. Bishop, D. McAllister, "Relief Texture
 * Mapping", 2000). For a texel of column u and row v this is u' = (u + k1 d) / (1 + k3 d), v' = (v
 * + k2 d) / (1 + k3 d), with d counted from the plane: depth 0, in perspective the depth of the
 * nearest valid texel (there 1 / d takes the place of d). It is done in two passes, along rows,
 * then along columns; each is exact where the surface is at whole positions. The nearest surface is
 * seen; where two are as near, that of the lower row, then the lower column. Connected surface has
 * no pinholes, and where the surface ends it reaches to the nearest whole position, so that single
 * texels stay. What lies behind a fold of a row may be lost where its own row folds.
 *
 * Input: a relief, a vtkImageData with the point arrays "Color" (unsigned char, 3 or 4 components),
 * "Depth" (float, NaN where there is no surface) and perhaps "Normals" (float, 3 components), and
 * the field arrays "ReliefProjection" and "ReliefMatrix".
 *
 * Output: a vtkImageData of the same dimensions with the same point arrays as seen by the camera,
 * row after row: depths are the source's, NaN where the camera sees no surface; colours and normals
 * are 0 there. What lands beside the image is left out. Field arrays: "ReliefProjection" and
 * "ReliefMatrix" of the source, and "ReliefWarp" with k1, k2, k3 and the height of the plane w0 (4
 * doubles). With the height w = d, in perspective w = 1 / d, a texel (u', v') lies at the column u
 * = u' (1 + k3 (w - w0)) - k1 (w - w0) and the row v = v' (1 + k3 (w - w0)) - k2 (w - w0) of the
 * source, at depth d there. So the output is no relief, and is refused as one.
 *
 * Only where the camera's eye is counts, with parallel projection from where it looks: turning and
 * zooming ask for no new warp. Where the eye is in the plane or behind it there is no such picture:
 * all is NaN, with a warning the first time, see CanWarp().
 *
 * Errors, with an empty output: no camera; an input that is no relief; too little memory.
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
   * Where to look from; needed.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * The surface is open between neighbours that are farther apart than this many texel widths, at
   * least 0, default 8. A texel is as wide as it is at the nearer one's depth.
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
   * Who warps; all give the same picture, to the bit. Default SEQUENTIAL (0).
   *
   * Sequential: Update() itself. Multi-threaded (2): in Update(), NumberOfThreads threads with a
   * band of rows and a picture each, merged at the end; memory for as many pictures. Rows and
   * columns (3): in Update(), threads share the rows of the first pass, then the columns of the
   * second; memory for what is between both, some 35 bytes for each texel.
   *
   * Parallel (1): a thread of its own, while the last picture is drawn. Update() waits for the
   * first picture alone, and for the first of other dimensions; then it takes the latest that is
   * finished, and has the next one begun if something has changed since. GetMTime() tells by a
   * newer time that there is one to take: update until GetState() is FINAL. The input may change
   * meanwhile.
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
   * Threads of MULTI_THREADED and ROWS_AND_COLUMNS, 0 to 64; 0, the default, is as many as
   * vtkMultiThreader has by default, one for each processor.
   */
  void SetNumberOfThreads(int number);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  enum StateType
  {
    INITIAL, ///< nothing is warped yet
    WARPING, ///< the parallel policy's thread warps
    WAITING, ///< it has finished a picture, which the next Update() takes
    FINAL    ///< the output shows what was asked for in the last Update()
  };

  /// What is going on, one of StateType. All policies but PARALLEL go from INITIAL to FINAL.
  int GetState();

  /// How many warps were done, by all policies.
  int GetNumberOfWarps();
  /// Seconds that the last warp took, 0 before the first.
  double GetWarpTime();

  /// Whether the camera, as it is now, sees the plane of the last input from the front: else
  /// Update() gives a picture without surface. False before the first Update().
  bool CanWarp();

  /// Includes the camera's modification time; always newer while a finished picture is WAITING.
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

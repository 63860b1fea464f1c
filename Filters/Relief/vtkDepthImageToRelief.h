// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthImageToRelief
 * @brief   convert a depth image or a z-buffer to a relief
 *
 * Input 0: a vtkImageData of n x m x 1 points whose point scalars, of any type, are depths. To
 * choose another array, call SetInputArrayToProcess(0, 0, 0, 0, name). Depths that are zero,
 * negative, NaN or infinite mean that there is no surface. Input 1, optional: a vtkImageData of the
 * same size with colours of 1 to 4 components (grey, grey and opacity, RGB, RGBA) as point scalars.
 * unsigned char is used unchanged, unsigned short ranges from 0 to 65535, float and double from 0
 * to 1. Without colours, the relief is grey: white is nearest, dark is farthest.
 *
 * By default, the image is that of a pinhole camera. The depth along the axis of the camera is d =
 * DepthScale * sample, and the texel in column c and row r is at Pose * ((c - cx) d / fx, (r - cy)
 * d / fy, d, 1). This is the usual calibration of depth cameras: x to the right, y down, z ahead.
 * The first row is the top row, as in camera drivers and NumPy. VTK's image readers store the
 * bottom row first: call BottomRowFirstOn() for their images.
 *
 * If you call SetCamera(), the samples are a z-buffer from 0 to 1, as vtkWindowToImageFilter and
 * vtkRendererSource produce it: 1 is the background, without surface, and row 0 is the bottom row.
 * The relief uses the projection of the camera and the aspect ratio of the image. If there is a
 * point array "ZBuffer", it has the depths, and the scalars are the colours (vtkRendererSource with
 * DepthValuesOn()). Texels are at pixel centres, where OpenGL samples. vtkDepthImageToPointCloud
 * instead maps the outermost pixels to the edges of the view, so that its points are up to half a
 * pixel away. DepthScale, Intrinsics, Pose and BottomRowFirst are ignored.
 *
 * The output is the relief, a vtkImageData of the same size with the point arrays "Color" (unsigned
 * char, 3 or 4 components), "Depth" (float, NaN without surface) and "Normals" (float, world
 * coordinates), and the field arrays "ReliefProjection" and "ReliefMatrix". Depths of a parallel
 * relief are relative to the nearest texel, in world units.
 *
 * The filter reports an error (ErrorEvent) and produces an empty output if there are neither
 * intrinsics nor a camera; the image is not n x m x 1 or has no scalars of one component; colours
 * have another size or type; the pose or camera is not invertible; or no depth is valid.
 *
 * @sa vtkHeightMapToRelief vtkDepthImageToPointCloud
 */
#ifndef vtkDepthImageToRelief_h
#define vtkDepthImageToRelief_h

#include "RelevoFiltersReliefModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <string> // for errors

class vtkCamera;
class vtkDataArray;
class vtkFloatArray;
class vtkMatrix4x4;

class RELEVOFILTERSRELIEF_EXPORT vtkDepthImageToRelief : public vtkImageAlgorithm
{
public:
  static vtkDepthImageToRelief* New();
  vtkTypeMacro(vtkDepthImageToRelief, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the world units per unit of depth, greater than 0, default 1. For example, use 0.001 for a
   * camera that delivers millimetres and a world in metres.
   */
  void SetDepthScale(double scale);
  vtkGetMacro(DepthScale, double);
  //@}

  //@{
  /**
   * Set the intrinsics of the pinhole camera in pixels: focal lengths along columns and rows,
   * greater than 0, and column and row of the principal point. Pixel centres are integers, and row
   * 0 is the top row. All are 0 by default, which means that they are not set. Other values out of
   * range are an error and change nothing.
   */
  void SetIntrinsics(double fx, double fy, double cx, double cy);
  void SetIntrinsics(const double values[4])
  {
    this->SetIntrinsics(values[0], values[1], values[2], values[3]);
  }
  vtkGetVector4Macro(Intrinsics, double);
  //@}

  //@{
  /**
   * Set the matrix from camera coordinates (x to the right, y down, z ahead) to world coordinates.
   * nullptr (default) is the identity.
   */
  void SetPose(vtkMatrix4x4* cameraToWorld);
  vtkMatrix4x4* GetPose();
  //@}

  //@{
  /**
   * Set whether the first row of the images is the bottom row, as in images of VTK's readers; off
   * by default. The intrinsics always count rows from the top.
   */
  vtkSetMacro(BottomRowFirst, bool);
  vtkGetMacro(BottomRowFirst, bool);
  vtkBooleanMacro(BottomRowFirst, bool);
  //@}

  //@{
  /**
   * Set the camera of the z-buffer, with the clipping range with which it was rendered. The filter
   * detects modifications of the camera. With nullptr (default), the depths are those of a pinhole
   * camera.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Set whether normals are computed from the depths; on by default.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  //@}

  /// Include the modification times of camera and pose.
  vtkMTimeType GetMTime() override;

protected:
  vtkDepthImageToRelief();
  ~vtkDepthImageToRelief() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDepthImageToRelief(const vtkDepthImageToRelief&) = delete;
  void operator=(const vtkDepthImageToRelief&) = delete;

  std::string Build(vtkImageData* input, vtkImageData* colorInput, vtkImageData* output);
  std::string GetChosenName();
  vtkDataArray* FindDepths(vtkImageData* input);
  std::string DescribeMissingDepths(vtkImageData* input);
  std::string AddPinholeDepths(vtkDataArray* samples, vtkImageData* output);
  std::string AddZBufferDepths(vtkDataArray* samples, vtkImageData* output);
  std::string AddColors(
    vtkImageData* input, vtkImageData* colorInput, vtkDataArray* samples, vtkImageData* output);

  double DepthScale = 1.0;
  double Intrinsics[4] = { 0.0, 0.0, 0.0, 0.0 };
  vtkSmartPointer<vtkMatrix4x4> Pose;
  bool BottomRowFirst = false;
  vtkSmartPointer<vtkCamera> Camera;
  bool ComputeNormals = true;
};

#endif

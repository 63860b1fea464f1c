// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthImageToRelief
 * @brief   a relief of a depth camera's image, or of a z-buffer
 *
 * Input 0: a vtkImageData of n x m x 1 points whose point scalars, of any type, are depths, or the
 * array of SetInputArrayToProcess(0, 0, 0, 0, name). Zero, negative, NaN and infinite depths are no
 * surface. Input 1, optional: a vtkImageData of the same size whose point scalars are colours, of 1
 * to 4 components (grey, grey and opacity, RGB, RGBA): unsigned char as they are, unsigned short
 * from 0 to 65535, float and double from 0 to 1. Without it the relief is grey: white is nearest,
 * dark farthest.
 *
 * By default the image is that of a pinhole camera: DepthScale times a sample is the depth d along
 * the camera's axis, and the texel of column c and row r lies at Pose times ((c - cx) d / fx, (r -
 * cy) d / fy, d, 1). This is how depth cameras are calibrated: x to the right, y down, z ahead, and
 * the first row of the image is the top one, as cameras and NumPy have it. VTK's image readers turn
 * pictures over, so that the first row is the bottom one: then call BottomRowFirstOn().
 *
 * With SetCamera() the samples are a z-buffer from 0 to 1, as vtkWindowToImageFilter and
 * vtkRendererSource give it: 1 is the background and no surface, and row 0 is the lowest. The
 * relief is of the camera's projection. The aspect ratio is the image's. If there is a point array
 * "ZBuffer", it has the depths, and the scalars the colours (vtkRendererSource with
 * DepthValuesOn()). Texels are the centres of pixels, where OpenGL samples; points lie where
 * vtkDepthImageToPointCloud puts them, but that this takes the outermost pixels for the edges of
 * the view, so that they are half a pixel apart there. DepthScale, Intrinsics, Pose and
 * BottomRowFirst have no effect.
 *
 * Output: the relief, a vtkImageData of the same size with the point arrays "Color" (unsigned char,
 * 3 or 4 components), "Depth" (float, NaN where there is no surface) and "Normals" (float, world),
 * and the field arrays "ReliefProjection" and "ReliefMatrix". A parallel relief's depths count from
 * its nearest texel, in units of the world.
 *
 * Errors (ErrorEvent of this object, empty output): neither intrinsics nor a camera; an image that
 * is not n x m x 1, or has no scalars of one component; colours of another size or type; a pose or
 * a camera without an inverse; no depth that is valid.
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
   * Units of the world, as metres, in one unit of the depths; default 1, more than 0. Cameras that
   * give millimetres have 0.001.
   */
  void SetDepthScale(double scale);
  vtkGetMacro(DepthScale, double);
  //@}

  //@{
  /**
   * The pinhole camera in pixels: focal lengths along columns and rows, more than 0, and the column
   * and row of the principal point, where centres of pixels are whole numbers and the image's top
   * row is 0. All are 0 before the first call: there are none.
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
   * From the camera's coordinates (x to the right, y down, z ahead) to the world's. Default
   * nullptr: they are the same.
   */
  void SetPose(vtkMatrix4x4* cameraToWorld);
  vtkMatrix4x4* GetPose();
  //@}

  //@{
  /**
   * Whether the first row of the images is the bottom one, as VTK's image readers give them; off by
   * default. Intrinsics count rows from the top all the same.
   */
  vtkSetMacro(BottomRowFirst, bool);
  vtkGetMacro(BottomRowFirst, bool);
  vtkBooleanMacro(BottomRowFirst, bool);
  //@}

  //@{
  /**
   * The camera that the z-buffer is of, as it was then, clipping range and all; its changes count.
   * Default nullptr: the depths are those of a pinhole camera.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Whether the relief gets normals, computed from its depths; on by default.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  //@}

  /// Includes the modification times of camera and pose.
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

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefCapture
 * @brief   captures reliefs of a renderer's scene: colours, depths and normals
 *
 * Each block of the output is the relief of one camera, a vtkImageData of n x m x 1 points, where n
 * x m is the resolution. Its point arrays are "Color" (unsigned char; red, green, blue under the
 * renderer's lights), "Depth" (float, NaN where the texel is empty) and "Normals" (float, unit
 * vectors in world coordinates). Its field arrays are "ReliefProjection" (0 parallel, 1
 * perspective) and "ReliefMatrix" (16 doubles M, by rows). A texel's column c and row r are whole
 * numbers at its centre. A texel at depth d shows the world position M (c, r, d, 1), in perspective
 * M (c d, r d, d, 1). A block is nullptr if its camera sees nothing. vtkReliefMapper draws reliefs
 * from nearby views (M. M. Oliveira, G. Bishop, D. McAllister, "Relief Texture Mapping", 2000).
 *
 * The capture draws into a framebuffer in the renderer's window and OpenGL context. Mappers keep
 * their buffers, and the window's image and its cameras do not change. A texel shows one surface:
 * there is no multisampling. The renderer's visible props with opaque geometry are captured.
 * Translucent props and volumes have no single depth: they are left out, and a warning reports
 * their number. Props without bounds, such as annotations, are left out, too. Shadows, ambient
 * occlusion and a renderer's render pass are not captured.
 *
 * Colours are lit for the capture's camera. A headlight, which renderers without lights have, is at
 * that camera, and highlights are those that it sees. Both differ from other views. To avoid this,
 * use scene lights (vtkLight::SetLightTypeToSceneLight()) and little specular, or the lit shading
 * of vtkReliefMapper.
 *
 * For vtkPolyDataMapper and mappers derived from it, the normals are those that light the visible
 * side of the surface. For other props they are computed from depths.
 *
 * The output is updated when a prop, its data, a light of the renderer or a given camera changes. A
 * prop that shows this output must be invisible during Update().
 *
 * These are errors without output: no renderer, no window, no cameras, an empty scene, and a
 * resolution that OpenGL cannot draw to. A camera whose matrices are singular is an error, too; the
 * other blocks are valid then.
 *
 * @sa vtkReliefMapper, vtkReliefPass
 */
#ifndef vtkReliefCapture_h
#define vtkReliefCapture_h

#include "RelevoRenderingReliefModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <memory> // for Internals

class vtkCamera;
class vtkRenderer;

class RELEVORENDERINGRELIEF_EXPORT vtkReliefCapture : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkReliefCapture* New();
  vtkTypeMacro(vtkReliefCapture, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the renderer to capture. This object does not hold a reference to the renderer, because it
   * may be part of the renderer's scene. The renderer must be in a vtkRenderWindow, which is
   * initialized if necessary.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  //@}

  //@{
  /**
   * Set the number of columns and rows of each relief. The default is 1024 x 1024. Values less than
   * 1 are an error and change nothing.
   */
  void SetResolution(int columns, int rows);
  void SetResolution(int size) { this->SetResolution(size, size); }
  vtkGetVector2Macro(Resolution, int);
  //@}

  //@{
  /**
   * Add a camera to capture from; the cameras of SetCamerasToBox() or SetCamerasToSphere() are then
   * not used. Parallel and perspective cameras work, including those with explicit matrices. The
   * clipping range is ignored: it is fitted to the visible scene. nullptr is an error and adds
   * nothing.
   */
  void AddCamera(vtkCamera* camera);
  void RemoveAllCameras();
  //@}

  /**
   * Use six parallel cameras along x, -x, y, -y, z and -z, each fitted to the bounds of the
   * captured props. This is the default.
   */
  void SetCamerasToBox();

  /**
   * Use parallel cameras at the points of an icosahedron that look at its centre, fitted to the
   * bounds of the captured props. Level 0 has 12 cameras; each level, up to 3, splits the
   * icosahedron's faces in four: 42, 162, 642 cameras. A level out of range is an error and changes
   * nothing.
   */
  void SetCamerasToSphere(int level);

  /// Return the number of cameras, which is the number of blocks of the output.
  int GetNumberOfCameras();

  //@{
  /**
   * Set whether empty rows and columns at the sides are cropped. Reliefs are then smaller than the
   * resolution. Off by default.
   */
  vtkSetMacro(Cropping, bool);
  vtkGetMacro(Cropping, bool);
  vtkBooleanMacro(Cropping, bool);
  //@}

  //@{
  /**
   * Set whether normals are captured, which takes 12 bytes per texel. On by default.
   */
  vtkSetMacro(CaptureNormals, bool);
  vtkGetMacro(CaptureNormals, bool);
  vtkBooleanMacro(CaptureNormals, bool);
  //@}

  /**
   * Includes changes of the cameras and of the renderer's scene.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkReliefCapture();
  ~vtkReliefCapture() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Resolution[2] = { 1024, 1024 };
  bool Cropping = false;
  bool CaptureNormals = true;

private:
  vtkReliefCapture(const vtkReliefCapture&) = delete;
  void operator=(const vtkReliefCapture&) = delete;

  class vtkInternals;

  bool Capture(vtkMultiBlockDataSet* output);
  bool CaptureAll(vtkMultiBlockDataSet* output);
  std::unique_ptr<vtkInternals> Internals;
};

#endif

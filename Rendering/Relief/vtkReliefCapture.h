// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefCapture
 * @brief   reliefs of what a renderer shows: colours, depths and normals, as cameras see them
 *
 * Each camera's relief is a block of the output, a vtkImageData of the resolution's n x m x 1
 * points: point arrays "Color" (unsigned char, red, green, blue, as drawn with the renderer's
 * lights), "Depth" (float, NaN where nothing is) and "Normals" (float, unit vectors in the world),
 * field arrays "ReliefProjection" (0 parallel, 1 perspective) and "ReliefMatrix" (16 doubles M, by
 * rows). The texel of column c, row r, whose centre is at whole numbers, shows the point M (c, r,
 * d, 1) of the world at its depth d, in perspective M (c d, r d, d, 1). A block whose camera sees
 * nothing is nullptr. vtkReliefMapper shows reliefs from near views
 * (M. M. Oliveira, G. Bishop, D. McAllister, "Relief Texture Mapping", 2000).
 *
 * It draws in the renderer's own window and OpenGL context, into a framebuffer of its own: mappers
 * keep their buffers, and neither what the window shows nor its cameras change. A texel shows one
 * surface: there are no multisamples. What is captured is the renderer's visible props with
 * opaque geometry. Translucent ones and volumes have no one depth and are left out, with a warning
 * that says how many; props without bounds, as annotations, are left out, too. Shadows, ambient
 * occlusion and a renderer's render pass are not drawn.
 *
 * Colours are those under the lights as they stand for the capture's camera: a headlight, which
 * renderers without lights have, is where that camera is, and highlights are those seen from there.
 * From elsewhere both differ. Where that matters use lights of the scene
 * (vtkLight::SetLightTypeToSceneLight()) and little specular, or vtkReliefMapper's lit shading.
 *
 * Normals are those that vtkPolyDataMapper and mappers derived from it light the surface with, on
 * the side that is seen; of other props they are computed from depths.
 *
 * The output is made anew when a prop, its data, a light of the renderer or a given camera changed.
 * A prop that shows this output is to be invisible during Update().
 *
 * An error, and no output: no renderer, no window, no cameras, nothing to be seen, a resolution
 * beyond what OpenGL can draw to. A camera whose matrices have no inverse is an error, too; the
 * other blocks are there then.
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
   * What is captured. The renderer is not kept alive by this object, which may be part of what it
   * draws. It must be in a vtkRenderWindow, which is initialized if it was not yet.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  //@}

  //@{
  /**
   * Columns and rows of each relief, or both at once; default 1024 x 1024.
   */
  void SetResolution(int columns, int rows);
  void SetResolution(int size) { this->SetResolution(size, size); }
  vtkGetVector2Macro(Resolution, int);
  //@}

  //@{
  /**
   * Cameras to capture from, in place of those of SetCamerasToBox() or SetCamerasToSphere(): in
   * parallel or perspective, through their own matrices, whatever they are. Only the clipping range
   * does not count: it is fitted to what is visible.
   */
  void AddCamera(vtkCamera* camera);
  void RemoveAllCameras();
  //@}

  /**
   * Parallel cameras along x, -x, y, -y, z and -z, each fitted to the bounds of what is captured:
   * the default.
   */
  void SetCamerasToBox();

  /**
   * Parallel cameras that look at the middle from the points of an icosahedron, fitted as above.
   * Level 0: its 12 points; each level, up to 3, splits its faces in four: 42, 162, 642.
   */
  void SetCamerasToSphere(int level);

  /// Of the output's blocks, now.
  int GetNumberOfCameras();

  //@{
  /**
   * Whether rows and columns at the sides where nothing is seen are left out of the reliefs, which
   * are then smaller than the resolution; off by default.
   */
  vtkSetMacro(Cropping, bool);
  vtkGetMacro(Cropping, bool);
  vtkBooleanMacro(Cropping, bool);
  //@}

  //@{
  /**
   * Whether there are normals, 12 bytes a texel; on by default.
   */
  vtkSetMacro(CaptureNormals, bool);
  vtkGetMacro(CaptureNormals, bool);
  vtkBooleanMacro(CaptureNormals, bool);
  //@}

  /**
   * Includes changes of the cameras and of what the renderer shows.
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

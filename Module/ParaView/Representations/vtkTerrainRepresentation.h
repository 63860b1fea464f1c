// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainRepresentation
 * @brief   draws the raster of a vtkTerrainReader with a vtkTerrainMapper
 *
 * The mapper reads the raster on the processes that render, and draws it at full resolution. The
 * mesh of the reader is not drawn. Colours, opacity, lights and transforms are those of
 * vtkGeometryRepresentationWithFaces. The view gets the bounds of the terrain that is drawn.
 *
 * With several processes, each draws a share of the terrain that is in view. The memory limit is
 * for each of them.
 *
 * Messages of the mapper are reported by this class, in ParaView's words.
 *
 * @sa vtkTerrainReader vtkTerrainMapper
 */
#ifndef vtkTerrainRepresentation_h
#define vtkTerrainRepresentation_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkGeometryRepresentationWithFaces.h"

#include <memory> // for Internals

class vtkTerrainMapper;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkTerrainRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkTerrainRepresentation* New();
  vtkTypeMacro(vtkTerrainRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the mapper that draws. It must not be shared with other representations. Its pyramid, its
   * colour mode, its loading mode, its error and its memory limit are set by this class. nullptr is
   * an error and changes nothing. The default is a vtkTerrainMapper with its defaults.
   */
  void SetMapper(vtkTerrainMapper* mapper);
  vtkTerrainMapper* GetMapper();
  //@}

  enum ColorModes
  {
    COLORING = 0,
    HILLSHADE = 4, // the numbers of vtkTerrainMapper
    IMAGERY,
    RASTER
  };

  //@{
  /**
   * Set the colours. COLORING (0, the default): the array in Coloring, which is Height, Slope or
   * Aspect, or the colour of the representation if there is none. HILLSHADE (4), IMAGERY (5) and
   * RASTER (6): see vtkTerrainMapper::SetTerrainColorMode(). Another value is an error and changes
   * nothing.
   */
  void SetTerrainColorMode(int mode);
  vtkGetMacro(TerrainColorMode, int);
  //@}

  //@{
  /**
   * Set the largest vertical distance to the surface of full resolution, in pixels; at least 0.01,
   * default 1. A value out of range is an error and changes nothing.
   */
  void SetScreenSpaceError(double pixels);
  vtkGetMacro(ScreenSpaceError, double);
  //@}

  //@{
  /**
   * Set this distance while the view moves, in pixels; at least 0.01, default 2. A smaller one than
   * ScreenSpaceError has no effect. A value out of range is an error and changes nothing.
   */
  void SetInteractiveScreenSpaceError(double pixels);
  vtkGetMacro(InteractiveScreenSpaceError, double);
  //@}

  //@{
  /**
   * Set the memory limit of each process in bytes; at least 2^22, default 2^29. See
   * vtkTerrainMapper::SetMemoryLimit(). A value out of range is an error and changes nothing.
   */
  void SetMemoryLimit(double bytes);
  vtkGetMacro(MemoryLimit, double);
  //@}

  //@{
  /**
   * Set whether still frames wait for tiles: no (0), or yes (1, the default). Frames never wait
   * while the view moves. A frame that does not wait shows the tiles in memory.
   * If the process that reads them has the interactor of the view, the view renders again until all
   * are drawn. A value out of
   * range is an error and changes nothing.
   */
  void SetLoadingMode(int mode);
  vtkGetMacro(LoadingMode, int);
  //@}

  //@{
  /**
   * Set the translation of the terrain and the fixed point of its rotation and scale. They do not
   * include the offset of the reader, see vtkTerrainReader::SetCoordinates().
   */
  void SetPosition(double x, double y, double z) override;
  void SetOrigin(double x, double y, double z) override;
  //@}

  /// Set whether the terrain is drawn.
  void SetVisibility(bool isVisible) override;

  /// Does nothing, because there is no decimated surface.
  void SetSuppressLOD(bool suppress) override;

  /// Does nothing, because the terrain has no points and cells to select.
  void SetArrayIdNames(const char* pointArray, const char* cellArray) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkTerrainRepresentation();
  ~vtkTerrainRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkTerrainRepresentation(const vtkTerrainRepresentation&) = delete;
  void operator=(const vtkTerrainRepresentation&) = delete;

  void ApplySettings(bool isInteractive);
  void ApplyPosition();
  int FindColorMode();
  void GiveBounds(vtkInformation* inInfo);
  void RequestFrame();
  void RenderAgain(vtkObject* interactor, unsigned long event, void* timer);
  void ReportMemory();
  void ReportExaggeration();
  int RequestRender(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  int TerrainColorMode = COLORING;
  double ScreenSpaceError = 1.0;
  double InteractiveScreenSpaceError = 2.0;
  double MemoryLimit = 536870912.0;
  int LoadingMode = 1;
};

#endif

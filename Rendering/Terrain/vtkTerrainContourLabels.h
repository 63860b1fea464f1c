// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainContourLabels
 * @brief   numbers on the contour lines that vtkTerrainMapper draws
 *
 * Set the actor of the terrain, and add this prop to the renderer after it. The interval is
 * vtkTerrainMapper::SetContourInterval(). Each label is centred on a contour line, where the
 * terrain, within its error, has the height of the label. Labels are upright, have a constant size
 * in pixels, and do not overlap. Places that are hidden by the terrain or by other opaque props
 * have no label. A label stays at its place on the terrain as long as it is visible.
 *
 * Places are found in the heights that are in memory for the shading, and nothing is read. Labels
 * need the depths of opaque props, which are read back from the graphics card in each frame.
 *
 * @sa vtkTerrainMapper
 */
#ifndef vtkTerrainContourLabels_h
#define vtkTerrainContourLabels_h

#include "RelevoRenderingTerrainModule.h" // for export macro
#include "vtkProp.h"
#include "vtkSmartPointer.h" // for members

#include <memory> // for Internals
#include <string> // for the format

class vtkActor;
class vtkRenderer;
class vtkTextProperty;

class RELEVORENDERINGTERRAIN_EXPORT vtkTerrainContourLabels : public vtkProp
{
public:
  static vtkTerrainContourLabels* New();
  vtkTypeMacro(vtkTerrainContourLabels, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the actor of the terrain, whose mapper is a vtkTerrainMapper. Required.
   */
  void SetActor(vtkActor* actor);
  vtkActor* GetActor();
  //@}

  //@{
  /**
   * Set the smallest distance between the centres of labels in pixels; at least 10, default 150. A
   * value out of range is an error and changes nothing.
   */
  void SetSpacing(double pixels);
  vtkGetMacro(Spacing, double);
  //@}

  //@{
  /**
   * Set the format of the numbers, as for printf() with one double; default "%g".
   */
  vtkSetMacro(LabelFormat, std::string);
  vtkGetMacro(LabelFormat, std::string);
  //@}

  //@{
  /**
   * Set the font, its size and the colours. The default is black on a translucent white background,
   * 12 points. Labels are centred at their place.
   */
  void SetTextProperty(vtkTextProperty* property);
  vtkTextProperty* GetTextProperty();
  //@}

  //@{
  /**
   * Return the labels of the last frame: how many there are, and the height of a label and its
   * place in world coordinates. NaN for a label that does not exist.
   */
  int GetNumberOfLabels();
  double GetLabelValue(int label);
  void GetLabelPosition(int label, double position[3]);
  //@}

  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  vtkMTimeType GetMTime() override;
  void ShallowCopy(vtkProp* prop) override;

protected:
  vtkTerrainContourLabels();
  ~vtkTerrainContourLabels() override;

  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkTextProperty> TextProperty;
  double Spacing = 150.0;
  std::string LabelFormat = "%g";

private:
  vtkTerrainContourLabels(const vtkTerrainContourLabels&) = delete;
  void operator=(const vtkTerrainContourLabels&) = delete;

  void PlaceLabels(vtkRenderer* renderer);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

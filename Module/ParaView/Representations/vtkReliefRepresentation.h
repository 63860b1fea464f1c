// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefRepresentation
 * @brief   draws reliefs with a vtkReliefMapper
 *
 * The input is a relief, a vtkImageData with the arrays that vtkReliefMapper describes, or a
 * composite data set of reliefs. Several reliefs complement one another, so they are not divided
 * among ranks: the first rank draws them, and the others draw nothing. Each rank requests the whole
 * input. SetMapper() sets the mapper, which has the settings of the method.
 *
 * Errors of the mapper are reported by this class.
 *
 * @sa vtkReliefMapper
 */
#ifndef vtkReliefRepresentation_h
#define vtkReliefRepresentation_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkPVDataRepresentation.h"

#include <memory> // for Internals
#include <string> // for messages

class vtkReliefMapper;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkReliefRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkReliefRepresentation* New();
  vtkTypeMacro(vtkReliefRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the mapper that draws. It must not be shared with other representations. nullptr is an
   * error and changes nothing. The default is a vtkReliefMapper with its defaults.
   */
  void SetMapper(vtkReliefMapper* mapper);
  vtkReliefMapper* GetMapper();
  //@}

  void SetVisibility(bool visible) override;

  //@{
  /**
   * Set the position, scale, orientation (in degrees) and origin of the actor.
   */
  void SetPosition(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  //@}

  //@{
  /**
   * Set the properties of the actor, those of the lighting for vtkReliefMapper::LIT.
   */
  void SetOpacity(double value);
  void SetAmbient(double value);
  void SetDiffuse(double value);
  void SetSpecular(double value);
  void SetSpecularPower(double value);
  void SetSpecularColor(double red, double green, double blue);
  void SetPickable(int pickable);
  //@}

  //@{
  /**
   * Select the blocks of a composite data set that are drawn. By default, all are drawn.
   */
  void SetActiveAssembly(const char* name);
  void AddBlockSelector(const char* selector);
  void RemoveAllBlockSelectors();
  //@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkReliefRepresentation();
  ~vtkReliefRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkReliefRepresentation(const vtkReliefRepresentation&) = delete;
  void operator=(const vtkReliefRepresentation&) = delete;

  void RefreshPiece(vtkDataObject* input);
  void GivePiece(vtkInformation* inInfo, vtkInformation* outInfo);
  void PrepareFrame(vtkInformation* inInfo);
  void Report(bool isError, std::string message);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A source that supports pieces: an algorithm like vtkPolyDataAlgorithm, without an input.
#ifndef RelevoPieceSource_h
#define RelevoPieceSource_h

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <functional>

template <typename Base>
class RelevoPieceSource : public Base
{
public:
  static RelevoPieceSource* New() { VTK_STANDARD_NEW_BODY(RelevoPieceSource); }
  vtkTemplateTypeMacro(RelevoPieceSource, Base);

  // Fills GetOutput() with the piece that the output's information requests.
  std::function<void(vtkInformation*)> Make;

protected:
  RelevoPieceSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    output->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    this->Make(output->GetInformationObject(0));
    return 1;
  }
};

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   replaces the data sets of an input before PlainGeometry
 *
 * Private to the module.
 */
#ifndef LeafConversion_h
#define LeafConversion_h

#include "vtkSmartPointer.h"

#include <functional>

class vtkDataObject;
class vtkInformationVector;
class vtkPolyData;

namespace relevo
{
struct DataLeaf;

/// Return what replaces a data set; the data set itself, or nullptr for nothing.
using LeafConverter = std::function<vtkSmartPointer<vtkDataObject>(const DataLeaf& leaf)>;

/**
 * Call request(inputs) with converted data sets. PlainGeometry adds its own original ids to
 * polygonal data. Afterwards, the output has the ids that the converted data sets have, if any.
 */
int RequestConverted(vtkInformationVector** inputs, vtkInformationVector* outputs,
  const LeafConverter& convert, const std::function<int(vtkInformationVector**)>& request);
}

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   one data set for all blocks of a file
 */
#ifndef MergedBlocks_h
#define MergedBlocks_h

#include "vtkSmartPointer.h"

class ViewerMessages;
class vtkDataObject;
class vtkDataSet;

/// Returns the only data set, or the cells of all blocks as a vtkUnstructuredGrid. An array that
/// some blocks lack is NaN there, also if it has another number of components there or is text,
/// which is a warning. nullptr if there are no data sets.
vtkSmartPointer<vtkDataSet> MergeBlocks(vtkDataObject* data, ViewerMessages& messages);

#endif

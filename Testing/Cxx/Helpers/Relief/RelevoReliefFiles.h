// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Reads parts of relief databases for tests.
#ifndef RelevoReliefFiles_h
#define RelevoReliefFiles_h

class vtkDataObject;
class vtkImageData;

/// A block of a vtkMultiBlockDataSet, if it is an image.
vtkImageData* RelevoGetImage(vtkDataObject* blocks, unsigned int block);

#endif

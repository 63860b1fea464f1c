// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   how thick a mesh of 3D cells is
 */
#ifndef VolumeThickness_h
#define VolumeThickness_h

class vtkDataObject;

/**
 * The mean length of lines through the mesh, estimated from a sample of its cells: four times the
 * volume divided by the surface (Cauchy). Cells count as linear. 0 if no cells of the sample are
 * tetrahedra, hexahedra, wedges or pyramids.
 */
double GetMeanChord(vtkDataObject* data);

#endif

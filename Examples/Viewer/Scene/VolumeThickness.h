// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the thickness of a mesh of 3D cells
 */
#ifndef VolumeThickness_h
#define VolumeThickness_h

class vtkDataObject;

/**
 * The mean length of chords through the mesh, estimated from a sample of its cells: four times the
 * volume divided by the surface area (Cauchy). Cells are treated as linear. Returns 0 if the sample
 * has no tetrahedra, hexahedra, wedges or pyramids.
 */
double GetMeanChord(vtkDataObject* data);

#endif

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   lookup tables for terrains
 *
 * Private to the module.
 */
#ifndef TerrainTables_h
#define TerrainTables_h

class vtkLookupTable;
class vtkScalarsToColors;

namespace relevo
{
/// Set the colours of VTK's default table, or of a circle of hues for directions.
void SetHues(vtkLookupTable* table, bool isCyclic);
/// Set the colours of land on maps, from green lowlands to white summits.
void SetColorsOfLand(vtkLookupTable* table);
/// Set blues, from the deepest water to the shore.
void SetColorsOfWater(vtkLookupTable* table);
/// Set greys from black to white.
void SetGreys(vtkLookupTable* table);

/**
 * Set the colours of a table to those of `water` up to a sea level and to those of `land` above it.
 * An interval of the table starts at the sea level, except for a hundredth of its width, so that
 * rounding errors do not turn water at the sea level into land.
 */
void JoinAtSeaLevel(
  vtkScalarsToColors* water, vtkScalarsToColors* land, double seaLevel, vtkLookupTable* joined);
}

#endif

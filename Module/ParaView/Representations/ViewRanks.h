// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which processes draw a frame of a view
 *
 * Private to the module.
 */
#ifndef ViewRanks_h
#define ViewRanks_h

class vtkInformation;
class vtkPVRenderView;

namespace relevo
{
/// Return whether all ranks draw the current frame of a view. Otherwise, a single process does.
bool IsDrawnByRanks(vtkPVRenderView* view);

/// Return whether all ranks draw the frame that the view requests with REQUEST_RENDER().
bool IsDrawnByRanks(vtkPVRenderView* view, vtkInformation* inInfo);
}

#endif

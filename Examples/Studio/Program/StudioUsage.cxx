// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/StudioUsage.h"

namespace
{
const char* const Options = R"(relevo-studio FILE [options]
relevo-studio [options] -- FILE     for names that begin with a hyphen

Shows a height map, a mesh or results in a window with controls. Files and options are those of
relevo-view, except --against, --capture, --export, --flight, --height-at, --micromesh, --output,
--relief, --save-script, --save-session, --save-source, --session and --stats. Each control has the
name of its option.

Options of the studio:
  --script FILE          run the lines of a script without a display, and exit: set NAME VALUE, click
                         NAME, drag X0 Y0 X1 Y1, key NAME, wait, save FILE, quit. Empty lines and
                         lines after # are ignored
  --serve [PORT]         show the window in a browser: print its URL, and serve it to this computer
                         until Ctrl-C. The port is 0 to 65535 (default 0, any free one)
  --layout FILE          write a JSON list of the controls, their places in pixels from the upper
                         left corner and the figures of the frame, after each frame
  --report               print a JSON report on the graphics card, and exit. Without FILE
  --help                 print this text and exit
  --version              print the version of Relevo and exit

In the window:
)";

const char* const ExitCodes = R"(

Exit codes: 0 success, 1 bad input, or a line of the script failed, 2 bad usage.
)";
}

//------------------------------------------------------------------------------
std::string GetStudioUsage()
{
  return std::string(Options) + GetStudioKeys() + ExitCodes;
}

//------------------------------------------------------------------------------
std::string GetStudioKeys()
{
  return R"(  left button             rotate; a click keeps the values of a point in the panel
  middle, shift + left    pan
  right button, wheel     zoom
  r                       reset the camera
  w, s                    wireframe, surface
  c                       keep the values under the mouse in the panel
  i                       save a picture under a new name
  +, -                    volumes: raise, lower the opacity
  . ,                     volumes: raise, lower the isovalues
  <, >                    the time step before, the next one
  m, n                    move a cut through a mesh or volume forward, back
  1 to 6                  front, back, left, right, top, bottom
  d                       the distance between two points under the mouse: press it at both
  h                       these keys
  q, e                    end
  Tab                     enter the panel
  arrows                  move between controls
  Space, Enter            use a control; arrows then change a slider
  Escape                  leave a control
  Ctrl+Z, Ctrl+Y          undo, redo)";
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/ViewerUsage.h"

namespace
{
const char* const Options = R"(relevo-view FILE [options]
relevo-view [options] -- FILE     for names that begin with a hyphen

Draws a height map (GeoTIFF, SRTM .hgt, USGS DEM, PNG, OpenEXR ...) or a mesh (.vtp, .ply, .obj,
.stl, .gltf, .glb, .off, .bpt, .vtk, .vtu, .pvtu, .ex2), refined where it matters, or the inside of a
mesh of 3D cells, or a folder of reliefs: a window when there is a display, a picture with --output.

The surface:
  --surface NAME         linear (default for height maps and for cells that are not curved), pn
                         (curved PN triangles; default for smooth meshes, with creases of more than
                         30 degrees kept; for other meshes linear), phong, st (scalar-tagged
                         PN triangles, by the mesh's arrays Sharpness, Tension, Bias and
                         Direction), g1 (with tangent planes that join), procedural (fur), patch (the cells' own curved shape; default for
                         .bpt files and for .vtk, .vtu and .pvtu files with curved cells)
  --alpha A              how far phong bulges, from 0, flat, to 1 (default 1)
  --amplitude A          height of procedural's fur, in the mesh's units (default: 0.03 of its
                         diagonal)
  --frequency F          half waves of procedural's fur along a coarse edge (default 1)
  --image FILE           drape a picture over the surface. On height maps: georeferenced, also as
                         --imagery; without one, colours show the height. On meshes: PNG, JPEG,
                         TIFF or BMP
  --no-data hole|fill    leave places without data empty (default), or fill them in smoothly
  --no-data-value V      heights equal to V, a number or nan, have no data, besides those that the
                         file declares

Height maps:
  --imagery-bands R,G,B  which bands of the picture, from 1, are red, green and blue (default: as
                         the file says, else 1,2,3)
  --stretch              stretch the contrast of each band, as raw satellite images need
  --exaggeration X       factor on heights (default 1; where heights without a coordinate system
                         would be more than the width, one that makes them a fifth of it)
  --resolution N         coarse squares along the longer side (default 128)

Meshes:
  --height FILE          move the surface by a height map along its normals
  --scale S              length per unit of height (default: a relief of 0.05 of the diagonal, its
                         lowest place on the surface)
  --offset O             length added to every height (default 0 with --scale)
  --mapping sphere|plane how height map and picture lie on a mesh without texture coordinates:
                         sphere wraps them around it, from pole to pole of the up axis, mirrored on
                         its far half so that there is no seam; plane projects them along the
                         shortest side of its bounding box (default: plane where that side is less
                         than a tenth of the longest, else sphere)
  --array NAME           colour by this array, points' or cells' (default: the active scalars)
  --feature-angle DEG    keep edges sharp where faces meet at more than this angle (default 30 if
                         --surface is not given)
  --up x|y|z             the axis that points up (default y)
  --lic ARRAY            streaks along this array of 2 or 3 components, points' or cells', by line
                         integral convolution; without --array and --image coloured by length
  --lic-steps N          steps of a streak each way (default 20)
  --lic-step-size PIXELS length of a step (default 1)
  --lic-contrast off|lic|color|both
                         what to stretch to full contrast (default off)
  --lic-mode blend|multiply
                         streaks over the colours (default), or as their lightness
  --lic-intensity I      the streaks' share of a blend, 0 to 1 (default 0.8)
  --lic-phase P          how far the streaks have moved, in loops: P and P + 1 look alike (default 0)

Curved cells (--surface patch), and hair:
  --error PIXELS         how far triangles may be from the cells' shape on the screen, for
                         --metric error, and segments from hairs', 0.001 to 1e6 (default 0.5)
  --isolines N           N lines of equal value of the array of points that colours the mesh
  --patch-edges          the cells' edges, and no others
  --hair N               grow N hairs on the mesh, long as 0.05 of its diagonal

The inside of meshes (.vtk, .vtu, .pvtu, .ex2):
  --volume [ARRAY]       draw the volume by this array, points' or cells', vectors by their length
                         (default: the active scalars, or the first array); after FILE, or as
                         --volume=ARRAY
  --transfer FILE        colours and opacities, from 0 to 1, in lines `value red green blue opacity`
                         by rising values (default: the colours of meshes, over the array's range,
                         the more opaque the higher the value)
  --unit-distance L      the length in which an opacity of O lets exp(-O) of the light through
                         (default: the diagonal divided by the cube root of the number of cells)
  --isosurfaces V,...    surfaces of these values, as opaque as the transfer function says for the
                         value, without --transfer so that they are seen
  --clip X,Y,Z,NX,NY,NZ  cut away what is behind the plane through X,Y,Z with the normal NX,NY,NZ
  --blend NAME           composite (default), maximum, minimum or average (value), additive, or
                         isosurface (surfaces alone, by default of the middle of the range)
  --volume-method ray|projection
                         cast rays through the cells (default), or sort and project the cells
  --integration exact|pre|pre2d
                         the integral along rays: exact (default), or from tables that are made for
                         each transfer function, of 3 or 2 dimensions

Where two meshes meet:
  --against FILE         print where the mesh meets this one and exit; with --output both are drawn
                         as they are, red where they are cut, with the curves
  --contact-distance D   also print the least distance, and draw what is nearer than D orange, what
                         is inside a closed one violet

Reliefs, pictures with depth that are drawn in place of what they show, or FILE a folder of them:
  --relief box|sphere|view
                         capture the surface from six sides, from twelve around, or as it is seen,
                         and draw the captures
  --capture FOLDER       write the captures (default: of box) into a new folder, or in place of
                         older captures, and exit
  --relief-method NAME   automatic (default; see the page), march (rays), refinement (triangle
                         patterns moved by the depths), warp (each relief warped to the view)
  --relief-search NAME   how march finds the surface: mipmap (default; misses nothing),
                         linear-binary, linear-secant, cones

Level of detail:
  --level N              every edge at level N, 0 to 7: an edge has 2^N segments
  --max-level N          highest level of the metric (default: as fine as the height map or the
                         pixels of the picture)
  --metric NAME          what to refine: distance (default for height maps; what is near),
                         screen-edge (default for meshes; what is long on the screen), curvature,
                         silhouette, contour (outlines by normals or by faces), view-dependent
                         (curved and seen edge-on), field (where the height, or a mesh's array of
                         points, varies), region (around a place), error (default for curved
                         cells: what is not flat enough), control-net (what has a bent control
                         net). Default with --lic: where the vectors vary, and edges of more than
                         10 pixels
  --reach M              how far from the camera distance refines (default: three times the
                         diagonal)
  --pixels N             length of a segment on the screen for screen-edge (default 4) and for
                         the metric of --lic (default 10)
  --region X,Y,RADIUS    the place for region: on height maps in metres from the centre;
                         X,Y,Z,RADIUS on meshes, in their coordinates (default:
                         around the centre, or the mesh's first point)
  --method NAME          how triangles are made: arkfpi (default; adaptive refinement kernel with
                         fewer patterns and instancing), ark (adaptive refinement kernel: a draw
                         call for each face), dmr (dynamic mesh refinement: a geometry shader splits
                         triangles pass by pass), suapt (semi-uniform adaptive patch tessellation:
                         uniform patterns with snapped borders), tessellation (the graphics
                         card's), uniform (every face at the highest level)
  --per-edge             give each edge a level of its own, not the mean of its ends': fewer
                         triangles
  --segments powers|whole
                         edges of 2^level segments (default), or of any number up to 16 (default
                         for curved cells)
  --no-geomorphing       let new vertices appear at their places instead of sliding there
  --budget N             draw about N triangles: raise or lower all levels; faces out of view
                         do not count

The picture:
  --color-by level|pattern|metric
                         show these instead of the surface's own colours, with a legend
  --wireframe            draw the edges of the refined triangles
  --view AZ,EL           where the camera stands, in degrees: azimuth, clockwise from north (for
                         meshes with y up, from -z), and elevation, from -90 to 90 (default 192,38;
                         meshes 205,20); 180,90 is a map, north up
  --center X,Y[,Z]       the place in the middle of the picture: on height maps in metres from the
                         raster's centre, Z (exaggerated) by default that of the terrain, or in
                         degrees, as 86.925E,27.988N; X,Y,Z on meshes, in their coordinates
                         (default: all is in view)
  --zoom F               magnify F times, about --center or the middle, 0.001 to 1e6 (default 1)
  --light AZ,EL          where the light comes from, as --view (default 315,40; meshes 250,45);
                         weaker lights turn with it
  --no-legend            draw no legend of the colours
  --stats                print faces, triangles, draw calls, graphics memory and times
  --size WxH             size of the picture or the window, in pixels (default 1280x800)
  --output FILE.png      write a picture and exit; needs no display
  --export FILE          write the displaced refined mesh (.vtp, .ply, .stl, .obj) and exit: height
                         maps in metres, x east, y north, z up, in .vtp with Origin and CoordinateSystem
                         as field data and Height in the raster's unit as point data; meshes in
                         their own coordinates
  --help                 print this text and exit
  --version              print the version of Relevo and exit

In the window:
)";

const char* const ExitCodes = R"(
Exit codes: 0 success, 1 bad input, 2 bad usage.
)";
}

//------------------------------------------------------------------------------
std::string GetUsage()
{
  return std::string(Options) + GetWindowUsage() + "\n" + ExitCodes;
}

//------------------------------------------------------------------------------
const char* GetWindowUsage()
{
  return R"(  left button             rotate
  middle, shift + left    move
  right button, wheel     zoom
  r                       show everything
  w, s                    edges, surface
  c                       print what is under the mouse
  i                       save a picture, under a new name
  +, -                    volumes: more, less opaque
  . ,                     volumes: isosurfaces of higher, lower values
  m, n                    volumes: move the cut on, back
  h                       this help
  q, e                    quit)";
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/ViewerUsage.h"

namespace
{
const char* const Options = R"(relevo-view FILE [options]
relevo-view [options] -- FILE     for names that begin with a hyphen
relevo-view --session FILE.json [options]

Draws a height map (GeoTIFF, SRTM .hgt, USGS DEM, PNG, OpenEXR ...), a surface mesh (.ply, .stl, .obj,
.gltf, .glb, .off, .bpt, .rmm, .vtp ...), results on a mesh of cells (.vtu, .vts, .vti, .vtm, .pvd, .vtk,
Exodus, EnSight, OpenFOAM, CGNS ...), the inside of such a mesh, or a folder of reliefs. The program
opens a window, or writes a picture with --output.

The surface:
  --surface NAME         the surface that refined points lie on: linear (default for height maps and
                         for cells that are not curved), pn (curved PN triangles; default for smooth
                         meshes, with creases of more than 30 degrees), phong, st (scalar-tagged PN
                         triangles, with the arrays Sharpness, Tension, Bias and Direction), g1
                         (continuous tangent planes), procedural (fur), patch (the shape of curved
                         cells; default for .bpt files, and for meshes with curved cells)
  --alpha A              strength of the bulge of phong, 0 to 1 (default 1)
  --amplitude A          height of the fur of procedural, in the mesh's units (default: 0.03 of its
                         diagonal)
  --frequency F          half waves of the fur along a coarse edge (default 1)
  --image FILE           drape a picture over the surface: on height maps a georeferenced raster
                         (also --imagery), on meshes PNG, JPEG, TIFF or BMP (default for height
                         maps: colours by height)
  --no-data hole|fill    draw holes where heights are missing (default), or fill them smoothly
  --no-data-value V      heights equal to V, a number or nan, are missing too

Height maps:
  --imagery-bands R,G,B  bands for red, green and blue, counted from 1 (default: as the file
                         declares, otherwise 1,2,3)
  --stretch              stretch the contrast of each band, for raw satellite images
  --exaggeration X       factor for heights (default 1; for rasters without a coordinate system that
                         would be higher than wide, a factor that makes them a fifth as high)
  --base H               draw or export a solid with walls and a bottom at the height H, for example
                         for a 3D print
  --contours N           draw contour lines every N units of the heights
  --contour-labels       label the contour lines with their heights
  --sea-level H          colour heights up to H as water, and those above as land. Not with --image
  --memory MIB           largest memory of heights, pictures and textures, 16 to 1048576 (default 512).
                         Terrain beyond it has a larger error
  --globe                place the height map on its ellipsoid, in metres from the centre of the earth.
                         --center is in degrees, and --view is relative to north there (default
                         180,60)
  --flight FILE.csv      draw a picture for each line `longitude,latitude,height,heading,pitch` below
                         this header: degrees, metres, degrees clockwise from north, degrees upwards.
                         Requires --output 'frames/%04d.png', which numbers them from 0. Not with
                         --center, --stats, --view or --zoom
  --resolution N         coarse squares along the longer side, 1 to 4096 (default 128)
  Height maps are drawn from tiles, which are read when the view needs them. Of a raster without a
  current index, the program builds one first, FILE.relevo-index. With these options, the whole file
  is read and a coarse mesh is refined: --imagery-bands, --stretch, --no-data fill, --no-data-value,
  --resolution, --relief, --capture, and those of the level of detail except --error

Meshes:
  --height FILE          displace the surface along its normals by a height map
  --scale S              length per unit of height (default: the relief is 0.05 of the diagonal
                         high, with its lowest point on the surface)
  --offset O             length added to every height (default 0 with --scale)
  --mapping sphere|plane mapping of the height map or picture, for meshes without texture
                         coordinates. sphere wraps it around half of the mesh and mirrors it on the
                         other half, without a seam. plane projects it along the shortest side of
                         the bounding box (default: plane if that side is less than a tenth of the
                         longest, otherwise sphere)
  --array NAME           point or cell array to colour by (default: the active scalars), or a quantity
                         of one: 'von Mises of A', 'Tresca of A', 'principal 1 of A', 'x of A',
                         'xy of A', 'magnitude of A', 'component 0 of A'
  --log                  a logarithmic scale of the colours. Values must be above 0, or --range
  --below, --above COLOR colour of values below or above --range: a name such as white, or #rrggbb
                         (default: the first or the last colour)
  --time T               the time step nearest to T (default: the first one)
  --warp ARRAY           move the points by a point array of 3 components, such as displacements,
                         times --scale (default 1)
  --clip X,Y,Z,NX,NY,NZ  cut away everything behind the plane through X,Y,Z with the normal NX,NY,NZ.
                         A cut through 3D cells is filled, and shows their edges
  --extremes             label the largest and the smallest visible value
  --ruler X,Y,Z,X,Y,Z    show the distance between two points
  --axes                 show the directions of the axes
  --feature-angle DEG    keep edges sharp where faces meet at more than this angle (default 30
                         without --surface)
  --up x|y|z             the axis that points up (default y)
  --streamlines ARRAY    draw streamlines along a point or cell array of 3 components through the mesh,
                         in a transparent surface. Colours show its length unless --array is given
  --seeds N              number of points where streamlines begin, 1 to 100000 (default 100)
  --seed-line X,Y,Z,X,Y,Z
                         seeds are on this line (default: in the middles of cells)
  --integration-points ARRAY
                         draw spheres at the integration points of an array, coloured by its values,
                         in a transparent surface with the averages of the cells
  --lic ARRAY            draw streaks along a point or cell array of 2 or 3 components, by line
                         integral convolution. Colours show its length unless --array or --image is
                         given
  --lic-steps N          steps of a streak in each direction, 1 to 1000 (default 20)
  --lic-step-size PIXELS length of a step (default 1)
  --lic-contrast off|lic|color|both
                         stretch streaks, colours or both to the full range of lightness (default
                         off)
  --lic-mode blend|multiply
                         blend the streaks with the colours (default), or multiply them
  --lic-intensity I      weight of the streaks in a blend, 0 to 1 (default 0.8)
  --lic-phase P          phase of the animation, in loops (default 0)

Curved cells and hair (see also --error):
  --isolines N           N isolines of the point array that colours the mesh, also in a cut
  --patch-edges          draw the edges of the cells, not those of triangles
  --hair N               grow N hairs on the mesh, each about 0.05 of its diagonal long

Volumes (files that can contain 3D cells):
  --volume [ARRAY]       draw the inside, using a point or cell array, or the length of vectors
                         (default: the active scalars, otherwise the first array). Write ARRAY after
                         FILE, or --volume=ARRAY
  --transfer FILE        transfer function: lines `value red green blue opacity` with increasing
                         values, colours and opacities from 0 to 1, in a file or separated by
                         semicolons (default: the colours of meshes; opacity increases with the
                         value)
  --unit-distance L      length over which an opacity of 1 absorbs 63 % of the light (default: the
                         diagonal divided by the cube root of the number of cells)
  --isosurfaces V,...    surfaces of these values. Their opacity is that of the transfer function;
                         without --transfer, it is at least 0.6
  --blend NAME           composite (default), maximum, minimum, average, additive, or isosurface
                         (surfaces without volume; by default the middle of the range)
  --volume-method ray|projection
                         cast rays through the cells (default), or sort and project the cells
  --integration exact|pre|pre2d
                         integrate along rays exactly (default), or with tables of 3 or 2 dimensions
  --shape-tolerance X    largest error of the shape of curved cells, as a share of the diagonal,
                         1e-6 to 1 (default: 5e-4)
  --field-tolerance X    largest error of the values in curved cells, as a share of their range,
                         1e-6 to 1 (default: 4e-3)

Where meshes meet:
  --against FILE         intersect the mesh with that of FILE, print the result and exit. With
                         --output, draw both meshes and the curves; cut faces are red
  --contact-distance D   also print the smallest distance; faces nearer than D are orange, faces
                         inside a closed mesh violet

Reliefs (captured images with depth, drawn in place of the geometry):
  --relief box|sphere|view
                         capture the surface from six sides, from twelve directions or from the
                         camera, and draw the captures
  --capture FOLDER       write the captures (default: of box) into a new or empty folder, or replace
                         older captures, and exit
  --relief-method NAME   automatic (default), march (ray marching), refinement (triangle patterns
                         displaced by the depths), warp (each relief warped to the view)
  --relief-search NAME   search of --relief-method march: mipmap (default; never steps over the
                         surface), linear-binary, linear-secant, cones

Level of detail:
  --level N              the level of every edge, 0 to 7: 2^N segments
  --max-level N          highest level of the metric, 0 to 7 (default: the level that matches the
                         samples of a height map, or the pixels of the picture)
  --metric NAME          where to refine: height (distance between triangles and the height map;
                         default for height maps), distance (near the camera), screen-edge (long
                         edges on the screen; default for meshes), curvature, silhouette
                         (silhouettes by normals), contour (silhouettes by faces), view-dependent
                         (curved and seen edge-on), field (where the height or the array varies),
                         region, error (distance between triangles and curved cells; default for
                         curved cells), control-net (bends of their control nets). With --lic, the
                         default refines where vectors vary, and edges longer than --pixels
  --error PIXELS         largest distance on the screen between triangles and the height map (default
                         1) or curved cells, and between segments and hairs (default 0.5), 0.001 to
                         1e6. --max-level limits the triangles
  --reach M              distance from the camera up to which distance refines (default: three times
                         the diagonal)
  --pixels N             length of a segment on the screen, for screen-edge (default 4) and --lic
                         (default 10)
  --region X,Y,RADIUS    circle that region refines, in metres from the terrain's centre; for meshes
                         a sphere X,Y,Z,RADIUS in their coordinates (default: around the centre, or
                         the mesh's first point)
  --method NAME          how triangles are generated: arkfpi (default; fixed patterns, instanced),
                         ark (a draw call for each face), dmr (a geometry shader splits triangles in
                         passes), suapt (uniform patterns with snapped borders), tessellation
                         (tessellation shaders), uniform (every face at the highest level)
  --per-edge             choose the level of each edge separately, not as the mean of its end points
  --segments powers|whole
                         divide edges into 2^level segments (default), or into whole numbers: 1 to
                         16, then larger steps up to 128 (default for curved cells)
  --no-geomorphing       new vertices appear at once, without sliding into place
  --budget N             shift all levels so that about N triangles are drawn. Faces out of view do
                         not count

The picture:
  --color-by level|pattern|metric
                         colour by these, with a legend
  --color-by height|slope|aspect|hillshade
                         of a height map: its heights (default without --image), slopes in degrees,
                         directions in which it falls, clockwise from north, or grey relief, with the
                         sun in the north-west
  --range A,B            values that the first and the last colour stand for, A less than B (default:
                         all values of the picture; of a series of pictures, of all time steps).
                         all: of all time steps
  --palette NAME         colours of arrays (default viridis), heights (default relief), slopes (default
                         heat) or aspects (default cyclic): cool-warm, cyclic, grey, heat, magma,
                         rainbow, relief, viridis, water
  --wireframe            draw the edges of the refined triangles
  --view AZ,EL           side that the camera looks from, in degrees: azimuth, clockwise from north
                         (for meshes with y up, from -z), and elevation, -90 to 90 (default 192,38;
                         meshes 205,20). 180,90 is a map with north up. front, back, left, right,
                         top and bottom are views along the axes: 180,0, 0,0, 270,0, 90,0, 180,90
                         and 180,-90
  --center X,Y[,Z]       point in the middle of the picture: in metres from a terrain's centre, with
                         Z on the terrain by default; in degrees such as 86.925E,27.988N; or X,Y,Z
                         in the coordinates of a mesh (default: the middle of the data)
  --zoom F               magnify F times about the middle of the picture, 0.001 to 1e6 (default 1)
  --light AZ,EL          side that the light comes from, as in --view (default 315,40; meshes
                         250,45). Weaker lights turn with it
  --scale-bar            show a scale, also in a picture. It is valid at the distance of the centre
  --no-legend            draw no legend of the colours
  --stats                print numbers of faces, triangles and draw calls, graphics memory and times.
                         Not with --flight
  --size WxH             size of the picture or the window, in pixels (default 1280x800)
  --output FILE.png      write a picture without a display, and exit. With a number in the name, such
                         as 'frames/%04d.png', write a picture for each time step of a mesh, or
                         each line of --flight, numbered from 0
  --serve [PORT]         show the window in a browser: print its URL, and serve it to this computer
                         until Ctrl-C. The port is 0 to 65535 (default 0, any free one)
  --session FILE.json    draw the file of a session with its options and its camera. Options of the
                         command line have priority, and FILE replaces its file
  --save-session FILE.json
                         write a session: FILE and its options, relative to the session, and the
                         camera, after the picture or when the window is closed
  --save-script FILE.py  with --output, write a Python script that draws the same picture by classes
                         of Relevo and VTK
  --save-source FOLDER   the same as a C++ source with its CMakeLists.txt
  --export FILE          write the mesh as it is drawn (.vtp, .glb, .obj, .ply, .stl) and exit.
                         Height maps are in metres, with x east, y north and z up; with --globe,
                         from the centre of the earth. A .vtp file also has the field data Origin
                         and CoordinateSystem and the point data Height. --image is the texture of
                         .glb and .obj files only. Meshes keep their coordinates
  --micromesh FILE.rmm   write a dense mesh as a coarse mesh with displacements, print sizes and
                         errors, and exit. With --output, also draw it. --isosurfaces V,V,...
                         writes isosurfaces of solid cells instead of their outer surface, of the
                         point array of --array. --feature-angle A keeps edges with larger angles
                         between normals (default 60). A FILE such as step%04d.rmm has all time
                         steps
  --tolerance T          with --export, write the whole height map as a mesh that is nowhere farther
                         than T metres above or below it. The view has no influence. With
                         --micromesh, the largest distance between both surfaces: a length in the
                         unit of the mesh, or a percentage of its diagonal (default 0.1%)
  --height-at LON,LAT    print the height at this longitude and latitude, in the unit of the raster,
                         and exit
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
  middle, shift + left    pan
  right button, wheel     zoom
  r                       reset the camera
  w, s                    wireframe, surface
  c                       print the values under the mouse
  i                       save a picture under a new name
  +, -                    volumes: raise, lower the opacity
  . ,                     volumes: raise, lower the isovalues
  <, >                    the time step before, the next one
  m, n                    move a cut through a mesh or volume forward, back
  1 to 6                  meshes and volumes: front, back, left, right, top, bottom
  d                       the distance between two points under the mouse: press it at both
  h                       this help
  q, e                    quit)";
}

// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Controls/ControlTable.h"

#include "Options/Palettes.h"

#include <set>

namespace
{
using Kind = ControlKind;

Control MakeChoice(const std::string& name, const std::string& group, const std::string& standard,
  const std::vector<std::string>& choices)
{
  Control control{ name, group, Kind::Choice, "", standard };
  control.Choices = choices;
  return control;
}

Control MakeFlag(const std::string& name, const std::string& group)
{
  return { name, group, Kind::Flag, "", "off" };
}

Control MakeText(const std::string& name, const std::string& group, const std::string& standard)
{
  return { name, group, Kind::Text, "", standard };
}

Control MakeNumber(const std::string& name, const std::string& group, const std::string& unit,
  const std::string& standard, double lowest, double highest, const std::vector<double>& start,
  bool isLogarithmic = false)
{
  Control control{ name, group, Kind::Number, unit, standard };
  control.Ranges = { { { lowest, highest } } };
  control.Start = start;
  control.IsLogarithmic = isLogarithmic;
  return control;
}

// Azimuth and elevation in degrees.
Control MakeDirection(const std::string& name, const std::string& group,
  const std::string& standard, const std::vector<double>& start)
{
  Control control = MakeNumber(name, group, "degrees", standard, 0.0, 360.0, start);
  control.Ranges = { { { 0.0, 360.0 } }, { { -90.0, 90.0 } } };
  return control;
}

Control MakeColor(const std::string& name, const std::string& group, const std::string& standard)
{
  return { name, group, Kind::Color, "", standard };
}

Control MakeInteger(const std::string& name, const std::string& group, const std::string& unit,
  const std::string& standard, int lowest, int highest, int start, bool isLogarithmic = false)
{
  Control control = MakeNumber(
    name, group, unit, standard, lowest, highest, { static_cast<double>(start) }, isLogarithmic);
  control.Kind = Kind::Integer;
  return control;
}

Control MakeButton(const std::string& name, const std::string& group)
{
  return { name, group, Kind::Button, "", "" };
}

void AddData(std::vector<Control>& table)
{
  const std::string group = "Data";
  table.push_back(MakeChoice("array", group, "the active scalars", {}));
  table.push_back({ "time", group, Kind::Step, "", "the first step" });
  for (const char* name : { "step-back", "step-forward", "play" })
  {
    table.push_back(MakeButton(name, group));
  }
  table.push_back(MakeFlag("loop", group));
  table.push_back(MakeChoice("warp", group, "none", {}));
  table.push_back(MakeNumber("scale", group, "times", "1", 0.0, 1000.0, { 1.0 }, true));
  table.push_back({ "clip", group, Kind::Plane, "coordinates", "none" });
  table.push_back(MakeFlag("extremes", group));
  table.push_back(MakeChoice("integration-points", group, "none", {}));
  table.push_back(MakeChoice("up", group, "y", { "x", "y", "z" }));
}

void AddColours(std::vector<Control>& table)
{
  const std::string group = "Colours";
  table.push_back(
    MakeNumber("range", group, "unit of the array", "all values", 0.0, 1.0, { 0.0, 1.0 }));
  table.push_back(MakeButton("range-all", group));
  table.push_back(MakeFlag("log", group));
  table.push_back(MakeColor("below", group, "the first colour"));
  table.push_back(MakeColor("above", group, "the last colour"));
  table.push_back(MakeChoice("palette", group, "viridis; of heights relief", GetPaletteNames()));
  table.push_back(MakeChoice("color-by", group, "the array or the heights",
    { "level", "pattern", "metric", "height", "slope", "aspect", "hillshade" }));
  table.push_back(MakeInteger("isolines", group, "lines", "none", 1, 100, 1, true));
  table.push_back(MakeFlag("patch-edges", group));
  table.push_back(MakeFlag("wireframe", group));
  table.push_back(MakeFlag("no-legend", group));
}

void AddSurface(std::vector<Control>& table)
{
  const std::string group = "Surface";
  table.push_back(MakeChoice("surface", group, "chosen for the file",
    { "linear", "pn", "phong", "st", "procedural", "g1", "patch" }));
  table.push_back(MakeNumber("alpha", group, "", "1", 0.0, 1.0, { 1.0 }));
  table.push_back(
    MakeNumber("amplitude", group, "length", "0.03 of the diagonal", 0.0, 1.0, { 0.0 }));
  table.push_back(MakeNumber("frequency", group, "half waves", "1", 0.0, 50.0, { 1.0 }));
  table.push_back(
    MakeNumber("feature-angle", group, "degrees", "30 without --surface", 0.0, 180.0, { 30.0 }));
  table.push_back(MakeText("height", group, "no height map"));
  table.push_back(MakeNumber("offset", group, "length", "0 with --scale", -1.0, 1.0, { 0.0 }));
  table.push_back(MakeChoice("mapping", group, "by the shape", { "sphere", "plane" }));
  table.push_back(MakeText("image", group, "none"));
  table.push_back(MakeChoice("no-data", group, "hole", { "hole", "fill" }));
  table.push_back(MakeText("no-data-value", group, "that of the file"));
  table.push_back(MakeInteger("hair", group, "hairs", "none", 1, 100000, 1000, true));
}

void AddDetail(std::vector<Control>& table)
{
  const std::string group = "Level of detail";
  table.push_back(MakeChoice("metric", group, "height; for meshes screen-edge or error",
    { "distance", "screen-edge", "curvature", "silhouette", "contour", "view-dependent", "field",
      "region", "error", "control-net", "height" }));
  table.push_back(
    MakeNumber("error", group, "pixels", "1; of curved cells 0.5", 0.01, 100.0, { 1.0 }, true));
  table.push_back(MakeNumber("pixels", group, "pixels", "4", 1.0, 200.0, { 4.0 }, true));
  table.push_back(
    MakeNumber("reach", group, "length", "three times the diagonal", 0.01, 1e6, { 1.0 }, true));
  table.push_back(MakeInteger("max-level", group, "", "for the picture", 0, 7, 7));
  table.push_back(MakeInteger("level", group, "", "by the metric", 0, 7, 0));
  table.push_back(MakeChoice(
    "method", group, "arkfpi", { "arkfpi", "ark", "dmr", "suapt", "tessellation", "uniform" }));
  table.push_back(MakeChoice("segments", group, "powers", { "powers", "whole" }));
  table.push_back(MakeFlag("per-edge", group));
  table.push_back(MakeFlag("no-geomorphing", group));
  table.push_back(MakeText("region", group, "around the middle"));
  table.push_back(
    MakeInteger("budget", group, "triangles", "no limit", 1000, 100000000, 1000000, true));
}

void AddStreaks(std::vector<Control>& table)
{
  const std::string group = "Streaks";
  table.push_back(MakeChoice("lic", group, "none", {}));
  table.push_back(MakeInteger("lic-steps", group, "steps", "20", 1, 200, 20));
  table.push_back(MakeNumber("lic-step-size", group, "pixels", "1", 0.1, 5.0, { 1.0 }));
  table.push_back(MakeChoice("lic-contrast", group, "off", { "off", "lic", "color", "both" }));
  table.push_back(MakeChoice("lic-mode", group, "blend", { "blend", "multiply" }));
  table.push_back(MakeNumber("lic-intensity", group, "", "0.8", 0.0, 1.0, { 0.8 }));
  table.push_back(MakeNumber("lic-phase", group, "loops", "0", 0.0, 1.0, { 0.0 }));
}

void AddStreamlines(std::vector<Control>& table)
{
  const std::string group = "Streamlines";
  table.push_back(MakeChoice("streamlines", group, "none", {}));
  table.push_back(MakeInteger("seeds", group, "points", "100", 1, 10000, 100, true));
  table.push_back(MakeText("seed-line", group, "in the middles of cells"));
}

void AddVolume(std::vector<Control>& table)
{
  const std::string group = "Volume";
  table.push_back(MakeChoice("volume", group, "the surface", {}));
  table.push_back({ "transfer", group, Kind::Transfer, "", "by the values" });
  table.push_back(MakeNumber("unit-distance", group, "length",
    "the diagonal by the cube root of the number of cells", 1e-3, 1.0, { 1.0 }, true));
  table.push_back(MakeNumber("isosurfaces", group, "unit of the array", "none", 0.0, 1.0, { 0.0 }));
  table.push_back(MakeChoice("blend", group, "composite",
    { "composite", "maximum", "minimum", "average", "additive", "isosurface" }));
  table.push_back(MakeChoice("volume-method", group, "ray", { "ray", "projection" }));
  table.push_back(MakeChoice("integration", group, "exact", { "exact", "pre", "pre2d" }));
  table.push_back(MakeNumber(
    "shape-tolerance", group, "share of the diagonal", "5e-4", 1e-6, 1.0, { 5e-4 }, true));
  table.push_back(
    MakeNumber("field-tolerance", group, "share of the range", "4e-3", 1e-6, 1.0, { 4e-3 }, true));
}

void AddTerrain(std::vector<Control>& table)
{
  const std::string group = "Terrain";
  table.push_back(MakeNumber("exaggeration", group, "times", "1", 0.1, 20.0, { 1.0 }, true));
  table.push_back(
    MakeNumber("contours", group, "unit of the heights", "none", 1.0, 1000.0, { 100.0 }, true));
  table.push_back(MakeFlag("contour-labels", group));
  table.push_back(
    MakeNumber("sea-level", group, "unit of the heights", "none", -500.0, 5000.0, { 0.0 }));
  table.push_back(
    MakeNumber("base", group, "unit of the heights", "none", -500.0, 5000.0, { 0.0 }));
  table.push_back(MakeText("imagery-bands", group, "those of the file"));
  table.push_back(MakeFlag("stretch", group));
  table.push_back(MakeFlag("globe", group));
  table.push_back(MakeInteger("resolution", group, "squares", "128", 1, 4096, 128, true));
  table.push_back(MakeInteger("memory", group, "MiB", "512", 16, 16384, 512, true));
}

void AddReliefs(std::vector<Control>& table)
{
  const std::string group = "Reliefs";
  table.push_back(MakeChoice(
    "relief-method", group, "automatic", { "automatic", "march", "refinement", "warp" }));
  table.push_back(MakeChoice(
    "relief-search", group, "mipmap", { "mipmap", "linear-binary", "linear-secant", "cones" }));
}

void AddMeasuring(std::vector<Control>& table)
{
  const std::string group = "Measure";
  table.push_back(MakeText("ruler", group, "none"));
  table.push_back(MakeButton("measure", group));
  table.push_back(MakeButton("forget-probe", group));
  table.push_back(MakeFlag("axes", group));
  table.push_back(MakeFlag("scale-bar", group));
}

void AddView(std::vector<Control>& table)
{
  const std::string group = "Light and camera";
  table.push_back(MakeDirection("light", group, "315,40; of meshes 250,45", { 315.0, 40.0 }));
  table.push_back(MakeDirection("view", group, "192,38; of meshes 205,20", { 192.0, 38.0 }));
  table.push_back(MakeText("center", group, "the middle of the data"));
  table.push_back(MakeNumber("zoom", group, "times", "1", 0.1, 100.0, { 1.0 }, true));
  for (const char* name : { "view-front", "view-back", "view-left", "view-right", "view-top",
         "view-bottom", "reset-view", "keys" })
  {
    table.push_back(MakeButton(name, group));
  }
}

void AddComparison(std::vector<Control>& table)
{
  const std::string group = "Compare";
  table.push_back(MakeChoice("compare-method", group, "no second view",
    { "arkfpi", "ark", "dmr", "suapt", "tessellation", "uniform" }));
  table.push_back(MakeText("compare-options", group, "none"));
  table.push_back(MakeFlag("show-difference", group));
  table.push_back(MakeNumber("difference-gain", group, "times", "4", 1.0, 100.0, { 4.0 }, true));
}

void AddPattern(std::vector<Control>& table)
{
  const std::string group = "Pattern generator";
  Control levels = MakeInteger("pattern-levels", group, "levels of the edges", "3,2,0", 0, 7, 0);
  levels.Start = { 3.0, 2.0, 0.0 };
  table.push_back(levels);
  table.push_back(MakeText("pattern-name", group, "pattern.vtp"));
  table.push_back(MakeButton("save-pattern", group));
  table.push_back(MakeText("table-name", group, "patterns.vtp"));
  table.push_back(MakeButton("save-table", group));
}

void AddFiles(std::vector<Control>& table)
{
  const std::string group = "Save";
  table.push_back(MakeText("picture-name", group, "studio.png"));
  table.push_back(MakeButton("save-picture", group));
  table.push_back(MakeText("mesh-name", group, "studio.vtp"));
  table.push_back(MakeButton("save-mesh", group));
  table.push_back(MakeText("session-name", group, "studio.json"));
  table.push_back(MakeButton("save-session", group));
  table.push_back(MakeButton("open-session", group));
  table.push_back(MakeText("script-name", group, "studio.py"));
  table.push_back(MakeButton("save-script", group));
  table.push_back(MakeText("source-name", group, "studio-source/"));
  table.push_back(MakeButton("save-source", group));
  table.push_back(MakeFlag("panels-in-pictures", group));
}
}

//------------------------------------------------------------------------------
std::vector<Control> GetControlTable()
{
  std::vector<Control> table = { MakeButton("undo", ""), MakeButton("redo", "") };
  AddData(table);
  AddColours(table);
  AddSurface(table);
  AddDetail(table);
  AddStreamlines(table);
  AddStreaks(table);
  AddVolume(table);
  AddTerrain(table);
  AddReliefs(table);
  AddMeasuring(table);
  AddView(table);
  AddComparison(table);
  AddPattern(table);
  AddFiles(table);
  // Their defaults are no numbers, or depend on the file.
  const std::set<std::string> others = { "base", "budget", "contours", "error", "exaggeration",
    "feature-angle", "hair", "isolines", "isosurfaces", "level", "light", "max-level", "offset",
    "reach", "sea-level", "view" };
  for (Control& control : table)
  {
    control.IsStartShown = others.count(control.Name) == 0;
    control.IsIncreasing = control.Name == "range";
  }
  return table;
}

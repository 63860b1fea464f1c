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
  control.Lowest = lowest;
  control.Highest = highest;
  control.Start = start;
  control.IsLogarithmic = isLogarithmic;
  return control;
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
  table.push_back(MakeChoice("up", group, "y", { "x", "y", "z" }));
}

void AddColours(std::vector<Control>& table)
{
  const std::string group = "Colours";
  table.push_back(
    MakeNumber("range", group, "unit of the array", "all values", 0.0, 1.0, { 0.0, 1.0 }));
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
  table.push_back(MakeFlag("globe", group));
}

void AddView(std::vector<Control>& table)
{
  const std::string group = "Light and camera";
  table.push_back(MakeNumber(
    "light", group, "degrees", "315,40; of meshes 250,45", -90.0, 360.0, { 315.0, 40.0 }));
  table.push_back(MakeNumber(
    "view", group, "degrees", "192,38; of meshes 205,20", -90.0, 360.0, { 192.0, 38.0 }));
  table.push_back(MakeNumber("zoom", group, "times", "1", 0.1, 100.0, { 1.0 }, true));
  for (const char* name : { "view-top", "view-bottom", "view-north", "view-east", "view-south",
         "view-west", "reset-view" })
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
  AddStreaks(table);
  AddVolume(table);
  AddTerrain(table);
  AddView(table);
  AddComparison(table);
  AddPattern(table);
  AddFiles(table);
  // Their defaults are no numbers, or depend on the file.
  const std::set<std::string> others = { "budget", "contours", "error", "exaggeration",
    "feature-angle", "isolines", "isosurfaces", "level", "light", "max-level", "offset", "reach",
    "sea-level", "view" };
  for (Control& control : table)
  {
    control.IsStartShown = others.count(control.Name) == 0;
  }
  return table;
}

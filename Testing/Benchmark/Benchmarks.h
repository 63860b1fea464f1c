// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what can be measured; each adds its tables to the report
 */
#ifndef Benchmarks_h
#define Benchmarks_h

#include <functional>
#include <string>
#include <vector>

class BenchmarkTable;

struct BenchmarkOptions
{
  bool Quick = false;    // sizes that only show that everything runs
  bool Full = false;     // sizes and repetitions that take long without a graphics card
  std::string HeightMap; // a raster file for the terrain; empty to make one
  std::string ParaView;  // a folder with ParaView, by ParaView/fetch.sh; may be empty
  std::string ProgramFolder;
};

using AddTable = std::function<void(const BenchmarkTable&)>;

/// Frames of the mapper against the same triangles as a static mesh.
void RunStaticMesh(const BenchmarkOptions& options, const AddTable& addTable);
/// Levels per coarse face, as the camera moves.
void RunSelection(const BenchmarkOptions& options, const AddTable& addTable);
/// VTK's pickers on the refined surface.
void RunPicking(const BenchmarkOptions& options, const AddTable& addTable);
/// The CPU's own work: patterns, selection, the refinement filter.
void RunProcessor(const BenchmarkOptions& options, const AddTable& addTable);
/// A budget of triangles over a flight.
void RunFlight(const BenchmarkOptions& options, const AddTable& addTable);
/// Rules for levels, at the same error on the screen.
void RunRules(const BenchmarkOptions& options, const AddTable& addTable);
/// Frames with and without geomorphing and culling.
void RunDrawing(const BenchmarkOptions& options, const AddTable& addTable);
/// The mapper's methods against each other.
void RunMethods(const BenchmarkOptions& options, const AddTable& addTable);
/// Phong tessellation against PN triangles.
void RunPhong(const BenchmarkOptions& options, const AddTable& addTable);
/// Surfaces against what their coarse mesh was made from, and RunPatterns().
void RunQuality(const BenchmarkOptions& options, const AddTable& addTable);
/// Shapes of triangles where levels differ.
void RunPatterns(const BenchmarkOptions& options, const AddTable& addTable);
/// Resident memory of the mapper and of a static mesh.
void RunMemory(const BenchmarkOptions& options, const AddTable& addTable);
/// A raster as terrain, against VTK's own way to draw it.
void RunTerrain(const BenchmarkOptions& options, const AddTable& addTable);
/// Line integral convolution against VTK's own.
void RunLIC(const BenchmarkOptions& options, const AddTable& addTable);
/// Volumes of cells against VTK's mappers and sort, and pictures against a reference.
void RunVolumes(const BenchmarkOptions& options, const AddTable& addTable);
/// Reliefs against the meshes that they show and meshes of their pixels, and warps a second.
void RunReliefs(const BenchmarkOptions& options, const AddTable& addTable);
/// Curved cells and hair against VTK's even cuts.
void RunPatches(const BenchmarkOptions& options, const AddTable& addTable);
/// Where surfaces meet, against exact whole numbers and VTK's filters, and in moving scenes.
void RunIntersections(const BenchmarkOptions& options, const AddTable& addTable);

/**
 * Measurements that need a process of their own run in this program, called again: the arguments
 * name the measurement, the result is a list of numbers.
 */
std::vector<double> RunInOwnProcess(const std::vector<std::string>& arguments);
std::vector<double> MeasureMemory(const std::vector<std::string>& arguments);
std::vector<double> MeasureTerrain(const std::vector<std::string>& arguments);
std::vector<double> MeasureVolumes(const std::vector<std::string>& arguments);
std::vector<double> MeasureReliefs(const std::vector<std::string>& arguments);
std::vector<double> MeasurePatches(const std::vector<std::string>& arguments);
std::vector<double> MeasureIntersections(const std::vector<std::string>& arguments);

#endif

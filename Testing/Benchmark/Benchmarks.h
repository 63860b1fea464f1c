// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the benchmarks, each of which adds its tables to the report
 */
#ifndef Benchmarks_h
#define Benchmarks_h

#include <functional>
#include <string>
#include <vector>

class BenchmarkTable;

struct BenchmarkOptions
{
  bool Quick = false;    // small sizes that only show that everything runs
  bool Full = false;     // sizes and repetitions for graphics cards
  std::string HeightMap; // a raster file for the terrain; empty to create one
  std::string ParaView;  // a folder filled by ParaView/fetch.sh; may be empty
  std::string ProgramFolder;
};

using AddTable = std::function<void(const BenchmarkTable&)>;

/// Compares frames of the mapper with the same triangles as a static mesh.
void RunStaticMesh(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures the selection of levels per coarse face while the camera moves.
void RunSelection(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures VTK's pickers on the refined surface.
void RunPicking(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures steps on the CPU: patterns, selection, the refinement filter.
void RunProcessor(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures a triangle budget during a flight.
void RunFlight(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares level rules at the same error on the screen.
void RunRules(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares frames with and without geomorphing and culling.
void RunDrawing(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares the mapper's methods.
void RunMethods(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares Phong tessellation with PN triangles.
void RunPhong(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares surfaces with the originals of their coarse meshes. Includes RunPatterns().
void RunQuality(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures shapes of triangles between different levels.
void RunPatterns(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares resident memory of the mapper and of a static mesh.
void RunMemory(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares a raster as terrain with VTK's classes.
void RunTerrain(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures terrains of any size: frames, triangles, errors, memory and times of files.
void RunTerrains(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares line integral convolution with VTK's.
void RunLIC(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares volumes of cells with VTK's mappers and sort, and pictures with a reference.
void RunVolumes(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures frames of cells with points and values of their own, and of cells next to smaller ones.
void RunVolumeNeighbors(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures isosurfaces alone, functions that are mostly transparent, and new isovalues.
void RunVolumeSkipping(const BenchmarkOptions& options, const AddTable& addTable);
/// Measures time steps, depth peeling, dragging and the memory of volumes.
void RunVolumeTasks(const BenchmarkOptions& options, const AddTable& addTable);
/// Frames of volumes with a tenth of the cells, and their likeness to full ones.
void RunVolumeDetail(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares volumes of cubic Lagrange hexahedra with VTK's way: tetrahedra between the nodes.
void RunVolumeCurved(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares the processor time of the volume filter and of the mapper.
void RunVolumeTwin(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares micro-meshes with their dense meshes and with VTK's decimation.
void RunMicroMeshes(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares frames of micro-meshes with their dense meshes and VTK's actors with levels of detail.
void RunMicroMeshFrames(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares reliefs with the captured meshes and with meshes of their pixels. Measures warps per
/// second.
void RunReliefs(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares curved cells and hair with VTK's uniform subdivision.
void RunPatches(const BenchmarkOptions& options, const AddTable& addTable);
/// Compares surface intersection with exact integer arithmetic and VTK's filters, and measures
/// moving scenes.
void RunIntersections(const BenchmarkOptions& options, const AddTable& addTable);

/**
 * Measurements that need a separate process run in this program, which is started again: the
 * arguments name the measurement, and the result is a list of numbers.
 */
std::vector<double> RunInOwnProcess(const std::vector<std::string>& arguments);
std::vector<double> MeasureMemory(const std::vector<std::string>& arguments);
std::vector<double> MeasureTerrain(const std::vector<std::string>& arguments);
std::vector<double> MeasureTerrains(const std::vector<std::string>& arguments);
std::vector<double> MeasureVolumes(const std::vector<std::string>& arguments);
std::vector<double> MeasureMicroMeshes(const std::vector<std::string>& arguments);
std::vector<double> MeasureReliefs(const std::vector<std::string>& arguments);
std::vector<double> MeasurePatches(const std::vector<std::string>& arguments);
std::vector<double> MeasureIntersections(const std::vector<std::string>& arguments);

#endif

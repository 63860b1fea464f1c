# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that the benchmark runs with tiny sizes and writes complete, valid JSON. Its speed is not
tested."""
import json
import os
import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv.pop(1)).resolve()


class TestBenchmark(unittest.TestCase):
    def run_benchmark(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "benchmark.json"
            result = subprocess.run([PROGRAM, "--quick", "--output", output, *arguments],
                                    cwd=folder, capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertNotIn("ERR|", result.stderr)
            left = [path.name for path in Path(folder).iterdir()]
            self.assertEqual(left, ["benchmark.json"])
            return result.stdout, json.loads(output.read_text(encoding="utf-8"))

    def run_with_error(self, code, *arguments, **settings):
        """The single line of the program's error."""
        result = subprocess.run([PROGRAM, "--quick", *arguments], capture_output=True, text=True,
                                **settings)
        self.assertEqual(result.returncode, code, result.stderr)
        errors = result.stderr.splitlines()
        self.assertRegex(errors[0], r"\Arelevo-benchmark: error: [^\x00-\x1f]+\Z")
        if code == 1:
            self.assertEqual(len(errors), 1)
        return errors[0]

    def test_bad_arguments(self):
        """The error names the argument with escaped control characters."""
        self.assertIn(r"'\x1b[2J\n'", self.run_with_error(2, "\x1b[2J\n"))
        self.assertIn("'--output'", self.run_with_error(2, "--output"))
        self.assertIn("'--quick'", self.run_with_error(2, "--", "rules", "--quick"))
        self.assertIn(r"a\x1b.tif", self.run_with_error(1, "--height-map", "a\x1b.tif"))
        self.assertIn(r"/no\nfolder/a.json: the folder ",
                      self.run_with_error(1, "--output", "/no\nfolder/a.json"))

    def test_full_disk(self):
        """A failure keeps the previous report."""
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "a.json"
            output.write_text("old")
            error = self.run_with_error(
                1, "--output", output, "--", "rules",
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (64, 64)))
            self.assertIn(f"cannot write {output}: {os.strerror(27)}", error)
            self.assertEqual([path.name for path in Path(folder).iterdir()], ["a.json"])
            self.assertEqual(output.read_text(), "old")

    def test_everything(self):
        markdown, report = self.run_benchmark()
        self.assertRegex(report["facts"]["OpenGL renderer"], ", OpenGL .*, (hardware|software)$")
        tables = {table["name"]: table["rows"] for table in report["tables"]}
        for name in ("static-mesh-frames", "static-mesh-memory", "selection", "picking", "flight",
                     "drawing",
                     "methods", "methods-small", "methods-work", "phong",
                     "quality-surfaces", "quality-patterns", "rules", "memory", "dem",
                     "lic-frames", "lic-pictures"):
            self.assertTrue(tables[name], name)
        for table in report["tables"]:
            self.assertIn("## " + table["title"], markdown)
            for row in table["rows"]:
                # Some rules have smaller errors than the reference.
                values = [value for key, value in row.items() if not key.startswith("ratio_")]
                self.assertNotIn(None, values, table["name"])
        self.check_methods(tables)
        self.check_quality(tables)
        frames = tables["static-mesh-frames"][0]
        self.assertGreater(frames["drawn_triangles"], frames["coarse_faces"])
        self.assertLessEqual(frames["draw_calls"], 2 * frames["used_patterns"])
        self.assertLess(frames["picture_difference"], 0.1)
        self.check_lic(tables)
        usage = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True).stderr
        if "volumes" in usage:  # with VTK's mappers for volumes
            self.check_volumes(tables)
        if "relief" in usage:
            self.check_reliefs(tables)
            self.check_warps(tables)
        if "micromesh" in usage:
            self.check_micro_meshes(tables)
        if " terrain" in usage:
            self.check_terrains(tables)
        if "patches" in usage:
            self.check_patches(tables)
        if "intersections" in usage:
            self.check_intersections(tables)
        self.assertEqual(len(tables["dem"]), 3)
        self.assertTrue(all(row["triangles"] > 0 for row in tables["dem"]))

    def check_methods(self, tables):
        self.assertEqual({row["mesh"] for row in tables["methods"]},
                         {"sphere2", "jet", "pacman2"})
        for row, work in zip(tables["methods"], tables["methods-work"]):
            self.assertEqual(row["selections"], 0)
            self.assertLess(abs(row["triangles"] / row["published_triangles"] - 1.0), 0.02)
            self.assertEqual(work["arkfpi_triangles"], row["triangles"])
            self.assertEqual(work["ark_draw_calls"], row["faces"])
            self.assertLess(work["arkfpi_draw_calls"], work["ark_draw_calls"])

    def check_quality(self, tables):
        rows = {(row["mesh"], row["surface"]): row for row in tables["quality-surfaces"]}
        for mesh in ("sphere", "torus"):
            for surface in ("Phong", "PN", "G1"):
                self.assertEqual(rows[mesh, "linear"]["triangles"],
                                 rows[mesh, surface]["triangles"])
                for key in ("hausdorff_percent", "facet_rms", "jump_mean"):
                    self.assertLess(rows[mesh, surface][key], rows[mesh, "linear"][key],
                                    (mesh, surface, key))
            self.assertLess(rows[mesh, "G1"]["jump_largest"], rows[mesh, "PN"]["jump_largest"])
        for row in tables["quality-patterns"]:
            is_snapped = row["method"] == "SUAPT" and row["difference"] > 0
            self.assertEqual(row["degenerate_percent"] > 0.0, is_snapped)

    def check_lic(self, tables):
        self.assertNotIn("lic-vtk", tables)
        for row in tables["lic-pictures"]:
            self.assertEqual(row["by"], "Relevo")
            self.assertLess(row["angle_median"], 5.0, row)

    def check_volumes(self, tables):
        for name in ("volumes", "volumes-memory", "volumes-neighbors", "volumes-pictures",
                     "volumes-published", "volumes-skipping", "volumes-tasks"):
            self.assertTrue(tables[name], name)
        errors = {row["picture"]: row for row in tables["volumes-pictures"]}
        for picture, most in (("ray casting, exact", 1.0), ("ray casting, exact, over white", 2.0),
                              ("cell projection with its sort", 1.0),
                              ("hexahedra unsplit, against vtkVolumeRayCastFilter", 1.0)):
            self.assertLess(errors[picture]["largest"], most, picture)
        for row in tables["volumes"]:
            self.assertGreater(row["ratio"], 0.0, row)
        for row in tables["volumes-memory"]:
            self.assertLess(row["ratio"], row["asked"])

    def check_micro_meshes(self, tables):
        for row in tables["micromesh"]:
            self.assertLessEqual(row["bound"], 1.0, row)
            self.assertLessEqual(row["distance"], 1.001, row)
            self.assertLess(row["packed_ratio"], row["file_ratio"], row)
        self.assertEqual({row["way"] for row in tables["micromesh-frames"]},
                         {"dense mesh", "micro-mesh", "vtkLODActor", "vtkQuadricLODActor"})

    def check_reliefs(self, tables):
        for row in tables["relief"]:
            self.assertGreater(row["memory_mb"], 0.0)
        for row in tables["relief-pictures"]:
            if row["way"] != "pre-warp":
                self.assertGreater(row["ssim"], row["ssim_pixel_mesh"] - 0.01, row)
        for row in tables["relief-accuracy"]:
            if row["way"] in ("automatic", "rays, maximum mipmap"):
                self.assertGreater(row["right_percent"], 99.0, row)
        for row in tables["relief-warp-frames"]:
            self.assertGreater(row["frames"], 0.0)

    def check_warps(self, tables):
        policies = {"sequential", "parallel", "multi-threaded", "rows and columns"}
        for sample in ("terrain with a void", "columns before a wall", "object"):
            rows = [row for row in tables["relief-warps"] if row["sample"] == sample]
            self.assertEqual({row["policy"] for row in rows}, policies)
            self.assertTrue(all(row["warps"] > 0.0 for row in rows))

    def check_terrains(self, tables):
        self.assertEqual({row["view"] for row in tables["terrain-frames"]},
                         {"oblique, all", "from above, all", "oblique, near"})
        for row in tables["terrain-frames"] + tables["terrain-grid"]:
            self.assertLess(row["error"], 1.02, row)
        for row in tables["terrain-triangles"]:
            self.assertLess(row["error_a"], 1.001 * row["asked"], row)
        self.assertEqual([row["asked"] for row in tables["terrain-cameras"]], [0.5, 1.0, 2.0])
        for row in tables["terrain-cameras"]:
            self.assertEqual(row["too_large"], 0, row)
            self.assertGreater(row["triangles"], 0)
        # The lighting of samples and of triangles differs in near views.
        for row in tables["terrain-warp"]:
            self.assertGreater(row["ssim"], 0.9, row)
        for row in tables["terrain-index"]:
            self.assertGreater(row["seconds"], 0.0)
        self.assertEqual({row["delay_ms"] for row in tables["terrain-flight"]}, {0, 20})
        for row in tables["terrain-flight"]:
            self.assertGreater(row["triangles"], 0)
        self.assertIn("terrain-writer", tables)  # empty without gdal_translate

    def check_patches(self, tables):
        for row in tables["patches-triangles"]:
            self.assertLessEqual(row["error"], 0.5)
            self.assertLessEqual(row["vtk_error"], 0.5)
            self.assertLessEqual(row["triangles_unculled"], row["triangles"])
        whole, part = tables["patches-triangles"][:2]
        self.assertEqual(whole["triangles_unculled"], whole["triangles"])
        self.assertLess(part["triangles_unculled"], part["triangles"])
        self.assertTrue(all(row["memory_mb"] > 0.0 for row in tables["patches-frames"]))
        near = {row["way"]: row["near_percent"] for row in tables["patches-pictures"]}
        self.assertGreater(near["patches, exact scalars"], near["patches, linear scalars"])
        for row in tables["patches-hairs"]:
            self.assertLessEqual(row["error"], 0.5)
            self.assertLessEqual(row["even_error"], row["error"])

    def check_intersections(self, tables):
        exact = tables["intersections-pairs"][0]
        self.assertEqual(exact["filter"], "vtkSurfaceIntersectionFilter")
        self.assertGreater(exact["meeting"], exact["crossing"])
        for key in ("crashes", "hangs", "too_many", "too_few", "too_few_crossing"):
            self.assertEqual(exact[key], 0, key)
        for row in tables.get("intersections-times", []):  # only if the bunny is available
            self.assertGreater(row["ratio"], 0.0)
        most, _, none = tables["intersections-scene"]
        self.assertGreater(most["triangles"], none["triangles"])
        self.assertEqual(most["segments"], none["segments"])
        self.assertGreater(most["contacts"], 0)
        self.assertGreaterEqual(most["candidates"], most["contacts"])

    def test_no_paraview(self):
        result = subprocess.run([PROGRAM, "--quick", "--paraview", "/nonexistent", "lic"],
                                capture_output=True, text=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn("/nonexistent/bin/paraview-python", result.stderr)

    def test_without_opengl(self):
        _, report = self.run_benchmark("quality")
        self.assertNotIn("OpenGL renderer", report["facts"])

    def test_by_name(self):
        _, report = self.run_benchmark("selection")
        self.assertEqual([table["name"] for table in report["tables"]], ["selection"])

    def test_unknown_name(self):
        result = subprocess.run([PROGRAM, "speed"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn("static-mesh", result.stderr)


if __name__ == "__main__":
    unittest.main()

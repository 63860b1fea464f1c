# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that type checkers know all classes and functions of the package: mypy --strict accepts
the examples and the package and finds mistakes, and stubtest compares the stubs with the modules."""

import importlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["RELEVO_SOURCE_DIR"])
EXAMPLES = sorted((SOURCE / "Examples/Python").glob("*.py"))
for program in ("mypy", "stubtest"):
    if not shutil.which(program):
        print(f"skipped: {program} is not installed")
        sys.exit(125)
try:
    import numpy  # noqa: F401
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

import relevo

PACKAGE = pathlib.Path(relevo.__file__).parent
if not (PACKAGE / "__init__.pyi").exists():
    print("skipped: built without stubs")
    sys.exit(125)
if not hasattr(relevo, "vtkTerrainMapper"):
    print("skipped: built without rendering")
    sys.exit(125)
sys.path.insert(0, str(SOURCE / "Module/Python/Packaging"))
make_stubs = importlib.import_module("make_stubs")

# What stubtest need not report.
ALLOWED = r"""
# VTK's wrappers represent static methods as method descriptors.
relevo\..*vtk\w+\.(GetNumberOfGenerationsFromBaseType|IsTypeOf|SafeDownCast)
relevo\..*vtkArrayQuantityFilter\.ListQuantities
relevo\..*vtkRefinementPatternTable\.(Canonicalize|GetPatternIndex|GetPermutation|IsOdd)
# This module has only types.
relevo\._vtk
# These modules are in Python and have no stubs. test_package() checks their annotations.
relevo\.(?!_interruptible|_filechecks)(_[a-z]\w*|__main__|arrays|files|version)(\..*)?
"""

MISTAKES = """\
import relevo
mapper = relevo.vtkTerrainMapper()
mapper.SetExagerration(2)
mapper.SetExaggeration("high")
mapper.SetLoadingMode()
relevo.vtkNothing()
relevo.terrain("dem.tif", exageration=2)
relevo.terrain("dem.tif", exaggeration="high")
relevo.refined("mesh.ply").screenshot(size=300)
relevo.intersection("a.ply").curve
relevo.vtkAdaptiveRefinement().SetSurface(mapper)
x: str = mapper.GetScreenSpaceError()
relevo.arrays.height_map("dem.tif", no_data="nothing")
mapper.SetLookupTabel(None)
relevo.terrain("dem.tif").mapper.SetContourIntervall(3)
relevo.terrain("dem.tif").actor.GetProperty().SetAmbience(3)
relevo.refined("mesh.ply").recipe.SetMaximumLevels(3)
relevo.refined("mesh.ply").mapper.SetScalarRange("high")
relevo.lic("mesh.ply").mapper.SetStepSizes(3)
relevo.volume("mesh.vtu").mapper.SetBlendMod(3)
relevo.volume("mesh.vtu").actor.GetProperty().SetShadee(1)
relevo.patches("mesh.vtu").mapper.SetPatchEdge(True)
relevo.relief("dem.tif").mapper.SetShadings(1)
relevo.intersection("a.ply").actor.AddParts(None)
"""


class TestStubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        # VTK installs no stubs in many systems. The same program makes them.
        stubs = cls.folder / "stubs/vtkmodules"
        (stubs / "util").mkdir(parents=True)
        for path in (*EXAMPLES, *PACKAGE.glob("*.py")):
            for name in re.findall(r"(?:from|import) (vtkmodules\.vtk\w+)", path.read_text()):
                importlib.import_module(name)
        for name in {*relevo._EXTENSIONS.values()}:
            importlib.import_module("relevo." + name)
        for name, module in sorted(sys.modules.items()):
            if name.startswith("vtkmodules.vtk"):
                text = make_stubs.StubWriter(module).write()
                (stubs / (name.partition(".")[2] + ".pyi")).write_text(text)
        (stubs / "__init__.pyi").write_text("")
        (stubs / "util/__init__.pyi").write_text("")
        for name in ("misc", "numpy_support"):
            text = "from typing import Any\ndef __getattr__(name: str) -> Any: ...\n"
            (stubs / f"util/{name}.pyi").write_text(text)
        for name in ("pyvista", "vedo"):
            (stubs.parent / f"{name}.pyi").write_text(text)
        # This package uses them.
        package = cls.folder / "package/relevo"
        shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("*.so", "__pycache__"))
        make_stubs.main(str(package), has_vtk_stubs=True)
        cls.environment = {
            **os.environ,
            "MYPYPATH": f"{stubs.parent}:{package.parent}",
            "PYTHONPATH": str(PACKAGE.parent),
        }

    def run_program(self, *command, **variables):
        return subprocess.run(
            list(map(str, command)),
            cwd=self.folder,
            env={**self.environment, **{name: str(value) for name, value in variables.items()}},
            capture_output=True,
            text=True,
        )

    def run_mypy(self, *arguments, **variables):
        options = ("--strict", "--python-executable", sys.executable, "--hide-error-context")
        return self.run_program("mypy", *options, *arguments, **variables)

    def test_examples(self):
        run = self.run_mypy(*EXAMPLES)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_package(self):
        run = self.run_mypy("-p", "relevo")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_mistakes(self):
        """Each line after the second has one mistake."""
        self.check_mistakes()

    def test_mistakes_without_stubs_of_vtk(self):
        """The same mistakes are found in systems where VTK has no stubs."""
        settings = self.folder / "user.ini"
        settings.write_text("[mypy]\n[mypy-vtkmodules.*]\nignore_missing_imports = True\n")
        self.check_mistakes(f"--config-file={settings}", MYPYPATH=PACKAGE.parent)

    def check_mistakes(self, *arguments, **variables):
        path = self.folder / "mistakes.py"
        path.write_text(MISTAKES)
        run = self.run_mypy(*arguments, path, **variables)
        found = {int(line) for line in re.findall(r"mistakes\.py:(\d+): error", run.stdout)}
        wanted = set(range(3, len(MISTAKES.splitlines()) + 1))
        self.assertEqual(found, wanted, run.stdout)

    def test_stubtest(self):
        """The stubs have all classes, methods, constants and functions of the modules."""
        allowed = self.folder / "allowed.txt"
        allowed.write_text(ALLOWED)
        settings = self.folder / "mypy.ini"
        settings.write_text("[mypy]\nignore_missing_imports = True\n")
        run = self.run_program(
            "stubtest",
            "--concise",
            "--ignore-unused-allowlist",
            f"--allowlist={allowed}",
            f"--mypy-config-file={settings}",
            "relevo",
            MYPYPATH=PACKAGE.parent,
        )
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_signatures(self):
        """Overloads have the types of C++, and no type of VTK is unknown."""
        unknown = {}
        for path in PACKAGE.glob("Relevo*.pyi"):
            for line in path.read_text().splitlines():
                if re.search(r"\bAny\b", line) and not re.match("from|import", line):
                    unknown[line.strip()] = path.name
        # It returns a pointer without a type.
        unknown.pop("def GetGenericContext(self) -> Any: ...", None)
        self.assertEqual(unknown, {})


if __name__ == "__main__":
    unittest.main(argv=["TestStubs"])

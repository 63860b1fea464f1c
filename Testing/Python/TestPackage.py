# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that `import relevo` provides every class with the documentation of its header."""

import importlib
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import relevo
from relevo._classes import EXTENSIONS
from vtkmodules.vtkCommonCore import vtkObjectBase, vtkVersion


def wrapped_headers():
    """Headers of the classes in all modules that were built, as name to text."""
    source = pathlib.Path(os.environ["RELEVO_SOURCE_DIR"])
    headers = {}
    for folder in (*source.glob("Filters/*/"), *source.glob("Rendering/*/")):
        library = "Relevo" + folder.parent.name + folder.name
        if not importlib.util.find_spec("relevo." + library):
            continue
        for header in folder.rglob("vtk*.h"):
            text = header.read_text()
            declared = r"^class \w+_EXPORT\s+%s\s*:" % header.stem
            if re.search(declared, text, re.MULTILINE):
                headers[header.stem] = text
    return headers


class TestPackage(unittest.TestCase):
    def test_version(self):
        """The version is that of the project."""
        self.assertEqual(relevo.__version__, os.environ["RELEVO_VERSION"])

    def test_other_vtk(self):
        """The package does not load with another version of VTK than that of the build."""
        with tempfile.TemporaryDirectory() as folder:
            package = pathlib.Path(folder, "vtkmodules")
            package.mkdir()
            (package / "__init__.py").write_text("")
            (package / "vtkCommonCore.py").write_text(
                "class vtkVersion:\n    GetVTKVersion = staticmethod(lambda: '9.99.1')\n"
            )
            run = subprocess.run(
                [sys.executable, "-c", "import relevo"],
                env={**os.environ, "PYTHONPATH": f"{folder}:{os.environ['PYTHONPATH']}"},
                capture_output=True,
                text=True,
            )
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"ImportError: this relevo was built for VTK 9\.\d+\.\d+.*9\.99\.1")
        self.assertIn(vtkVersion.GetVTKVersion(), run.stderr)

    def test_other_python(self):
        """The package does not load with another version of Python than that of the build."""
        package = pathlib.Path(relevo.__file__).parent
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder, "relevo")
            copy.mkdir()
            (copy / "__init__.py").write_text((package / "__init__.py").read_text())
            version = (package / "version.py").read_text()
            changed = re.sub(r'PYTHON_VERSION = "3\.\d+"', 'PYTHON_VERSION = "3.99"', version)
            self.assertNotEqual(changed, version)
            (copy / "version.py").write_text(changed)
            run = subprocess.run(
                [sys.executable, "-c", "import relevo"],
                env={**os.environ, "PYTHONPATH": folder},
                capture_output=True,
                text=True,
            )
        self.assertEqual(run.returncode, 1)
        this = re.escape(sys.version.split()[0])
        self.assertRegex(
            run.stderr, rf"ImportError: this relevo was built for Python 3\.99, .* Python {this};"
        )

    def test_report(self):
        """python3 -m relevo --report prints versions and the graphics driver."""
        run = subprocess.run(
            [sys.executable, "-m", "relevo", "--report"], capture_output=True, text=True
        )
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        rows = dict(re.split(r":\s+", line, maxsplit=1) for line in run.stdout.splitlines())
        self.assertEqual(rows["Relevo"], relevo.__version__)
        self.assertEqual(rows["VTK"], vtkVersion.GetVTKVersion())
        self.assertEqual(rows["Python"], sys.version.split()[0])
        if hasattr(relevo, "vtkEGLOffscreenRenderWindow"):
            self.assertTrue(rows["OpenGL renderer"])

    def test_every_class_is_there(self):
        headers = wrapped_headers()
        self.assertGreater(len(headers), 8)
        for name in headers:
            self.assertTrue(hasattr(relevo, name), name)
            self.assertIn(name, dir(relevo))

    def test_modules_are_imported_when_needed(self):
        """Libraries that load slowly, such as GDAL, and numpy load with the first use."""
        script = (
            "import sys\n"
            "import vtkmodules.vtkRenderingOpenGL2\n"
            "is_there = 'numpy' in sys.modules\n"  # newer versions of VTK import numpy
            "import relevo\n"
            "loaded = [name for name in sys.modules if name.startswith('relevo.Relevo')]\n"
            "assert not loaded and ('numpy' in sys.modules) == is_there, loaded\n"
            "relevo.vtkPNTriangleSurface\n"
            "assert 'relevo.RelevoFiltersTerrain' not in sys.modules\n"
            "assert not hasattr(relevo, 'vtkNothing') and 'show' in dir(relevo)\n"
            "from relevo import *\n"
            "terrain, show\n"
            "assert relevo.arrays.height_map and relevo.files.write\n"
        )
        run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_results_have_the_types_of_their_classes(self):
        """Classes that a script has not used itself, in the results of others."""
        script = """if True:
            import relevo
            from vtkmodules.vtkFiltersSources import vtkSphereSource
            from vtkmodules.vtkRenderingCore import vtkActor
            scene = relevo.vtkContactScene()
            mapper = relevo.vtkAdaptiveRefinementMapper()
            source = vtkSphereSource()
            mapper.SetInputConnection(source.GetOutputPort())
            mapper.SetRefinement(relevo.vtkAdaptiveRefinement())
            actor = vtkActor()
            actor.SetMapper(mapper)
            scene.AddActor(actor)
            scene.Update()
            print(type(mapper.GetRefinement().GetMetric()).__name__)
            patches = relevo.vtkAdaptivePatchMapper()
            print(type(patches.GetRefinement().GetSurface()).__name__)
            """
        run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
        names = "vtkProximityDepthTagMetric\nvtkPatchSurface\n"
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, names, ""))

    def test_modules_have_no_other_classes(self):
        for name in {extension for extension in EXTENSIONS.values()}:
            module = importlib.import_module("relevo." + name)
            classes = {own for own in vars(module) if not own.startswith("_")}
            self.assertEqual(classes, {own for own in EXTENSIONS if EXTENSIONS[own] == name})

    def test_documentation_comes_from_the_headers(self):
        for name, text in wrapped_headers().items():
            brief = re.search(r"@brief\s+(.*?)\n \*\n", text, re.DOTALL)
            self.assertIsNotNone(brief, name)
            words = re.sub(r"\s*\n \*\s*", " ", brief[1]).split()
            documented = getattr(relevo, name).__doc__.split()
            self.assertEqual(documented[2 : 2 + len(words)], words, name)

    def test_every_public_method_is_documented(self):
        missing = []
        for name in wrapped_headers():
            cls = getattr(relevo, name)
            for method, value in vars(cls).items():
                if method.startswith("_") or not callable(value) or isinstance(value, type):
                    continue
                # VTK documents methods that every class overrides in the superclass.
                if any(hasattr(base, method) for base in cls.__bases__):
                    continue
                # Signatures, an empty line, and the header's text.
                if not (value.__doc__ or "").partition("\n\n")[2].strip():
                    missing.append(f"{name}.{method}")
        self.assertEqual(missing, [])

    def test_classes_print_themselves(self):
        for name in wrapped_headers():
            try:
                made = getattr(relevo, name)()
            except (TypeError, NotImplementedError):  # abstract
                continue
            self.assertIsInstance(made, vtkObjectBase)
            self.assertIn(name, str(made))


if __name__ == "__main__":
    unittest.main(argv=["TestPackage"])

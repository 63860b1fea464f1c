# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that the Python package works beside the plugin if ParaView uses the installed VTK."""

import os

from paraview import simple

import RelevoParaView as relevo_tests


def libraries(part):
    """Loaded libraries whose names contain this text."""
    with open("/proc/self/maps") as maps:
        paths = {line.split()[-1] for line in maps if part in line}
    return sorted(os.path.basename(path).split(".so")[0] for path in paths)


class TestPackage(relevo_tests.TestCase):
    def setUp(self):
        if libraries("libvtkCommonCore-pv"):
            self.skipTest("ParaView has a VTK of its own")
        try:
            import relevo
        except ImportError as error:
            self.skipTest(f"there is no Python package: {error}")
        self.relevo = relevo

    def test_one_set_of_libraries(self):
        """Each library is loaded once, whichever is imported first."""
        names = [name.split("-")[0] for name in libraries("/libRelevo")]
        self.assertIn("libRelevoFiltersRefinement", names)
        self.assertEqual(len(names), len(set(names)))

    def test_one_set_of_classes(self):
        """Objects created by the plugin are instances of the package's classes."""
        tags = simple.DepthTags(Input=relevo_tests.sphere())
        tags.UpdatePipeline()
        self.assertIsInstance(tags.GetClientSideObject(), self.relevo.vtkDepthTagFilter)


if __name__ == "__main__":
    relevo_tests.main()

# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that the examples for ParaView run without files of the user and draw something."""

import os
import pathlib
import runpy
import sys
import tempfile
import unittest.mock

import RelevoParaView as relevo

EXAMPLES = pathlib.Path(__file__).parents[2] / "Examples" / "ParaView"


class TestExamples(relevo.TestCase):
    def test_pictures(self):
        for script in sorted(EXAMPLES.glob("*.py")):
            if script.name == "catalyst.py":
                continue  # TestInSitu runs this one in simulations
            with self.subTest(script.name), tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "picture.png")
                with unittest.mock.patch.object(sys, "argv", [str(script), path]):
                    runpy.run_path(str(script))
                self.assertGreater(relevo.foreground(relevo.read_png(path)), 20000)
                relevo.clear()


if __name__ == "__main__":
    relevo.main()

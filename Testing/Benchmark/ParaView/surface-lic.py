#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a mesh with and without VTK's surface LIC, as requested on the standard input.

    surface-lic.py MESH.vtp ARRAY WIDTH HEIGHT NOISE.png [SETTING=VALUE...]

It runs with ParaView's VTK, which must be on PYTHONPATH and LD_LIBRARY_PATH. An empty name for the
noise selects VTK's default noise. Settings are those of vtkSurfaceLICInterface. Each line on the
standard input gets one line on the standard output:

    renderer                        the name of the OpenGL renderer
    camera POSITION FOCALPOINT VIEWUP IS_PARALLEL SCALE ANGLE    "ok"; 12 numbers
    frame lic | frame plain         milliseconds of the clock and of all processors for one frame
    picture FILE.png                "ok": the last frame, the surface white and without light
"""
import sys
import time

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, the implementation of vtkRenderingCore
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
from vtkmodules.vtkRenderingLICOpenGL2 import vtkSurfaceLICMapper

MESH_POINT_DATA = 0


class Scene:
    def __init__(self, mesh, array, width, height, noise, settings):
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(width, height)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(mesh)
        reader.Update()
        lic = vtkSurfaceLICMapper()
        lic.SetInputArrayToProcess(0, 0, 0, MESH_POINT_DATA, array)
        interface = lic.GetLICInterface()
        if noise:
            image = vtkPNGReader()
            image.SetFileName(noise)
            image.Update()
            interface.SetNoiseDataSet(image.GetOutput())
        for name, value in settings.items():
            getattr(interface, "Set" + name)(value)
        self.actors = {"lic": self.add_actor(lic, reader),
                       "plain": self.add_actor(vtkPolyDataMapper(), reader)}

    def add_actor(self, mapper, reader):
        mapper.SetInputDataObject(reader.GetOutput())
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.VisibilityOff()
        # White and unlit. LightingOff would leave variables of VTK's LIC shader unset.
        surface = actor.GetProperty()
        surface.SetColor(1.0, 1.0, 1.0)
        surface.SetAmbient(1.0)
        surface.SetDiffuse(0.0)
        surface.SetSpecular(0.0)
        self.renderer.AddActor(actor)
        return actor

    def get_renderer(self):
        self.window.Render()
        return self.window.ReportCapabilities().split("renderer string:")[1].split("\n")[0].strip()

    def set_camera(self, *words):
        numbers = [float(word) for word in words]
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(numbers[0:3])
        camera.SetFocalPoint(numbers[3:6])
        camera.SetViewUp(numbers[6:9])
        camera.SetParallelProjection(int(numbers[9]))
        camera.SetParallelScale(numbers[10])
        camera.SetViewAngle(numbers[11])
        return "ok"

    def draw_frame(self, name):
        for other, actor in self.actors.items():
            actor.SetVisibility(other == name)
        start = time.perf_counter(), time.process_time()
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        self.window.WaitForCompletion()
        end = time.perf_counter(), time.process_time()
        return " ".join(str(1e3 * (b - a)) for a, b in zip(start, end))

    def write_picture(self, file_name):
        picture = vtkWindowToImageFilter()
        picture.SetInput(self.window)
        picture.ShouldRerenderOff()
        picture.ReadFrontBufferOff()
        writer = vtkPNGWriter()
        writer.SetInputConnection(picture.GetOutputPort())
        writer.SetFileName(file_name)
        writer.Write()
        return "ok"


def main():
    mesh, array, width, height, noise, *words = sys.argv[1:]
    settings = {name: float(value) if "." in value else int(value)
                for name, value in (word.split("=") for word in words)}
    scene = Scene(mesh, array, int(width), int(height), noise, settings)
    commands = {"renderer": scene.get_renderer, "camera": scene.set_camera,
                "frame": scene.draw_frame, "picture": scene.write_picture}
    for line in sys.stdin:
        name, *arguments = line.split()
        print(commands[name](*arguments), flush=True)


if __name__ == "__main__":
    main()

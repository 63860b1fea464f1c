# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves flow.md from Python: vtkLineIntegralConvolution and vtkLICNoiseSource, compared with sums
in numpy."""

import sys
import unittest

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

import relevo
from relevo import arrays


def convolve(vectors, noise=None, **settings):
    """The LIC of vectors, shape (rows, columns, 2 or 3), and its mask."""
    filter = relevo.vtkLineIntegralConvolution()
    filter.SetInputData(arrays.image(vectors))
    if noise is not None:
        filter.SetNoiseData(arrays.image(noise))
    for name, value in settings.items():
        getattr(filter, "Set" + name)(value)
    filter.Update()
    return arrays.samples(filter.GetOutput(), "LIC"), arrays.samples(filter.GetOutput(), "LICMask")


def make_noise(**settings):
    source = relevo.vtkLICNoiseSource()
    for name, value in settings.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return arrays.samples(source.GetOutput(), "Noise")


def running_mean(values, reach):
    """Means of up to 2 reach + 1 values in each row, fewer at its ends."""
    columns = values.shape[1]
    sums = numpy.cumsum(numpy.pad(values.astype(float), ((0, 0), (1, 0))), axis=1)
    first = numpy.maximum(numpy.arange(columns) - reach, 0)
    last = numpy.minimum(numpy.arange(columns) + reach, columns - 1)
    return (sums[:, last + 1] - sums[:, first]) / (last - first + 1)


def blur(values, reach=4, times=3):
    for _ in range(times):
        values = running_mean(running_mean(values, reach).T, reach).T
    return values


def line_angles(values):
    """Directions from the structure tensor, in radians, modulo pi."""
    gy, gx = numpy.gradient(blur(values, 1, 2))
    return 0.5 * numpy.arctan2(2 * blur(gx * gy), blur(gx * gx - gy * gy)) + 0.5 * numpy.pi


class TestLineIntegralConvolution(unittest.TestCase):
    def setUp(self):
        self.noise = numpy.random.default_rng(5).random((40, 70)).astype("float32")

    def test_straight_lines_are_running_means(self):
        for reach in (1, 5, 20, 100):
            along_x, mask = convolve(
                numpy.broadcast_to((1.0, 0.0), (40, 70, 2)), self.noise, NumberOfSteps=reach, EnhancedLIC=False)
            numpy.testing.assert_allclose(along_x, running_mean(self.noise, reach), atol=2e-6)
            self.assertFalse(mask.any())
            along_y, _ = convolve(
                numpy.broadcast_to((0.0, -3.0, 9.0), (40, 70, 3)), self.noise, NumberOfSteps=reach,
                EnhancedLIC=False)
            numpy.testing.assert_allclose(along_y, running_mean(self.noise.T, reach).T, atol=2e-6)

    def test_noise_is_tiled(self):
        tile = self.noise[:7, :11]
        tiled = numpy.tile(tile, (6, 7))[:40, :70]
        vectors = numpy.dstack(numpy.meshgrid(numpy.arange(70.0) - 30, 25 - numpy.arange(40.0)))
        numpy.testing.assert_array_equal(convolve(vectors, tile)[0], convolve(vectors, tiled)[0])

    def test_directions(self):
        x, y = numpy.meshgrid(numpy.arange(300) - 149.3, numpy.arange(200) - 99.6)
        for vectors in ((-y, x), (x, -y), (numpy.ones_like(x), numpy.sin(x / 40))):
            lic, mask = convolve(numpy.dstack(vectors))
            self.assertFalse(mask.any())
            self.assertTrue(0 <= lic.min() and lic.max() <= 1)
            difference = line_angles(lic) - numpy.arctan2(vectors[1], vectors[0])
            degrees = numpy.abs(numpy.degrees((difference + numpy.pi / 2) % numpy.pi - numpy.pi / 2))
            inner = (numpy.hypot(x, y) > 20) & (numpy.abs(x) < 135) & (numpy.abs(y) < 85)
            self.assertLess(numpy.median(degrees[inner]), 2.5)
            self.assertLess(numpy.percentile(degrees[inner], 95), 7.5)

    def test_mask(self):
        x, y = numpy.meshgrid(numpy.arange(70.0), numpy.arange(40.0))
        vectors = numpy.dstack((20 - y, x - 30.5))
        hole = numpy.hypot(x - 50, y - 12) < 6
        pictures = []
        for content in (numpy.nan, -1e9, 1e20, numpy.inf, 0.0):
            vectors[hole] = content
            lic, mask = convolve(vectors, self.noise)
            numpy.testing.assert_array_equal(mask, hole)
            numpy.testing.assert_array_equal(lic[hole], self.noise[hole])
            pictures.append(lic)
        for picture in pictures:
            numpy.testing.assert_array_equal(picture, pictures[0])

    def test_loop(self):
        vectors = numpy.broadcast_to((1.0, 0.5), (40, 70, 2))
        still = convolve(vectors)[0]
        numpy.testing.assert_array_equal(convolve(vectors, Phase=1.0)[0], still)
        self.assertGreater(numpy.abs(convolve(vectors, Phase=0.5)[0] - still).mean(), 0.01)

    def test_noise_source(self):
        noise = make_noise()
        self.assertEqual((noise.shape, noise.dtype), ((200, 200), numpy.float32))
        self.assertAlmostEqual(noise.mean(), 0.329, delta=0.005)
        self.assertAlmostEqual(noise.std(), 0.127, delta=0.003)
        uniform = make_noise(NoiseType=0, MinNoiseValue=0.5, MaxNoiseValue=1.0, NoiseTextureSize=300)
        counts, _ = numpy.histogram(uniform, 8, (0.5, 1.0))
        self.assertLess(numpy.abs(counts / uniform.size - 0.125).max(), 0.005)
        self.assertTrue((make_noise(NoiseGeneratorSeed=2) != noise).any())
        impulses = make_noise(ImpulseNoiseProbability=0.05, MinNoiseValue=0.1)
        self.assertAlmostEqual((impulses > 0).mean(), 0.05, delta=0.005)

    def test_errors(self):
        messages = []

        def catch(caller, event, message):
            messages.append(message)

        catch.CallDataType = "string0"
        filter = relevo.vtkLineIntegralConvolution()
        filter.AddObserver("ErrorEvent", catch)
        filter.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        filter.SetInputData(arrays.image(numpy.zeros((3, 3))))
        filter.Update()
        self.assertIn("2 or 3 components", messages.pop())
        self.assertEqual(filter.GetOutput().GetNumberOfPoints(), 0)
        filter.SetInputData(arrays.image(numpy.ones((3, 3, 2))))
        filter.SetNumberOfSteps(0)
        filter.Update()
        self.assertIn("NumberOfSteps must be in [1, 100000], got 0.", messages.pop())
        filter.SetNumberOfSteps(1)
        filter.Update()
        self.assertEqual(messages, [])
        self.assertEqual(filter.GetOutput().GetNumberOfPoints(), 9)

    def test_documentation(self):
        for item in (relevo.vtkLineIntegralConvolution, relevo.vtkLICNoiseSource):
            self.assertIn("error", item.__doc__.lower())
        steps = relevo.vtkLineIntegralConvolution.SetNumberOfSteps.__doc__
        self.assertIn("default 20", " ".join(steps.split()))


if __name__ == "__main__":
    unittest.main(argv=["TestLineIntegralConvolution"])

# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that properties of the plugin's proxies have documentation, and the defaults and ranges of
the classes, and that a value out of range is one error.

A copy of every proxy has an additional information property for each, which queries the class."""

import glob
import os
import re
import tempfile
import xml.etree.ElementTree as ElementTree

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkObject

import RelevoParaView as relevo

PROXIES = os.path.join(os.path.dirname(__file__), "..", "..", "Module", "ParaView", "Proxies")
GROUP = "relevo_test"
SURFACE_LIC = "vtkLICSettings"  # has Surface LIC's defaults, except for OWN_SETTINGS
# Other defaults than those of the classes: displacements read heights themselves, and ParaView's
# readers have the bottom row first. Volumes keep their rays, because each rank would choose others.
OPPOSITE = {
    ("vtkTerrainSource", "KeepHeights"),
    ("vtkDepthImageToRelief", "BottomRowFirst"),
    ("vtkGPUUnstructuredGridVolumeMapper", "AutoAdjustSampleDistances"),
}
# Values that surfaces in ParaView cannot have: control points of patches.
NOT_OFFERED = {("vtkDistanceDepthTagMetric", "Measure"): 2}
# Slices of ParaView's Volume, which Adaptive Volume does not draw.
NOT_OFFERED["vtkAdaptiveVolumeRepresentation", "BlendMode"] = 6
OWN_SETTINGS = {"OrientedLIC", "Phase", "NoiseFileName", "NoDataMagnitude"}
PAIR = "TextureSize"  # both numbers are 0, or neither
# Representations of all of the plugin's, and a mesh, an image and a surface that have them.
INPUTS = {
    "Adaptive Refinement": lambda: simple.Sphere(),
    "Adaptive Patches": lambda: simple.Tetrahedralize(Input=simple.Wavelet()),
    "Relief": lambda: simple.Wavelet(WholeExtent=[0, 3, 0, 3, 0, 0]),
}
MESSAGE = re.compile(r"vtk\w+ \(0x\w+\): (.*)")


def read_properties():
    """The elements of properties with one setter each, by class and name."""
    result = {}
    for path in sorted(glob.glob(os.path.join(PROXIES, "*.xml"))):
        for proxy in ElementTree.parse(path).iterfind("ProxyGroup/*[@class]"):
            for each in proxy:
                has_setter = each.get("command") and each.get("element_types") is None
                if each.tag.endswith("VectorProperty") and has_setter:
                    result.setdefault(proxy.get("class"), {})[each.get("name")] = each
    return result


def find_undocumented():
    """The elements without documentation: proxies, properties, groups of properties, and ports."""
    result = []
    for path in sorted(glob.glob(os.path.join(PROXIES, "*.xml"))):
        tree = ElementTree.parse(path)
        # ParaView reports an error for documentation there.
        exposed = set(tree.iterfind(".//ExposedProperties/PropertyGroup"))
        for each in tree.iter():
            is_proxy = each.tag.endswith("Proxy") and each.get("class")
            is_property = each.tag.endswith("Property") and each.tag != "Property"
            is_group = each.tag == "PropertyGroup" and each not in exposed
            if is_proxy or is_property or is_group or each.tag == "OutputPort":
                text = each.findtext("Documentation")
                if not (text and text.strip()):
                    result.append((os.path.basename(path), each.tag, dict(each.attrib)))
    return result


def getter(element):
    return "G" + element.get("command")[1:]


def write_proxies(properties, path):
    """For each class one proxy with getters only, and one with setters too."""
    root = ElementTree.Element("ServerManagerConfiguration")
    group = ElementTree.SubElement(root, "ProxyGroup", name=GROUP)
    for name, elements in properties.items():
        for suffix in "Getters", "Setters":
            proxy = ElementTree.SubElement(group, "Proxy", {"name": name + suffix, "class": name})
            for each in elements.values():
                attributes = {
                    "name": getter(each),
                    "command": getter(each),
                    "number_of_elements": each.get("number_of_elements"),
                    "default_values": "none",
                    "information_only": "1",
                }
                ElementTree.SubElement(proxy, each.tag, attributes)
                if suffix == "Setters":
                    attributes = dict(each.attrib, default_values="none")
                    ElementTree.SubElement(proxy, each.tag, attributes)
    ElementTree.ElementTree(root).write(path)


def values(of_property):
    return [of_property.GetElement(i) for i in range(of_property.GetNumberOfElements())]


def ends(element):
    """Values to test: the component, a value, and whether it is in the domain."""
    domain = element.find("IntRangeDomain")
    if domain is None:
        domain = element.find("DoubleRangeDomain")
    if domain is not None and "min" in domain.keys():
        value = float(domain.get("min").split()[0])
        yield from ((0, value, True), (0, value - 1, False))
    if domain is not None and "max" in domain.keys():
        value = float(domain.get("max").split()[-1])
        yield from ((-1, value, True), (-1, value + 1, False))
    entries = [int(each.get("value")) for each in element.iterfind("EnumerationDomain/Entry")]
    yield from ((0, each, True) for each in entries)
    if entries:
        yield 0, max(entries) + 1, False


def read_exposed_names():
    """Names of properties in the panel, and those in the definition."""
    result = {}
    for path in sorted(glob.glob(os.path.join(PROXIES, "*.xml"))):
        with open(path, encoding="utf-8") as file:
            pairs = re.findall(r'<Property name="(\w+)"\s+exposed_name="(\w+)"', file.read())
        result.update((shown, name) for name, shown in pairs)
    return result


def find_invalid(elements):
    """Names of properties, and a component and its value that is out of the range of each."""
    for each in elements:
        invalid = [(i, value) for i, value, is_valid in ends(each) if not is_valid]
        if invalid and each.get("name") != PAIR:
            component, value = invalid[0]
            # ParaView's Volume has another blend mode, and shares the property.
            yield each.get("name"), component, value + (each.get("name") == "BlendMode")


def count_messages(proxy, name, component, value):
    """The messages about a value of a property, which is restored."""
    of_property = proxy.GetProperty(name)
    before = values(of_property)
    tried = list(before)
    tried[component] = type(before[0])(value)
    with relevo.messages() as text:
        for i, number in enumerate(tried):
            of_property.SetElement(i, number)
        proxy.UpdateVTKObjects()
        found = MESSAGE.findall(text())
    for i, number in enumerate(before):
        of_property.SetElement(i, number)
    proxy.UpdateVTKObjects()
    return found


class TestProperties(relevo.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.properties = read_properties()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "RelevoTest.xml")
            write_proxies(cls.properties, path)
            simple.LoadPlugin(path, remote=False, ns=globals())

    def setUp(self):
        vtkObject.GlobalWarningDisplayOff()  # values out of range are errors

    def tearDown(self):
        vtkObject.GlobalWarningDisplayOn()
        super().tearDown()

    def make(self, name):
        proxy = servermanager.ProxyManager().NewProxy(GROUP, name)
        proxy.UpdateVTKObjects()
        return proxy

    def ask(self, proxy, element):
        proxy.UpdatePropertyInformation()
        return values(proxy.GetProperty(getter(element)))

    def test_documentation(self):
        self.assertEqual(find_undocumented(), [])

    def test_defaults(self):
        count = 0
        for name, elements in self.properties.items():
            proxy = self.make(name + "Getters")
            for each in elements.values() if name != SURFACE_LIC else ():
                if each.get("default_values") == "none":
                    continue  # that of a domain
                given = each.get("default_values", "").split()
                expected = [type(x)(y) for x, y in zip(self.ask(proxy, each), given)]
                if (name, each.get("name")) in OPPOSITE:
                    expected = [1 - int(each.get("default_values"))]
                if each.tag == "StringVectorProperty":
                    expected = [each.get("default_values", "")]
                self.assertEqual(self.ask(proxy, each), expected, (name, each.get("name")))
                count += 1
        self.assertGreater(count, 60)

    def test_surface_lic(self):
        """Adaptive LIC has the settings and defaults of Surface LIC."""
        theirs = relevo.show(simple.Sphere(), relevo.view(), "Surface LIC").SMProxy
        for each in self.properties[SURFACE_LIC].values():
            if each.get("name") not in OWN_SETTINGS:
                known = values(theirs.GetProperty(each.get("name")))
                given = [float(x) for x in each.get("default_values").split()]
                self.assertEqual(list(map(float, known)), given, each.get("name"))

    def test_ranges(self):
        """The classes accept the ends of a range and nothing beyond."""
        count = 0
        for name, elements in self.properties.items():
            for each in elements.values():
                for component, value, is_valid in ends(each) if each.get("name") != PAIR else ():
                    proxy = self.make(name + "Setters")
                    if NOT_OFFERED.get((name, each.get("name"))) == value:
                        continue
                    setter = proxy.GetProperty(each.get("name"))
                    tried = self.ask(proxy, each)
                    tried[component] = type(tried[0])(value)
                    for i, number in enumerate(tried):
                        setter.SetElement(i, number)
                    proxy.UpdateVTKObjects()
                    taken = self.ask(proxy, each) == tried
                    self.assertEqual(taken, is_valid, (name, each.get("name"), tried))
                    count += 1
        self.assertGreater(count, 100)

    def assert_one_message(self, proxy, name, component, value):
        """Expects one error if a property has this value. Returns it."""
        found = count_messages(proxy, name, component, value)
        self.assertEqual(len(found), 1, (proxy.GetXMLName(), name, found))
        self.assertIn(name, found[0])
        return found[0]

    def test_messages(self):
        """Several representations have a property, and one of them reports it, by its name."""
        vtkObject.GlobalWarningDisplayOn()
        exposed = read_exposed_names()
        tried = set()
        view = relevo.view((200, 150))
        proxies = [relevo.show(make(), view, kind).SMProxy for kind, make in INPUTS.items()]
        for of_class, elements in self.properties.items():
            if not re.search("Representation|Interaction|Mapper|Refinement$|LICSettings", of_class):
                continue
            for name, component, value in find_invalid(elements.values()):
                names = {shown for shown in exposed if exposed[shown] == name}
                if "Relief" not in of_class or not names:
                    names = {name}
                for shown in names:
                    # The view has properties of its own. The representations share one Method.
                    is_other = shown == "Method" and of_class.endswith("Mapper")
                    for proxy in [*proxies, view.SMProxy] if "Relief" in shown else proxies:
                        if proxy.GetProperty(shown) and not is_other:
                            told = self.assert_one_message(proxy, shown, component, value)
                            if shown != "BlendMode":  # of ParaView's Volume, too
                                self.assertRegex(told, shown + " of (Adaptive|Terrain|Relief)")
                            tried.add(shown)
        self.assertGreater(len(tried), 50, tried)

    def test_messages_of_sources(self):
        """Sources, filters, and proxies that lists offer."""
        vtkObject.GlobalWarningDisplayOn()
        tried = 0
        for path in sorted(glob.glob(os.path.join(PROXIES, "*.xml"))):
            for group in ElementTree.parse(path).iterfind("ProxyGroup"):
                if re.search("representations|views", group.get("name")):
                    continue
                for each in group.iterfind("*[@class]"):
                    if each.tag == "Proxy":  # a base of others
                        continue
                    proxy = servermanager.ProxyManager().NewProxy(group.get("name"), each.get("name"))
                    proxy.UpdateVTKObjects()
                    elements = self.properties.get(each.get("class"), {})
                    for name, component, value in find_invalid(elements.values()):
                        if proxy.GetProperty(name):
                            self.assert_one_message(proxy, name, component, value)
                            tried += 1
        self.assertGreater(tried, 100)


if __name__ == "__main__":
    relevo.main()

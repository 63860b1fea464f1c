# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Check the layers of the modules' sources; Module/Documentation/architecture.md shows them.

A file includes no header of a higher layer and no private header of another module. Classes do not
depend on each other in circles. A module's root has only public classes, and private files are not
named vtk*. Names and include guards of headers differ from VTK's. Functions have at most
LONGEST_FUNCTION lines, also in tests.

    TestLayers.py SOURCE VTK_INCLUDE_FOLDER...
"""

import pathlib
import re
import sys

# Modules, and the folders of each module, from the lowest layer to the highest. The module's root,
# with the public classes, is above its folders.
LAYERS = {
    "Filters/Core": ["Compatibility", "Mathematics", "Changes", "Checks", "View", "Arrays", "Points",
                     "Parallel", "Files", "Cells", "Mesh", "Boxes", "Levels", "Patterns"],
    "Filters/Refinement": ["Patterns", "Surfaces", "Mesh", "Metrics", "Recipe", "Evaluation",
                           "Intersection"],
    "Filters/Flow": ["Noise", "Image", "Surface"],
    "Filters/Volume": ["Quantities", "Integral", "Mesh", "Bezier", "Cells", "Rays", "Sections", "Tiles"],
    "Filters/Terrain": ["Geodesy", "Raster", "Heights", "Lattice", "Imagery", "Pyramid",
                        "Bisection", "Draping"],
    "Filters/Parametric": ["Splines", "Cells", "Coarse", "Files", "Curves", "Patches", "Metrics"],
    "Filters/MicroMesh": ["Data", "Dense", "Distance", "Base", "Encoding", "Blocks",
                          "Files", "Metrics", "Tables"],
    "Filters/Intersection": ["Exact", "Mesh", "Pairs", "Curves", "Contact"],
    "Filters/Relief": ["Data", "Warp", "Database"],
    "Rendering/Core": ["OpenGL", "View", "Buffers", "Targets", "Passes", "Shaders", "Actors",
                       "Composite", "Picking"],
    "Rendering/Refinement": ["State", "Shaders", "Buffers", "Compute", "Methods", "Picking", "Blocks",
                             "Stages"],
    "Rendering/Flow": ["Passes", "Shaders", "Buffers", "Stages"],
    "Rendering/Offscreen": [],
    "Rendering/Overlay": ["Context", "Drawing"],
    "Rendering/Remote": ["Messages", "Pictures", "Connection", "Window"],
    "Rendering/Volume": ["View", "Mesh", "Segments", "Buffers", "Shaders", "Stages", "Probe"],
    "Rendering/Parametric": ["View", "Shaders", "Buffers", "Drawing"],
    "Rendering/Intersection": ["Scene"],
    "Rendering/Relief": ["View", "Buffers", "Shaders", "Drawing", "Capture"],
    "Rendering/Terrain": ["View", "Colors", "Labels", "Buffers", "Shaders", "Drawing"],
    "Examples/Viewer": ["Text", "Files", "Options", "Code", "Legend", "Scene", "Window"],
    "Examples/Studio": ["State", "Controls", "Drawing", "Panels", "Driving", "Program"],
}
MODULES = list(LAYERS)  # a module includes no later one
# Allowed circles: a metric makes evaluators, and an evaluator reads the settings of its metric.
MUTUAL = {
    "Filters/Refinement: Metrics/DepthTags, Metrics/MetricEvaluator, vtkDepthTagMetric",
}
PROGRAMS = ("relevo-view", "relevo-studio")
LONGEST_FUNCTION = 80
NO_FUNCTION = re.compile(r"(inline |typedef )*(namespace|class|struct|union|enum|extern)\b")


def is_public(header):
    """Return whether a header declares a VTK class of its name."""
    return header.exists() and f"TypeMacro({header.stem}," in header.read_text(encoding="utf-8")


def is_of_public_class(path):
    """Return whether a file belongs to a public class or is a main program."""
    return is_public(path.with_suffix(".h")) or path.stem in PROGRAMS


def is_slice(path):
    """Return whether a source has no header of its name, so that it is a part of another class."""
    return path.suffix == ".cxx" and not (
        path.with_suffix(".h").exists() or path.stem in PROGRAMS
    )


def find_unlisted(source):
    """Find modules that are missing in LAYERS and would not be checked."""
    for top in ("Filters", "Rendering"):
        for path in sorted((source / top).rglob("vtk.module")):
            module = path.parent.relative_to(source).as_posix()
            if module not in LAYERS:
                yield f"{module}: add the module and its layers to LAYERS in TestLayers.py"


def installed_for_authors(source, module):
    """Return the headers that a module installs besides those of its public classes."""
    lists = (source / module / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"^set\(author_headers\n(.*?)\)", lists, re.MULTILINE | re.DOTALL)
    return set(found.group(1).split()) if found else set()


def may_include(module, other, name, installed):
    """Return whether a module may include a header of another one.

    Any module may include public and installed headers and those of the Core modules. Rendering/X
    may include headers of Filters/X. The studio may include headers of the viewer.
    """
    folder, idea = module.split("/")
    return (
        pathlib.PurePath(name).stem.startswith("vtk")
        or name in installed
        or other in ("Filters/Core", "Rendering/Core")
        or folder == "Rendering" and other == "Filters/" + idea
        or module == "Examples/Studio" and other == "Examples/Viewer"
    )


def functions(text):
    """Yield the first line and the number of lines of each function in a formatted source."""
    lines = text.splitlines()
    opened = []  # open braces: (indentation, line, whether it is a function), the innermost last
    for number, line in enumerate(lines):
        indentation = len(line) - len(line.lstrip())
        if line.strip() == "{":
            first = number
            while first > 0 and re.search(r"[^;{}\s]$", lines[first - 1]):
                first -= 1
            is_function = not any(
                NO_FUNCTION.match(head.strip()) for head in lines[first:number]
            )
            opened.append((indentation, number, is_function))
        elif line.strip().startswith("}") and opened and opened[-1][0] == indentation:
            _, start, is_function = opened.pop()
            if is_function and not any(outer[2] for outer in opened):
                yield start + 1, number - start - 1


def find_large(source):
    """Find functions that are too long."""
    for top in ("Filters", "Rendering", "Examples", "Testing"):
        for path in sorted((source / top).rglob("*")):
            if path.suffix in (".cxx", ".h"):
                name = path.relative_to(source)
                for line, length in functions(path.read_text(encoding="utf-8")):
                    if length > LONGEST_FUNCTION:
                        yield (
                            f"{name}:{line}: a function of more than {LONGEST_FUNCTION} lines "
                            f"({length})"
                        )


def includes(path):
    """Return the names in the #include lines of a file."""
    return re.findall(r'#include [<"]([^>"]+)', path.read_text(encoding="utf-8"))


def find_circles(files):
    """Find classes, each a header and its source, that depend on each other, also indirectly.

    Tarjan's algorithm finds the strongly connected components of the graph of includes.
    """
    graph = {}
    for name, (path, module, _) in files.items():
        used = graph.setdefault(name.rsplit(".", 1)[0], [])
        used += [other.rsplit(".", 1)[0] for other in includes(path) if other in files]
    index, low, stack, circles = {}, {}, [], []

    def visit(unit):
        index[unit] = low[unit] = len(index)
        stack.append(unit)
        for other in graph[unit]:
            if other not in index:
                visit(other)
            if other in stack:
                low[unit] = min(low[unit], low[other])
        if low[unit] == index[unit]:
            members = stack[stack.index(unit):]
            del stack[stack.index(unit):]
            if len(members) > 1:
                circles.append(sorted(members))

    sys.setrecursionlimit(10 * len(graph) + 1000)
    for unit in graph:
        if unit not in index:
            visit(unit)
    for members in circles:
        _, module, _ = files.get(members[0] + ".h") or files[members[0] + ".cxx"]
        circle = f"{module}: {', '.join(members)}"
        if circle not in MUTUAL:
            yield circle + " depend on each other in a circle"


def main():
    source = pathlib.Path(sys.argv[1])
    faults = list(find_unlisted(source))
    files = {}  # name in #include lines: (path, module, layer)
    for module, layers in LAYERS.items():
        for path in sorted((source / module).rglob("*")):
            if path.suffix not in (".h", ".cxx"):
                continue
            inside = path.relative_to(source / module)
            layer = len(layers)
            if len(inside.parts) > 1:
                if inside.parts[0] not in layers:
                    faults.append(f"{module}/{inside}: {inside.parts[0]} is not in LAYERS")
                    continue
                layer = layers.index(inside.parts[0])
            if len(inside.parts) == 1 or path.stem.startswith("vtk"):
                if not is_of_public_class(path):
                    faults.append(f"{module}/{inside}: only public classes may be named vtk... or "
                                  "lie at the module's root")
                name = inside.name
            else:
                name = inside.as_posix()
            if is_slice(path):
                faults.append(f"{module}/{inside}: has no header of its name; put each class in "
                              "one .h and one .cxx")
            if name in files:
                faults.append(f"{module}/{inside}: another module has a file of this name")
            files[name] = (path, module, layer)

    installed = {module: installed_for_authors(source, module) for module in MODULES}
    for name, (path, module, layer) in files.items():
        for include in includes(path):
            if ".." in pathlib.PurePath(include).parts:
                faults.append(f"{module}/{name}: includes {include} by a path with ..")
            if include not in files or pathlib.PurePath(include).stem == path.stem:
                continue
            _, other, below = files[include]
            if MODULES.index(other) > MODULES.index(module) or other == module and below > layer:
                faults.append(f"{module}/{name}: includes {include} of a higher layer")
            if other != module and not may_include(module, other, include, installed[other]):
                faults.append(f"{module}/{name}: includes {include}, which is private to {other}")
    faults += find_circles(files)
    faults += find_large(source)
    number_of_functions = sum(
        len(list(functions(path.read_text(encoding="utf-8")))) for path, _, _ in files.values()
    )

    theirs = set()
    guards = set()
    for folder in map(pathlib.Path, sys.argv[2:]):
        for path in folder.rglob("*.h"):
            text = path.read_text(errors="replace")
            guards.update(re.findall(r"^#ifndef (\w+)", text, re.MULTILINE))
            if path.parent == folder:  # others are included with the name of their folder
                theirs.add(path.name)
    own = {}  # include guards; two classes of the same name would clash in the linker
    for name, (path, module, _) in files.items():
        if path.suffix != ".h":
            continue
        guard = re.search(r"^#ifndef (\w+)", path.read_text(encoding="utf-8"), re.MULTILINE)
        if path.name in theirs:
            faults.append(f"{module}/{name}: VTK also has a header {path.name}")
        if not guard or guard.group(1) != path.stem + "_h":
            faults.append(f"{module}/{name}: the include guard must be {path.stem}_h")
        elif guard.group(1) in guards:
            faults.append(f"{module}/{name}: VTK also has the include guard {guard.group(1)}")
        elif guard.group(1) in own:
            faults.append(f"{module}/{name}: {own[guard.group(1)]} has the same name")
        else:
            own[guard.group(1)] = f"{module}/{name}"

    print("\n".join(faults))
    print(
        f"{len(files)} files, {number_of_functions} functions, "
        f"{len(theirs)} headers of VTK, {len(faults)} faults"
    )
    return 1 if faults or not number_of_functions or not theirs else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The layers of the modules' sources, as Module/Documentation/architecture.md draws them.

An include never goes to a higher layer or to a private header of another module. Classes do not
depend on each other in circles. A module's root holds public classes only, and private files are
not called vtk*. Headers differ from VTK's in name and include guard. Functions stay small, also in
tests.

    TestLayers.py SOURCE VTK_INCLUDE_FOLDER...
"""

import pathlib
import re
import sys

# The modules from the bottom up, and the folders of each from the bottom up. A module's own folder,
# with the public classes that its users start from, is above its folders.
LAYERS = {
    "Filters/Core": ["Compatibility", "Mathematics", "Changes", "Checks", "View", "Arrays", "Points",
                     "Parallel", "Files", "Cells", "Mesh", "Boxes", "Levels", "Patterns"],
    "Filters/Refinement": ["Patterns", "Surfaces", "Mesh", "Metrics", "Recipe", "Evaluation",
                           "Intersection"],
    "Filters/Flow": ["Noise", "Image", "Surface"],
    "Filters/Volume": ["Integral", "Mesh", "Cells", "Rays"],
    "Filters/Terrain": ["Geodesy", "Raster", "Heights"],
    "Filters/Parametric": ["Splines", "Cells", "Coarse", "Files", "Curves", "Patches", "Metrics"],
    "Filters/Intersection": ["Exact", "Mesh", "Pairs", "Curves", "Contact"],
    "Filters/Relief": ["Data", "Warp", "Database"],
    "Rendering/Core": ["OpenGL", "View", "Buffers", "Targets", "Passes", "Shaders", "Actors",
                       "Composite", "Picking"],
    "Rendering/Refinement": ["State", "Shaders", "Buffers", "Compute", "Methods", "Picking", "Blocks",
                             "Stages"],
    "Rendering/Flow": ["Passes", "Shaders", "Buffers", "Stages"],
    "Rendering/Offscreen": [],
    "Rendering/Volume": ["View", "Mesh", "Buffers", "Shaders", "Stages"],
    "Rendering/Parametric": ["View", "Shaders", "Buffers", "Drawing"],
    "Rendering/Intersection": ["Scene"],
    "Rendering/Relief": ["View", "Buffers", "Shaders", "Drawing", "Capture"],
    "Examples/Viewer": ["Text", "Files", "Options", "Legend", "Scene", "Window"],
}
MODULES = list(LAYERS)  # no module includes one that comes after it
# A metric makes its evaluators, and an evaluator reads the settings of its metric.
MUTUAL = {
    "Filters/Refinement: Metrics/DepthTags, Metrics/MetricEvaluator, vtkDepthTagMetric",
}
LONGEST_FUNCTION = 80
NO_FUNCTION = re.compile(r"(inline |typedef )*(namespace|class|struct|union|enum|extern)\b")


def is_public(header):
    """Whether a header at a module's root declares the class that it is named after."""
    return header.exists() and f"TypeMacro({header.stem}," in header.read_text(encoding="utf-8")


def is_of_public_class(path):
    """A file that is called as a public class is."""
    return is_public(path.with_suffix(".h")) or path.stem == "relevo-view"


def is_slice(path):
    """A source without a header of its name: a part of another file's class."""
    return path.suffix == ".cxx" and not (
        path.with_suffix(".h").exists() or path.stem == "relevo-view"
    )


def find_unlisted(source):
    """Modules that LAYERS does not have, so that nothing looks at them."""
    for top in ("Filters", "Rendering"):
        for path in sorted((source / top).rglob("vtk.module")):
            module = path.parent.relative_to(source).as_posix()
            if module not in LAYERS:
                yield f"{module}: add the module and its layers to LAYERS in TestLayers.py"


def installed_for_authors(source, module):
    """The headers that a module installs beside those of its public classes."""
    lists = (source / module / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"^set\(author_headers\n(.*?)\)", lists, re.MULTILINE | re.DOTALL)
    return set(found.group(1).split()) if found else set()


def may_include(module, other, name, installed):
    """Whether a module may include a header of another one.

    Public classes and installed headers are there for everyone, those of Core for all modules, and
    those of Filters/X for Rendering/X, its twin.
    """
    folder, idea = module.split("/")
    return (
        pathlib.PurePath(name).stem.startswith("vtk")
        or name in installed
        or other in ("Filters/Core", "Rendering/Core")
        or folder == "Rendering" and other == "Filters/" + idea
    )


def functions(text):
    """Where the functions of a formatted source start, and how many lines their braces enclose."""
    lines = text.splitlines()
    opened = []  # (indentation, line, whether a function), the innermost last
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
    """Functions of too many lines."""
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
    """What a file includes, as it names it."""
    return re.findall(r'#include [<"]([^>"]+)', path.read_text(encoding="utf-8"))


def find_circles(files):
    """Classes that depend on each other, directly or by others, through their headers or sources.

    They are the strongly connected components of the graph of includes, found with Tarjan's
    algorithm. A class is a header with its source.
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
    files = {}  # as includes name it: (module, layer)
    for module, layers in LAYERS.items():
        for path in sorted((source / module).rglob("*")):
            if path.suffix not in (".h", ".cxx"):
                continue
            inside = path.relative_to(source / module)
            layer = len(layers)
            if len(inside.parts) > 1:
                if inside.parts[0] not in layers:
                    faults.append(f"{module}/{inside}: {inside.parts[0]} is no layer")
                    continue
                layer = layers.index(inside.parts[0])
            if len(inside.parts) == 1 or path.stem.startswith("vtk"):
                if not is_of_public_class(path):
                    faults.append(f"{module}/{inside}: only public classes are called vtk... and "
                                  "lie beside the module's folders")
                name = inside.name  # as includes name it
            else:
                name = inside.as_posix()
            if is_slice(path):
                faults.append(f"{module}/{inside}: has no header of its name; a class is in one .h "
                              "and one .cxx")
            if name in files:
                faults.append(f"{module}/{inside}: another module has it too")
            files[name] = (path, module, layer)

    installed = {module: installed_for_authors(source, module) for module in MODULES}
    for name, (path, module, layer) in files.items():
        for include in includes(path):
            if ".." in pathlib.PurePath(include).parts:
                faults.append(f"{module}/{name}: names {include} from where it lies")
            if include not in files or pathlib.PurePath(include).stem == path.stem:
                continue
            _, other, below = files[include]
            if MODULES.index(other) > MODULES.index(module) or other == module and below > layer:
                faults.append(f"{module}/{name}: climbs to {include}")
            if other != module and not may_include(module, other, include, installed[other]):
                faults.append(f"{module}/{name}: {include} is private to {other}")
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
            if path.parent == folder:  # those below are included with their folder's name
                theirs.add(path.name)
    own = {}  # include guards: classes of the same name would be one to the linker
    for name, (path, module, _) in files.items():
        if path.suffix != ".h":
            continue
        guard = re.search(r"^#ifndef (\w+)", path.read_text(encoding="utf-8"), re.MULTILINE)
        if path.name in theirs:
            faults.append(f"{module}/{name}: VTK has a {path.name}")
        if not guard or guard.group(1) != path.stem + "_h":
            faults.append(f"{module}/{name}: its include guard is not {path.stem}_h")
        elif guard.group(1) in guards:
            faults.append(f"{module}/{name}: VTK has an include guard {guard.group(1)}")
        elif guard.group(1) in own:
            faults.append(f"{module}/{name}: {own[guard.group(1)]} has this name, too")
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

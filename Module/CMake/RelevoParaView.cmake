# Finds ParaView, whose VTK the modules are then built with.

if (RELEVO_WRAP_PYTHON OR RELEVO_BUILD_EXAMPLES OR RELEVO_BUILD_TESTING OR RELEVO_BUILD_BENCHMARK)
  message(FATAL_ERROR "RELEVO_BUILD_PARAVIEW builds the plugin alone: set RELEVO_WRAP_PYTHON, "
    "RELEVO_BUILD_EXAMPLES, RELEVO_BUILD_TESTING and RELEVO_BUILD_BENCHMARK to OFF, or use "
    "Module/ParaView/build.sh.")
endif ()
find_package(Python3 REQUIRED COMPONENTS Interpreter Development)
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingViews)

set(relevo_component paraview)
# Libraries for a VTK of ParaView's own have names of their own, as a process may find those for the
# installed VTK, too. With the installed VTK they are those of the Python package, by name as well: a
# process loads only one of two with the same name.
if (VTK_DIR MATCHES "/paraview-[^/]+/vtk$")
  set(relevo_library_suffix "paraview${ParaView_VERSION_SIMPLE}")
endif ()

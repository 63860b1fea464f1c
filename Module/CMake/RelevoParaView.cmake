# Finds ParaView. The modules are built with its VTK.

if (RELEVO_WRAP_PYTHON OR RELEVO_BUILD_EXAMPLES OR RELEVO_BUILD_TESTING OR RELEVO_BUILD_BENCHMARK)
  message(FATAL_ERROR "RELEVO_BUILD_PARAVIEW builds only the plugin. Set RELEVO_WRAP_PYTHON, "
    "RELEVO_BUILD_EXAMPLES, RELEVO_BUILD_TESTING and RELEVO_BUILD_BENCHMARK to OFF, or use "
    "Module/ParaView/build.sh.")
endif ()
find_package(Python3 REQUIRED COMPONENTS Interpreter Development)
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingViews)

set(relevo_component paraview)
# If ParaView brings a VTK, the libraries get a suffix, because a process may also find those for
# the installed VTK. If ParaView uses the installed VTK, the libraries have the names of those of
# the Python package, so that a process loads only one of them.
if (VTK_DIR MATCHES "/paraview-[^/]+/vtk$")
  set(relevo_library_suffix "paraview${ParaView_VERSION_SIMPLE}")
endif ()
if (relevo_debian_layout)
  set(relevo_library_destination "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Relevo")
endif ()

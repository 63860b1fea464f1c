# Describes the packages that `cpack -G DEB` makes. Module/package.sh configures such a build: all
# packages except relevo-paraview come from one build, and relevo-paraview from that of the plugin.

set(CPACK_PACKAGE_NAME relevo)
set(CPACK_PACKAGE_VENDOR "The Relevo developers")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
if (NOT relevo_debian_layout)
  set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_LIST_DIR}/RelevoDebianCheck.cmake")
  include(CPack)
  return ()
endif ()

# The maintainer, from the environment variables that Debian's tools use.
set(relevo_maintainer "The Relevo developers <relevo@example.org>")
if (DEFINED ENV{DEBEMAIL})
  set(relevo_maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif ()
set(relevo_debian_version "${PROJECT_VERSION}-1")
set(relevo_debian_templates "${PROJECT_SOURCE_DIR}/Module/Packaging/debian")
set(relevo_debian_files "${CMAKE_BINARY_DIR}/debian")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${relevo_maintainer}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries of other packages of this build, and of a ParaView that is not installed.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_GENERATOR DEB)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

# Policy asks for a changelog in Debian's format and for compressed files without time stamps.
string(TIMESTAMP relevo_debian_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${relevo_debian_templates}/changelog.in"
  "${relevo_debian_files}/changelog.Debian" @ONLY)
file(COPY_FILE "${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${relevo_debian_files}/changelog")
foreach (name IN ITEMS changelog changelog.Debian)
  execute_process(
    COMMAND               gzip -9nf "${relevo_debian_files}/${name}"
    COMMAND_ERROR_IS_FATAL ANY)
endforeach ()
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" relevo_debian_licence)
string(REGEX REPLACE "^[^\n]*\n\nCopyright [^\n]*\n[^\n]*\n\n" "" relevo_debian_licence
  "${relevo_debian_licence}")
string(STRIP "${relevo_debian_licence}" relevo_debian_licence)
string(REPLACE "\n\n" "\n.\n" relevo_debian_licence "${relevo_debian_licence}")
string(REPLACE "\n" "\n " relevo_debian_licence "${relevo_debian_licence}")
configure_file("${relevo_debian_templates}/copyright.in" "${relevo_debian_files}/copyright" @ONLY)

# relevo_describe_package(<package> COMPONENT <component> [GROUP <component>...]
#   SECTION <section> SUMMARY <text> DESCRIPTION <text> [DEPENDS <text>] [RECOMMENDS <text>] [CONTROL <file>...])
#
# Describes the package that contains a component, or a component and those of its group. SUMMARY
# continues the first line of the description, and DESCRIPTION its text.
# Dependencies by libraries are added to DEPENDS.
function (relevo_describe_package package)
  cmake_parse_arguments(PARSE_ARGV 1 arg ""
    "COMPONENT;SECTION;SUMMARY;DESCRIPTION;DEPENDS;RECOMMENDS" "GROUP;CONTROL")
  install(
    FILES
      "${relevo_debian_files}/changelog.gz"
      "${relevo_debian_files}/changelog.Debian.gz"
      "${relevo_debian_files}/copyright"
    DESTINATION "share/doc/${package}"
    COMPONENT   "${arg_COMPONENT}")
  if (EXISTS "${relevo_debian_templates}/${package}.lintian-overrides")
    install(
      FILES       "${relevo_debian_templates}/${package}.lintian-overrides"
      DESTINATION share/lintian/overrides
      RENAME      "${package}"
      COMPONENT   "${arg_COMPONENT}")
  endif ()
  set(components ${arg_COMPONENT})
  set(owner "${arg_COMPONENT}")
  if (arg_GROUP)
    list(APPEND components ${arg_GROUP})
    string(REPLACE "-" "_" owner "${package}_group")
    foreach (component IN LISTS components)
      string(TOUPPER "${component}" upper)
      set("CPACK_COMPONENT_${upper}_GROUP" "${owner}" PARENT_SCOPE)
    endforeach ()
  endif ()
  string(TOUPPER "${owner}" upper)
  set("CPACK_DEBIAN_${upper}_DESCRIPTION"
    "${relevo_debian_summary} - ${arg_SUMMARY}\n${relevo_debian_text}${arg_DESCRIPTION}"
    PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_PACKAGE_NAME" "${package}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_PACKAGE_SECTION" "${arg_SECTION}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS" "${arg_DEPENDS}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_PACKAGE_RECOMMENDS" "${arg_RECOMMENDS}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA" "${arg_CONTROL}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${components} PARENT_SCOPE)
endfunction ()

# Prints the dependency on the versions of a package that have the same two first numbers.
function (relevo_depend_on_minor_version result package version)
  string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" lower "${version}")
  math(EXPR minor "${CMAKE_MATCH_2} + 1")
  set("${result}" "${package} (>= ${lower}), ${package} (<< ${CMAKE_MATCH_1}.${minor}~)"
    PARENT_SCOPE)
endfunction ()

set(relevo_debian_summary "adaptive surface refinement on the graphics card")
# CPack indents the lines of descriptions. Without the empty variable, it would write its own summary.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(relevo_debian_text "Relevo is a set of VTK modules. They refine meshes, terrain and volumes on the
graphics card in each frame.

")
set(CPACK_COMPONENTS_ALL)
if (RELEVO_BUILD_PARAVIEW)
  get_filename_component(libraries "${ParaView_DIR}/../.." ABSOLUTE)
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
    "${libraries}" "${libraries}/paraview-${ParaView_VERSION_SIMPLE}")
  relevo_depend_on_minor_version(paraview paraview "${ParaView_VERSION_SIMPLE}")
  relevo_describe_package(relevo-paraview
    COMPONENT   paraview
    SECTION     science
    DEPENDS     "${paraview}"
    RECOMMENDS  python3-paraview
    SUMMARY     "ParaView plugin"
    DESCRIPTION "This package contains the plugin for ParaView.")
  include(CPack)
  return ()
endif ()

# Until version 1.0, programs that use the libraries need exactly this version.
set(shlibs)
foreach (module IN LISTS relevo_modules)
  string(REPLACE "Relevo::" "libRelevo" library "${module}")
  string(APPEND shlibs
    "${library} ${PROJECT_VERSION_MAJOR} librelevo${PROJECT_VERSION_MAJOR} (= ${relevo_debian_version})\n")
endforeach ()
file(WRITE "${relevo_debian_files}/shlibs" "${shlibs}")
set(library "librelevo${PROJECT_VERSION_MAJOR} (= ${relevo_debian_version})")

relevo_describe_package("librelevo${PROJECT_VERSION_MAJOR}"
  COMPONENT   runtime
  SECTION     libs
  CONTROL     "${relevo_debian_files}/shlibs" "${relevo_debian_templates}/triggers"
  SUMMARY     "libraries"
  DESCRIPTION "This package contains the libraries.")
set(imgui "")
if (TARGET Relevo::RenderingOverlay)
  set(imgui ", libimgui-dev")
endif ()
relevo_describe_package(librelevo-dev
  COMPONENT   development
  SECTION     libdevel
  DEPENDS     "${library}, libvtk9-dev${imgui}"
  SUMMARY     "development files"
  DESCRIPTION "This package contains headers, and files for find_package of CMake.")
if (TARGET relevo-view)
  relevo_describe_package(relevo
    COMPONENT   programs
    GROUP       documentation
    SECTION     science
    DEPENDS     "${library}"
    RECOMMENDS  "python3-relevo (= ${relevo_debian_version})"
    SUMMARY     "viewer and tools"
    DESCRIPTION "This package contains the viewer relevo-view, the program relevo-studio with
controls for its options, the converter relevo-pyramid and the documentation.")
endif ()
if (RELEVO_WRAP_PYTHON)
  relevo_depend_on_minor_version(python python3 "${Python3_VERSION}")
  relevo_depend_on_minor_version(vtk python3-vtk9 "${VTK_VERSION}")
  relevo_describe_package(python3-relevo
    COMPONENT   python
    SECTION     python
    DEPENDS     "${library}, ${python}, python3-numpy, ${vtk}"
    RECOMMENDS  "relevo (= ${relevo_debian_version})"
    CONTROL     "${relevo_debian_templates}/postinst" "${relevo_debian_templates}/prerm"
    SUMMARY     "Python package"
    DESCRIPTION "This package contains the Python package relevo.")
endif ()
include(CPack)

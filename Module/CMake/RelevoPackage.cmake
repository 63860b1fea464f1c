# Writes RelevoConfig.cmake and its version file, for find_package(Relevo) in the build tree and in
# an installation. vtk_module_build writes the targets and module properties beside them.
include(CMakePackageConfigHelpers)

# Users of static libraries must link their dependencies.
set(relevo_link_dependencies)
set(relevo_find_modules)
if (NOT BUILD_SHARED_LIBS)
  set(relevo_link_dependencies glm GeographicLib OpenImageIO)
  set(relevo_find_modules "${PROJECT_SOURCE_DIR}/Filters/Terrain/CMake/FindGeographicLib.cmake")
  get_target_property(libraries Relevo::FiltersTerrain LINK_LIBRARIES)
  if ("GDAL::GDAL" IN_LIST libraries)
    list(APPEND relevo_link_dependencies GDAL)
  endif ()
  if (TARGET Relevo::RenderingOffscreen)
    list(APPEND relevo_link_dependencies "OpenGL COMPONENTS OpenGL EGL")
  endif ()
  if (TARGET Relevo::RenderingOverlay)
    list(APPEND relevo_link_dependencies ImGui)
    list(APPEND relevo_find_modules "${CMAKE_CURRENT_LIST_DIR}/FindImGui.cmake")
  endif ()
  if (TARGET Relevo::RenderingRemote)
    list(APPEND relevo_link_dependencies Civetweb Threads)
    list(APPEND relevo_find_modules "${CMAKE_CURRENT_LIST_DIR}/FindCivetweb.cmake")
  endif ()
  file(COPY ${relevo_find_modules} DESTINATION "${CMAKE_BINARY_DIR}/${relevo_cmake_destination}")
endif ()
string(REPLACE "Relevo::" "" relevo_components "${relevo_modules}")
set(relevo_vtk_components ${relevo_required})
list(TRANSFORM relevo_vtk_components REPLACE "^VTK::" "")

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/RelevoConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${relevo_cmake_destination}/RelevoConfig.cmake"
  INSTALL_DESTINATION "${relevo_cmake_destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${relevo_cmake_destination}/RelevoConfigVersion.cmake"
  VERSION       "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${relevo_cmake_destination}/RelevoConfig.cmake"
    "${CMAKE_BINARY_DIR}/${relevo_cmake_destination}/RelevoConfigVersion.cmake"
    ${relevo_find_modules}
  DESTINATION "${relevo_cmake_destination}"
  COMPONENT   development)

# Users source env.sh. It works in a build tree or an installation, also after these are moved.
set(relevo_env_purpose
  "adds Relevo's programs to PATH and its package for ${Python3_EXECUTABLE} to PYTHONPATH")
string(CONFIGURE [[
  PATH="$relevo_prefix/@CMAKE_INSTALL_BINDIR@${PATH:+:$PATH}"
  PYTHONPATH="$relevo_prefix/@RELEVO_PYTHON_DESTINATION@${PYTHONPATH:+:$PYTHONPATH}"
  export PATH PYTHONPATH]] relevo_env_settings @ONLY)
set(relevo_env_folder "build")
set(relevo_env_to_prefix ".")
if (relevo_is_whole)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/env.sh.in" "${CMAKE_BINARY_DIR}/env.sh" @ONLY)
endif ()
set(relevo_env_destination "${CMAKE_INSTALL_DATADIR}/relevo")
set(relevo_env_folder "PREFIX/${relevo_env_destination}")
file(RELATIVE_PATH relevo_env_to_prefix "/prefix/${relevo_env_destination}" "/prefix")
set(installed_env "${CMAKE_BINARY_DIR}/${relevo_env_destination}/env.sh")
configure_file("${CMAKE_CURRENT_LIST_DIR}/env.sh.in" "${installed_env}" @ONLY)
install(
  FILES       "${installed_env}"
  DESTINATION "${relevo_env_destination}"
  COMPONENT   environment)

# A project that includes Relevo installs its pages, and Relevo adds only the licence.
if (NOT relevo_is_whole)
  install(
    FILES       "${PROJECT_SOURCE_DIR}/LICENSE"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/Relevo"
    COMPONENT   runtime)
  return ()
endif ()

# Pages are installed with the examples and pictures that they link to.
install(
  FILES
    "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
    "${PROJECT_SOURCE_DIR}/CONTRIBUTING.md"
    "${PROJECT_SOURCE_DIR}/LICENSE"
    "${PROJECT_SOURCE_DIR}/README.md"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT   documentation)
install(
  FILES       "${PROJECT_SOURCE_DIR}/Data/README.md"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}/Data"
  COMPONENT   documentation)
install(
  DIRECTORY   "${PROJECT_SOURCE_DIR}/Module/Documentation"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}/Module"
  COMPONENT   documentation
  FILES_MATCHING PATTERN "*.md" PATTERN "*.gif" PATTERN "*.jpg" PATTERN "*.png")
install(
  DIRECTORY
    "${PROJECT_SOURCE_DIR}/Examples/Cxx"
    "${PROJECT_SOURCE_DIR}/Examples/ParaView"
    "${PROJECT_SOURCE_DIR}/Examples/Python"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}/Examples"
  COMPONENT   documentation
  PATTERN     __pycache__ EXCLUDE)
install(
  FILES
    "${PROJECT_SOURCE_DIR}/Examples/relevo-view.png"
    "${PROJECT_SOURCE_DIR}/Examples/relevo-view-wireframe.png"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}/Examples"
  COMPONENT   documentation)

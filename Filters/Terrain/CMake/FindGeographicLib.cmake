# Sets GeographicLib_FOUND and defines the target GeographicLib::GeographicLib.
#
# Some distributions ship GeographicLib without a package configuration, and the library has one of
# two names.
find_package(GeographicLib CONFIG QUIET)
if (GeographicLib_FOUND AND NOT TARGET GeographicLib::GeographicLib)
  add_library(GeographicLib::GeographicLib INTERFACE IMPORTED)
  set_target_properties(GeographicLib::GeographicLib PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${GeographicLib_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "${GeographicLib_LIBRARIES}")
endif ()
if (NOT TARGET GeographicLib::GeographicLib)
  find_path(GeographicLib_INCLUDE_DIR GeographicLib/LocalCartesian.hpp)
  find_library(GeographicLib_LIBRARY NAMES GeographicLib Geographic)
  mark_as_advanced(GeographicLib_INCLUDE_DIR GeographicLib_LIBRARY)
  include(FindPackageHandleStandardArgs)
  find_package_handle_standard_args(GeographicLib
    REQUIRED_VARS GeographicLib_LIBRARY GeographicLib_INCLUDE_DIR)
  if (GeographicLib_FOUND)
    add_library(GeographicLib::GeographicLib UNKNOWN IMPORTED)
    set_target_properties(GeographicLib::GeographicLib PROPERTIES
      IMPORTED_LOCATION "${GeographicLib_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${GeographicLib_INCLUDE_DIR}")
  endif ()
endif ()

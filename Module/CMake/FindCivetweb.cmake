# Finds civetweb and defines the target Civetweb::Civetweb. The package configuration of Debian also
# requires the server program, which is in another package.
find_path(Civetweb_INCLUDE_DIR NAMES civetweb.h)
find_library(Civetweb_LIBRARY NAMES civetweb)
mark_as_advanced(Civetweb_INCLUDE_DIR Civetweb_LIBRARY)
if (Civetweb_INCLUDE_DIR)
  file(STRINGS "${Civetweb_INCLUDE_DIR}/civetweb.h" version REGEX "define CIVETWEB_VERSION +\"")
  string(REGEX MATCH "[0-9]+[.0-9]*" Civetweb_VERSION "${version}")
endif ()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Civetweb
  REQUIRED_VARS Civetweb_LIBRARY Civetweb_INCLUDE_DIR
  VERSION_VAR   Civetweb_VERSION)

if (Civetweb_FOUND AND NOT TARGET Civetweb::Civetweb)
  add_library(Civetweb::Civetweb UNKNOWN IMPORTED)
  set_target_properties(Civetweb::Civetweb PROPERTIES
    IMPORTED_LOCATION             "${Civetweb_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Civetweb_INCLUDE_DIR}")
endif ()

# Finds the raster and geodesy libraries of Relevo::FiltersTerrain, and sets:
#   relevo_terrain_libraries  targets to link
#   relevo_has_gdal           1 if GDAL is used, otherwise 0 (see RELEVO_USE_GDAL)
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
find_package(GeographicLib REQUIRED)
find_package(OpenImageIO REQUIRED)
set(relevo_terrain_libraries GeographicLib::GeographicLib OpenImageIO::OpenImageIO)

# On Debian, the target names include folders of packages that it does not depend on.
get_target_property(relevo_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
foreach (folder IN LISTS relevo_includes)
  if (IS_ABSOLUTE "${folder}" AND NOT EXISTS "${folder}")
    list(REMOVE_ITEM relevo_includes "${folder}")
  endif ()
endforeach ()
set_property(TARGET OpenImageIO::OpenImageIO
  PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${relevo_includes}")

set(relevo_has_gdal 0)
if (RELEVO_USE_GDAL STREQUAL "AUTO")
  find_package(GDAL)
elseif (RELEVO_USE_GDAL)
  find_package(GDAL REQUIRED)
endif ()
if (RELEVO_USE_GDAL AND GDAL_FOUND)
  set(relevo_has_gdal 1)
  list(APPEND relevo_terrain_libraries GDAL::GDAL)
endif ()

# Finds Dear ImGui, which distributions build as one library. Defines the target ImGui::ImGui.
find_path(ImGui_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui)
find_library(ImGui_LIBRARY imgui)
# Debian builds ImGui without its own copy of stb.
find_library(ImGui_STB_LIBRARY stb)
mark_as_advanced(ImGui_INCLUDE_DIR ImGui_LIBRARY ImGui_STB_LIBRARY)
if (ImGui_INCLUDE_DIR)
  file(STRINGS "${ImGui_INCLUDE_DIR}/imgui.h" ImGui_VERSION
    REGEX "^#define IMGUI_VERSION +\"" LIMIT_COUNT 1)
  string(REGEX REPLACE "^[^\"]*\"([0-9.]*).*" "\\1" ImGui_VERSION "${ImGui_VERSION}")
endif ()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ImGui
  REQUIRED_VARS ImGui_LIBRARY ImGui_INCLUDE_DIR
  VERSION_VAR   ImGui_VERSION)
if (ImGui_FOUND AND NOT TARGET ImGui::ImGui)
  add_library(ImGui::ImGui UNKNOWN IMPORTED)
  set_target_properties(ImGui::ImGui PROPERTIES
    IMPORTED_LOCATION             "${ImGui_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${ImGui_INCLUDE_DIR}")
  if (ImGui_STB_LIBRARY)
    set_target_properties(ImGui::ImGui PROPERTIES
      INTERFACE_LINK_LIBRARIES "${ImGui_STB_LIBRARY}")
  endif ()
endif ()

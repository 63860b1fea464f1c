# Compiler settings shared by every target of the project.

include(CheckCXXCompilerFlag)

# Contracting a*b+c would give shared edges different bits on their two sides.
check_cxx_compiler_flag(-ffp-contract=off relevo_has_ffp_contract)
if (relevo_has_ffp_contract)
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)
elseif (MSVC)
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:/fp:precise>)
endif ()

if (RELEVO_SANITIZE)
  add_compile_options(-fsanitize=${RELEVO_SANITIZE} -fno-omit-frame-pointer -g)
  add_link_options(-fsanitize=${RELEVO_SANITIZE})
endif ()

if (MSVC)
  set(relevo_warning_flags /W3)
else ()
  set(relevo_warning_flags -Wall -Wextra)
endif ()
if (RELEVO_WERROR AND MSVC)
  list(APPEND relevo_warning_flags /WX)
elseif (RELEVO_WERROR)
  list(APPEND relevo_warning_flags -Werror)
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # From version 14 on, g++'s optimiser warns of impossible sizes in vtkSMPThreadLocal and std::vector<bool>.
    list(APPEND relevo_warning_flags
      -Wno-error=array-bounds -Wno-error=stringop-overflow)
  endif ()
endif ()

# Warnings for a module's own files only: generated wrappers are VTK's. Call from the folder that
# holds the module's sources.
function (relevo_enable_warnings)
  file(GLOB_RECURSE sources "${CMAKE_CURRENT_SOURCE_DIR}/*.cxx")
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS "${relevo_warning_flags}")
endfunction ()

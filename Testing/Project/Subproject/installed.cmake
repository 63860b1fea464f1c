# Within another project, Relevo installs only its licence, not its pages.
file(REMOVE_RECURSE "${BUILD}/prefix")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${BUILD}/prefix"
  RESULT_VARIABLE result OUTPUT_QUIET)
file(GLOB_RECURSE pages RELATIVE "${BUILD}/prefix" "${BUILD}/prefix/share/doc/*")
if (NOT result EQUAL 0 OR NOT pages STREQUAL "share/doc/Relevo/LICENSE")
  message(FATAL_ERROR "cmake --install: exit code ${result}, installed pages: ${pages}")
endif ()

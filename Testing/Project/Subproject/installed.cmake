# Among the pages of the project, Relevo installs its licence alone.
file(REMOVE_RECURSE "${BUILD}/prefix")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${BUILD}/prefix"
  RESULT_VARIABLE result OUTPUT_QUIET)
file(GLOB_RECURSE pages RELATIVE "${BUILD}/prefix" "${BUILD}/prefix/share/doc/*")
if (NOT result EQUAL 0 OR NOT pages STREQUAL "share/doc/Relevo/LICENSE")
  message(FATAL_ERROR "--install left with ${result}, and installed these pages: ${pages}")
endif ()

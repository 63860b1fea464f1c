# relevo_add_cxx_tests(<executable>
#   TESTS [<folder>/]<TestName>...
#   LIBRARIES <module>...
#   [HELPERS <library>...]
#   [REPEATED [<folder>/]<TestName>...]
#   [LABELS <label>...])
#
# Builds one executable for all tests of a module and adds a CTest test for each of TESTS. REPEATED
# are tests of other modules, which relevo_repeat_cxx_tests adds. HELPERS are libraries of
# Testing/Cxx/Helpers. TestName.cxx defines
#   int TestName(int argc, char* argv[])
# which returns EXIT_SUCCESS, EXIT_FAILURE, or 125 to skip the test if a requirement is missing.
# Arguments and environment are those of VTK's tests:
#   -D <folder of test data in the repository>   -T <output folder>
#   -V <baseline image>                          RELEVO_TEST_DATA: folder of larger real data
function (relevo_add_cxx_tests executable)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "TESTS;REPEATED;HELPERS;LIBRARIES;LABELS")
  if (RELEVO_LEFT_OUT_TESTS)
    list(FILTER arg_TESTS EXCLUDE REGEX "(^|/)(${RELEVO_LEFT_OUT_TESTS})$")
  endif ()
  set(sources ${arg_TESTS} ${arg_REPEATED})
  list(TRANSFORM sources APPEND ".cxx")
  # The test driver calls functions, whose names have no folders.
  set(functions ${sources})
  list(TRANSFORM functions REPLACE "^.*/" "")
  create_test_sourcelist(driver "${executable}.cxx" ${functions})
  list(GET driver 0 driver)
  add_executable("${executable}" "${driver}" ${sources})
  target_link_libraries("${executable}" PRIVATE ${arg_HELPERS} ${arg_LIBRARIES})
  vtk_module_autoinit(TARGETS "${executable}" MODULES ${arg_LIBRARIES})
  relevo_precompile_test_headers("${executable}")
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS
    "${relevo_warning_flags};${relevo_test_flags}")
  foreach (test IN LISTS arg_TESTS)
    get_filename_component(test "${test}" NAME)
    relevo_add_cxx_test("${executable}" "${test}" "${test}" ${arg_LABELS})
  endforeach ()
endfunction ()

# relevo_add_cxx_test(<executable> <TestName> <name> [<label>...])
#
# Adds TestName of the executable as the CTest test <name>.
function (relevo_add_cxx_test executable test name)
  add_test(
    NAME    "${name}"
    COMMAND "${executable}" "${test}"
      -D "${relevo_test_input}"
      -T "${relevo_test_output}"
      -V "${relevo_test_baseline}/${test}.png")
  relevo_set_test_properties("${name}" ${ARGN})
  # For small windows, llvmpipe takes half the time if it compiles shaders without optimization.
  if ("Rendering" IN_LIST ARGN AND NOT relevo_optimize_shaders)
    set_property(TEST "${name}" APPEND PROPERTY ENVIRONMENT GALLIVM_PERF=nopt)
  endif ()
endfunction ()

# relevo_repeat_cxx_tests(<executable> SUFFIX <suffix> ENVIRONMENT <NAME=value>...
#   TESTS [<folder>/]<TestName>... [LABELS <label>...])
#
# Adds the tests again as TestName<suffix>, with an environment.
function (relevo_repeat_cxx_tests executable)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SUFFIX" "ENVIRONMENT;TESTS;LABELS")
  foreach (test IN LISTS arg_TESTS)
    get_filename_component(test "${test}" NAME)
    relevo_add_cxx_test("${executable}" "${test}" "${test}${arg_SUFFIX}" ${arg_LABELS})
    set_property(TEST "${test}${arg_SUFFIX}" APPEND PROPERTY ENVIRONMENT ${arg_ENVIRONMENT})
  endforeach ()
endfunction ()

# relevo_add_python_tests(TESTS <TestName>... [LABELS <label>...])
#
# Adds TestName.py, which uses unittest and exits with 125 to skip the test.
function (relevo_add_python_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "TESTS;LABELS")
  foreach (test IN LISTS arg_TESTS)
    add_test(
      NAME    "${test}"
      COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${test}.py"
        -D "${relevo_test_input}" -T "${relevo_test_output}"
        -V "${relevo_test_baseline}/${test}.png")
    relevo_set_test_properties("${test}" ${arg_LABELS})
  endforeach ()
endfunction ()

# relevo_set_test_properties(<test> [<label>...])
function (relevo_set_test_properties test)
  set(environment
    "RELEVO_TEST_DATA=${RELEVO_TEST_DATA}"
    "RELEVO_SOURCE_DIR=${PROJECT_SOURCE_DIR}"
    "RELEVO_BINARY_DIR=${PROJECT_BINARY_DIR}"
    "RELEVO_VERSION=${PROJECT_VERSION}"
    "PYTHONPATH=${PROJECT_BINARY_DIR}/${RELEVO_PYTHON_DESTINATION}")
  set_tests_properties("${test}" PROPERTIES
    ENVIRONMENT      "${environment}"
    LABELS           "${ARGN}"
    SKIP_RETURN_CODE 125
    TIMEOUT          600)
endfunction ()

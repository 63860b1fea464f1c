# Compiler settings shared by all targets. Flags that the compiler does not support are left out.

include(CheckCXXCompilerFlag)

# relevo_add_known_flags(<list> <flag>...) appends the flags that the compiler supports to the list.
function (relevo_add_known_flags list)
  set(flags ${${list}})
  foreach (flag IN LISTS ARGN)
    string(MAKE_C_IDENTIFIER "relevo_has${flag}" is_known)
    check_cxx_compiler_flag("${flag}" ${is_known})
    if (${is_known})
      list(APPEND flags "${flag}")
    endif ()
  endforeach ()
  set("${list}" "${flags}" PARENT_SCOPE)
endfunction ()

# Fused multiply-adds (a*b+c) would give a shared edge different bits on its two sides.
set(relevo_flags)
if (MSVC)
  relevo_add_known_flags(relevo_flags /fp:precise)
else ()
  relevo_add_known_flags(relevo_flags -ffp-contract=off)
endif ()
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:${relevo_flags}>)

# libFuzzer needs the coverage of all code.
if (RELEVO_BUILD_FUZZERS)
  if (NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "RELEVO_BUILD_FUZZERS needs clang. Set CMAKE_CXX_COMPILER to clang++.")
  endif ()
  if (NOT RELEVO_SANITIZE)
    set(RELEVO_SANITIZE address,undefined)
  endif ()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif ()

if (RELEVO_SANITIZE)
  set(CMAKE_REQUIRED_LINK_OPTIONS "-fsanitize=${RELEVO_SANITIZE}")
  string(MAKE_C_IDENTIFIER "relevo_can_sanitize_${RELEVO_SANITIZE}" can_sanitize)
  check_cxx_compiler_flag("-fsanitize=${RELEVO_SANITIZE}" ${can_sanitize})
  unset(CMAKE_REQUIRED_LINK_OPTIONS)
  if (NOT ${can_sanitize})
    message(FATAL_ERROR "The compiler does not support -fsanitize=${RELEVO_SANITIZE}. "
      "Set RELEVO_SANITIZE to supported sanitizers, for example address,undefined.")
  endif ()
  # With -g1, reports name functions and lines, and the build takes a third less time than with -g.
  add_compile_options(-fno-sanitize-recover=all -fsanitize=${RELEVO_SANITIZE}
    -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${RELEVO_SANITIZE})
  # A null pointer crashes anyway, and the address sanitizer finds objects that are too small. The
  # build takes half the time without these checks and those of alignment and of dynamic types, which
  # fuzz targets have.
  if (RELEVO_SANITIZE MATCHES "address" AND RELEVO_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=null,object-size)
    if (NOT RELEVO_BUILD_FUZZERS)
      add_compile_options(-fno-sanitize=alignment,vptr)
    endif ()
  endif ()
  # Modules must call their copies of inline functions, because those in tests have fewer checks.
  include(CheckLinkerFlag)
  check_linker_flag(CXX "-Wl,-Bsymbolic-functions" relevo_can_bind_functions)
  if (relevo_can_bind_functions)
    add_link_options("-Wl,-Bsymbolic-functions")
  endif ()
endif ()

# With these flags the sources of tests compile in half the time. Tests can do without optimization,
# and the address sanitizer finds errors of the modules whether or not it checks the tests.
set(relevo_test_flags)
if (RELEVO_SANITIZE MATCHES "address")
  set(relevo_test_flags -fno-sanitize=all -DRELEVO_HAS_ADDRESS_SANITIZER)
elseif (NOT MSVC)
  relevo_add_known_flags(relevo_test_flags -O1)
endif ()

set(relevo_warning_flags)
if (MSVC)
  relevo_add_known_flags(relevo_warning_flags /W3)
else ()
  relevo_add_known_flags(relevo_warning_flags -Wall -Wextra)
endif ()
if (RELEVO_WERROR AND MSVC)
  relevo_add_known_flags(relevo_warning_flags /WX)
elseif (RELEVO_WERROR)
  relevo_add_known_flags(relevo_warning_flags -Werror)
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 14 and later warn about impossible sizes in vtkSMPThreadLocal and std::vector<bool>.
    relevo_add_known_flags(relevo_warning_flags
      -Wno-error=array-bounds -Wno-error=stringop-overflow)
  endif ()
endif ()

# Compilers spend most of their time on VTK's headers. Precompiled headers and unity builds (several
# sources in one file) read them less often. A compiler cache works better without either.
set(shorten_by_default ON)
if (CMAKE_CXX_COMPILER_LAUNCHER)
  set(shorten_by_default OFF)
endif ()
option(RELEVO_PRECOMPILE_HEADERS "Precompile the headers that most sources include"
  ${shorten_by_default})
option(RELEVO_UNITY_BUILD "Compile several sources of a module at once" ${shorten_by_default})

# The headers take longer to compile than a source of a module, so all targets share two libraries
# of precompiled headers: one for position-independent code (modules), the other for executables and
# the static libraries of tests.
if (RELEVO_PRECOMPILE_HEADERS)
  set(relevo_precompiled_source "${CMAKE_CURRENT_BINARY_DIR}/RelevoPrecompiled.cxx")
  file(CONFIGURE OUTPUT "${relevo_precompiled_source}"
    CONTENT "// CMake needs a source to compile the headers.\n")
  foreach (relevo_library IN ITEMS RelevoPrecompiledModules RelevoPrecompiledExecutables)
    add_library(${relevo_library} OBJECT "${relevo_precompiled_source}")
    target_link_libraries(${relevo_library} PRIVATE VTK::CommonDataModel VTK::CommonExecutionModel)
    target_precompile_headers(${relevo_library} PRIVATE
      "$<$<COMPILE_LANGUAGE:CXX>:${CMAKE_CURRENT_SOURCE_DIR}/Module/CMake/RelevoPrecompiled.h>")
  endforeach ()
  set_target_properties(RelevoPrecompiledModules PROPERTIES POSITION_INDEPENDENT_CODE ON)
  if (RELEVO_SANITIZE) # for tests
    target_compile_options(RelevoPrecompiledExecutables PRIVATE ${relevo_test_flags})
  endif ()
endif ()

# relevo_precompile_headers(<target>) makes the target use the precompiled headers, if enabled.
function (relevo_precompile_headers target)
  if (NOT RELEVO_PRECOMPILE_HEADERS)
    return()
  endif ()
  get_target_property(type "${target}" TYPE)
  get_target_property(is_movable "${target}" POSITION_INDEPENDENT_CODE)
  if (type STREQUAL "SHARED_LIBRARY" OR is_movable)
    target_precompile_headers("${target}" REUSE_FROM RelevoPrecompiledModules)
  elseif (NOT RELEVO_SANITIZE)
    target_precompile_headers("${target}" REUSE_FROM RelevoPrecompiledExecutables)
  endif ()
endfunction ()

# relevo_precompile_test_headers(<target>) does that for an executable or a static library of tests,
# which are not sanitized.
function (relevo_precompile_test_headers target)
  if (RELEVO_SANITIZE)
    target_compile_options("${target}" PRIVATE ${relevo_test_flags})
  endif ()
  if (RELEVO_PRECOMPILE_HEADERS)
    target_precompile_headers("${target}" REUSE_FROM RelevoPrecompiledExecutables)
  endif ()
endfunction ()

# relevo_shorten_build(<target>) enables precompiled headers and a unity build. The sources of such
# a target need different names in their anonymous namespaces, so tests do not use it.
function (relevo_shorten_build target)
  relevo_precompile_headers("${target}")
  if (RELEVO_UNITY_BUILD)
    set_target_properties("${target}" PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
    if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # g++ treats included sources as headers and warns about their anonymous namespaces.
      target_compile_options("${target}" PRIVATE
        "$<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>")
    endif ()
  endif ()
endfunction ()

# relevo_enable_warnings(<target>) enables warnings for a module, but not for its generated
# wrappers.
function (relevo_enable_warnings target)
  target_compile_options("${target}" PRIVATE
    "$<$<COMPILE_LANGUAGE:CXX>:${relevo_warning_flags}>")
endfunction ()

# relevo_add_public_folders(<target> <folder>...) adds folders with public headers to the include
# path. Users include these headers without the folder, because all public headers are installed
# together.
function (relevo_add_public_folders target)
  foreach (folder IN LISTS ARGN)
    target_include_directories("${target}" PUBLIC
      "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>")
  endforeach ()
endfunction ()

# Compiler settings shared by every target of the project. A compiler gets no flag that it does not
# know.

include(CheckCXXCompilerFlag)

# relevo_add_known_flags(<list> <flag>...) appends the flags that the compiler knows to the list.
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

# Contracting a*b+c would give shared edges different bits on their two sides.
set(relevo_flags)
if (MSVC)
  relevo_add_known_flags(relevo_flags /fp:precise)
else ()
  relevo_add_known_flags(relevo_flags -ffp-contract=off)
endif ()
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:${relevo_flags}>)

if (RELEVO_SANITIZE)
  set(CMAKE_REQUIRED_LINK_OPTIONS "-fsanitize=${RELEVO_SANITIZE}")
  string(MAKE_C_IDENTIFIER "relevo_can_sanitize_${RELEVO_SANITIZE}" can_sanitize)
  check_cxx_compiler_flag("-fsanitize=${RELEVO_SANITIZE}" ${can_sanitize})
  unset(CMAKE_REQUIRED_LINK_OPTIONS)
  if (NOT ${can_sanitize})
    message(FATAL_ERROR "The compiler does not know -fsanitize=${RELEVO_SANITIZE}: "
      "set RELEVO_SANITIZE to sanitizers that it knows, for example address,undefined.")
  endif ()
  # -g1: reports name functions and lines, and the build takes a third less.
  add_compile_options(-fsanitize=${RELEVO_SANITIZE} -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${RELEVO_SANITIZE})
  # A module calls its own copies of inline functions, not those of a test that has fewer checks.
  include(CheckLinkerFlag)
  check_linker_flag(CXX "-Wl,-Bsymbolic-functions" relevo_can_bind_functions)
  if (relevo_can_bind_functions)
    add_link_options("-Wl,-Bsymbolic-functions")
  endif ()
endif ()

# Flags of the tests' own sources, which compile in half the time with them. The processor finds null
# pointers, and the address sanitizer objects that are too small; modules are checked for all.
set(relevo_test_flags)
if (RELEVO_SANITIZE MATCHES "undefined")
  set(relevo_test_flags -fno-sanitize=null,alignment,object-size,vptr)
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
    # From version 14 on, g++'s optimiser warns of impossible sizes in vtkSMPThreadLocal and std::vector<bool>.
    relevo_add_known_flags(relevo_warning_flags
      -Wno-error=array-bounds -Wno-error=stringop-overflow)
  endif ()
endif ()

# Compilers spend most of their time on VTK's headers. Precompiled headers and unity builds (several
# sources in one file) read them less often. A compiler cache works better without both.
set(shorten_by_default ON)
if (CMAKE_CXX_COMPILER_LAUNCHER)
  set(shorten_by_default OFF)
endif ()
option(RELEVO_PRECOMPILE_HEADERS "Precompile the headers that most sources include"
  ${shorten_by_default})
option(RELEVO_UNITY_BUILD "Compile several sources of a module at once" ${shorten_by_default})

# Libraries that hold nothing but the precompiled headers: one for the modules, whose code does not
# depend on its position, one for executables and the static libraries of tests. The headers take
# longer to compile than a module's source, so each target of the two kinds uses one of them again.
if (RELEVO_PRECOMPILE_HEADERS)
  set(relevo_precompiled_source "${CMAKE_CURRENT_BINARY_DIR}/RelevoPrecompiled.cxx")
  file(CONFIGURE OUTPUT "${relevo_precompiled_source}"
    CONTENT "// The headers are compiled for this.\n")
  foreach (relevo_library IN ITEMS RelevoPrecompiledModules RelevoPrecompiledExecutables)
    add_library(${relevo_library} OBJECT "${relevo_precompiled_source}")
    target_link_libraries(${relevo_library} PRIVATE VTK::CommonDataModel VTK::CommonExecutionModel)
    target_precompile_headers(${relevo_library} PRIVATE
      "$<$<COMPILE_LANGUAGE:CXX>:${CMAKE_CURRENT_SOURCE_DIR}/Module/CMake/RelevoPrecompiled.h>")
  endforeach ()
  set_target_properties(RelevoPrecompiledModules PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif ()

# relevo_precompile_headers(<target>): where that is wanted.
function (relevo_precompile_headers target)
  if (NOT RELEVO_PRECOMPILE_HEADERS)
    return()
  endif ()
  get_target_property(type "${target}" TYPE)
  get_target_property(is_movable "${target}" POSITION_INDEPENDENT_CODE)
  if (type STREQUAL "SHARED_LIBRARY" OR is_movable)
    target_precompile_headers("${target}" REUSE_FROM RelevoPrecompiledModules)
  else ()
    target_precompile_headers("${target}" REUSE_FROM RelevoPrecompiledExecutables)
  endif ()
endfunction ()

# relevo_shorten_build(<target>): precompiled headers and unity builds. Sources of such a target have
# different names in their anonymous namespaces, so this is not for tests.
function (relevo_shorten_build target)
  relevo_precompile_headers("${target}")
  if (RELEVO_UNITY_BUILD)
    set_target_properties("${target}" PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
    if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # g++ takes included sources for headers, where anonymous namespaces would be a mistake.
      target_compile_options("${target}" PRIVATE
        "$<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>")
    endif ()
  endif ()
endfunction ()

# relevo_enable_warnings(<target>): for a module. Generated wrappers are other targets.
function (relevo_enable_warnings target)
  target_compile_options("${target}" PRIVATE
    "$<$<COMPILE_LANGUAGE:CXX>:${relevo_warning_flags}>")
endfunction ()

# relevo_add_public_folders(<target> <folder>...): folders of a module with headers of public
# classes, which installed headers keep beside those of the module's own folder.
function (relevo_add_public_folders target)
  foreach (folder IN LISTS ARGN)
    target_include_directories("${target}" PUBLIC
      "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>")
  endforeach ()
endfunction ()

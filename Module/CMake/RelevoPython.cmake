# Finds the Python that VTK's own package was built for, before VTK looks for one: the first
# python3 in PATH may be a different one, without vtkmodules. Sets Python3_EXECUTABLE.

if (NOT Python3_EXECUTABLE)
  foreach (candidate IN ITEMS /usr/bin/python3 python3)
    execute_process(
      COMMAND         "${candidate}" -c "import vtkmodules.vtkCommonCore, sys; print(sys.executable)"
      OUTPUT_VARIABLE executable
      RESULT_VARIABLE result
      ERROR_QUIET
      OUTPUT_STRIP_TRAILING_WHITESPACE)
    if (result EQUAL 0)
      set(Python3_EXECUTABLE "${executable}" CACHE FILEPATH "The Python that has vtkmodules")
      break ()
    endif ()
  endforeach ()
endif ()

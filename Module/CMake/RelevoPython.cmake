# Finds the Python that the VTK in use was built for, before VTK looks for one: the first python3 in
# PATH may be a different one, without vtkmodules or with those of another VTK. Sets
# Python3_EXECUTABLE, in the cache where that is Relevo's own.

if (NOT Python3_EXECUTABLE)
  foreach (candidate IN ITEMS "${VTK_PREFIX_PATH}/bin/python3" python3 /usr/bin/python3)
    execute_process(
      COMMAND         "${candidate}" -c "import sys
from vtkmodules.vtkCommonCore import vtkVersion
print(vtkVersion.GetVTKVersion(), sys.executable, sep=';')"
      OUTPUT_VARIABLE found
      RESULT_VARIABLE result
      ERROR_QUIET
      OUTPUT_STRIP_TRAILING_WHITESPACE)
    if (NOT result EQUAL 0)
      continue ()
    endif ()
    list(GET found 0 version)
    list(GET found 1 executable)
    if (NOT version VERSION_EQUAL VTK_VERSION)
      message(STATUS "${executable} has VTK ${version}, not ${VTK_VERSION}: it is not used")
    elseif (relevo_is_whole)
      set(Python3_EXECUTABLE "${executable}" CACHE FILEPATH "The Python of the VTK in use")
      break ()
    else ()
      set(Python3_EXECUTABLE "${executable}")
      break ()
    endif ()
  endforeach ()
endif ()

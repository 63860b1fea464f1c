# Finds the Python that VTK was built for, and sets Python3_EXECUTABLE before VTK looks for a
# Python. The first python3 in PATH may have no vtkmodules, or those of another VTK. The cache entry
# is set only if Relevo is the top-level project.

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
      message(STATUS "${executable} is not used: it has VTK ${version}, not ${VTK_VERSION}")
    elseif (relevo_is_whole)
      set(Python3_EXECUTABLE "${executable}" CACHE FILEPATH "The Python that VTK was built for")
      break ()
    else ()
      set(Python3_EXECUTABLE "${executable}")
      break ()
    endif ()
  endforeach ()
endif ()

# SPDX-License-Identifier: GPL-3.0-or-later
# Sets HOBE_PYTHON to a Python that can run the generator.  The first python3 in PATH is often one
# without sympy (a virtual environment, pyenv), so all of them are asked.

set(_advice "install one with: apt-get install python3-sympy (Python 3.11 or newer)")
set(_ask "import sys, sympy, tomllib; print(sys.executable)")

if(HOBE_PYTHON)
  set(_candidates ${HOBE_PYTHON})
else()
  string(REPLACE ":" ";" _candidates "$ENV{PATH}:/usr/bin")
  list(TRANSFORM _candidates APPEND "/python3")
endif()

set(_found "")
foreach(_python IN LISTS _candidates)
  if(EXISTS ${_python})
    # sys.executable, since a pyenv shim means another Python in another directory.
    execute_process(COMMAND ${_python} -c "${_ask}" RESULT_VARIABLE _failed
                    OUTPUT_VARIABLE _found ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT _failed)
      break()
    endif()
    set(_found "")
  endif()
endforeach()

if(_found)
  set_property(CACHE HOBE_PYTHON PROPERTY VALUE ${_found})
  set(GeneratorPython_FOUND TRUE)
elseif(HOBE_PYTHON)
  message(FATAL_ERROR "HOBE_PYTHON=${HOBE_PYTHON} cannot import sympy and tomllib; ${_advice}.")
else()
  message(FATAL_ERROR "No python3 in PATH can import sympy and tomllib; ${_advice}.")
endif()

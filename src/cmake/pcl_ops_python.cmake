# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Sets PCL_OPS_PYTHON, the Python that the module is built for, unless it is given: the first that
# has NumPy of Python3_EXECUTABLE, if that is given, the first on the PATH, and that of the system.
# With pyenv and the like the last two differ. Debian packages are for that of the system.
function(pcl_ops_choose_python)
  if(PCL_OPS_PYTHON)
    return()
  endif()
  find_program(PCL_OPS_PYTHON_ON_PATH NAMES python3)
  mark_as_advanced(PCL_OPS_PYTHON_ON_PATH)
  set(candidates ${Python3_EXECUTABLE} ${PCL_OPS_PYTHON_ON_PATH} /usr/bin/python3)
  if(PCL_OPS_DEBIAN_PACKAGES)
    set(candidates /usr/bin/python3)
  endif()
  foreach(python ${candidates})
    execute_process(COMMAND ${python} -c "import numpy"
      RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
    if(result EQUAL 0)
      set(PCL_OPS_PYTHON "${python}" CACHE FILEPATH
        "The Python interpreter the module is built for; it has to have NumPy" FORCE)
      return()
    endif()
  endforeach()
endfunction()

# Sets PCL_OPS_PYTHON_INSTALL_DIR, where that Python looks for packages below the prefix.
function(pcl_ops_choose_python_install_dir)
  execute_process(COMMAND ${Python3_EXECUTABLE} -c
      "import os, sysconfig; print(os.path.basename(sysconfig.get_path('platlib')))"
    OUTPUT_VARIABLE packages OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(version ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})
  # Debian's Python has the folder dist-packages below /usr and /usr/local only; below other
  # prefixes, as of colcon and venv, it is site-packages.
  if(packages STREQUAL "dist-packages" AND NOT CMAKE_INSTALL_PREFIX MATCHES "^/usr(/local)?/?$")
    set(packages site-packages)
  endif()
  # Below /usr all versions of Python 3 of Debian share one folder.
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr" AND packages STREQUAL "dist-packages")
    set(version ${Python3_VERSION_MAJOR})
  endif()
  # The Debian package is for this version only.
  set(PCL_OPS_PYTHON_VERSION ${Python3_VERSION} CACHE INTERNAL "")
  set(PCL_OPS_PYTHON_INSTALL_DIR lib/python${version}/${packages} CACHE STRING
    "Where the Python module is installed, below the prefix")
endfunction()

# Finds Python and pybind11. Sets result to the reason why the module cannot be built; empty
# if it can.
macro(pcl_ops_find_python result)
  set(${result} "")
  if(NOT PCL_OPS_BUILD_PYTHON)
    set(${result} "PCL_OPS_BUILD_PYTHON is OFF")
  elseif(PCL_OPS_SANITIZE)
    set(${result} "Python itself is built without sanitizers")
  else()
    pcl_ops_choose_python()
    set(Python3_EXECUTABLE ${PCL_OPS_PYTHON})
    if(PCL_OPS_PYTHON)
      find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module)
      # The folder of a pybind11 that pip has installed.
      execute_process(COMMAND ${PCL_OPS_PYTHON} -m pybind11 --cmakedir
        OUTPUT_VARIABLE pips_pybind11 OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    endif()
    if(Python3_FOUND)
      find_package(pybind11 2.9 CONFIG QUIET HINTS ${pips_pybind11})
    endif()
    if(NOT PCL_OPS_PYTHON)
      set(${result} "no Python with NumPy was found; name one by PCL_OPS_PYTHON")
    elseif(NOT Python3_FOUND)
      set(${result} "the headers of ${PCL_OPS_PYTHON} were not found")
    elseif(NOT pybind11_FOUND)
      set(${result} "pybind11 was not found")
    else()
      pcl_ops_choose_python_install_dir()
    endif()
  endif()
endmacro()

# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# The Python a module is built for: the first on the PATH that has NumPy, else that of the
# system, which is not the first where others manage versions of Python.
function(pcl_ops_choose_python)
  if(PCL_OPS_PYTHON)
    return()
  endif()
  set(found "")
  find_program(pcl_ops_python_on_path NAMES python3 NO_CACHE)
  # A package is for the Python of the system.
  if(PCL_OPS_DEBIAN_PACKAGES)
    unset(pcl_ops_python_on_path)
  endif()
  foreach(python ${Python3_EXECUTABLE} ${pcl_ops_python_on_path} /usr/bin/python3)
    execute_process(COMMAND ${python} -c "import numpy"
      RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
    if(result EQUAL 0)
      set(found ${python})
      break()
    endif()
  endforeach()
  set(PCL_OPS_PYTHON "${found}" CACHE FILEPATH
    "The Python interpreter the module is built for; it has to have NumPy" FORCE)
endfunction()

# Where that Python looks for packages below the install prefix.
function(pcl_ops_choose_python_install_dir)
  execute_process(COMMAND ${Python3_EXECUTABLE} -c
      "import os, sysconfig; print(os.path.basename(sysconfig.get_path('platlib')))"
    OUTPUT_VARIABLE packages OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(version ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})
  # Debian's packages are those of all its versions of Python 3.
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr" AND packages STREQUAL "dist-packages")
    set(version ${Python3_VERSION_MAJOR})
  endif()
  # For the Debian package, which is of this version only.
  set(PCL_OPS_PYTHON_VERSION ${Python3_VERSION} CACHE INTERNAL "")
  set(PCL_OPS_PYTHON_INSTALL_DIR lib/python${version}/${packages} CACHE STRING
    "Where the Python module is installed, below the prefix")
endfunction()

# Finds Python and pybind11; what keeps the module from being built is in result, if
# anything does.
macro(pcl_ops_find_python result)
  set(${result} "")
  pcl_ops_choose_python()
  if(NOT PCL_OPS_BUILD_PYTHON)
    set(${result} "PCL_OPS_BUILD_PYTHON is OFF")
  elseif(PCL_OPS_SANITIZE)
    set(${result} "Python itself is built without sanitizers")
  elseif(NOT BUILD_SHARED_LIBS)
    set(${result} "it needs the shared library")
  elseif(NOT PCL_OPS_PYTHON)
    set(${result} "no Python with NumPy was found; name one by PCL_OPS_PYTHON")
  else()
    set(Python3_EXECUTABLE ${PCL_OPS_PYTHON})
    find_package(Python3 3.7 QUIET COMPONENTS Interpreter Development.Module)
    if(Python3_FOUND)
      find_package(pybind11 2.9 CONFIG QUIET)
    endif()
    if(NOT Python3_FOUND)
      set(${result} "the headers of ${PCL_OPS_PYTHON} were not found")
    elseif(NOT pybind11_FOUND)
      set(${result} "pybind11 was not found")
    else()
      pcl_ops_choose_python_install_dir()
    endif()
  endif()
endmacro()

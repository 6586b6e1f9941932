# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Fails if the library pcl_ops_core refers to a symbol of PCL's libraries, or if the Python module
# (if MODULE is given) loads other libraries than those of C and C++.
# cmake -DNM=nm -DCORE=libpcl_ops_core.a [-DMODULE=_pcl_ops.so] -P needs_no_pcl.cmake
cmake_minimum_required(VERSION 3.16)

# lines_of(result COMMAND...): runs a command and sets result to the list of its output's lines.
function(lines_of result)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} failed")
  endif()
  string(REPLACE ";" "," output "${output}")
  string(REPLACE "\n" ";" output "${output}")
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

lines_of(undefined_symbols ${NM} -uC ${CORE})
if(NOT undefined_symbols)
  message(FATAL_ERROR "nm finds no undefined symbols in ${CORE}, not even those of C++")
endif()
list(FILTER undefined_symbols INCLUDE REGEX "U ((non-virtual )?thunk to |vtable for |typeinfo for )?pcl::")
if(undefined_symbols)
  list(JOIN undefined_symbols "\n" undefined_symbols)
  message(FATAL_ERROR "the core needs PCL's libraries:\n${undefined_symbols}")
endif()

if(MODULE)
  lines_of(loaded_libraries ldd ${MODULE})
  list(FILTER loaded_libraries EXCLUDE REGEX "^$|linux-vdso|ld-linux|lib(c|m|stdc\\+\\+|gcc_s|pthread)\\.so")
  if(loaded_libraries)
    list(JOIN loaded_libraries "\n" loaded_libraries)
    message(FATAL_ERROR "the Python module loads:\n${loaded_libraries}")
  endif()
endif()

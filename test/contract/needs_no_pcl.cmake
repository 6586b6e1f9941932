# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Fails if the core calls a function of PCL's libraries, or if the Python module (if there is one)
# loads other libraries than those of C and C++.
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

lines_of(undefined ${NM} -uC ${CORE})
list(FILTER undefined INCLUDE REGEX "U ((non-virtual )?thunk to |vtable for |typeinfo for )?pcl::")
if(undefined)
  list(JOIN undefined "\n" undefined)
  message(FATAL_ERROR "the core needs PCL's libraries:\n${undefined}")
endif()

if(MODULE)
  lines_of(loaded ldd ${MODULE})
  list(FILTER loaded EXCLUDE REGEX "^$|linux-vdso|ld-linux|lib(c|m|stdc\\+\\+|gcc_s|pthread)\\.so")
  if(loaded)
    list(JOIN loaded "\n" loaded)
    message(FATAL_ERROR "the Python module loads:\n${loaded}")
  endif()
endif()

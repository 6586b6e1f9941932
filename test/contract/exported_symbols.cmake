# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Fails if a shared library exports a name in pcl_ops that no public header declares: each part of
# the name has to be a word of some header.
# cmake -DNM=nm -DLIBRARY=libpcl_ops.so -DHEADERS=include/pcl_ops -P exported_symbols.cmake
cmake_minimum_required(VERSION 3.16)

file(GLOB_RECURSE headers ${HEADERS}/*.h ${HEADERS}/*.hpp)
set(declared "")
foreach(header ${headers})
  file(READ ${header} text)
  string(APPEND declared "${text}")
endforeach()

execute_process(COMMAND ${NM} -DC --defined-only ${LIBRARY}
  OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "nm cannot read ${LIBRARY}")
endif()

# Square brackets and semicolons have a meaning in CMake's lists. Braces stand for lambdas and
# unnamed types.
string(REGEX REPLACE "\\[[^]\n]*\\]|;" "" symbols "${symbols}")
string(REGEX REPLACE "::{[^}\n]*}" "" symbols "${symbols}")
# Remove template arguments and parameters, from the inside out; only names remain.
set(before "")
while(NOT symbols STREQUAL before)
  set(before "${symbols}")
  string(REGEX REPLACE "<[^<>\n]*>|\\([^()\n]*\\)" "" symbols "${symbols}")
endwhile()
string(REGEX MATCHALL "pcl_ops::[^\n]*" names "${symbols}")
list(REMOVE_DUPLICATES names)
list(LENGTH names number)
if(number EQUAL 0)
  message(FATAL_ERROR "${LIBRARY} exports nothing of pcl_ops")
endif()

set(undeclared "")
foreach(name ${names})
  string(REGEX REPLACE "^pcl_ops::| .*$|operator.*$" "" path "${name}")
  string(REGEX MATCHALL "[A-Za-z0-9_]+" parts "${path}")
  foreach(part ${parts})
    if(part STREQUAL "internal" OR NOT declared MATCHES "[^A-Za-z0-9_]${part}[^A-Za-z0-9_]")
      list(APPEND undeclared ${name})
      break()
    endif()
  endforeach()
endforeach()
if(undeclared)
  list(JOIN undeclared "\n  " undeclared)
  message(FATAL_ERROR "exported, but in no public header:\n  ${undeclared}")
endif()
message(STATUS "${number} names, all in public headers")

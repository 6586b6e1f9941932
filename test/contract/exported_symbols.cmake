# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Fails if a shared library exports a name in pcl_ops that no public header declares. Each part of
# the name, as a and b of pcl_ops::a::b, has to occur as a word in some public header.
# cmake -DNM=nm -DLIBRARY=libpcl_ops.so -DHEADERS=include/pcl_ops -P exported_symbols.cmake
cmake_minimum_required(VERSION 3.16)

file(GLOB_RECURSE headers ${HEADERS}/*.h ${HEADERS}/*.hpp)
set(text_of_headers "")
foreach(header ${headers})
  file(READ ${header} text)
  string(APPEND text_of_headers "${text}")
endforeach()

execute_process(COMMAND ${NM} -DC --defined-only ${LIBRARY}
  OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "nm cannot read ${LIBRARY}")
endif()

# Square brackets and semicolons are removed: they have a meaning in CMake's lists. Parts in braces
# are removed, too: nm writes them for lambdas and unnamed types.
string(REGEX REPLACE "\\[[^]\n]*\\]|;" "" symbols "${symbols}")
string(REGEX REPLACE "::{[^}\n]*}" "" symbols "${symbols}")
# Template arguments and parameters are removed, the innermost first, until only names remain.
set(previous_symbols "")
while(NOT symbols STREQUAL previous_symbols)
  set(previous_symbols "${symbols}")
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
    if(part STREQUAL "internal" OR NOT text_of_headers MATCHES "[^A-Za-z0-9_]${part}[^A-Za-z0-9_]")
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

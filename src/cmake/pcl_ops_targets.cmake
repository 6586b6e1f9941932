# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Sets how a target of the project is compiled and linked.
function(pcl_ops_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-Wall -Wextra -Wpedantic>)
  # Clang 19 warns of a call within std::stable_sort of libstdc++ 12. Deprecated calls of the
  # project itself are found by g++.
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANG_AND_ID:CXX,Clang>:-Wno-deprecated-declarations>)
  # MPL of Boost 1.74 casts to values that an enumeration lacks.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^1[6-9]\\.")
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANGUAGE:CXX>:-Wno-enum-constexpr-conversion>)
  endif()
  if(PCL_OPS_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-Werror>)
  endif()
  if(CMAKE_UNITY_BUILD)
    # In a unity build an unnamed namespace of a source looks like one of a header.
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
  endif()
  # Links only the libraries that are called: PCL's targets bring many more, and loading them
  # takes longer than the detection.
  if(UNIX AND NOT APPLE)
    target_link_options(${target} PRIVATE LINKER:--as-needed)
  endif()
  if(PCL_OPS_SANITIZE)
    target_compile_options(${target} PRIVATE
      -fsanitize=${PCL_OPS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${PCL_OPS_SANITIZE})
    # Under a sanitizer Eigen aligns allocations by hand, which PCL's own binary, built
    # without one, frees in another way.
    target_compile_definitions(${target} PRIVATE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  endif()
endfunction()

# Turns off fused multiplications and additions: some compilers use them and others do not,
# and with the other rounding points at the edge of a plane would change sides.
function(pcl_ops_round_alike target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>)
endfunction()

# Adds a program of the project and its manual page, installed as part of a component:
# pcl_ops_add_program(name sources... SUMMARY line LINK libraries... [COMPONENT tools])
function(pcl_ops_add_program name)
  cmake_parse_arguments(ARG "" "SUMMARY;COMPONENT" "LINK" ${ARGN})
  if(NOT ARG_COMPONENT)
    set(ARG_COMPONENT tools)
  endif()
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  pcl_ops_target_defaults(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  target_compile_definitions(${name} PRIVATE PCL_OPS_VERSION="${PROJECT_VERSION}")
  # Installed programs find the library beside them, wherever the prefix is.
  file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin
    INSTALL_RPATH "$ORIGIN/${bin_to_lib}"
    INSTALL_RPATH_USE_LINK_PATH ON)
  install(TARGETS ${name}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${ARG_COMPONENT})
  pcl_ops_add_manual_page(${name} "${ARG_SUMMARY}" ${ARG_COMPONENT})
endfunction()

# Compiles a test with less optimization, in half the time, as tests are compiled more often
# than they are run.
function(pcl_ops_compile_quickly target)
  set(is_known "$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>")
  target_compile_options(${target} PRIVATE "$<$<AND:$<CONFIG:Release>,${is_known}>:-O1>")
  # At -O1 GCC gives this warning falsely for Boost's templates.
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-maybe-uninitialized>)
endfunction()

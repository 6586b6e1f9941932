// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/** \brief Compiles a function a second time for wider vectors, and takes that where the
 * processor has them. Neither version fuses multiplications with additions or reorders
 * sums: both give the same digits. Sanitizers do not cope with functions that are
 * chosen when the library is loaded, and GCC exports them, unless they are in an
 * unnamed namespace: that is where such functions belong. Defined empty by the
 * compiler's command line it leaves the second version out. */
#ifndef PCL_OPS_VECTORIZED
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) &&              \
    !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&                           \
    !defined(__SANITIZE_THREAD__)
#define PCL_OPS_VECTORIZED __attribute__ ((target_clones ("avx2", "default")))
#else
#define PCL_OPS_VECTORIZED
#endif
#endif

// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/** \brief Attribute that compiles a function twice: for the default target and for
 * AVX2. The loader picks AVX2 if the processor has it. Neither version fuses
 * multiplications with additions or reorders sums: both give the same results to the
 * last bit. Put the function into an unnamed namespace, else GCC exports it. The
 * attribute is empty except for GCC on x86-64 GNU/Linux without the address or thread
 * sanitizer: the sanitizers do not cope with functions that the loader picks. Define
 * the macro as empty to build without AVX2. */
#ifndef PCL_OPS_VECTORIZED
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) &&              \
    !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&                           \
    !defined(__SANITIZE_THREAD__)
#define PCL_OPS_VECTORIZED __attribute__ ((target_clones ("avx2", "default")))
#else
#define PCL_OPS_VECTORIZED
#endif
#endif

#pragma once

/** \file
 * GR2TO_VECTORISED before a function of plain loops: the compiler makes a second version of it for processors
 * with AVX2, and the program picks one when it starts. Both give the same results bit for bit. Not under the
 * sanitizers, which are not ready when the choice is made, nor with compilers and processors that lack it.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define GR2TO_VECTORISED __attribute__((target_clones("avx2", "default")))
#else
#define GR2TO_VECTORISED
#endif

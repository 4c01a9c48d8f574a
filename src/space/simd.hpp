// How hot loops are compiled: for x86-64 and x86-64-v3, picked at start. Contraction is off, so both give the same
// bits.
#pragma once

// Sanitizers instrument the resolver that picks a version before they are set up, so they get one version only.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ALATE_SIMD __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define ALATE_SIMD
#endif

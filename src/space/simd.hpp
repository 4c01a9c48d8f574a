// How hot loops are compiled, and the arrays they run over.
//
// For x86-64, x86-64-v3 (AVX2) and x86-64-v4 (AVX-512), picked at start. Contraction is off, and sums run in kLanes
// partial sums whatever the width of the registers, so all three give the same bits.
#pragma once

#include <boost/align/aligned_allocator.hpp>
#include <cstddef>
#include <vector>

// Sanitizers instrument the resolver that picks a version before they are set up, so they get one version only.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ALATE_SIMD __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define ALATE_SIMD
#endif

namespace alate {

inline constexpr std::size_t kSimdBytes = 64;
template <class Value>
using AlignedVector = std::vector<Value, boost::alignment::aligned_allocator<Value, kSimdBytes>>;
using AlignedDoubles = AlignedVector<double>;
using AlignedFloats = AlignedVector<float>;

/// Floats in the widest register.
inline constexpr std::size_t kLanes = kSimdBytes / sizeof(float);

/// Length of arrays of `count` floats that vector loops can run over without a rest.
constexpr std::size_t padded_size(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

/// Length of an array; said of floats so that the compiler knows there is no rest.
inline std::size_t whole(const AlignedFloats& array) { return array.size() & ~(kLanes - 1); }
inline std::size_t whole(const AlignedDoubles& array) { return array.size(); }

/// The elements, said so that the compiler knows they are aligned.
template <class Value>
const Value* aligned(const AlignedVector<Value>& array) {
  return static_cast<const Value*>(__builtin_assume_aligned(array.data(), kSimdBytes));
}
template <class Value>
Value* aligned(AlignedVector<Value>& array) {
  return static_cast<Value*>(__builtin_assume_aligned(array.data(), kSimdBytes));
}

template <class Body, class... Values>
[[gnu::always_inline]] inline void loop_over(std::size_t count, Body body, Values*... arrays) {
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
  for (std::size_t k = 0; k < count; ++k) body(arrays[k]...);
}

/// body(array[k]...) for all k: the loop of every kernel. Arrays are as long as the first, and none is given twice, so
/// that the compiler may be told that no turn depends on another. Inlined into functions that are compiled thrice. What
/// `body` knows it holds by value: a reference could be changed by what it writes.
template <class Body, class First, class... Rest>
[[gnu::always_inline]] inline void for_each_lane(Body body, First& first, Rest&... rest) {
  loop_over(whole(first), body, aligned(first), aligned(rest)...);
}

}  // namespace alate

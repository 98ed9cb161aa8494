// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion {

/// Asks for the line of memory with `address`, which will be read soon. Nothing waits for it, and
/// nothing else happens.
inline void prefetch_line(const void* address) {
#if defined(__x86_64__)
  // GCC takes calls of functions that hold nothing but its __builtin_prefetch for calls without
  // effect, and leaves them out.
  asm volatile("prefetcht0 %0" : : "m"(*static_cast<const char*>(address)));
#elif defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

/// Asks for the memory from `begin` to `end`.
inline void prefetch(const void* begin, const void* end) {
  constexpr int line = 64;
  for (const char* p = static_cast<const char*>(begin); p < static_cast<const char*>(end);
       p += line) {
    prefetch_line(p);
  }
}

/// Asks for an object.
template <class T>
void prefetch(const T& item) {
  prefetch(&item, &item + 1);
}

/// Asks for the first and the last of some numbers, wherever in a line they begin or
/// end; with more than 16 of them there are others between, which are not asked for.
inline void prefetch_numbers(const double* numbers, int count) {
  prefetch_line(numbers);
  prefetch_line(numbers + count - 1);
}

}  // namespace cohesion

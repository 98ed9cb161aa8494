// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::hard_sphere {

/// Asks for the memory from `begin` to `end`, which will be read soon. Nothing waits for it, and
/// nothing else happens.
inline void prefetch(const void* begin, const void* end) {
  constexpr int line = 64;
  for (const char* p = static_cast<const char*>(begin); p < static_cast<const char*>(end);
       p += line) {
#if defined(__x86_64__)
    // GCC takes calls of functions that hold nothing but its __builtin_prefetch for calls without
    // effect, and leaves them out.
    asm volatile("prefetcht0 %0" : : "m"(*p));
#elif defined(__GNUC__)
    __builtin_prefetch(p);
#endif
  }
}

/// The same for an object.
template <class T>
void prefetch(const T& item) {
  prefetch(&item, &item + 1);
}

}  // namespace cohesion::hard_sphere

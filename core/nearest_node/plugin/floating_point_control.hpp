// SPDX-License-Identifier: MIT
// How this thread computes: what code from outside may change behind our back, and must not.
#pragma once

#include <fpu_control.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace phytobench {

/// The control bits of a thread's floating-point environment: rounding, what becomes of denormal
/// numbers, which exceptions are signals. Not the flags, which any division may set. Reading them
/// takes a few nanoseconds.
class FloatingPointControl {
 public:
  /// As they are now, in this thread.
  FloatingPointControl() {
    _FPU_GETCW(word_);
#ifdef __SSE__
    vectors_ = _mm_getcsr() & ~flags;
#endif
  }

  /// Whether this thread still computes so.
  bool is_in_force() const {
    const FloatingPointControl now;
    return now.word_ == word_ && now.vectors_ == vectors_;
  }

  void restore() const {
    fpu_control_t word = word_;
    _FPU_SETCW(word);
#ifdef __SSE__
    _mm_setcsr((_mm_getcsr() & flags) | vectors_);
#endif
  }

 private:
  static constexpr unsigned int flags = 0x3f;  ///< of MXCSR: exceptions that have happened

  fpu_control_t word_ = 0;    ///< of x87 on x86, the only one elsewhere
  unsigned int vectors_ = 0;  ///< MXCSR: rounding, masks, flush-to-zero, denormals-are-zero
};

}  // namespace phytobench

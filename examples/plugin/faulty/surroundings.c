/* SPDX-License-Identifier: MIT */
/* Every answer is right, but something that is not the engine's own is not left as it was; a
 * definition says what. */
#define _POSIX_C_SOURCE 200809L /* close() */
#include <fenv.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif
#ifdef CLOSES_FILES
#include <unistd.h>
#endif

#include "faulty.h"

#ifdef ROUNDS_WHEN_LOADED
__attribute__((constructor)) static void round_upward_at_once(void) {
  fesetround(FE_UPWARD);
}
#endif

static void* create_and_change(const phytobench_vector* points, int32_t count,
                               const phytobench_setup* setup) {
#ifdef FLUSHES_DENORMALS
#ifdef __SSE__
  _mm_setcsr(_mm_getcsr() | 0x8040u); /* flush to zero, denormals are zero */
#else
  fesetround(FE_TOWARDZERO);
#endif
#endif
  return create(points, count, setup);
}

static int32_t associate_and_change(void* engine, const phytobench_node* new_nodes, int32_t count,
                                    int32_t* nearest) {
  const int32_t result = associate(engine, new_nodes, count, nearest);
#ifdef ROUNDS_UPWARD
  fesetround(FE_UPWARD);
#endif
  return result;
}

static void destroy_and_change(void* engine) {
  destroy(engine);
#if defined(ROUNDS_AT_THE_END)
  fesetround(FE_UPWARD);
#elif defined(CLOSES_FILES)
  for (int descriptor = 3; descriptor < 256; ++descriptor) close(descriptor);
#endif
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("surroundings");
  table.create = create_and_change;
  table.associate = associate_and_change;
  table.destroy = destroy_and_change;
  return &table;
}

/* SPDX-License-Identifier: MIT */
/* Right on small trees, and so through its trial; a definition says what happens on larger ones. */
#include <signal.h>

#include "faulty.h"

static void* create_small(const phytobench_vector* points, int32_t count,
                          const phytobench_setup* setup) {
  if (count > 4000) {
#ifdef LATE_CRASH
    raise(SIGSEGV);
#endif
    return NULL;
  }
  return create(points, count, setup);
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("late");
  table.create = create_small;
  return &table;
}

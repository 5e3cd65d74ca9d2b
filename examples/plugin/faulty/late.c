/* SPDX-License-Identifier: MIT */
/* Right on small trees, and so through its trial; a definition says what happens on larger ones:
 * at once, or only when they are timed, after they were grown to be checked and to count memory. */
#include <signal.h>

#include "faulty.h"

static int large_engines = 0; /* so far */

static void* create_small(const phytobench_vector* points, int32_t count,
                          const phytobench_setup* setup) {
  if (count > 4000) {
    ++large_engines;
#if defined(LATE_CRASH)
    raise(SIGSEGV);
#elif defined(LATE_FAILURE)
    return NULL;
#elif defined(DIES_WHEN_TIMED)
    if (large_engines > 2) raise(SIGSEGV);
#endif
  }
  return create(points, count, setup);
}

#ifdef CHANGES_WHEN_TIMED
static int32_t forget_every_other(void* engine, const phytobench_node* new_nodes, int32_t count,
                                  int32_t* nearest) {
  const scan* self = (const scan*)engine;
  const int32_t result = associate(engine, new_nodes, count, nearest);
  if (self->point_count > 4000 && large_engines > 2)
    for (int32_t i = 0; i < self->point_count; i += 2) nearest[i] = PHYTOBENCH_NO_NODE;
  return result;
}
#endif

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
#if defined(DIES_WHEN_TIMED)
  table = table_named("dies_when_timed");
#elif defined(CHANGES_WHEN_TIMED)
  table = table_named("changes_when_timed");
  table.associate = forget_every_other;
#else
  table = table_named("late");
#endif
  table.create = create_small;
  return &table;
}

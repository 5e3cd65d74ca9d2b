/* SPDX-License-Identifier: MIT */
/* Right in every growth with one thread, but not where phytobench_engine.h demands more than a
 * growth does; a definition says where. */
#include "faulty.h"

#if defined(GLOBAL_STATE)
static int32_t nodes_so_far; /* of all engines together */
#elif defined(CHANGES_ITS_MIND)
#define RIGHT_ENGINES 2
#elif defined(CHANGES_ITS_MIND_LATE)
#define RIGHT_ENGINES 9
#endif
#ifdef RIGHT_ENGINES
static int engines; /* made so far */
#endif

static void* create_unless(const phytobench_vector* points, int32_t count,
                           const phytobench_setup* setup) {
#if defined(NEEDS_POINTS)
  if (count == 0) return NULL;
#elif defined(NEEDS_ONE_THREAD)
  if (setup->threads > 1) return NULL;
#elif defined(GLOBAL_STATE)
  nodes_so_far = 0;
#elif defined(RIGHT_ENGINES)
  ++engines;
#endif
  return create(points, count, setup);
}

static int32_t associate_unless(void* engine, const phytobench_node* new_nodes, int32_t count,
                                int32_t* nearest) {
#if defined(NEEDS_NODES)
  if (count == 0) return 1;
#elif defined(GLOBAL_STATE)
  ((scan*)engine)->node_count = nodes_so_far;
  nodes_so_far += count;
#endif
  const int32_t result = associate(engine, new_nodes, count, nearest);
#ifdef RIGHT_ENGINES
  if (engines > RIGHT_ENGINES)
    for (int32_t i = 0; i < ((scan*)engine)->point_count; i += 2) nearest[i] = PHYTOBENCH_NO_NODE;
#endif
  return result;
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("unusual");
  table.create = create_unless;
  table.associate = associate_unless;
  return &table;
}

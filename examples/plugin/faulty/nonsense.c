/* SPDX-License-Identifier: MIT */
/* Answers that are not merely wrong but impossible; a definition says which. */
#include "faulty.h"

static int32_t answer(void* engine, const phytobench_node* new_nodes, int32_t count,
                      int32_t* nearest) {
  const int32_t result = associate(engine, new_nodes, count, nearest);
#if defined(REPORTS_FAILURE)
  return result + 7;
#else
#if defined(NODE_BEYOND)
  nearest[0] = ((scan*)engine)->node_count;
#elif defined(NODE_NEGATIVE)
  nearest[0] = -2;
#endif
  return result;
#endif
}

#if defined(REMOVED_TWICE) || defined(REMOVED_BEYOND) || defined(TOO_MANY)
static int32_t remove_points(void* engine, const phytobench_node* killers, int32_t count,
                             double kill_distance, int32_t* removed_points, int32_t capacity) {
  (void)engine, (void)killers, (void)count, (void)kill_distance;
#if defined(TOO_MANY)
  (void)removed_points;
  return capacity + 1;
#elif defined(REMOVED_TWICE)
  if (capacity < 2) return 0;
  removed_points[0] = removed_points[1] = 0;
  return 2;
#else
  if (capacity < 1) return 0;
  removed_points[0] = ((scan*)engine)->point_count;
  return 1;
#endif
}
#endif

#ifdef CREATES_NOTHING
static void* create_nothing(const phytobench_vector* points, int32_t count,
                            const phytobench_setup* setup) {
  (void)points, (void)count, (void)setup;
  return NULL;
}
#endif

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("nonsense");
  table.associate = answer;
#if defined(REMOVED_TWICE) || defined(REMOVED_BEYOND) || defined(TOO_MANY)
  table.remove = remove_points;
#endif
#ifdef CREATES_NOTHING
  table.create = create_nothing;
#endif
  return &table;
}

/* SPDX-License-Identifier: MIT */
/* Nothing is wrong with this one: it removes points itself, which the example leaves to phytobench,
 * and gives them in descending order. */
#include "faulty.h"

static int32_t remove_points(void* engine, const phytobench_node* killers, int32_t count,
                             double kill_distance, int32_t* removed_points, int32_t capacity) {
  scan* self = (scan*)engine;
  const double squared_reach = kill_distance * kill_distance;
  int32_t found = 0;
  for (int32_t i = self->point_count - 1; i >= 0 && found < capacity; --i) {
    int is_reached = 0;
    for (int32_t k = 0; k < count && !self->is_removed[i] && !is_reached; ++k)
      is_reached = phytobench_squared_distance(&self->points[i], &killers[k].position) <=
                   squared_reach;
    if (!is_reached) continue;
    self->is_removed[i] = 1;
    removed_points[found++] = i;
  }
  return found;
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("removing");
  table.summary = "The example, removing points itself.";
  table.remove = remove_points;
  table.removed = NULL;
  return &table;
}

/* SPDX-License-Identifier: MIT */
/* Of equally near nodes it takes the last one: less or equal, where less belongs. Only a tie shows
 * that. */
#include "faulty.h"

static int32_t take_the_last(void* engine, const phytobench_node* new_nodes, int32_t count,
                             int32_t* nearest) {
  scan* self = (scan*)engine;
  for (int32_t i = 0; i < self->point_count; ++i)
    for (int32_t n = 0; n < count; ++n) {
      const phytobench_vector* point = &self->points[i];
      const double squared = phytobench_squared_distance(point, &new_nodes[n].position);
      if (squared <= self->nearest_squared[i] &&
          phytobench_perceives(&self->setup, &new_nodes[n], point, squared)) {
        self->nearest_squared[i] = squared;
        nearest[i] = self->node_count + n;
      }
    }
  self->node_count += count;
  return 0;
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("wrong");
  table.associate = take_the_last;
  return &table;
}

/* SPDX-License-Identifier: MIT */
/* Right, and no call takes long, but a growth takes seconds. */
#include <time.h>

#include "faulty.h"

static int32_t associate_slowly(void* engine, const phytobench_node* new_nodes, int32_t count,
                                int32_t* nearest) {
  const clock_t start = clock();
  while (clock() - start < CLOCKS_PER_SEC / 5) {
  }
  return associate(engine, new_nodes, count, nearest);
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("slow");
  table.associate = associate_slowly;
  return &table;
}

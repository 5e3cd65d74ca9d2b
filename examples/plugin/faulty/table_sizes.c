/* SPDX-License-Identifier: MIT */
/* Nothing is wrong with these: tables as a plugin has them that was built with a newer or an older
 * header of the same version of the interface. */
#include <stddef.h>

#include "faulty.h"

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
#ifdef LONGER_TABLE
  static struct {
    phytobench_engine_v1 known;
    void (*added_later)(void);
  } table;
  table.known = table_named("longer_table");
  table.known.size = sizeof table;
  return &table.known;
#else
  static phytobench_engine_v1 table;
  table = table_named("shorter_table"); /* its last member stands for whatever lies behind */
  table.size = offsetof(phytobench_engine_v1, last_error);
  return &table;
#endif
}

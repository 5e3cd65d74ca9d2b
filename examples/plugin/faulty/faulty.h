/* SPDX-License-Identifier: MIT */
/* The example engine with parts replaced: a mistake is all that a faulty engine has to write. */
#ifndef PHYTOBENCH_FAULTY_H
#define PHYTOBENCH_FAULTY_H

#define phytobench_engine right_engine
#include "../nearest_scan.c"
#undef phytobench_engine

/* The right table under another name, to be changed. */
static phytobench_engine_v1 table_named(const char* name) {
  phytobench_engine_v1 table = *right_engine();
  table.name = name;
  table.summary = "Wrong on purpose.";
  return table;
}

#endif

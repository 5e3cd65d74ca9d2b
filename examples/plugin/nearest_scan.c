/* SPDX-License-Identifier: MIT */
/* A complete engine: compares every live point with every new node, once. A point's nearest node
 * changes only because of a new node, so nothing but its squared distance must be kept. */
#include <stdlib.h>

#include "phytobench_engine.h"

typedef struct scan {
  const phytobench_vector* points; /* phytobench keeps them until destroy() */
  int32_t point_count;
  phytobench_setup setup;
  int32_t node_count;        /* so far */
  double* nearest_squared;   /* per point: squared distance of its nearest node */
  unsigned char* is_removed; /* per point */
} scan;

static void destroy(void* engine) {
  scan* self = (scan*)engine;
  free(self->nearest_squared);
  free(self->is_removed);
  free(self);
}

static void* create(const phytobench_vector* points, int32_t count, const phytobench_setup* setup) {
  const size_t room = count > 0 ? (size_t)count : 1; /* calloc(0) may return null */
  scan* self = (scan*)calloc(1, sizeof *self);
  if (self == NULL) return NULL;
  self->points = points;
  self->point_count = count;
  self->setup = *setup;
  self->nearest_squared = (double*)calloc(room, sizeof *self->nearest_squared);
  self->is_removed = (unsigned char*)calloc(room, sizeof *self->is_removed);
  if (self->nearest_squared == NULL || self->is_removed == NULL) {
    destroy(self);
    return NULL;
  }
  for (int32_t i = 0; i < count; ++i) self->nearest_squared[i] = (double)INFINITY;
  return self;
}

static int32_t associate(void* engine, const phytobench_node* new_nodes, int32_t count,
                         int32_t* nearest) {
  scan* self = (scan*)engine;
  for (int32_t i = 0; i < self->point_count; ++i) {
    if (self->is_removed[i]) continue;
    const phytobench_vector* point = &self->points[i];
    for (int32_t n = 0; n < count; ++n) {
      const double squared = phytobench_squared_distance(point, &new_nodes[n].position);
      /* Less, not less or equal: of equally near nodes the first one stays. */
      if (squared < self->nearest_squared[i] &&
          phytobench_perceives(&self->setup, &new_nodes[n], point, squared)) {
        self->nearest_squared[i] = squared;
        nearest[i] = self->node_count + n;
      }
    }
  }
  self->node_count += count;
  return 0;
}

/* phytobench finds the points to remove, because remove() is null below. */
static void removed(void* engine, const int32_t* points, int32_t count) {
  scan* self = (scan*)engine;
  for (int32_t i = 0; i < count; ++i) self->is_removed[points[i]] = 1;
}

static const char* last_error(void* engine) {
  (void)engine; /* only create() can fail, and only for one reason */
  return "out of memory";
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static const phytobench_engine_v1 table = {
      PHYTOBENCH_ENGINE_ABI,
      sizeof(phytobench_engine_v1),
      "nearest_scan",
      "Compares every live point with every new node, once.",
      create,
      associate,
      NULL, /* remove */
      removed,
      destroy,
      last_error,
  };
  return &table;
}

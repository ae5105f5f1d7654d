/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A host in C99 that knows the header only: loads the plug-in, makes the cage of a capsule, checks it by itself,
 * cancels a solve, saves and loads the state, and unloads. Exit 0 where all of it holds. */
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cagewright/cagewright.h"

#define SIDES 24
#define RINGS 40
#define VERTEX_COUNT (RINGS * SIDES + 2)
#define TRIANGLE_COUNT (2 * RINGS * SIDES)

static int failures = 0;
#define EXPECT(condition)                                                     \
  do {                                                                        \
    if (!(condition)) {                                                       \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                             \
    }                                                                         \
  } while (0)

static double vertices[VERTEX_COUNT * 3];
static uint32_t triangles[TRIANGLE_COUNT * 3];

/* A capsule of radius 1 along x, from -1 to 7. */
static void build_capsule(void) {
  const double pi = 3.14159265358979323846;
  uint32_t* t = triangles;
  uint32_t ring, side;
  for (ring = 0; ring < RINGS; ++ring) {
    const double s = (ring + 1.0) / (RINGS + 1.0) * (pi + 6.0); /* length along the profile */
    const double angle = s < pi / 2 ? s : s > pi / 2 + 6 ? s - 6 : pi / 2;
    const double x = s < pi / 2 ? -cos(angle) : s > pi / 2 + 6 ? 6 - cos(angle) : s - pi / 2;
    for (side = 0; side < SIDES; ++side) {
      double* v = vertices + 3 * (ring * SIDES + side);
      v[0] = x;
      v[1] = sin(angle) * cos(2 * pi * side / SIDES);
      v[2] = sin(angle) * sin(2 * pi * side / SIDES);
    }
  }
  vertices[3 * RINGS * SIDES] = -1;
  vertices[3 * (RINGS * SIDES + 1)] = 7;
  for (side = 0; side < SIDES; ++side) {
    const uint32_t next = (side + 1) % SIDES, last = (RINGS - 1) * SIDES;
    *t++ = RINGS * SIDES, *t++ = next, *t++ = side;
    for (ring = 0; ring + 1 < RINGS; ++ring) {
      const uint32_t a = ring * SIDES + side, b = ring * SIDES + next;
      *t++ = a, *t++ = b, *t++ = b + SIDES;
      *t++ = a, *t++ = b + SIDES, *t++ = a + SIDES;
    }
    *t++ = RINGS * SIDES + 1, *t++ = last + side, *t++ = last + next;
  }
}

struct watcher {
  int calls, cancel_after, falls;
  double last;
  char stages[256];
};

static int32_t watch(void* user, double fraction, const char* stage) {
  struct watcher* w = user;
  if (fraction < w->last || fraction < 0 || fraction > 1) ++w->falls;
  w->last = fraction;
  if (!strstr(w->stages, stage)) strcat(strcat(w->stages, stage), " ");
  return ++w->calls == w->cancel_after;
}

static void add_slides(const cgw_api* api, cgw_session* session) {
  static const double xs[3] = {1.03, 3.01, 4.97};
  static const char* const names[3] = {"left", "middle", "right"};
  int k;
  for (k = 0; k < 3; ++k) {
    cgw_slide_input input = CGW_SLIDE_INPUT_INIT;
    uint64_t id = CGW_NO_ID;
    input.kind = CGW_SLIDE_POINT_NORMAL;
    input.name = names[k];
    input.point[0] = xs[k];
    input.normal[0] = 1;
    EXPECT(api->slide_add(session, &input, &id) == CGW_OK);
    EXPECT(id != CGW_NO_ID);
  }
  EXPECT(api->slide_count(session) == 3);
}

/* Every edge is run once in each direction, and V - E + F = 2. */
static void check_closed(const cgw_cage* cage) {
  const uint64_t n = cage->triangle_count;
  uint64_t i, k, opposite, same;
  for (i = 0; i < 3 * n; ++i) {
    const uint32_t a = cage->triangles[i], b = cage->triangles[i / 3 * 3 + (i + 1) % 3];
    EXPECT(a < cage->vertex_count && a != b);
    for (k = opposite = same = 0; k < 3 * n; ++k) {
      const uint32_t c = cage->triangles[k], d = cage->triangles[k / 3 * 3 + (k + 1) % 3];
      opposite += c == b && d == a;
      same += c == a && d == b;
    }
    EXPECT(opposite == 1 && same == 1);
  }
  EXPECT(n % 2 == 0 && cage->vertex_count + n == 2 + 3 * n / 2);
}

static double volume(const cgw_cage* cage) {
  double sum = 0;
  uint64_t t;
  for (t = 0; t < cage->triangle_count; ++t) {
    const double* a = cage->vertices + 3 * cage->triangles[3 * t];
    const double* b = cage->vertices + 3 * cage->triangles[3 * t + 1];
    const double* c = cage->vertices + 3 * cage->triangles[3 * t + 2];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

static cgw_cage read_cage(const cgw_api* api, const cgw_session* session) {
  cgw_cage cage = CGW_CAGE_INIT;
  EXPECT(api->get_cage(session, &cage) == CGW_OK);
  cage.vertices = calloc((size_t)cage.vertex_count * 3, sizeof *cage.vertices);
  cage.vertex_section = calloc((size_t)cage.vertex_count, sizeof *cage.vertex_section);
  cage.triangles = calloc((size_t)cage.triangle_count * 3, sizeof *cage.triangles);
  cage.triangle_part = calloc((size_t)cage.triangle_count, sizeof *cage.triangle_part);
  cage.vertex_capacity = cage.vertex_count;
  cage.triangle_capacity = cage.triangle_count;
  EXPECT(api->get_cage(session, &cage) == CGW_OK);
  return cage;
}

static void free_cage(cgw_cage* cage) {
  free(cage->vertices);
  free(cage->vertex_section);
  free(cage->triangles);
  free(cage->triangle_part);
}

/* 3 slides: 12 section corners and 4 at each of the two caps. */
static void check_cage(const cgw_api* api, const cgw_session* session) {
  cgw_cage cage = read_cage(api, session);
  uint64_t k;
  EXPECT(cage.vertex_count == 20);
  check_closed(&cage);
  EXPECT(volume(&cage) > 0.99 * (4.0 / 3.0 + 6.0) * 3.1); /* it bounds the capsule, so its volume is larger */
  for (k = 0; k < cage.vertex_count; ++k) EXPECT(cage.vertex_section[k] == (k < 12 ? (int32_t)k / 4 : -1));
  for (k = 0; k < cage.triangle_count; ++k) EXPECT(cage.triangle_part[k] >= 0 && cage.triangle_part[k] < 4);
  free_cage(&cage);
}

static void check_certificate(const cgw_api* api, const cgw_session* session) {
  cgw_certificate certificate = CGW_CERTIFICATE_INIT;
  cgw_measures measures = CGW_MEASURES_INIT;
  EXPECT(api->get_certificate(session, &certificate) == CGW_OK);
  EXPECT(certificate.encloses == 1 && certificate.keeps_distance == 1 && *certificate.message == 0);
  EXPECT(api->get_measures(session, &measures) == CGW_OK);
  EXPECT(measures.clearance >= 0.01 && measures.clearance <= 0.015 && measures.coverage == 1);
}

/* As the paper ends. */
static void check_records(const cgw_api* api, cgw_session* session) {
  uint64_t count;
  cgw_summary summary = CGW_SUMMARY_INIT;
  cgw_iteration iteration = CGW_ITERATION_INIT;
  double before[60], after[60];
  EXPECT(api->set_parameter_text(session, "enclose.mode", "off") == CGW_OK);
  EXPECT(api->solve(session, NULL) == CGW_OK);
  count = api->iteration_count(session);
  EXPECT(api->get_summary(session, &summary) == CGW_OK);
  EXPECT(summary.last_stage == CGW_STAGE_REFINE && summary.iterations == count && summary.converged == 1);
  EXPECT(summary.cage_genus == 0 && summary.volume_ratio > 1 && summary.threads >= 1);
  EXPECT(count > 0);
  iteration.vertices_before = before;
  iteration.vertices_after = after;
  iteration.vertex_capacity = 20;
  EXPECT(api->get_iteration(session, 0, &iteration) == CGW_OK);
  EXPECT(iteration.vertex_count == 20 && memcmp(before, after, sizeof before) != 0);
}

static void check_cancel(const cgw_api* api, cgw_session* session, struct watcher* w) {
  cgw_cage before = read_cage(api, session), after;
  w->calls = 0;
  w->last = 0;
  w->cancel_after = 2;
  EXPECT(api->set_parameter(session, "refine.delta", 0.02) == CGW_OK);
  EXPECT(api->solve(session, NULL) == CGW_CANCELLED);
  EXPECT(w->calls == 2);
  after = read_cage(api, session);
  EXPECT(memcmp(before.vertices, after.vertices, (size_t)before.vertex_count * 24) == 0);
  free_cage(&before);
  free_cage(&after);
  w->cancel_after = 0;
}

struct memory {
  unsigned char bytes[4096];
  uint64_t size, at;
};

static uint64_t write_memory(void* user, const void* bytes, uint64_t count) {
  struct memory* m = user;
  if (count > sizeof m->bytes - m->size) return 0;
  memcpy(m->bytes + m->size, bytes, (size_t)count);
  m->size += count;
  return count;
}

static uint64_t read_memory(void* user, void* bytes, uint64_t count) {
  struct memory* m = user;
  const uint64_t got = count < m->size - m->at ? count : m->size - m->at;
  memcpy(bytes, m->bytes + m->at, (size_t)got);
  m->at += got;
  return got;
}

static void check_state(const cgw_api* api, cgw_session* session) {
  struct memory memory = {{0}, 0, 0};
  cgw_stream stream = CGW_STREAM_INIT;
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  double delta = 0;
  stream.user = &memory;
  stream.read = read_memory;
  stream.write = write_memory;
  EXPECT(api->set_parameter(session, "refine.delta", 0.25) == CGW_OK);
  EXPECT(api->save_state(session, &stream) == CGW_OK);
  EXPECT(api->slide_info(session, 0, &info) == CGW_OK);
  EXPECT(api->slide_remove(session, info.id) == CGW_OK);
  EXPECT(api->set_parameter(session, "refine.delta", 0) == CGW_OK);
  EXPECT(api->load_state(session, &stream) == CGW_OK);
  EXPECT(memory.at == memory.size);
  EXPECT(api->slide_count(session) == 3);
  EXPECT(api->slide_info(session, 0, &info) == CGW_OK);
  EXPECT(strcmp(info.name, "left") == 0 && info.status == CGW_SLIDE_UNSOLVED);
  EXPECT(api->get_parameter(session, "refine.delta", &delta) == CGW_OK);
  EXPECT(delta == 0.25);
}

static void check_all(const cgw_api* api) {
  struct watcher watcher = {0, 0, 0, 0, ""};
  cgw_host host = CGW_HOST_INIT;
  cgw_mesh mesh = CGW_MESH_INIT;
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  cgw_session* session = NULL;
  host.user = &watcher;
  host.progress = watch;
  EXPECT(api->session_create(&host, &session) == CGW_OK);
  mesh.vertices = vertices;
  mesh.vertex_count = VERTEX_COUNT;
  mesh.triangles = triangles;
  mesh.triangle_count = TRIANGLE_COUNT;
  EXPECT(api->set_mesh(session, &mesh) == CGW_OK);
  EXPECT(api->mesh_report(session, &report) == CGW_OK);
  EXPECT(report.closed == 1 && report.turned_triangles == 0 && report.genus == 0);
  add_slides(api, session);
  EXPECT(api->set_parameter_text(session, "refine.delta", "0.01") == CGW_OK);
  EXPECT(api->solve(session, NULL) == CGW_OK);
  if (*api->last_error(session)) fprintf(stderr, "%s\n", api->last_error(session));
  EXPECT(watcher.falls == 0 && strcmp(watcher.stages, "segment orient meshing refine enclose ") == 0);
  if (failures == 0) {
    check_cage(api, session);
    check_certificate(api, session);
    check_records(api, session);
    check_cancel(api, session, &watcher);
    check_state(api, session);
  }
  api->session_destroy(session);
}

int main(int argc, char** argv) {
  void* library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  void* symbol = library ? dlsym(library, CGW_ENTRY_POINT) : NULL;
  cgw_get_api_fn get_api;
  if (!symbol) {
    fprintf(stderr, "usage: c_host PLUGIN; %s\n", argc == 2 ? dlerror() : "one argument is needed");
    return 2;
  }
  memcpy(&get_api, &symbol, sizeof get_api);
  build_capsule();
  check_all(get_api(CGW_ABI_MINOR));
  EXPECT(dlclose(library) == 0);
  EXPECT(dlopen(argv[1], RTLD_NOW | RTLD_NOLOAD) == NULL); /* it is gone */
  if (failures == 0) printf("c_host: all is well\n");
  return failures == 0 ? 0 : 1;
}

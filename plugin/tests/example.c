/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The example of docs/c-abi.md: the cage of a box that is cut once.
 *     cc -std=c99 -I plugin/include example.c -ldl -o example && ./example cagewright_plugin.so */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cagewright/cagewright.h"

static const double box_vertices[8 * 3] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 3, 1, 0, 3, 1, 1, 3, 0, 1, 3};
static const uint32_t box_triangles[12 * 3] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                               1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};

static int fail(const cgw_api* api, const cgw_session* session, cgw_status status) {
  fprintf(stderr, "%s: %s\n", api->status_name(status), api->last_error(session));
  return 1;
}

static int print_cage(const cgw_api* api, const cgw_session* session) {
  cgw_cage cage = CGW_CAGE_INIT;
  cgw_status status = api->get_cage(session, &cage); /* the counts */
  uint64_t i;
  if (status != CGW_OK) return fail(api, session, status);
  cage.vertices = malloc((size_t)cage.vertex_count * 3 * sizeof *cage.vertices);
  cage.triangles = malloc((size_t)cage.triangle_count * 3 * sizeof *cage.triangles);
  cage.vertex_capacity = cage.vertex_count;
  cage.triangle_capacity = cage.triangle_count;
  if (cage.vertices && cage.triangles) status = api->get_cage(session, &cage); /* the rows */
  for (i = 0; status == CGW_OK && i < cage.vertex_count; ++i) {
    const double* v = cage.vertices + 3 * i;
    printf("v %.17g %.17g %.17g\n", v[0], v[1], v[2]);
  }
  for (i = 0; status == CGW_OK && i < cage.triangle_count; ++i) {
    const uint32_t* t = cage.triangles + 3 * i;
    printf("f %u %u %u\n", (unsigned)t[0] + 1, (unsigned)t[1] + 1, (unsigned)t[2] + 1);
  }
  free(cage.vertices);
  free(cage.triangles);
  return status == CGW_OK ? 0 : fail(api, session, status);
}

static int make_cage(const cgw_api* api, cgw_session* session) {
  cgw_mesh mesh = CGW_MESH_INIT;
  cgw_slide_input slide = CGW_SLIDE_INPUT_INIT;
  uint64_t id = CGW_NO_ID;
  cgw_status status;

  mesh.vertices = box_vertices;
  mesh.vertex_count = 8;
  mesh.triangles = box_triangles;
  mesh.triangle_count = 12;
  status = api->set_mesh(session, &mesh);
  if (status != CGW_OK) return fail(api, session, status);

  slide.kind = CGW_SLIDE_POINT_NORMAL;
  slide.name = "middle";
  slide.point[0] = 0.5, slide.point[1] = 0.5, slide.point[2] = 1.5;
  slide.normal[2] = 1;
  status = api->slide_add(session, &slide, &id);
  if (status != CGW_OK) return fail(api, session, status);

  status = api->set_parameter(session, "refine.delta", 0.01);
  if (status != CGW_OK) return fail(api, session, status);
  status = api->solve(session, NULL);
  if (status != CGW_OK) return fail(api, session, status);
  return print_cage(api, session);
}

int main(int argc, char** argv) {
  void* library = dlopen(argc > 1 ? argv[1] : "./cagewright_plugin.so", RTLD_NOW | RTLD_LOCAL);
  cgw_get_api_fn get_api = NULL;
  const cgw_api* api = NULL;
  cgw_session* session = NULL;
  int exit_code = 1;
  void* symbol;

  if (!library) {
    fprintf(stderr, "%s\n", dlerror());
    return 1;
  }
  symbol = dlsym(library, CGW_ENTRY_POINT);
  memcpy(&get_api, &symbol, sizeof get_api); /* C99 has no cast from an object to a function pointer */
  if (get_api) api = get_api(CGW_ABI_MINOR);
  if (api && api->session_create(NULL, &session) == CGW_OK) exit_code = make_cage(api, session);
  if (api) api->session_destroy(session);
  dlclose(library);
  return exit_code;
}

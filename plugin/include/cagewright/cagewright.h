/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Cagewright's C ABI, version 1. C99; no other header of the product is needed by a host.
 *
 * How a host uses it: dlopen the plug-in, look up CGW_ENTRY_POINT, call it, keep the table.
 *
 *     const cgw_api* api = ((cgw_get_api_fn)dlsym(lib, CGW_ENTRY_POINT))(CGW_ABI_MINOR);
 *
 * Rules that hold for the whole header
 * - Every struct that crosses begins with `uint32_t struct_size`, set by whoever allocates it (use the _INIT macros).
 *   The other side reads and writes only the smaller of both sizes; a missing tail means the defaults.
 * - Tables and structs grow at their end only. Numbers (status, kinds, stages) are frozen once released.
 * - Positions are in model units, directions need not be normalised unless a comment says so, angles are in radians.
 *   Arrays of points are packed rows: n x 3 doubles. Triangles are packed rows: m x 3 uint32_t, counter-clockwise as
 *   seen from outside, indices from 0.
 * - What a host passes in is borrowed for the duration of the call. What the plug-in hands out as `const char*` belongs
 *   to the plug-in and lives until the comment there says so. Strings are UTF-8.
 * - Reading into buffers: the call always sets the counts; it copies an array only where the pointer is not NULL, and
 *   fails with CGW_ERROR_BUFFER_TOO_SMALL, writing no array, where one of them is too small. Capacities count rows.
 *   So: call once with NULL pointers, allocate, call again.
 * - A call that fails or is cancelled leaves its outputs and the session as they were, except for last_error and the
 *   per-slide status and message of slide_info, which tell of the failure.
 * - No C++ exception and no signal crosses the ABI.
 * - Thread tags: [any-thread] at any time from any thread; [one-at-a-time] from any thread, but one call at a time for
 *   the same session (different sessions may run at once); [main-thread] only from the thread that loaded the plug-in.
 * - NULL for a required pointer is CGW_ERROR_INVALID_ARGUMENT, never a crash.
 */
#ifndef CAGEWRIGHT_CAGEWRIGHT_H
#define CAGEWRIGHT_CAGEWRIGHT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CGW_ABI_MAJOR 1u
#define CGW_ABI_MINOR 5u
#define CGW_ENTRY_POINT "cgw_get_api_v1"

/* ---- status ---------------------------------------------------------------------------------------------------- */

typedef int32_t cgw_status;

#define CGW_OK 0
#define CGW_CANCELLED 1 /* the host's progress function asked for it */

/* Misuse of the ABI. */
#define CGW_ERROR_INTERNAL (-1)         /* a defect of the plug-in; the sentence says where */
#define CGW_ERROR_INVALID_ARGUMENT (-2) /* a pointer is NULL, a size or kind is wrong, a callback calls back */
#define CGW_ERROR_OUT_OF_MEMORY (-3)
#define CGW_ERROR_BUFFER_TOO_SMALL (-4)
#define CGW_ERROR_NOT_READY (-5)         /* asked for a result that no successful solve has made yet */
#define CGW_ERROR_UNKNOWN_SLIDE (-6)     /* no slide of that id */
#define CGW_ERROR_UNKNOWN_PARAMETER (-7) /* no parameter of that id */
#define CGW_ERROR_PARAMETER_OUT_OF_RANGE (-8)
#define CGW_ERROR_STREAM (-9) /* the host's stream reported a failure or ended early */

/* The model. */
#define CGW_ERROR_MESH_EMPTY (-20)
#define CGW_ERROR_MESH_NOT_FINITE (-21)     /* NaN or infinite position; element = vertex */
#define CGW_ERROR_MESH_INDEX (-22)          /* a triangle names a vertex that is not there; element = triangle */
#define CGW_ERROR_MESH_OPEN (-23)           /* open edges; the sentence counts them and tells the first place */
#define CGW_ERROR_MESH_NON_MANIFOLD (-24)   /* edges with more than two triangles */
#define CGW_ERROR_MESH_NOT_ORIENTABLE (-25) /* no consistent orientation exists (a Moebius band's closure) */

/* One slide. */
#define CGW_ERROR_STROKE_TOO_SHORT (-40) /* fewer than 5 distinct points */
#define CGW_ERROR_STROKE_COLLINEAR (-41)
#define CGW_ERROR_STROKE_NO_ELLIPSE (-42) /* the best conic is no ellipse */
#define CGW_ERROR_SLIDE_NOT_FINITE (-43)
#define CGW_ERROR_SLIDE_DEGENERATE (-44)   /* zero normal, zero or parallel radii */
#define CGW_ERROR_SLIDE_MISSES_MODEL (-45) /* its plane does not meet the model */
#define CGW_ERROR_SLIDE_NOT_ENCLOSED (-46) /* no closed loop of its plane goes round its centre */
#define CGW_ERROR_SLIDE_NAME (-47)         /* empty, or taken by another slide */

/* Slides together. */
#define CGW_ERROR_SLIDES_TOUCH (-60)          /* the loops of two slides touch or cross; the sentence names both */
#define CGW_ERROR_PART_SEES_SLIDE_TWICE (-61) /* a ring cut once: a part lies on both sides of the same slide */
#define CGW_ERROR_SECTIONS_OVERLAP (-62)      /* no point of the part sees all its sections side by side from inside */
#define CGW_ERROR_PARTS_SHARE_WALL (-63)      /* two parts between the same slides would have the same cage triangles */
#define CGW_ERROR_REFINE_DIVERGED (-64)       /* a cage vertex left every reasonable distance; names part and slides */

/* Saved states. */
#define CGW_ERROR_STATE_MAGIC (-80)       /* not a saved state */
#define CGW_ERROR_STATE_VERSION (-81)     /* made by a newer plug-in */
#define CGW_ERROR_STATE_CORRUPT (-82)     /* lengths or checksums do not agree */
#define CGW_ERROR_STATE_FINGERPRINT (-83) /* made for another mesh than the session's */

#define CGW_NO_ID UINT64_MAX /* "no such slide / part / element" in cgw_error_info */

/* What went wrong last, in parts; last_error gives the sentence. */
typedef struct cgw_error_info {
  uint32_t struct_size;
  cgw_status code;
  uint64_t slide;       /* id, or CGW_NO_ID */
  uint64_t other_slide; /* id of the second slide of a pair, or CGW_NO_ID */
  uint64_t part;        /* index, or CGW_NO_ID */
  uint64_t element;     /* vertex, triangle or stroke-point index as the code's comment says, or CGW_NO_ID */
  uint32_t has_point;   /* 1 where point is set */
  uint32_t reserved;
  double point[3]; /* the place, model units */
} cgw_error_info;
#define CGW_ERROR_INFO_INIT                                                                            \
  {                                                                                                    \
    (uint32_t)sizeof(cgw_error_info), 0, CGW_NO_ID, CGW_NO_ID, CGW_NO_ID, CGW_NO_ID, 0, 0, { 0, 0, 0 } \
  }

/* ---- the host's table ------------------------------------------------------------------------------------------ */

#define CGW_LOG_DEBUG 0
#define CGW_LOG_INFO 1
#define CGW_LOG_WARNING 2
#define CGW_LOG_ERROR 3

/* Every function may be NULL. All are called on the thread that called into the plug-in, never after that call ends.
   They, and those of cgw_stream, must not call into the session whose call they are part of. Such a call is refused
   with CGW_ERROR_INVALID_ARGUMENT and changes nothing (last_error(NULL) has the sentence); session_destroy does
   nothing, the functions that count give 0. Other sessions, and functions without a session, may be called. */
typedef struct cgw_host {
  uint32_t struct_size;
  uint32_t reserved;
  void* user; /* handed back as the first argument */
  void (*log)(void* user, int32_t level, const char* message);
  /* fraction in [0, 1] of the whole solve, never falling; stage as in stage_name. Nonzero return cancels: the solve
     ends with CGW_CANCELLED within one refinement iteration, one step of enclosing, one slide's cut, or one of the
     short stages between. */
  int32_t (*progress)(void* user, double fraction, const char* stage);
  /* An extension table of the host by versioned id, or NULL. None is defined in version 1.0. */
  const void* (*get_extension)(void* user, const char* id);
} cgw_host;
#define CGW_HOST_INIT \
  { (uint32_t)sizeof(cgw_host), 0, NULL, NULL, NULL, NULL }

/* ---- parameters ------------------------------------------------------------------------------------------------ */

#define CGW_PARAM_REAL 0
#define CGW_PARAM_INTEGER 1
#define CGW_PARAM_BOOLEAN 2 /* 0 or 1 */
#define CGW_PARAM_CHOICE 3  /* index into choices */

/* One parameter describes itself; hosts build panels from this. Strings live as long as the plug-in is loaded. */
typedef struct cgw_parameter {
  uint32_t struct_size;
  int32_t type;      /* CGW_PARAM_* */
  const char* id;    /* "orient.lambda" */
  const char* label; /* "Alignment" */
  const char* doc;   /* one line */
  const char* unit;  /* "", "diagonal", "radian", ... */
  double default_value;
  double minimum;             /* inclusive */
  double maximum;             /* inclusive; may be +infinity */
  const char* const* choices; /* choice_count names, or NULL */
  uint32_t choice_count;
  uint32_t reserved;
} cgw_parameter;
#define CGW_PARAMETER_INIT \
  { (uint32_t)sizeof(cgw_parameter), 0, NULL, NULL, NULL, NULL, 0, 0, 0, NULL, 0, 0 }

/* ---- meshes ---------------------------------------------------------------------------------------------------- */

typedef struct cgw_mesh {
  uint32_t struct_size;
  uint32_t reserved;
  const double* vertices; /* vertex_count x 3 */
  uint64_t vertex_count;
  const uint32_t* triangles; /* triangle_count x 3 */
  uint64_t triangle_count;
} cgw_mesh;
#define CGW_MESH_INIT \
  { (uint32_t)sizeof(cgw_mesh), 0, NULL, 0, NULL, 0 }

/* What a mesh is, counted after vertices at the same position have been welded. */
typedef struct cgw_mesh_report {
  uint32_t struct_size;
  uint32_t closed;                /* 1: no open and no non-manifold edge */
  uint32_t consistently_oriented; /* 1: no edge is run twice in the same direction */
  uint32_t inside_out;            /* 1: closed, and the signed volume is negative */
  uint64_t vertices;              /* after welding, those that a triangle uses */
  uint64_t triangles;             /* after degenerate ones were dropped */
  uint64_t welded_vertices;       /* vertices merged into another at the same position */
  uint64_t degenerate_triangles;  /* triangles that name a position twice; dropped */
  uint64_t unused_vertices;
  uint64_t open_edges;
  uint64_t non_manifold_edges;
  uint64_t inconsistent_edges; /* edges that both triangles run in the same direction */
  uint64_t bow_tie_vertices;   /* vertices where several fans meet */
  uint64_t turned_triangles;   /* triangles that had to be turned for a consistent, outward orientation */
  uint64_t components;
  int64_t genus;        /* of the whole, bow-ties split; -1 where the mesh is not closed */
  double signed_volume; /* model units cubed, of the triangles as given */
  double diagonal;      /* of the bounding box */
  double box_min[3], box_max[3];
} cgw_mesh_report;
#define CGW_MESH_REPORT_INIT                                                                                     \
  {                                                                                                              \
    (uint32_t)sizeof(cgw_mesh_report), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {0, 0, 0}, { 0, 0, 0 } \
  }

/* ---- slides ---------------------------------------------------------------------------------------------------- */

#define CGW_SLIDE_STROKE 0 /* points on the surface: plane and ellipse are fitted to them */
#define CGW_SLIDE_POINT_NORMAL \
  1                         /* the loop of that plane round, or nearest to, the point; the ellipse is fitted to it */
#define CGW_SLIDE_ELLIPSE 2 /* centre and two radii as they are */
#define CGW_SLIDE_POINT                                                                        \
  3 /* a point on the surface: as POINT_NORMAL with the plane across the limb there. Since 1.3 \
     */

typedef struct cgw_slide_input {
  uint32_t struct_size;
  int32_t kind;         /* CGW_SLIDE_* */
  const char* name;     /* not empty, unique in the session; for slide_fit "" and NULL will do */
  const double* stroke; /* CGW_SLIDE_STROKE: stroke_count x 3 */
  uint64_t stroke_count;
  double point[3];   /* CGW_SLIDE_POINT_NORMAL, CGW_SLIDE_POINT: point; CGW_SLIDE_ELLIPSE: centre */
  double normal[3];  /* CGW_SLIDE_POINT_NORMAL */
  double u[3], v[3]; /* CGW_SLIDE_ELLIPSE: conjugate radii; the principal ones are taken from them */
} cgw_slide_input;
#define CGW_SLIDE_INPUT_INIT                                                                          \
  {                                                                                                   \
    (uint32_t)sizeof(cgw_slide_input), 0, NULL, NULL, 0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, { 0, 0, 0 } \
  }

/* A cgw_status of slides only: no solve has looked at it since it was added, changed or loaded. */
#define CGW_SLIDE_UNSOLVED 2

typedef struct cgw_slide_info {
  uint32_t struct_size;
  int32_t kind;
  uint64_t id;          /* stable, never given to another slide; after load_state the ids are those of the file */
  const char* name;     /* lives until the slide is changed or removed, or load_state */
  cgw_status status;    /* CGW_OK, CGW_SLIDE_UNSOLVED, or what the last solve found wrong with this slide: it looks at
                           every slide, and returns the error of the first */
  uint32_t has_ellipse; /* 1 where the fields below are known */
  const char* message;  /* "" or the sentence; lives until the next call on the session */
  double center[3];
  double normal[3];  /* unit */
  double u[3], v[3]; /* principal radii, |u| >= |v|, normal along u x v */
} cgw_slide_info;
#define CGW_SLIDE_INFO_INIT                                                                                \
  {                                                                                                        \
    (uint32_t)sizeof(cgw_slide_info), 0, 0, NULL, 0, 0, NULL, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, { 0, 0, 0 } \
  }

/* ---- solving --------------------------------------------------------------------------------------------------- */

#define CGW_STAGE_SEGMENT 1 /* paper 3.1 */
#define CGW_STAGE_ORIENT 2  /* paper 3.2 */
#define CGW_STAGE_MESHING 3 /* paper 3.3 */
#define CGW_STAGE_REFINE 4  /* paper 3.4 */
#define CGW_STAGE_ENCLOSE 5 /* earns the certificate; passed over where enclose.mode is off. Since 1.1 */

#define CGW_EDITING_NONE 0u
#define CGW_EDITING_ENCLOSE 1u /* refine.editing_iterations instead of refine.iterations, no tightening or merging */
#define CGW_EDITING_REFINE                                                                        \
  2u /* the same, and last_stage is CGW_STAGE_REFINE at most: for every move of a mouse. Sections \
        stay in plane where those of the enclosing cage would. Since 1.4 */

typedef struct cgw_solve_options {
  uint32_t struct_size;
  int32_t last_stage; /* CGW_STAGE_*: solve up to and with this one */
  uint32_t editing;   /* CGW_EDITING_* */
  uint32_t threads;   /* 0: as many as the machine has; at most 256. Results are the same bits for any number. */
} cgw_solve_options;
#define CGW_SOLVE_OPTIONS_INIT \
  { (uint32_t)sizeof(cgw_solve_options), CGW_STAGE_ENCLOSE, 0, 0 }

#define CGW_PART_ENCLOSED 1u /* lies inside the rest of the model and has no cage of its own */

/* The model cut along the slides. Indices of parts are from 0, in an order that does not depend on the order of the
   model's vertices and triangles. Available after CGW_STAGE_SEGMENT, part_center after CGW_STAGE_MESHING. */
typedef struct cgw_parts {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t part_count;     /* set */
  uint64_t vertex_count;   /* set: vertices of the cut model */
  uint64_t triangle_count; /* set: triangles of the cut model */
  double* vertices;        /* vertex_count x 3, or NULL */
  uint64_t vertex_capacity;
  uint32_t* triangles;    /* triangle_count x 3, or NULL */
  int32_t* triangle_part; /* triangle_count, or NULL: the part of each triangle */
  uint64_t triangle_capacity;
  uint32_t* section_count; /* part_count, or NULL: how many slides bound the part. 0: its cage is its bounding box, or
                              there is none (CGW_PART_ENCLOSED); 1: a leaf, its cage ends in a cap.
                              Limbs that no slide cuts off have caps, too */
  uint64_t part_capacity;  /* of section_count, part_flags and part_center */
  uint32_t* part_flags;    /* part_count, or NULL: sum of CGW_PART_* */
  double* part_center;     /* part_count x 3, or NULL: the projection centre of 3.3 (without slides: the middle of the
                              box); NaN before CGW_STAGE_MESHING and for parts without a cage of their own */
} cgw_parts;
#define CGW_PARTS_INIT \
  { (uint32_t)sizeof(cgw_parts), 0, 0, 0, 0, NULL, 0, NULL, NULL, 0, NULL, 0, NULL, NULL }

/* The closed loop along which a slide cuts the model. Available after CGW_STAGE_SEGMENT. */
typedef struct cgw_loop {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t point_count; /* set */
  double* points;       /* point_count x 3, or NULL; the last point is not the first again */
  uint64_t point_capacity;
} cgw_loop;
#define CGW_LOOP_INIT \
  { (uint32_t)sizeof(cgw_loop), 0, 0, NULL, 0 }

/* The cross section of one slide. After CGW_STAGE_SEGMENT: slide, parts and the ellipse as it was at the time of the
   solve (center, normal, u, v); after CGW_STAGE_ORIENT: p, q, x, corners, which are 0 before. */
typedef struct cgw_section {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t slide;      /* id */
  int32_t part_behind; /* the part on the side that the normal points away from */
  int32_t part_ahead;  /* the part on the side that the normal points to */
  double center[3];
  double p[3], q[3];      /* half edges of the rectangle as oriented: corners are center +- p +- q */
  double x[2];            /* the minimiser of equation (1) for this slide, in the frame (u, v) of this struct; the 4th
                             power of p's direction is x / |x|; over directions of length 1 with
                             orient.minimum = angles */
  double corners[12];     /* 4 x 3: the section's corners in the cage as it is (refined, enclosing) */
  int32_t cage_vertex[4]; /* rows of the corners in cgw_cage.vertices; -1 before CGW_STAGE_MESHING, and for a corner
                             that is gone where limbs were merged (enclose.merge): corners then has it as oriented */
  double normal[3];       /* unit, along u x v */
  double u[3], v[3];      /* principal radii, |u| >= |v|; as the frame (u, v) of x: their directions */
  /* Since 1.2. */
  double linear_x[2]; /* the minimiser of equation (1) as a quadratic form, of any length, as in the paper: x itself,
                         or where it starts from with orient.minimum = angles */
} cgw_section;
#define CGW_SECTION_INIT                                                                                         \
  {                                                                                                              \
    (uint32_t)sizeof(cgw_section), 0, 0, -1, -1, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0}, {0}, {-1, -1, -1, -1}, \
        {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {                                                                       \
      0, 0                                                                                                       \
    }                                                                                                            \
  }

/* The cage. Available after CGW_STAGE_MESHING. */
typedef struct cgw_cage {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t vertex_count;   /* set */
  uint64_t triangle_count; /* set */
  double* vertices;        /* vertex_count x 3, or NULL */
  int32_t* vertex_section; /* vertex_count, or NULL: index of the section (the order of section), -1: a cap's or box's
                              corner, or new at a seam of limbs that were merged */
  uint64_t vertex_capacity;
  uint32_t* triangles;    /* triangle_count x 3, or NULL */
  int32_t* triangle_part; /* triangle_count, or NULL */
  uint64_t triangle_capacity;
} cgw_cage;
#define CGW_CAGE_INIT \
  { (uint32_t)sizeof(cgw_cage), 0, 0, 0, NULL, NULL, 0, NULL, NULL, 0 }

/* One iteration of the refinement, equations (6) to (8): what an independent solver needs to repeat it. Rows are those
   of get_cage, but where limbs were merged (cgw_summary.merged): then of the cage as it was refined, which a solve with
   enclose.merge = false hands out. */
typedef struct cgw_iteration {
  uint32_t struct_size;
  uint32_t reserved;
  double max_signed_distance; /* max over t of (6), before the step, in model units (cgw_summary has it over the
                                 diagonal) */
  uint64_t vertex_count;      /* set */
  uint64_t triangle_count;    /* set */
  double* vertices_before;    /* vertex_count x 3, or NULL: u_j^(k) */
  double* vertices_after;     /* vertex_count x 3, or NULL: u_j^(k+1) */
  double* damping;            /* vertex_count, or NULL: mu_j of the term mu_j |x - u_j^(k)|^2 that is added to (8) */
  double* plane_normal;       /* vertex_count x 3, or NULL: vertex j moves only perpendicular to this unit normal; 0:
                                 free */
  uint64_t vertex_capacity;
  double* normals;         /* triangle_count x 3, or NULL: n_t, unit */
  double* anchors;         /* triangle_count x 3, or NULL: a_t' of (7) */
  double* weights;         /* triangle_count x 3, or NULL: the weight in (8) of triangle t at its three corners */
  double* signed_distance; /* triangle_count, or NULL: d(v_i(t), t) of (6); -infinity where t sees no vertex */
  int64_t* outermost;      /* triangle_count, or NULL: i(t) of (6), vertex of the cut model; -1 where none */
  uint64_t triangle_capacity;
} cgw_iteration;
#define CGW_ITERATION_INIT \
  { (uint32_t)sizeof(cgw_iteration), 0, 0, 0, 0, NULL, NULL, NULL, NULL, 0, NULL, NULL, NULL, NULL, NULL, 0 }

/* Figures of the last solve. What was not computed is NaN. */
typedef struct cgw_summary {
  uint32_t struct_size;
  int32_t last_stage;  /* the last stage that the solve went through */
  uint64_t iterations; /* refinement steps taken */
  uint32_t converged;  /* 1: equation (9) is met */
  uint32_t threads;    /* that the solve could use, at most 256; where there is less to do, fewer worked */
  double max_signed_distance_over_diagonal; /* max over t of (6), of the final cage, over the model's diagonal */
  double volume_ratio;                      /* cage volume over model volume */
  int64_t cage_genus;                       /* -1 before CGW_STAGE_MESHING, and where the welded cage is not manifold */
  double segment_ms, orient_ms, meshing_ms, refine_ms;
  double extent; /* model units: the length for D_BB in equation (9) as it was judged, all in model units:
                    | -max - delta | <= 0.001 extent; turns with the model, at most the diagonal. delta is
                    refine.delta where enclose.mode is off, else 0: then CGW_STAGE_ENCLOSE keeps the distance */
  /* Since 1.1. */
  double enclose_ms;
  uint32_t certified; /* 1: the last stage was CGW_STAGE_ENCLOSE, and get_certificate says `encloses` */
  /* Since 1.2. */
  uint32_t merged; /* 1: limbs were merged (enclose.merge): the cage has other triangles than before enclosing */
} cgw_summary;
#define CGW_SUMMARY_INIT \
  { (uint32_t)sizeof(cgw_summary), 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0 }

/* ---- certificate and measures (since 1.1) ---------------------------------------------------------------------- */

/* Whether a cage encloses a model, and what keeps it from it, by exact tests of the doubles given. Vertices and
   triangles are rows of the meshes that were given: to set_mesh and by get_cage, or to evaluation_create. */
typedef struct cgw_certificate {
  uint32_t struct_size;
  /* 1: closed is 1, and the counts below are 0. Vertices that no triangle of the model uses, and triangles of it that
     name a position twice, do not count as model. */
  uint32_t encloses;
  /* 1: a closed, consistently oriented 2-manifold whose pieces face outward, but for those that lie in others. */
  uint32_t closed;
  /* 1: cage and model are nowhere nearer than refine.delta asks for, in floating point; 0 for evaluations. */
  uint32_t keeps_distance;
  uint64_t degenerate_count;         /* set: cage triangles whose corners lie on a line */
  uint64_t self_intersection_count;  /* set: pairs of cage triangles that meet but in what they share */
  uint64_t model_intersection_count; /* set: model triangles that meet the cage; to touch is to meet */
  uint64_t outside_count;            /* set: model vertices that are not inside; on the cage is not inside */
  uint32_t* degenerate_triangles;    /* degenerate_count, or NULL */
  uint64_t degenerate_capacity;
  uint32_t* self_intersections; /* self_intersection_count x 2, or NULL */
  uint64_t self_intersection_capacity;
  uint32_t*
      model_intersections; /* model_intersection_count x 2, or NULL: model triangle, first cage triangle it meets */
  uint64_t model_intersection_capacity;
  uint32_t* outside_vertices; /* outside_count, or NULL */
  uint64_t outside_capacity;
  const char* message; /* "" or the sentence that names the slides at fault and what to do; lives until the next solve,
                          set_mesh or load_state, and as long as the session. "" for evaluations */
  /* Since 1.5. */
  uint64_t finding_count; /* set: what the message is made of, a sentence each: get_finding. 0 for evaluations */
} cgw_certificate;
#define CGW_CERTIFICATE_INIT \
  { (uint32_t)sizeof(cgw_certificate), 0, 0, 0, 0, 0, 0, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0 }

/* One sentence of a certificate's message: what keeps the cage from enclosing the model, or could be better of it.
   Since 1.5. */
typedef struct cgw_finding {
  uint32_t struct_size;
  uint32_t has_point;   /* 1: a place is known */
  double point[3];      /* of the model as it was given to set_mesh; 0 where none is known */
  const char* message;  /* lives as long as that of the certificate */
  uint64_t slide_count; /* set: slides that the sentence names */
  uint64_t* slides;     /* slide_count ids, in the order of the slides, or NULL; those that are there no more, too */
  uint64_t slide_capacity;
  uint32_t is_advice; /* 1: the cage could be better, but has all that was asked for; 0: that is what is missing */
  uint32_t reserved;
} cgw_finding;
#define CGW_FINDING_INIT \
  { (uint32_t)sizeof(cgw_finding), 0, {0, 0, 0}, NULL, 0, NULL, 0, 0, 0 }

/* How closely a cage fits and how well it is shaped. Lengths are fractions of the diagonal of the model's bounding box,
   angles are radians. What has no meaning is NaN: volume_ratio and coverage where a mesh is not closed, asymmetry where
   the model is not symmetric, sections of an evaluation. docs/algorithms/measures.md defines each. */
typedef struct cgw_measures {
  uint32_t struct_size;
  uint32_t reserved;
  double volume_ratio; /* cage over model */
  double mean_gap;     /* from the cage to the model's surface, by the cage's area */
  double max_gap;
  double coverage;                          /* share of the model's vertices inside, by area */
  double clearance;                         /* the least distance between cage and model, 0 where they meet */
  double least_dihedral, greatest_dihedral; /* interior angle at the cage's edges: pi is flat */
  double greatest_aspect;                   /* longest edge over 2 sqrt(3) times the inradius: 1 is equilateral */
  double mean_asymmetry, max_asymmetry;     /* from the mirrored cage to the cage */
  double worst_squareness; /* of a section: the largest difference of a corner's angle from a right one */
  double worst_planarity;  /* of a section: the largest distance of a corner from its slide's plane */
  double worst_twist;      /* between sections that bound one part: the angle of equation (2) */
  uint64_t section_count;  /* set */
  uint64_t twist_count;    /* set: pairs of sections that bound one part */
  double* squareness;      /* section_count, or NULL */
  double* planarity;       /* section_count, or NULL */
  uint64_t section_capacity;
  double* twist;          /* twist_count, or NULL */
  int32_t* twist_between; /* twist_count x 2, or NULL: indices of sections */
  uint64_t twist_capacity;
} cgw_measures;
#define CGW_MEASURES_INIT \
  { (uint32_t)sizeof(cgw_measures), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, NULL, NULL, 0, NULL, NULL, 0 }

/* ---- streams --------------------------------------------------------------------------------------------------- */

/* The host's stream. Both functions return how many bytes they moved; less than asked for means failure or the end.
   Neither may call into the session (see cgw_host). */
typedef struct cgw_stream {
  uint32_t struct_size;
  uint32_t reserved;
  void* user;
  uint64_t (*read)(void* user, void* bytes, uint64_t count);        /* needed by load_state */
  uint64_t (*write)(void* user, const void* bytes, uint64_t count); /* needed by save_state */
} cgw_stream;
#define CGW_STREAM_INIT \
  { (uint32_t)sizeof(cgw_stream), 0, NULL, NULL, NULL }

/* ---- the table ------------------------------------------------------------------------------------------------- */

typedef struct cgw_session cgw_session;       /* one model with its slides, parameters and results */
typedef struct cgw_evaluation cgw_evaluation; /* what any cage is to any model; immutable */

typedef struct cgw_api {
  uint32_t struct_size;
  uint32_t abi_major;
  uint32_t abi_minor;
  uint32_t parameter_count;
  const char* version; /* of the plug-in, "major.minor.patch" */

  /* [any-thread] A short name of a status or stage, for logs; "unknown" for others. */
  const char* (*status_name)(cgw_status status);
  const char* (*stage_name)(int32_t stage);

  /* [any-thread] Parameter `index` < parameter_count. */
  cgw_status (*parameter_info)(uint32_t index, cgw_parameter* out);

  /* [any-thread] Counts what a mesh is, without a session and without refusing open or non-manifold ones.
     Errors: MESH_EMPTY, MESH_NOT_FINITE, MESH_INDEX. O(n log n). */
  cgw_status (*inspect_mesh)(const cgw_mesh* mesh, cgw_mesh_report* out);

  /* [any-thread] host may be NULL; it is copied, its functions and user pointer must outlive the session. */
  cgw_status (*session_create)(const cgw_host* host, cgw_session** out);
  /* [one-at-a-time] NULL is allowed. */
  void (*session_destroy)(cgw_session* session);

  /* [one-at-a-time] The sentence of the last call on this session that failed; "" where none did. With NULL: of the
     last call on this thread without a session, or refused since its session was in another call. Lives until the next
     call on the session (on the thread). */
  const char* (*last_error)(const cgw_session* session);
  cgw_status (*last_error_info)(const cgw_session* session, cgw_error_info* out);

  /* [one-at-a-time] Takes a copy of the model: welds, splits bow-tie vertices, turns what is inside out (the report
     says so), refuses what is open, non-manifold or not orientable. Slides and parameters stay, results go.
     Errors: MESH_*. O(n log n). */
  cgw_status (*set_mesh)(cgw_session* session, const cgw_mesh* mesh);
  cgw_status (*mesh_report)(const cgw_session* session, cgw_mesh_report* out);

  /* [one-at-a-time] Parameters. Text is a number, true/false, or a choice's name. Results stay until the next solve.
     Errors: UNKNOWN_PARAMETER, PARAMETER_OUT_OF_RANGE. */
  cgw_status (*set_parameter)(cgw_session* session, const char* id, double value);
  cgw_status (*set_parameter_text)(cgw_session* session, const char* id, const char* text);
  cgw_status (*get_parameter)(const cgw_session* session, const char* id, double* value);

  /* [one-at-a-time] Slides. What needs no model is checked here (SLIDE_NAME, STROKE_*, SLIDE_NOT_FINITE,
     SLIDE_DEGENERATE), the rest by solve. Results stay until the next solve. slide_info by index < slide_count, in the
     order in which slides were added. */
  cgw_status (*slide_add)(cgw_session* session, const cgw_slide_input* input, uint64_t* id);
  cgw_status (*slide_change)(cgw_session* session, uint64_t id, const cgw_slide_input* input);
  cgw_status (*slide_remove)(cgw_session* session, uint64_t id);
  uint64_t (*slide_count)(const cgw_session* session);
  cgw_status (*slide_info)(const cgw_session* session, uint64_t index, cgw_slide_info* out);

  /* [one-at-a-time] Makes the cage, or the stages up to options->last_stage. options may be NULL.
     On failure the results of the last good solve stay. */
  cgw_status (*solve)(cgw_session* session, const cgw_solve_options* options);

  /* [one-at-a-time] Results. Errors: NOT_READY, BUFFER_TOO_SMALL. Sections are one a slide, in the order of the slides
     at the time of the solve. */
  cgw_status (*get_parts)(const cgw_session* session, cgw_parts* out);
  uint64_t (*section_count)(const cgw_session* session);
  cgw_status (*get_section)(const cgw_session* session, uint64_t index, cgw_section* out);
  cgw_status (*get_loop)(const cgw_session* session, uint64_t index, cgw_loop* out);
  cgw_status (*get_cage)(const cgw_session* session, cgw_cage* out);
  uint64_t (*iteration_count)(const cgw_session* session);
  cgw_status (*get_iteration)(const cgw_session* session, uint64_t index, cgw_iteration* out);
  cgw_status (*get_summary)(const cgw_session* session, cgw_summary* out);

  /* [one-at-a-time] Slides and parameters (not results, not the mesh) with a magic, a version, a checksum and the
     mesh's fingerprint. load_state replaces slides and parameters; it needs the same mesh to be set. The slides' ids
     are then those of the file, which may have named other slides of the session before; so results go.
     Errors: NOT_READY (no mesh), STREAM, STATE_*. */
  cgw_status (*save_state)(const cgw_session* session, const cgw_stream* stream);
  cgw_status (*load_state)(cgw_session* session, const cgw_stream* stream);

  /* Since 1.1. */

  /* [one-at-a-time] Of the cage as the last solve left it; found when first asked for, unless the solve has. Errors:
     NOT_READY (no cage), BUFFER_TOO_SMALL. O((n + c) log n), n and c triangles. */
  cgw_status (*get_certificate)(const cgw_session* session, cgw_certificate* out);
  cgw_status (*get_measures)(const cgw_session* session, cgw_measures* out);

  /* [any-thread] Certificate and measures of any cage: nothing is mended, but vertices at the same position count as
     one, and the model may face inward. threads: as in cgw_solve_options. Errors: MESH_EMPTY (also: the model encloses
     no volume), MESH_NOT_FINITE, MESH_INDEX; the sentence says which of the two meshes. O((n + c) log n). */
  cgw_status (*evaluation_create)(const cgw_mesh* model, const cgw_mesh* cage, uint32_t threads, cgw_evaluation** out);
  /* [any-thread] NULL is allowed. Not while another call uses it. */
  void (*evaluation_destroy)(cgw_evaluation* evaluation);
  /* [any-thread] Errors: BUFFER_TOO_SMALL; the sentence is last_error(NULL)'s. */
  cgw_status (*evaluation_certificate)(const cgw_evaluation* evaluation, cgw_certificate* out);
  cgw_status (*evaluation_measures)(const cgw_evaluation* evaluation, cgw_measures* out);

  /* Since 1.3. */

  /* [one-at-a-time] What ellipse a slide would have on the session's model, without adding it: kind, has_ellipse,
     center, normal, u, v are set, id is CGW_NO_ID, name and message are "", status is CGW_OK. The name may be NULL or
     "", or that of a slide of the session; sentences say "the slide" where there is none. Of CGW_SLIDE_ELLIPSE the
     principal radii. To have a slide's centre in the middle of its loop, fit POINT_NORMAL with its centre and normal.
     Nothing changes. Errors: NOT_READY (no mesh), and those of one slide (STROKE_*, SLIDE_*) but SLIDE_NAME, by
     id CGW_NO_ID. O(n). */
  cgw_status (*slide_fit)(const cgw_session* session, const cgw_slide_input* input, cgw_slide_info* out);

  /* Since 1.5. */

  /* [one-at-a-time] One of the certificate's finding_count. Errors: NOT_READY (no cage), INVALID_ARGUMENT (index),
     BUFFER_TOO_SMALL. */
  cgw_status (*get_finding)(const cgw_session* session, uint64_t index, cgw_finding* out);
} cgw_api;

/* [any-thread] The only exported symbol. host_minor: the CGW_ABI_MINOR that the host was compiled with. The table is
   static and immutable and lives until the plug-in is unloaded; NULL where the plug-in cannot serve that host. */
typedef const cgw_api* (*cgw_get_api_fn)(uint32_t host_minor);
const cgw_api* cgw_get_api_v1(uint32_t host_minor);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mesh of a section.  The only room that talks to gmsh. */
#include "section_mesh.h"

#include "outline.h"

#include <dlfcn.h>
#include <gmshc.h>
#include <math.h>
#include <pthread.h>
#include <stddef.h>

enum { QUADRATIC_TRIANGLE = 9, NODES = 6 }; /* gmsh's number of the element type */

/* Sizes of triangles.  Where a wall is plain w is bilinear across and along it, which one quadratic
 * triangle holds; at a re-entrant corner w goes like r^(2/3), at a convex one its second derivative
 * like log r.  With these numbers J is within 1e-5 on rectangles and 1e-4 on I-sections. */
static const double PLAIN = 0.8;          /* of the wall's thickness */
static const double MOST_SLENDER = 10000; /* perimeter over thickness: some 20 000 triangles */
static const double STRAIGHT = 0.4; /* sine of the turn below which a vertex belongs to a curve */
static const struct {
    double size;   /* at the corner, of the section's mean thickness */
    double growth; /* of the size with the distance from it */
} CONVEX = {0.08, 0.08}, REENTRANT = {0.01, 0.45};

struct sizing {
    const struct hobe_outline *outline;
    double thickness; /* 2 A/perimeter: of a thin wall its thickness, of a square half its side */
    signed char *corner; /* [points] 1 convex, -1 re-entrant, 0 where the outline runs on */
};

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* The nearest point q of the outline to p, and the inward normal there.  Asked some hundred
 * thousand times: no square roots within the loop. */
static void nearest_edge(const struct hobe_outline *o, const double p[2], double q[2], double n[2])
{
    double best = INFINITY;
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++) {
            const double *a = o->point[i], *b = o->point[hobe_outline_next(o, l, i)];
            const double e[2] = {b[0] - a[0], b[1] - a[1]}, ap[2] = {p[0] - a[0], p[1] - a[1]};
            const double along = (ap[0] * e[0] + ap[1] * e[1]) / (e[0] * e[0] + e[1] * e[1]);
            const double t = along < 0 ? 0 : along > 1 ? 1 : along;
            const double d[2] = {ap[0] - t * e[0], ap[1] - t * e[1]};
            const double square = d[0] * d[0] + d[1] * d[1];
            if (square >= best)
                continue;
            best = square;
            q[0] = a[0] + t * e[0];
            q[1] = a[1] + t * e[1];
            n[0] = -e[1];
            n[1] = e[0];
        }
    const double length = hypot(n[0], n[1]);
    n[0] /= length;
    n[1] /= length;
}

/* How thick the wall is at p: from the nearest edge straight across to the next one. */
static double wall(const struct sizing *s, const double p[2])
{
    const struct hobe_outline *o = s->outline;
    double q[2] = {0, 0}, n[2] = {0, 1}, across = INFINITY;
    nearest_edge(o, p, q, n);
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++) {
            const double *a = o->point[i], *b = o->point[hobe_outline_next(o, l, i)];
            const double e[2] = {b[0] - a[0], b[1] - a[1]}, to[2] = {a[0] - q[0], a[1] - q[1]};
            /* q + d n = a + u e: u from 0 to 1 where a and b lie on different sides of the ray */
            const double from_b[2] = {b[0] - q[0], b[1] - q[1]};
            if ((cross(to, n) > 0) == (cross(from_b, n) > 0))
                continue;
            const double d = cross(to, e) / cross(n, e);
            if (d > 1e-6 * s->thickness)
                across = fmin(across, d);
        }
    return across;
}

static double size_at(int dim, int tag, double y, double z, double x, void *data)
{
    const struct sizing *s = data;
    const struct hobe_outline *o = s->outline;
    const double p[2] = {y, z};
    double size = fmax(PLAIN * wall(s, p), CONVEX.size * s->thickness);
    (void)dim, (void)tag, (void)x;
    for (int i = 0; i < o->start[o->loops]; i++)
        if (s->corner[i]) {
            const double far = hypot(y - o->point[i][0], z - o->point[i][1]);
            size =
                fmin(size, s->corner[i] < 0 ? REENTRANT.size * s->thickness + REENTRANT.growth * far
                                            : CONVEX.size * s->thickness + CONVEX.growth * far);
        }
    return size;
}

static enum hobe_status set_sizing(const struct hobe_outline *o, struct sizing *s,
                                   struct hobe_error *err)
{
    double perimeter = 0, twice = 0;
    *s = (struct sizing){.outline = o};
    s->corner = hobe_alloc((size_t)o->start[o->loops], sizeof *s->corner, err);
    if (!s->corner)
        return HOBE_NO_MEMORY;
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++) {
            const int j = hobe_outline_next(o, l, i), k = hobe_outline_next(o, l, j);
            const double *a = o->point[i], *b = o->point[j], *c = o->point[k];
            const double e[2] = {b[0] - a[0], b[1] - a[1]}, f[2] = {c[0] - b[0], c[1] - b[1]};
            const double lengths = hypot(e[0], e[1]) * hypot(f[0], f[1]);
            const double sine = cross(e, f) / lengths,
                         cosine = (e[0] * f[0] + e[1] * f[1]) / lengths;
            perimeter += hypot(e[0], e[1]);
            twice += cross(a, b);
            if (cosine < 0 || fabs(sine) > STRAIGHT)
                s->corner[j] = sine < 0 ? -1 : 1;
        }
    s->thickness = twice / perimeter;
    if (perimeter > MOST_SLENDER * s->thickness)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the section's walls are too thin to mesh: %g m on average, for %g m of "
                         "edges; at most 1 : %g is possible",
                         s->thickness, perimeter, MOST_SLENDER);
    return HOBE_OK;
}

/* ---- gmsh ----------------------------------------------------------------------------------- */

/* gmsh takes a tenth of a second to load with the ninety libraries behind it, so that it is loaded
 * when the first outline is meshed.  HOBE_GMSH is the library's file name. */
#define FUNCTIONS(X)                                                                               \
    X(gmshFinalize)                                                                                \
    X(gmshFree)                                                                                    \
    X(gmshInitialize)                                                                              \
    X(gmshModelGeoAddCurveLoop)                                                                    \
    X(gmshModelGeoAddLine)                                                                         \
    X(gmshModelGeoAddPlaneSurface)                                                                 \
    X(gmshModelGeoAddPoint)                                                                        \
    X(gmshModelGeoSynchronize)                                                                     \
    X(gmshModelMeshGenerate)                                                                       \
    X(gmshModelMeshGetElementsByType)                                                              \
    X(gmshModelMeshGetNodes)                                                                       \
    X(gmshModelMeshSetOrder)                                                                       \
    X(gmshModelMeshSetSizeCallback)                                                                \
    X(gmshOptionSetNumber)

#define MEMBER(f) __typeof__(&(f)) f;
static struct {
    void *library;
    FUNCTIONS(MEMBER)
} gmsh;

/* gmsh keeps its model in globals, too. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

#define FIND(f) found &= (*(void **)&gmsh.f = dlsym(library, #f)) != NULL;

static enum hobe_status load(struct hobe_error *err)
{
    if (gmsh.library)
        return HOBE_OK;
    void *library = dlopen(HOBE_GMSH, RTLD_LAZY | RTLD_LOCAL);
    int found = library != NULL;
    if (library) {
        FUNCTIONS(FIND)
    }
    if (!found)
        return hobe_fail(err, HOBE_IO, NULL, "the mesher of sections cannot be used: %.300s",
                         dlerror());
    gmsh.library = library;
    return HOBE_OK;
}

/* Calls return at the first failure; ierr is gmsh's. */
static void set_options(int *ierr)
{
    static const struct {
        const char *name;
        double value;
    } option[] = {
        {"General.Terminal", 0},
        {"General.NumThreads", 1},
        {"Mesh.Algorithm", 6}, /* frontal Delaunay: good triangles of graded size */
        {"Mesh.RandomSeed", 1},
        {"Mesh.MeshSizeFromPoints", 0},
        {"Mesh.MeshSizeExtendFromBoundary", 0},
    };
    for (size_t i = 0; !*ierr && i < sizeof option / sizeof *option; i++)
        gmsh.gmshOptionSetNumber(option[i].name, option[i].value, ierr);
}

/* One loop of points and lines, which have the same tags; the loop's tag is l + 1. */
static void add_loop(const struct hobe_outline *o, int l, int *tags, int *ierr)
{
    const int from = o->start[l], to = o->start[l + 1];
    for (int i = from; !*ierr && i < to; i++)
        gmsh.gmshModelGeoAddPoint(o->point[i][0], o->point[i][1], 0, 0, i + 1, ierr);
    for (int i = from; !*ierr && i < to; i++) {
        gmsh.gmshModelGeoAddLine(i + 1, hobe_outline_next(o, l, i) + 1, i + 1, ierr);
        tags[i - from] = i + 1;
    }
    if (!*ierr)
        gmsh.gmshModelGeoAddCurveLoop(tags, (size_t)(to - from), l + 1, 0, ierr);
}

static void generate(struct sizing *s, int *tags, int *ierr)
{
    const struct hobe_outline *o = s->outline;
    set_options(ierr);
    for (int l = 0; !*ierr && l < o->loops; l++)
        add_loop(o, l, tags, ierr);
    for (int l = 0; l < o->loops; l++)
        tags[l] = l + 1;
    if (!*ierr)
        gmsh.gmshModelGeoAddPlaneSurface(tags, (size_t)o->loops, 1, ierr);
    if (!*ierr)
        gmsh.gmshModelGeoSynchronize(ierr);
    if (!*ierr)
        gmsh.gmshModelMeshSetSizeCallback(size_at, s, ierr);
    if (!*ierr)
        gmsh.gmshModelMeshGenerate(2, ierr);
    if (!*ierr)
        gmsh.gmshModelMeshSetOrder(2, ierr);
}

/* gmsh's arrays of the finished mesh: tags count from 1 with gaps. */
struct raw {
    size_t *tag, *element, *of;
    double *coordinate, *parameter;
    size_t tags, elements, ofs, coordinates, parameters;
};

static void fetch(struct raw *raw, int *ierr)
{
    gmsh.gmshModelMeshGetNodes(&raw->tag, &raw->tags, &raw->coordinate, &raw->coordinates,
                               &raw->parameter, &raw->parameters, -1, -1, 0, 0, ierr);
    if (!*ierr)
        gmsh.gmshModelMeshGetElementsByType(QUADRATIC_TRIANGLE, &raw->element, &raw->elements,
                                            &raw->of, &raw->ofs, -1, 0, 1, ierr);
}

static void free_raw(struct raw *raw)
{
    gmsh.gmshFree(raw->tag);
    gmsh.gmshFree(raw->element);
    gmsh.gmshFree(raw->of);
    gmsh.gmshFree(raw->coordinate);
    gmsh.gmshFree(raw->parameter);
}

/* Numbers the nodes from 0 and turns the triangles anticlockwise. */
static enum hobe_status take(const struct raw *raw, struct hobe_mesh *mesh, struct hobe_error *err)
{
    size_t most = 0;
    for (size_t i = 0; i < raw->tags; i++)
        most = raw->tag[i] > most ? raw->tag[i] : most;
    int *number = hobe_alloc(most + 1, sizeof *number, err);
    mesh->node = hobe_alloc(raw->tags, sizeof *mesh->node, err);
    mesh->triangle = hobe_alloc(raw->elements, sizeof *mesh->triangle, err);
    if (!number || !mesh->node || !mesh->triangle) {
        hobe_free(number);
        return HOBE_NO_MEMORY;
    }
    mesh->nodes = (int)raw->tags;
    mesh->triangles = (int)raw->elements;
    for (size_t i = 0; i < raw->tags; i++) {
        number[raw->tag[i]] = (int)i;
        mesh->node[i][0] = raw->coordinate[3 * i];
        mesh->node[i][1] = raw->coordinate[3 * i + 1];
    }
    for (size_t t = 0; t < raw->elements; t++) {
        static const int turned[NODES] = {0, 2, 1, 5, 4, 3};
        const size_t *tag = raw->of + NODES * t;
        const double *a = mesh->node[number[tag[0]]], *b = mesh->node[number[tag[1]]];
        const double *c = mesh->node[number[tag[2]]];
        const double ab[2] = {b[0] - a[0], b[1] - a[1]}, ac[2] = {c[0] - a[0], c[1] - a[1]};
        const int turn = cross(ab, ac) < 0;
        for (int i = 0; i < NODES; i++)
            mesh->triangle[t][i] = number[tag[turn ? turned[i] : i]];
    }
    hobe_free(number);
    return HOBE_OK;
}

static enum hobe_status run(struct sizing *s, int *tags, struct hobe_mesh *mesh,
                            struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    struct raw raw = {0};
    int ierr = 0, ignored;
    gmsh.gmshInitialize(0, NULL, 0, &ierr);
    if (!ierr)
        generate(s, tags, &ierr);
    if (!ierr)
        fetch(&raw, &ierr);
    if (ierr || !raw.elements)
        status =
            hobe_fail(err, HOBE_BAD_INPUT, NULL,
                      "the section's outline of %d points could not be meshed; points that "
                      "nearly coincide or walls far thinner than the rest are the usual reason",
                      s->outline->start[s->outline->loops]);
    if (!status)
        status = take(&raw, mesh, err);
    free_raw(&raw);
    gmsh.gmshFinalize(&ignored);
    return status;
}

enum hobe_status hobe_mesh_outline(const struct hobe_outline *outline, struct hobe_mesh *mesh,
                                   struct hobe_error *err)
{
    const size_t points = (size_t)outline->start[outline->loops];
    struct sizing sizing;
    *mesh = (struct hobe_mesh){0};
    enum hobe_status status = set_sizing(outline, &sizing, err);
    int *tags = status ? NULL : hobe_alloc(points, sizeof *tags, err);
    if (tags) {
        pthread_mutex_lock(&lock);
        status = load(err);
        if (!status)
            status = run(&sizing, tags, mesh, err);
        pthread_mutex_unlock(&lock);
    } else if (!status)
        status = HOBE_NO_MEMORY;
    hobe_free(tags);
    hobe_free(sizing.corner);
    if (status)
        hobe_mesh_free(mesh);
    return status;
}

void hobe_mesh_free(struct hobe_mesh *mesh)
{
    hobe_free(mesh->node);
    hobe_free(mesh->triangle);
    *mesh = (struct hobe_mesh){0};
}

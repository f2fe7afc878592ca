/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mesh of a section.  The only room that talks to gmsh. */
#include "section_mesh.h"

#include "outline.h"
#include "section_mirror.h"

#include <dlfcn.h>
#include <gmshc.h>
#include <math.h>
#include <pthread.h>
#include <stddef.h>
#include <string.h>

enum { QUADRATIC_TRIANGLE = 9, NODES = 6 }; /* gmsh's number of the element type */

/* Sizes of triangles.  Where a wall is plain w is bilinear across and along it, which one quadratic
 * triangle holds; at a re-entrant corner w goes like r^(2/3), at a convex one its second derivative
 * like log r.  With these numbers J is within 1e-5 on rectangles and 1e-4 on I-sections. */
static const double PLAIN = 0.8;          /* of the wall's thickness */
static const double MOST_SLENDER = 10000; /* perimeter over thickness: some 20 000 triangles */
static const double SAME = 1e-7;          /* of the section's extent: closer points are one */
static const double STRAIGHT = 0.4; /* sine of the turn below which a vertex belongs to a curve */
static const struct {
    double size;   /* at the corner, of the section's mean thickness */
    double growth; /* of the size with the distance from it */
} CONVEX = {0.08, 0.08}, REENTRANT = {0.01, 0.45};

/* Away from a part of a section triangles may grow by this much of the distance. */
static const double OUTSIDE = 0.5;

/* One outline and what sizes its triangles. */
struct sizing {
    const struct hobe_outline *outline;
    double thickness; /* 2 A/perimeter: of a thin wall its thickness, of a square half its side */
    signed char *corner; /* [points] 1 convex, -1 re-entrant, 0 where the outline runs on */
    int group;           /* the first part it hangs together with */
};

struct job {
    int parts;
    struct sizing *part; /* [parts] */
    double unit;         /* of lengths in gmsh, m: the section's extent, for absolute tolerances */
    int points;          /* of all parts */
    int *tags;           /* scratch, [points] */
    int mirrored[2];     /* whether all outlines are their own image under y -> 2 at[0] - y; z */
    double at[2];        /* m */
};

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* The nearest point q of the outline to p, and the inward normal there; returns the distance. Asked
 * some hundred thousand times: no square roots within the loop. */
static double nearest_edge(const struct hobe_outline *o, const double p[2], double q[2],
                           double n[2])
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
    return sqrt(best);
}

/* How thick the wall is at p: from the nearest edge straight across to the next one.  outside: how
 * far p lies out of the outline. */
static double wall(const struct sizing *s, const double p[2], double *outside)
{
    const struct hobe_outline *o = s->outline;
    double q[2] = {0, 0}, n[2] = {0, 1}, across = INFINITY;
    const double far = nearest_edge(o, p, q, n);
    *outside = (p[0] - q[0]) * n[0] + (p[1] - q[1]) * n[1] < 0 ? far : 0;
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

/* The size that one outline asks for at p. */
static double size_for(const struct sizing *s, const double p[2])
{
    const struct hobe_outline *o = s->outline;
    double outside;
    double size = fmax(PLAIN * wall(s, p, &outside), CONVEX.size * s->thickness);
    size += OUTSIDE * outside;
    for (int i = 0; i < o->start[o->loops]; i++)
        if (s->corner[i]) {
            const double far = hypot(p[0] - o->point[i][0], p[1] - o->point[i][1]);
            size =
                fmin(size, s->corner[i] < 0 ? REENTRANT.size * s->thickness + REENTRANT.growth * far
                                            : CONVEX.size * s->thickness + CONVEX.growth * far);
        }
    return size;
}

static double size_at(int dim, int tag, double y, double z, double x, void *data)
{
    const struct job *job = data;
    const double p[2] = {y * job->unit, z * job->unit};
    double size = INFINITY;
    (void)dim, (void)tag, (void)x;
    for (int i = 0; i < job->parts; i++)
        size = fmin(size, size_for(job->part + i, p));
    return size / job->unit;
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

/* The angle of material around p: 2 pi within the outline, that between the edges at a point of it,
 * pi on an edge, 0 outside. */
static double angle_around(const struct hobe_outline *o, const double p[2], double near)
{
    for (int l = 0; l < o->loops; l++)
        for (int i = o->start[l]; i < o->start[l + 1]; i++) {
            const int j = hobe_outline_next(o, l, i), k = hobe_outline_next(o, l, j);
            const double *a = o->point[i], *b = o->point[j], *c = o->point[k];
            const double e[2] = {b[0] - a[0], b[1] - a[1]}, f[2] = {c[0] - b[0], c[1] - b[1]};
            const double ap[2] = {p[0] - a[0], p[1] - a[1]}, length = hypot(e[0], e[1]);
            const double along = (ap[0] * e[0] + ap[1] * e[1]) / length;
            if (hypot(p[0] - b[0], p[1] - b[1]) < near)
                return M_PI - atan2(cross(e, f), e[0] * f[0] + e[1] * f[1]);
            if (fabs(cross(e, ap)) < near * length && along > near && along < length - near)
                return M_PI;
        }
    return hobe_outline_holds(o, p) ? 2 * M_PI : 0;
}

/* Corners of parts are re-entrant ones of the section where the parts around them fill more than a
 * half plane; within the section, too, since w is singular where materials meet at a corner. */
static void join_corners(struct job *job)
{
    for (int k = 0; k < job->parts; k++) {
        const struct hobe_outline *o = job->part[k].outline;
        for (int i = 0; i < o->start[o->loops]; i++) {
            double angle = 0;
            for (int m = 0; m < job->parts && job->part[k].corner[i]; m++)
                angle += angle_around(job->part[m].outline, o->point[i], SAME * job->unit);
            if (angle > M_PI + STRAIGHT)
                job->part[k].corner[i] = -1;
        }
    }
}

/* ---- gmsh ----------------------------------------------------------------------------------- */

/* gmsh takes a tenth of a second to load with the ninety libraries behind it, so that it is loaded
 * when the first outline is meshed.  HOBE_GMSH is the library's file name. */
#define FUNCTIONS(X)                                                                               \
    X(gmshFinalize)                                                                                \
    X(gmshFree)                                                                                    \
    X(gmshInitialize)                                                                              \
    X(gmshModelMeshGenerate)                                                                       \
    X(gmshModelMeshGetElementsByType)                                                              \
    X(gmshModelMeshGetNodes)                                                                       \
    X(gmshModelMeshSetOrder)                                                                       \
    X(gmshModelMeshSetSizeCallback)                                                                \
    X(gmshModelOccAddCurveLoop)                                                                    \
    X(gmshModelOccAddLine)                                                                         \
    X(gmshModelOccAddPlaneSurface)                                                                 \
    X(gmshModelOccAddPoint)                                                                        \
    X(gmshModelOccAddRectangle)                                                                    \
    X(gmshModelOccFragment)                                                                        \
    X(gmshModelOccGetEntities)                                                                     \
    X(gmshModelOccIntersect)                                                                       \
    X(gmshModelOccSynchronize)                                                                     \
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

/* Loop l of a part: points and lines have the same tags, those of the loop follow `before`.  All
 * run anticlockwise: halves of a surface whose hole runs the other way would be those of the hole.
 */
static void add_loop(struct job *job, const struct hobe_outline *o, int l, int before, int loop,
                     int *ierr)
{
    const int from = o->start[l], to = o->start[l + 1];
    for (int i = from; !*ierr && i < to; i++)
        gmsh.gmshModelOccAddPoint(o->point[i][0] / job->unit, o->point[i][1] / job->unit, 0, 0,
                                  before + i + 1, ierr);
    for (int i = from; !*ierr && i < to; i++) {
        const int point[2] = {before + i + 1, before + hobe_outline_next(o, l, i) + 1};
        job->tags[l ? to - 1 - i : i - from] = point[0];
        gmsh.gmshModelOccAddLine(point[l > 0], point[l == 0], point[0], ierr);
    }
    if (!*ierr)
        gmsh.gmshModelOccAddCurveLoop(job->tags, (size_t)(to - from), loop, ierr);
}

/* One surface for each part, tags 1, 2, ... */
static void add_parts(struct job *job, int *ierr)
{
    int points = 0, loops = 0;
    for (int k = 0; k < job->parts; k++) {
        const struct hobe_outline *o = job->part[k].outline;
        for (int l = 0; !*ierr && l < o->loops; l++)
            add_loop(job, o, l, points, loops + l + 1, ierr);
        for (int l = 0; l < o->loops; l++)
            job->tags[l] = loops + l + 1;
        if (!*ierr)
            gmsh.gmshModelOccAddPlaneSurface(job->tags, (size_t)o->loops, k + 1, ierr);
        points += o->start[o->loops];
        loops += o->loops;
    }
}

static void free_map(int **map, size_t *counts, size_t maps)
{
    for (size_t i = 0; i < maps; i++)
        gmsh.gmshFree(map[i]);
    gmsh.gmshFree(map);
    gmsh.gmshFree(counts);
}

/* Leaves of the surfaces what lies on the positive sides of their mirrors. */
static void halve(const struct job *job, int *ierr)
{
    const double far = 4; /* beyond a section of extent 1 */
    double corner[2], size[2];
    int *surface = NULL, *out = NULL, **map = NULL;
    size_t surfaces = 0, outs, *counts = NULL, maps = 0;
    for (int a = 0; a < 2; a++) {
        corner[a] = job->at[a] / job->unit - (job->mirrored[a] ? 0 : far);
        size[a] = job->mirrored[a] ? far : 2 * far;
    }
    gmsh.gmshModelOccGetEntities(&surface, &surfaces, 2, ierr);
    if (!*ierr) {
        int half[2] = {2, gmsh.gmshModelOccAddRectangle(corner[0], corner[1], 0, size[0], size[1],
                                                        -1, 0, ierr)};
        gmsh.gmshModelOccIntersect(surface, surfaces, half, 2, &out, &outs, &map, &counts, &maps,
                                   -1, 1, 1, ierr);
    }
    free_map(map, counts, maps);
    gmsh.gmshFree(out);
    gmsh.gmshFree(surface);
}

/* Cuts the surfaces where they meet, so that they share edges. */
static void join_parts(int *ierr)
{
    int *surface = NULL, *out = NULL, **map = NULL;
    size_t surfaces = 0, outs, *counts = NULL, maps = 0;
    gmsh.gmshModelOccGetEntities(&surface, &surfaces, 2, ierr);
    if (!*ierr)
        gmsh.gmshModelOccFragment(surface, 2, surface + 2, surfaces - 2, &out, &outs, &map, &counts,
                                  &maps, -1, 1, 1, ierr);
    free_map(map, counts, maps);
    gmsh.gmshFree(out);
    gmsh.gmshFree(surface);
}

static void generate(struct job *job, int *ierr)
{
    set_options(ierr);
    add_parts(job, ierr);
    if (!*ierr && job->parts > 1)
        join_parts(ierr);
    if (!*ierr && (job->mirrored[0] || job->mirrored[1]))
        halve(job, ierr);
    if (!*ierr)
        gmsh.gmshModelOccSynchronize(ierr);
    if (!*ierr)
        gmsh.gmshModelMeshSetSizeCallback(size_at, job, ierr);
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

/* Numbers the nodes of triangles from 0 and turns the triangles anticlockwise. */
static enum hobe_status take(const struct raw *raw, double unit, struct hobe_mesh *mesh,
                             struct hobe_error *err)
{
    size_t most = 0;
    for (size_t i = 0; i < raw->tags; i++)
        most = raw->tag[i] > most ? raw->tag[i] : most;
    int *number = hobe_alloc(most + 1, sizeof *number, err);
    mesh->node = hobe_alloc(raw->tags, sizeof *mesh->node, err);
    mesh->triangle = hobe_alloc(raw->elements, sizeof *mesh->triangle, err);
    mesh->region = hobe_alloc(raw->elements, sizeof *mesh->region, err);
    if (!number || !mesh->node || !mesh->triangle || !mesh->region) {
        hobe_free(number);
        return HOBE_NO_MEMORY;
    }
    mesh->triangles = (int)raw->elements;
    for (size_t i = 0; i < raw->ofs; i++)
        number[raw->of[i]] = 1;
    for (size_t i = 0; i < raw->tags; i++)
        if (number[raw->tag[i]]) {
            double *node = mesh->node[mesh->nodes];
            number[raw->tag[i]] = mesh->nodes++;
            node[0] = raw->coordinate[3 * i] * unit;
            node[1] = raw->coordinate[3 * i + 1] * unit;
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

/* The part that holds the middle of each triangle. */
static enum hobe_status set_regions(const struct job *job, struct hobe_mesh *mesh,
                                    struct hobe_error *err)
{
    for (int t = 0; t < mesh->triangles; t++) {
        const int *n = mesh->triangle[t];
        double p[2];
        int held = 0;
        for (int a = 0; a < 2; a++)
            p[a] = (mesh->node[n[0]][a] + mesh->node[n[1]][a] + mesh->node[n[2]][a]) / 3;
        for (int k = 0; k < job->parts; k++) {
            if (!hobe_outline_holds(job->part[k].outline, p))
                continue;
            if (held++)
                return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                                 "parts %d and %d overlap at (%g, %g); parts must touch only",
                                 mesh->region[t] + 1, k + 1, p[0], p[1]);
            mesh->region[t] = k;
        }
    }
    return HOBE_OK;
}

/* Parts whose triangles share the middle of a side hang together. */
static void join_groups(struct job *job, const struct hobe_mesh *mesh, int *region)
{
    for (int n = 0; n < mesh->nodes; n++)
        region[n] = -1;
    for (int k = 0; k < job->parts; k++)
        job->part[k].group = k;
    for (int t = 0; t < mesh->triangles; t++)
        for (int i = 3; i < NODES; i++) {
            int *other = region + mesh->triangle[t][i];
            const int here = job->part[mesh->region[t]].group;
            const int there = *other < 0 ? here : job->part[*other].group;
            for (int k = 0; k < job->parts && here != there; k++)
                if (job->part[k].group == here || job->part[k].group == there)
                    job->part[k].group = here < there ? here : there;
            *other = mesh->region[t];
        }
}

static enum hobe_status check_joined(struct job *job, const struct hobe_mesh *mesh,
                                     struct hobe_error *err)
{
    int *region = hobe_alloc((size_t)mesh->nodes, sizeof *region, err);
    if (!region)
        return HOBE_NO_MEMORY;
    join_groups(job, mesh, region);
    hobe_free(region);
    for (int k = 0; k < job->parts; k++)
        if (job->part[k].group)
            return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                             "part %d is apart from part 1; the parts of a section must hang "
                             "together by edges along which they touch",
                             k + 1);
    return HOBE_OK;
}

static enum hobe_status run(struct job *job, struct hobe_mesh *mesh, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    struct raw raw = {0};
    int ierr = 0, ignored;
    gmsh.gmshInitialize(0, NULL, 0, &ierr);
    if (!ierr)
        generate(job, &ierr);
    if (!ierr)
        fetch(&raw, &ierr);
    if (ierr || !raw.elements)
        status =
            hobe_fail(err, HOBE_BAD_INPUT, NULL,
                      "the section's outline of %d points could not be meshed; points that "
                      "nearly coincide or walls far thinner than the rest are the usual reason",
                      job->points);
    if (!status)
        status = take(&raw, job->unit, mesh, err);
    free_raw(&raw);
    gmsh.gmshFinalize(&ignored);
    for (int a = 0; a < 2; a++)
        if (!status && job->mirrored[a])
            status = mirror_mesh(mesh, a, job->at[a], SAME * job->unit, err);
    if (!status)
        status = set_regions(job, mesh, err);
    return status ? status : check_joined(job, mesh, err);
}

static enum hobe_status set_job(int parts, const struct hobe_outline *outline, struct job *job,
                                struct hobe_error *err)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    job->part = hobe_alloc((size_t)parts, sizeof *job->part, err);
    if (!job->part)
        return HOBE_NO_MEMORY;
    job->parts = parts;
    for (int k = 0; k < parts; k++) {
        const struct hobe_outline *o = outline + k;
        const enum hobe_status status = set_sizing(o, job->part + k, err);
        if (status)
            return status;
        for (int i = 0; i < o->start[1]; i++)
            for (int a = 0; a < 2; a++) {
                low[a] = fmin(low[a], o->point[i][a]);
                high[a] = fmax(high[a], o->point[i][a]);
            }
        job->points += o->start[o->loops];
    }
    job->unit = fmax(high[0] - low[0], high[1] - low[1]);
    if (parts > 1)
        join_corners(job);
    for (int a = 0; a < 2; a++)
        job->mirrored[a] = mirror_outlines(parts, outline, a, SAME * job->unit, job->at + a);
    job->tags = hobe_alloc((size_t)job->points, sizeof *job->tags, err);
    return job->tags ? HOBE_OK : HOBE_NO_MEMORY;
}

enum hobe_status hobe_mesh_outlines(int parts, const struct hobe_outline *outline,
                                    struct hobe_mesh *mesh, struct hobe_error *err)
{
    struct job job = {0};
    *mesh = (struct hobe_mesh){0};
    enum hobe_status status = set_job(parts, outline, &job, err);
    if (!status) {
        pthread_mutex_lock(&lock);
        status = load(err);
        if (!status)
            status = run(&job, mesh, err);
        pthread_mutex_unlock(&lock);
    }
    if (!status)
        status = hobe_mesh_set_index(mesh, err);
    for (int k = 0; k < job.parts; k++)
        hobe_free(job.part[k].corner);
    hobe_free(job.part);
    hobe_free(job.tags);
    if (status)
        hobe_mesh_free(mesh);
    return status;
}

enum hobe_status hobe_mesh_copy(const struct hobe_mesh *from, struct hobe_mesh *to,
                                struct hobe_error *err)
{
    const size_t n = (size_t)from->nodes, t = (size_t)from->triangles;
    *to = (struct hobe_mesh){from->nodes,
                             from->triangles,
                             hobe_alloc(n, sizeof *to->node, err),
                             hobe_alloc(t, sizeof *to->triangle, err),
                             hobe_alloc(t, sizeof *to->region, err),
                             {NULL, NULL},
                             NULL};
    if (!to->node || !to->triangle || !to->region) {
        hobe_mesh_free(to);
        return HOBE_NO_MEMORY;
    }
    memcpy(to->node, from->node, n * sizeof *to->node);
    memcpy(to->triangle, from->triangle, t * sizeof *to->triangle);
    memcpy(to->region, from->region, t * sizeof *to->region);
    return HOBE_OK;
}

int hobe_mesh_upright(const struct hobe_mesh *mesh)
{
    for (int t = 0; t < mesh->triangles; t++) {
        const int *n = mesh->triangle[t];
        const double *a = mesh->node[n[0]], *b = mesh->node[n[1]], *c = mesh->node[n[2]];
        const double ab[2] = {b[0] - a[0], b[1] - a[1]}, ac[2] = {c[0] - a[0], c[1] - a[1]};
        if (!(cross(ab, ac) > 0))
            return 0;
    }
    return 1;
}

void hobe_mesh_free(struct hobe_mesh *mesh)
{
    hobe_free(mesh->node);
    hobe_free(mesh->triangle);
    hobe_free(mesh->region);
    hobe_free(mesh->image[0]);
    hobe_free(mesh->image[1]);
    hobe_mesh_free_index(mesh);
    *mesh = (struct hobe_mesh){0};
}

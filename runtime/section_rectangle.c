/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rectangles, the series of their Saint-Venant warping function, and the cubics of their bending
 * shear. */
#include "outline.h"
#include "section_surface.h"
#include "section_taper.h"

#include <math.h>
#include <stdio.h>

enum {
    WARPING_POINTS = 32, /* Gauss points per side or panel for w: J to 1e-8, see tests/runtime.
                            Of the large rules GSL has but some to full precision: 32, 64, 96.
                            More than any polynomial needs */
    PAPER_POINTS = 3,    /* Tang et al. 2022 */
    MAX_TERMS = 300,     /* the torsion constant's tail is below 1/(8 (2 n)^4): 1e-12 */
    MAX_POINTS = 3 * WARPING_POINTS
};

/* w of a rectangle differs from -+ y z within about one width of its short ends only. */
static const double SLENDER = 4, END_WIDTHS = 2;

/* The series of eq. 33 with the sine along one side and the hyperbolic sine along the other:
 *
 *     w = sign (y z + sum over odd n of c_n sin(n pi s/S) sinh(n pi t/S)),
 *     c_n = (-1)^((n+1)/2) 8 S^2 / (n^3 pi^3 cosh(n pi T/(2S))),
 *
 * (s, t) = (z, y) and sign +, as the paper has it, or (y, z) and sign -: both are Saint-Venant's
 * function.  The terms decay from the edges t = +-T/2 inwards like exp(-n pi (T/2 - |t|)/S), so the
 * sine belongs along the short side. */
struct series {
    int terms;
    int sine_along_y;
    double sine, hyperbolic;           /* S, T */
    double a[MAX_TERMS], c[MAX_TERMS]; /* n pi/S; c_n cosh(n pi T/(2S)) / (1 + exp(-n pi T/S)) */
};

struct rectangle {
    struct hobe_section base;
    double width, height;
    enum hobe_warping warping;
    struct series series, paper_series;
    struct hobe_rule functions_rule; /* kept because w costs most of the set-up */
};

static void set_series(struct series *w, double width, double height, enum hobe_warping warping)
{
    w->terms = warping == HOBE_WARPING_PAPER ? 1 : MAX_TERMS;
    w->sine_along_y = warping == HOBE_WARPING_SERIES && width < height;
    w->sine = w->sine_along_y ? width : height;
    w->hyperbolic = w->sine_along_y ? height : width;
    for (int i = 0; i < w->terms; i++) {
        const double n = 2 * i + 1, pi_n = M_PI * n;
        w->a[i] = pi_n / w->sine;
        w->c[i] = (i % 2 ? 8.0 : -8.0) * w->sine * w->sine / (pi_n * pi_n * pi_n) /
                  (1 + exp(-w->a[i] * w->hyperbolic));
    }
}

/* w and its gradient at (y, z): f[3].  From one term to the next sine and exponentials go by
 * products, which costs a tenth of calling for them and a few digits of the far, small terms. */
static void warping(const struct series *w, double y, double z, double *f)
{
    const double s = w->sine_along_y ? y : z, t = w->sine_along_y ? z : y;
    const double step = 2 * w->a[0], turn_cos = cos(step * s), turn_sin = sin(step * s);
    /* sinh(a t)/cosh(a T/2) and cosh(a t)/cosh(a T/2) without overflow, but for 1 + exp(-a T) */
    double grow = exp(w->a[0] * (fabs(t) - w->hyperbolic / 2)), decay = exp(-step * fabs(t));
    const double growth = exp(step * (fabs(t) - w->hyperbolic / 2)), fall = decay * decay;
    double cos_s = cos(w->a[0] * s), sin_s = sin(w->a[0] * s), sum = 0, sum_s = 0, sum_t = 0;
    for (int i = 0; i < w->terms && grow >= 1e-18; i++) {
        const double sinh_t = grow * (1 - decay), cosh_t = grow * (1 + decay), before = cos_s;
        sum += w->c[i] * sin_s * sinh_t;
        sum_s += w->c[i] * w->a[i] * cos_s * sinh_t;
        sum_t += w->c[i] * w->a[i] * sin_s * cosh_t;
        cos_s = before * turn_cos - sin_s * turn_sin;
        sin_s = before * turn_sin + sin_s * turn_cos;
        grow *= growth;
        decay *= fall;
    }
    sum = copysign(1, t) * sum;
    sum_s = copysign(1, t) * sum_s;
    const double sign = w->sine_along_y ? -1 : 1;
    f[0] = sign * (y * z + sum);
    f[1] = sign * (z + (w->sine_along_y ? sum_s : sum_t));
    f[2] = sign * (y + (w->sine_along_y ? sum_t : sum_s));
}

/* Bending shear along the side s of length S: psi = S^2 s/8 - s^3/6 has psi'' = -s and psi' = 0 at
 * its ends; without its part along s. */
static void flexure(double length, double s, double *value, double *slope)
{
    const double a = length / 2;
    *value = s * (a * a / 10 - s * s / 6);
    *slope = a * a / 10 - s * s / 2;
}

static void functions(const struct rectangle *r, int paper, double y, double z, double (*f)[4])
{
    warping(paper ? &r->paper_series : &r->series, y, z, f[HOBE_W]);
    flexure(r->width, y, &f[HOBE_WY][0], &f[HOBE_WY][1]);
    flexure(r->height, z, &f[HOBE_WZ][0], &f[HOBE_WZ][2]);
}

/* Beyond the outline, where the series of w has no bound, those of the nearest point. */
static void functions_at(const hobe_section *section, int paper, double y, double z, double (*f)[4])
{
    const struct rectangle *r = (const struct rectangle *)section;
    const double most[2] = {r->width / 2, r->height / 2};
    functions(r, paper, fmax(-most[0], fmin(y, most[0])), fmax(-most[1], fmin(z, most[1])), f);
}

/* Saint-Venant's torsion constant of a rectangle a >= b:
 * J = a b^3/3 (1 - 192 b/(pi^5 a) sum over odd n of tanh(n pi a/(2b))/n^5). */
static double torsion_constant(double width, double height)
{
    const double a = fmax(width, height), b = fmin(width, height);
    double sum = 0;
    for (int n = 999; n > 0; n -= 2)
        sum += tanh(n * M_PI * a / (2 * b)) / pow(n, 5);
    return a * pow(b, 3) / 3 * (1 - 192 * b / (pow(M_PI, 5) * a) * sum);
}

/* A rule on one side of the rectangle, from its centre. */
struct side {
    int points;
    double at[MAX_POINTS][2]; /* position, weight, m */
};

/* n Gauss points on [from, to]. */
static enum hobe_status add_panel(struct side *side, int n, double from, double to,
                                  struct hobe_error *err)
{
    double(*gauss)[2] = side->at + side->points;
    const enum hobe_status status = hobe_gauss(n, gauss, err);
    for (int i = 0; !status && i < n; i++) {
        gauss[i][0] = from + (to - from) * gauss[i][0];
        gauss[i][1] *= to - from;
    }
    side->points += n;
    return status;
}

/* n Gauss points on a side; three panels on a long one where w has its boundary layers. */
static enum hobe_status side_rule(struct side *side, int n, double length, double other,
                                  int boundary_layers, struct hobe_error *err)
{
    const double half = length / 2, inner = half - END_WIDTHS * other;
    side->points = 0;
    if (!boundary_layers || length < SLENDER * other || inner <= 0)
        return add_panel(side, n, -half, half, err);
    enum hobe_status status = add_panel(side, n, -half, -inner, err);
    if (!status)
        status = add_panel(side, n, -inner, inner, err);
    return status ? status : add_panel(side, n, inner, half, err);
}

/* The product of n Gauss points per side; fill_functions adds the functions. */
static enum hobe_status product_rule(const struct rectangle *section, int n, struct hobe_rule *rule,
                                     struct hobe_error *err)
{
    const double W = section->width, H = section->height;
    const int layers = n == WARPING_POINTS;
    struct side y, z;
    *rule = (struct hobe_rule){0};
    enum hobe_status status = side_rule(&y, n, W, H, layers, err);
    if (!status)
        status = side_rule(&z, n, H, W, layers, err);
    if (status)
        return status;
    if (hobe_rule_new(rule, (size_t)y.points * (size_t)z.points, err))
        return HOBE_NO_MEMORY;
    struct hobe_section_point *p = rule->point;
    for (int i = 0; i < y.points; i++)
        for (int j = 0; j < z.points; j++, p++) {
            p->y = y.at[i][0];
            p->z = z.at[j][0];
            p->weight = y.at[i][1] * z.at[j][1];
        }
    return HOBE_OK;
}

static void fill_functions(const struct rectangle *section, int paper, struct hobe_rule *rule)
{
    for (int i = 0; i < rule->rule.points; i++) {
        struct hobe_section_point *p = rule->point + i;
        functions(section, paper, p->y, p->z, p->f);
    }
}

static enum hobe_status rule(const hobe_section *section, const struct hobe_kernel *kernel,
                             enum hobe_integration integration, struct hobe_rule *rule,
                             struct hobe_error *err)
{
    const struct rectangle *r = (const struct rectangle *)section;
    const int paper = integration == HOBE_INTEGRATION_PAPER;
    const int exact = 2 * kernel->degree + 1; /* for polynomials of degree 4 * kernel->degree */
    if (kernel->functions && !paper)
        return hobe_rule_copy(&r->functions_rule, rule, err);
    const enum hobe_status status = product_rule(r, paper ? PAPER_POINTS : exact, rule, err);
    if (!status && paper)
        fill_functions(r, paper, rule);
    return status;
}

/* Anticlockwise from (-, -). */
static void set_corners(double width, double height, double corner[4][2])
{
    for (int i = 0; i < 4; i++) {
        corner[i][0] = (i == 1 || i == 2 ? 0.5 : -0.5) * width;
        corner[i][1] = (i > 1 ? 0.5 : -0.5) * height;
    }
}

static enum hobe_status outline(const hobe_section *section, struct hobe_outline *outline,
                                struct hobe_error *err)
{
    const struct rectangle *r = (const struct rectangle *)section;
    double corner[4][2];
    set_corners(r->width, r->height, corner);
    return hobe_outline_new(1, (const int[]){4}, (const double(*)[2])corner, outline, err);
}

/* Finer at the edges, where w has its boundary layers: places like cosines. */
static enum hobe_status surface(const hobe_section *section, int fineness,
                                struct hobe_surface *surface, struct hobe_error *err)
{
    const struct rectangle *r = (const struct rectangle *)section;
    const int n = 2 * fineness;
    const enum hobe_status status = hobe_surface_grid(n, n, 0, surface, err);
    for (int p = 0; !status && p < surface->points; p++) {
        surface->point[p][1] = -r->width / 2 * cos(M_PI * (p % (n + 1)) / n);
        surface->point[p][2] = -r->height / 2 * cos(M_PI * (p / (n + 1)) / n);
    }
    return status;
}

static void close_rectangle(hobe_section *section)
{
    hobe_rule_free(&((struct rectangle *)section)->functions_rule);
}

static int count_sizes(const hobe_section *section)
{
    (void)section;
    return 2;
}

static void read_sizes(const hobe_section *section, double *sizes)
{
    const struct rectangle *r = (const struct rectangle *)section;
    sizes[0] = r->width;
    sizes[1] = r->height;
}

static hobe_section *make(double width, double height, enum hobe_warping warping, int bare,
                          struct hobe_error *err);

static hobe_section *make_like(const hobe_section *like, const double *sizes, int bare,
                               struct hobe_error *err)
{
    return make(sizes[0], sizes[1], ((const struct rectangle *)like)->warping, bare, err);
}

static const struct hobe_section_sizes rectangle_sizes = {count_sizes, read_sizes, make_like, NULL};
static const struct hobe_section_kind rectangle_kind = {.rule = rule,
                                                        .functions = functions_at,
                                                        .surface = surface,
                                                        .outline = outline,
                                                        .close = close_rectangle,
                                                        .sizes = &rectangle_sizes};

/* int r^4 dA - I_p^2/A */
static double wagner(double W, double H)
{
    const double A = W * H, Ip = A * (W * W + H * H) / 12;
    return A * (pow(W, 4) / 80 + pow(H, 4) / 80 + W * W * H * H / 72) - Ip * Ip / A;
}

static void set_base(struct rectangle *r)
{
    static const double corner[5][2] = {{0, 0}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
    const double W = r->width, H = r->height, A = W * H;
    r->base = (struct hobe_section){.kind = &rectangle_kind, .probes = 5};
    r->base.properties = (struct hobe_section_properties){
        .A = A,
        .Iyy = A * H * H / 12,
        .Izz = A * W * W / 12,
        .J = torsion_constant(W, H),
        .Wagner = wagner(W, H),
        .width = W,
        .height = H,
    };
    for (int c = 0; c < 5; c++) {
        r->base.probe[c][0] = corner[c][0] * W / 2;
        r->base.probe[c][1] = corner[c][1] * H / 2;
    }
    snprintf(r->base.text, sizeof r->base.text, "rectangle %g x %g m, w: %s", W, H,
             r->warping == HOBE_WARPING_PAPER ? "one term of the series (paper)"
                                              : "Saint-Venant series, converged");
}

static hobe_section *make(double width, double height, enum hobe_warping warping, int bare,
                          struct hobe_error *err)
{
    if (!(width > 0 && isfinite(width)) || !(height > 0 && isfinite(height))) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL,
                  "a rectangle needs width > 0 and height > 0 (m), got %g and %g", width, height);
        return NULL;
    }
    struct rectangle *r = hobe_alloc(1, sizeof *r, err);
    if (!r)
        return NULL;
    r->width = width;
    r->height = height;
    set_series(&r->series, width, height, warping);
    set_series(&r->paper_series, width, height, HOBE_WARPING_PAPER);
    r->warping = warping;
    set_base(r);
    if (bare)
        return &r->base;
    if (product_rule(r, WARPING_POINTS, &r->functions_rule, err)) {
        hobe_section_free(&r->base);
        return NULL;
    }
    fill_functions(r, 0, &r->functions_rule);
    hobe_section_set_warping(&r->base, &r->functions_rule);
    hobe_section_set_shear(&r->base, &r->functions_rule);
    return &r->base;
}

hobe_section *hobe_section_rectangle(double width, double height, enum hobe_warping warping,
                                     struct hobe_error *err)
{
    if (warping == HOBE_WARPING_SOLVED) {
        double corner[4][2];
        set_corners(width, height, corner);
        return hobe_section_polygon(1, (const int[]){4}, (const double(*)[2])corner, err);
    }
    return make(width, height, warping, 0, err);
}

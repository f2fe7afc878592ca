/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The evaluator's own table of elements, with their shape functions as printed in textbooks. */
#include "pointwise.h"

#include <string.h>

#define QUADRATIC_MODES " yy yz zz"
#define CUBIC_MODES     " yyy yyz yzz zzz"
#define QUARTIC_MODES   " yyyy yyyz yyzz yzzz zzzz"

#define SLOPES          "1 y z"
#define HERMITE         "1 1' y z"
#define BE42_NODE       HERMITE QUADRATIC_MODES
#define B4_NODE         BE42_NODE CUBIC_MODES QUARTIC_MODES
#define FULL_CUBIC_NODE SLOPES QUADRATIC_MODES CUBIC_MODES
#define II_MODES        " w" QUADRATIC_MODES CUBIC_MODES

/* Nodes lie at equal distances.  A node's vectors are named by the mode they multiply; 1' is the
 * slope r_x of the centreline.  An s in the element's name: structural mechanics. */
static const struct row {
    const char *name;
    enum pw_field centre, others;
    const char *node[PW_NODES];
} table[] = {
    {"BE24", PW_HERMITE, PW_LINEAR, {HERMITE, HERMITE}},
    {"BE42", PW_HERMITE, PW_LINEAR, {BE42_NODE, BE42_NODE}},
    {"B4", PW_HERMITE, PW_LINEAR, {B4_NODE, B4_NODE}},
    {"MGD30", PW_HERMITE, PW_QUADRATIC, {HERMITE, "y z", HERMITE}},
    {"3333", PW_QUADRATIC, PW_QUADRATIC, {SLOPES, SLOPES, SLOPES}},
    {"3333s", PW_QUADRATIC, PW_QUADRATIC, {SLOPES, SLOPES, SLOPES}},
    {"3363",
     PW_QUADRATIC,
     PW_QUADRATIC,
     {SLOPES QUADRATIC_MODES, SLOPES QUADRATIC_MODES, SLOPES QUADRATIC_MODES}},
    {"3433", PW_CUBIC, PW_CUBIC, {SLOPES, SLOPES, SLOPES, SLOPES}},
    {"34X3",
     PW_CUBIC,
     PW_CUBIC,
     {FULL_CUBIC_NODE, FULL_CUBIC_NODE, FULL_CUBIC_NODE, FULL_CUBIC_NODE}},
    {"BE24w", PW_HERMITE, PW_LINEAR, {HERMITE " w", HERMITE " w"}},
    {"MGD30w", PW_HERMITE, PW_QUADRATIC, {HERMITE " w", "y z w", HERMITE " w"}},
    {"3333w", PW_QUADRATIC, PW_QUADRATIC, {SLOPES " w", SLOPES " w", SLOPES " w"}},
    {"3433w", PW_CUBIC, PW_CUBIC, {SLOPES " w", SLOPES " w", SLOPES " w", SLOPES " w"}},
    {"BE24w-II", PW_HERMITE, PW_LINEAR, {HERMITE II_MODES, HERMITE II_MODES}},
    {"MGD30w-II", PW_HERMITE, PW_QUADRATIC, {HERMITE II_MODES, "y z" II_MODES, HERMITE II_MODES}},
};

int pw_elements(void)
{
    return (int)(sizeof table / sizeof *table);
}

/* How often c occurs in s. */
static int count(const char *s, char c)
{
    int n = 0;
    for (; *s; s++)
        n += *s == c;
    return n;
}

/* The index of the mode called name (of the given length), added if it is new. */
static int mode_index(struct pw_element *e, const char *name, size_t length)
{
    for (int k = 0; k < e->modes; k++)
        if (strlen(e->mode[k]) == length && !strncmp(e->mode[k], name, length))
            return k;
    char *mode = e->mode[e->modes];
    memcpy(mode, name, length);
    mode[length] = 0;
    int y = count(mode, 'y'), z = count(mode, 'z');
    int degree = y > z ? y : z;
    e->degree = degree > e->degree ? degree : e->degree;
    return e->modes++;
}

static void add_node(struct pw_element *e, const char *text)
{
    while (*text) {
        size_t length = strcspn(text, " ");
        int slope = text[length - 1] == '\'';
        int mode = mode_index(e, text, length - (size_t)slope);
        e->vector[e->vectors++] = (struct pw_vector){e->nodes, mode, slope};
        text += length;
        text += strspn(text, " ");
    }
    e->nodes++;
}

void pw_element(int i, struct pw_element *e)
{
    const struct row *row = &table[i];
    memset(e, 0, sizeof *e);
    e->name = row->name;
    e->centre = row->centre;
    e->others = row->others;
    e->structural = strchr(row->name, 's') != NULL;
    for (int n = 0; n < PW_NODES && row->node[n]; n++)
        add_node(e, row->node[n]);
}

int pw_find(const char *name, struct pw_element *e)
{
    for (int i = 0; i < pw_elements(); i++)
        if (!strcmp(table[i].name, name)) {
            pw_element(i, e);
            return 1;
        }
    return 0;
}

/* ---- axial functions ------------------------------------------------------------------------ */

static number linear(int node, number s)
{
    return node == 0 ? 1 - s : s;
}

static number quadratic(int node, number s)
{
    switch (node) {
    case 0:
        return 1 - 3 * s + 2 * s * s;
    case 1:
        return 4 * s * (1 - s);
    default:
        return s * (2 * s - 1);
    }
}

/* Lagrange on 0, 1/3, 2/3, 1. */
static number cubic(int node, number s)
{
    switch (node) {
    case 0:
        return 1 - 11 * s / 2 + 9 * s * s - 9 * s * s * s / 2;
    case 1:
        return (9 - 45 * s / 2 + 27 * s * s / 2) * s;
    case 2:
        return (-9 / 2.0L + 18 * s - 27 * s * s / 2) * s;
    default:
        return (1 - 9 * s / 2 + 9 * s * s / 2) * s;
    }
}

/* Value and slope (with respect to x, hence the length) at the two ends. */
static number hermite(int last, int slope, real length, number s)
{
    if (!last)
        return slope ? length * (s - 2 * s * s + s * s * s) : 1 - 3 * s * s + 2 * s * s * s;
    return slope ? length * (s * s * s - s * s) : 3 * s * s - 2 * s * s * s;
}

static number shape(const struct pw_beam *beam, const struct pw_vector *v, number s)
{
    const struct pw_element *e = &beam->element;
    switch (v->mode == 0 ? e->centre : e->others) {
    case PW_LINEAR:
        return linear(v->node, s);
    case PW_QUADRATIC:
        return quadratic(v->node, s);
    case PW_CUBIC:
        return cubic(v->node, s);
    default:
        return hermite(v->node != 0, v->slope, beam->length, s);
    }
}

void pw_shape(const struct pw_beam *beam, real xi, real *N, real *Nx)
{
    const real h = 0x1p-100L;
    for (int v = 0; v < beam->element.vectors; v++) {
        number value = shape(beam, &beam->element.vector[v], xi + h * I);
        N[v] = creall(value);
        Nx[v] = cimagl(value) / h / beam->length;
    }
}

/* ---- section modes -------------------------------------------------------------------------- */

/* x^n/n!, zero for n < 0. */
static real monomial(real x, int n)
{
    real p = n < 0 ? 0 : 1;
    for (int i = 1; i <= n; i++)
        p *= x / i;
    return p;
}

/* A mode's name spells its monomial: yyz is y^2/2! z/1!. */
static void mode(const struct pw_beam *beam, const char *name, real y, real z, real *phi)
{
    if (*name == 'w') {
        beam->warping(y, z, phi);
        return;
    }
    int a = count(name, 'y'), b = count(name, 'z');
    phi[0] = monomial(y, a) * monomial(z, b);
    phi[1] = monomial(y, a - 1) * monomial(z, b);
    phi[2] = monomial(y, a) * monomial(z, b - 1);
}

void pw_modes(const struct pw_beam *beam, real y, real z, real *phi)
{
    for (int k = 0; k < beam->element.modes; k++)
        mode(beam, beam->element.mode[k], y, z, phi + 3 * k);
}

void pw_reference(const struct pw_beam *beam, const real *frame, real *q0)
{
    const struct pw_element *e = &beam->element;
    for (int v = 0; v < e->vectors; v++) {
        const struct pw_vector *a = &e->vector[v];
        const char *name = e->mode[a->mode];
        int axis = !strcmp(name, "1") ? 0 : !strcmp(name, "y") ? 1 : !strcmp(name, "z") ? 2 : -1;
        real size = axis != 0 || a->slope ? 1 : beam->length * a->node / (e->nodes - 1);
        for (int i = 0; i < 3; i++)
            q0[3 * v + i] = axis < 0 ? 0 : size * frame[3 * axis + i];
    }
}

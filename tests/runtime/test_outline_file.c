/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Outlines from files: lists of points to the last bit, curves by their areas, bad files by their
 * sentences, and any bytes without harm. */
#include "check.h"
#include "hobe.h"
#include "outline.h"
#include "outline_file.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST = 8000 };

/* A drawing in millimetres: the words of its ENTITIES, which stand one a line in the file. */
static const char *dxf(const char *words)
{
    static char text[MOST];
    snprintf(text, sizeof text,
             "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES %s 0 ENDSEC 0 EOF ",
             words);
    for (char *c = text; *c; c++)
        *c = *c == ' ' ? '\n' : *c;
    return text;
}

static struct hobe_outline_file named(const char *name, const char *text)
{
    return (struct hobe_outline_file){.name = name, .text = text, .size = strlen(text)};
}

/* The loops of a good file, or the end of the test. */
static struct hobe_loops read_file(const struct hobe_outline_file *file, struct hobe_unit *unit)
{
    struct hobe_error err;
    struct hobe_loops loops;
    if (hobe_outline_read(file, &loops, unit, &err))
        check_stop("%s", err.message);
    return loops;
}

/* ---- lists ---------------------------------------------------------------------------------- */

static void lists(void)
{
    /* all the same: a triangle with a hole, which comes first where `hole_first` */
    static const struct {
        const char *text;
        int hole_first;
    } list[] = {
        {"0.1 0.2\n4 0.2\n0.1 3\n\n1 1\n1.5 1\n1 1.5\n", 0},
        {"1 1\n1.5 1\n1 1.5\n\n0.1 0.2\n4 0.2\n0.1 3\n", 1},
        {"\xEF\xBB\xBFy,z\r\n0.1,0.2\r\n4,.2\r\n 0.1 ; 3 # the tip\r\n\r\n \r\n1,1\r\n# hole\r\n"
         "1.5,1\r\n1,1.5",
         0},
        {"# a comment\n\n\nNACA 0012\n\n1e-1 2e-1\n+4.0 0.2\n1E-1 3\n0.1 0.2\n\n1 1\n1 1\n1.5 1\n"
         "1 1.5\n",
         0},
    };
    static const double point[6][2] = {{.1, .2}, {4, .2}, {.1, 3}, {1, 1}, {1.5, 1}, {1, 1.5}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        struct hobe_unit unit;
        const struct hobe_outline_file file = named("list.csv", list[i].text);
        struct hobe_loops loops = read_file(&file, &unit);
        check_that(loops.loops == 2 && loops.points[0] == 3 && loops.points[1] == 3,
                   "list %zu: %d loops", i, loops.loops);
        check_that(memcmp(loops.point, point, sizeof point) == 0, "points of list %zu", i);
        check_that(unit.metres == 1, "a list is in metres");
        hobe_loops_free(&loops);
    }
}

static void scales(void)
{
    struct hobe_unit unit;
    struct hobe_outline_file file = named("list.txt", "0 0\n3 0\n0 4");
    file.scale = 0.5;
    struct hobe_loops loops = read_file(&file, &unit);
    check_that(loops.point[1][0] == 1.5 && loops.point[2][1] == 2, "a scale of 1/2");
    hobe_loops_free(&loops);
}

/* ---- drawings ------------------------------------------------------------------------------- */

/* 40 x 20 mm with corners of 3 mm, from (10, 5): lines and arcs out of order, one arc from end to
 * start, one line twice as long as need be because it is two. */
static const char pieces[] =
    "0 LINE 8 0 10 13 20 5 11 47 21 5 0 ARC 10 47 20 8 40 3 50 270 51 360 "
    "0 LINE 10 50 20 22 11 50 21 15 0 LINE 10 50 20 8 11 50 21 15 "
    "0 ARC 10 13 20 22 40 3 50 90 51 180 0 TEXT 10 0 20 0 40 2.5 1 nothing "
    "0 LINE 10 10 20 8 11 10 21 22 0 ARC 10 13 20 8 40 3 50 -180 51 -90 "
    "0 LINE 10 47 20 25 11 13 21 25 0 ARC 10 47 20 22 40 3 50 360 51 90 "
    "0 LINE 10 1 20 1 11 1 21 1";
/* tan(pi/8) for a quarter of a circle */
#define Q "0.41421356237309503"
static const char light[] =
    "0 LWPOLYLINE 90 8 70 1 10 13 20 5 10 47 20 5 42 " Q " 10 50 20 8 10 50 20 22 42 " Q
    " 10 47 20 25 10 13 20 25 42 " Q " 10 10 20 22 10 10 20 8 42 " Q;
static const char heavy[] =
    "0 POLYLINE 66 1 70 1 10 0 20 0 0 VERTEX 10 13 20 5 0 VERTEX 10 47 20 5 42 " Q
    " 0 VERTEX 10 50 20 8 0 VERTEX 10 50 20 22 42 " Q " 0 VERTEX 10 47 20 25 "
    "0 VERTEX 10 9 20 9 70 16 0 VERTEX 10 13 20 25 42 " Q
    " 0 VERTEX 10 10 20 22 0 VERTEX 10 10 20 8 42 " Q " 0 SEQEND";
/* x to the left, y up, clockwise: bulges of the other sign */
static const char mirrored[] =
    "0 LWPOLYLINE 90 8 70 1 10 -13 20 5 10 -47 20 5 42 -" Q " 10 -50 20 8 10 -50 20 22 42 -" Q
    " 10 -47 20 25 10 -13 20 25 42 -" Q " 10 -10 20 22 10 -10 20 8 42 -" Q " 210 0 220 0 230 -1";

/* Area and centroid of a drawing, mm. */
static double area_of(const char *words, double centroid[2], double tolerance)
{
    struct hobe_error err;
    struct hobe_unit unit;
    struct hobe_outline outline;
    struct hobe_outline_file file = named("part.DXF", dxf(words));
    file.tolerance = tolerance;
    struct hobe_loops loops = read_file(&file, &unit);
    check_that(unit.metres == 1e-3, "the file is in mm: %g", unit.metres);
    if (hobe_outline_new(loops.loops, loops.points, (const double(*)[2])loops.point, &outline,
                         &err))
        check_stop("%s", err.message);
    const double A = hobe_outline_area(&outline, centroid);
    hobe_outline_free(&outline);
    hobe_loops_free(&loops);
    for (int a = 0; a < 2; a++)
        centroid[a] *= 1e3;
    return A * 1e6;
}

static void rounded_rectangles(void)
{
    static const char *const words[] = {pieces, light, heavy, mirrored};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        for (int coarse = 0; coarse < 2; coarse++) {
            double centroid[2];
            const double A = area_of(words[i], centroid, coarse ? 1e-3 : 0);
            check_relative(A, 800 - (4 - M_PI) * 9, 1e-12, "area of drawing %zu", i);
            check_absolute(centroid[0], 30, 1e-10, "x of its centroid");
            check_absolute(centroid[1], 15, 1e-10, "y of its centroid");
        }
}

/* Programs of old pad group codes and end lines as DOS did. */
static void padded(void)
{
    char text[MOST];
    size_t size = 0;
    struct hobe_unit unit;
    for (const char *c = dxf(light); *c; c++)
        size += (size_t)snprintf(text + size, sizeof text - size, *c == '\n' ? "\r\n  " : "%c", *c);
    struct hobe_outline_file file = named("part.dxf", text);
    struct hobe_loops loops = read_file(&file, &unit);
    file = named("part.dxf", dxf(light));
    struct hobe_loops plain = read_file(&file, &unit);
    check_that(loops.points[0] == plain.points[0] &&
                   !memcmp(loops.point, plain.point, (size_t)plain.points[0] * sizeof *plain.point),
               "blanks around group codes and values change nothing");
    hobe_loops_free(&loops);
    hobe_loops_free(&plain);
}

/* A circle with an elliptic hole, a half moon of an elliptic arc, a bulge of more than half a
 * circle. */
static void curves(void)
{
    static const struct {
        const char *words;
        double A, x, y; /* mm */
    } curve[] = {
        {"0 ELLIPSE 10 3 20 1 11 3 21 4 40 0.5 41 0 42 6.283185307179586 "
         "0 CIRCLE 10 2 20 1 40 10",
         M_PI * (100 - 12.5), (100 * 2 - 12.5 * 3) / 87.5, 1},
        /* semi-axes 4 along y and 2 along -x, from the y axis to the left and down */
        {"0 ELLIPSE 10 0 20 0 11 0 21 4 40 0.5 41 0 42 3.141592653589793 "
         "0 LINE 10 0 20 4 11 0 21 -4",
         4 * M_PI, -8 / (3 * M_PI), 0},
        /* the same with the normal down: to the right */
        {"0 ELLIPSE 10 0 20 0 11 0 21 4 40 0.5 41 0 42 3.141592653589793 230 -1 "
         "0 LINE 10 0 20 4 11 0 21 -4",
         4 * M_PI, 8 / (3 * M_PI), 0},
        /* three quarters of a circle of radius 2 about the origin: bulge tan(3 pi/8) */
        {"0 LWPOLYLINE 70 1 10 2 20 0 42 2.414213562373095 10 0 20 -2 10 0 20 0", 3 * M_PI,
         -8 / (9 * M_PI), 8 / (9 * M_PI)},
        {"0 ARC 10 5 20 5 40 2 50 0 51 360", 4 * M_PI, 5, 5},
        {"0 CIRCLE 10 5 20 5 40 2 230 -1", 4 * M_PI, -5, 5},
        /* with a frame on the sheet */
        {"0 INSERT 67 1 2 frame 0 LWPOLYLINE 67 1 70 1 10 0 20 0 10 9 20 0 10 9 20 9 "
         "0 CIRCLE 10 5 20 5 40 2 0 POLYLINE 67 1 70 1 0 VERTEX 67 1 10 0 20 0 0 VERTEX 67 1 "
         "10 1 20 1 0 SEQEND 67 1",
         4 * M_PI, 5, 5},
    };
    for (size_t i = 0; i < sizeof curve / sizeof *curve; i++) {
        double centroid[2];
        const double A = area_of(curve[i].words, centroid, 0);
        check_relative(A, curve[i].A, 1e-12, "area of curve %zu", i);
        /* areas are exact, first moments of partial arcs to fourth order of a chord's angle */
        check_absolute(centroid[0], curve[i].x, 1e-4 * sqrt(A), "x of the centroid of %zu", i);
        check_absolute(centroid[1], curve[i].y, 1e-4 * sqrt(A), "y of the centroid of %zu", i);
    }
}

/* No corner lies further from the circle than the tolerance, nor does the middle of a chord. */
static void tolerances(void)
{
    const double R = 0.01;
    for (double tolerance = 1e-3; tolerance > 2e-7; tolerance /= 3) {
        struct hobe_unit unit;
        struct hobe_outline_file file = named("disc.dxf", dxf("0 CIRCLE 10 0 20 0 40 10"));
        file.tolerance = tolerance;
        struct hobe_loops loops = read_file(&file, &unit);
        const int n = loops.points[0];
        double worst = 0;
        for (int i = 0; i < n; i++) {
            const double *p = loops.point[i], *q = loops.point[(i + 1) % n];
            worst = fmax(worst, fabs(hypot(p[0], p[1]) - R));
            worst = fmax(worst, fabs(hypot(p[0] + q[0], p[1] + q[1]) / 2 - R));
        }
        printf("tolerance %.2e m: %d chords, off by %.2e m\n", tolerance, n, worst);
        check_that(worst < tolerance, "off by %g with a tolerance of %g", worst, tolerance);
        hobe_loops_free(&loops);
    }
}

/* Each $INSUNITS, and a scale before it. */
static void units(void)
{
    static const double metres[][2] = {{1, .0254}, {2, .3048}, {4, 1e-3}, {5, 1e-2},
                                       {6, 1},     {14, .1},   {0, 1}};
    for (size_t i = 0; i < sizeof metres / sizeof *metres; i++)
        for (int given = 0; given < 2; given++) {
            char text[MOST];
            struct hobe_unit unit;
            snprintf(text, sizeof text,
                     "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n%g\n0\nENDSEC\n0\nSECTION\n2\n"
                     "ENTITIES\n0\nCIRCLE\n10\n0\n20\n0\n40\n2\n0\nENDSEC\n0\nEOF\n",
                     metres[i][0]);
            struct hobe_outline_file file = named("disc.dxf", text);
            file.scale = given ? 7 : 0;
            struct hobe_loops loops = read_file(&file, &unit);
            check_that(unit.metres == (given ? 7 : metres[i][1]), "$INSUNITS %g: %g m",
                       metres[i][0], unit.metres);
            hobe_loops_free(&loops);
        }
}

/* ---- sections ------------------------------------------------------------------------------- */

/* A disc of chords: moments and J to the fourth order of the chords' angle. */
static void disc(void)
{
    struct hobe_error err;
    const double R = 0.01, I = M_PI * pow(R, 4) / 4;
    const struct hobe_outline_file file = named("disc.dxf", dxf("0 CIRCLE 10 7 20 8 40 10"));
    hobe_section *section = hobe_section_file(&file, &err);
    if (!section)
        check_stop("%s", err.message);
    const struct hobe_section_properties p = properties_of(section);
    printf("%s\n", hobe_section_text(section));
    check_relative(p.A, M_PI * R * R, 1e-12, "A of a disc");
    check_absolute(p.yc, 7e-3, 1e-12, "its centroid");
    check_relative(p.Iyy, I, 1e-5, "Iyy");
    check_relative(p.Izz, I, 1e-5, "Izz");
    check_relative(p.J, 2 * I, 1e-4, "J");
    check_that(strstr(hobe_section_text(section), "$INSUNITS: mm") != NULL,
               "the text has the unit");
    hobe_section_free(section);
}

/* ---- bad files ------------------------------------------------------------------------------ */

static void refused(const struct hobe_outline_file *file, const char *words)
{
    struct hobe_error err = {0};
    hobe_section *section = hobe_section_file(file, &err);
    check_that(!section && err.status == HOBE_BAD_INPUT && strstr(err.message, words) &&
                   strstr(err.message, file->name) && !strchr(err.message, '\n'),
               "refused with \"%s\": %s", words, section ? "accepted" : err.message);
    hobe_section_free(section);
}

static void bad_lists(void)
{
    static const char *const bad[][2] = {
        {"", "no outline"},
        {"NACA 0012\n", "no outline"},
        {"0 0\n", "no outline"},
        {"0 0\n1 0\n1 one\n", "line 3 must hold two numbers, y and z, got \"1 one\""},
        {"y z\n0 0\n1 0 2\n", "line 3 must hold two numbers, y and z, got \"1 0 2\""},
        {"y z\nin metres\n0 0\n", "line 2 must"},
        {"23012 wing\n0 0\n", "line 1 must"},
        {"0 0\n1 0\n1 \x01\xFF\n", "\"1 ??\""},
        {"0 0\n1,0 0,0\n", "line 2 must"},
        {"0 0\n1 1e999\n", "finite"},
        {"0 0\n1 nan\n", "line 2 must"},
        {"0 0\n1 0x10\n", "line 2 must"},
        {"0 0\n1 0\n", "at least 3 points, got 2"},
        {"0 0\n1 1\n1 0\n0 1.5\n", "crosses"},
        {"0 0\n1 0\n0 1\n\n5 5\n6 5\n5 6.1\n", "outside"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const struct hobe_outline_file file = named("list.csv", bad[i][0]);
        refused(&file, bad[i][1]);
    }
}

static void bad_drawings(void)
{
    static const char *const bad[][2] = {
        {"0 TEXT 10 0 20 0 40 2.5 1 empty", "no outline"},
        {"0 SPLINE 10 0 20 0", "SPLINE is not read"},
        {"0 INSERT 2 part 10 0 20 0", "INSERT is not read"},
        {"0 LINE 10 0 20 0 11 1 21 zero", "line 24: group 21 must be a number, got \"zero\""},
        {"0 LINE 10 0 20 0 11 1 21 0 0 LINE 10 1 20 0 11 1.5 21 1",
         "the LINE of line 16 ends at (0, 0), where nothing goes on (the nearest other end is 1"},
        {"0 CIRCLE 10 0 20 0 40 9 0 LINE 10 0 20 0 11 1 21 0 0 LINE 10 0 20 0 11 2 21 1 "
         "0 LINE 10 0 20 0 11 3 21 1",
         "3 ends meet at (0, 0)"},
        {"0 CIRCLE 10 1e308 20 0 40 1e308", "finite"},
        {"0 LWPOLYLINE 70 1 10 0 20 0 42 1e200 10 1 20 0 10 0 20 1", "finite"},
        {"0 CIRCLE 10 0 20 0 40 9 210 1 220 0 230 0", "xy plane"},
        {"0 VERTEX 10 0 20 0", "VERTEX without"},
        {"0 POLYLINE 70 64 0 VERTEX 10 0 20 0", "mesh"},
        {"group 1", "\"group\" is no group code"},
        {"10.5 1", "\"10.5\" is no group code"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const struct hobe_outline_file file = named("part.dxf", dxf(bad[i][0]));
        refused(&file, bad[i][1]);
    }
}

static void bad_files(void)
{
    struct hobe_outline_file file = named("part.dxf", dxf("0 CIRCLE 10 0 20 0 40 9"));
    file.tolerance = 1e-9;
    refused(&file, "1000 points, got more");
    file.tolerance = -1;
    refused(&file, "tolerance must be > 0 (m), got -1");
    file.tolerance = 0;
    file.scale = NAN;
    refused(&file, "scale must be > 0 (m per unit of the file), got nan");
    file.scale = 0;
    file.size -= 6;
    refused(&file, "ends without EOF");
    file = named("part.dxf", "AutoCAD Binary DXF\r\n\x1A");
    refused(&file, "binary");
    file = named("part.dxf", "0\nSECTION\n2\nBLOCKS\n0\nENDSEC\n0\nEOF\n");
    refused(&file, "no section ENTITIES");
    file =
        named("part.dxf", "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n3\n0\nENDSEC\n0\nSECTION\n2\n"
                          "ENTITIES\n0\nENDSEC\n0\nEOF\n");
    refused(&file, "$INSUNITS = 3, is not known");
    file.size = (size_t)HOBE_MOST_OUTLINE_BYTES + 1; /* refused before a byte is read */
    refused(&file, "at most 16 MB");
}

/* ---- any bytes ------------------------------------------------------------------------------ */

/* Good files with bytes changed, lines lost and ends cut off: loops or one sentence. */
static void mutations(void)
{
    static const char list[] = "NACA 0012\n1 0\n0.5 0.05\n0 0\n0.5 -0.05\n\n.4 0\n.5 0\n.45 .01\n";
    const char *const good[] = {list, pieces, light, heavy};
    int read = 0, tried = 4000;
    for (int trial = 0; trial < tried; trial++) {
        char text[MOST];
        const char *from = good[trial % 4];
        size_t size = (size_t)snprintf(text, sizeof text, "%s", from == list ? list : dxf(from));
        for (int n = (int)random_real(1, 6); n > 0 && size > 1; n--) {
            static const char some[] = "\n\n 0123456789.-+eE,#\x00\xFFVT";
            const size_t at = (size_t)random_real(0, (double)size);
            const size_t lost = (size_t)random_real(1, 12);
            if (random_real(0, 1) < 0.7)
                text[at] = some[(size_t)random_real(0, sizeof some - 1)];
            else if (at + lost < size)
                memmove(text + at, text + at + lost, size -= lost);
            else
                size = at;
        }
        struct hobe_error err = {0};
        struct hobe_loops loops;
        struct hobe_unit unit;
        const struct hobe_outline_file file = {from == list ? "list" : "part.dxf", text, size, 0,
                                               0};
        const int failed = hobe_outline_read(&file, &loops, &unit, &err);
        int total = 0;
        for (int l = 0; l < loops.loops; l++)
            total += loops.points[l];
        read += !failed;
        if (failed ? !*err.message || strchr(err.message, '\n') : total < 1)
            check_that(0, "trial %d: %s", trial, err.message);
        hobe_loops_free(&loops);
    }
    printf("%d of %d changed files can still be read\n", read, tried);
    check_that(read > 0 && read < tried, "changes show");
}

int main(void)
{
    random_start();
    lists();
    scales();
    rounded_rectangles();
    padded();
    curves();
    tolerances();
    units();
    disc();
    bad_lists();
    bad_drawings();
    bad_files();
    mutations();
    return check_report();
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rolled profiles and hollow rectangles: outlines by a table of corners. */
#include "section_outline.h"

#include <math.h>
#include <stdio.h>

enum { MOST_CORNERS = 12 };

/* Corners at y = width b + web w, z = height h + flange f, anticlockwise; width and flange are
 * those of the top where h > 0. */
struct corner {
    double b, w, h, f;
};

static const struct {
    const char *name;
    int flanges; /* one above the other */
    int corners;
    struct corner corner[MOST_CORNERS];
} profiles[HOBE_PROFILES] = {
    [HOBE_PROFILE_I] = {"I",
                        2,
                        12,
                        {{-.5, 0, -.5, 0},
                         {.5, 0, -.5, 0},
                         {.5, 0, -.5, 1},
                         {0, .5, -.5, 1},
                         {0, .5, .5, -1},
                         {.5, 0, .5, -1},
                         {.5, 0, .5, 0},
                         {-.5, 0, .5, 0},
                         {-.5, 0, .5, -1},
                         {0, -.5, .5, -1},
                         {0, -.5, -.5, 1},
                         {-.5, 0, -.5, 1}}},
    [HOBE_PROFILE_CHANNEL] = {"channel",
                              2,
                              8,
                              {{0, 0, -.5, 0},
                               {1, 0, -.5, 0},
                               {1, 0, -.5, 1},
                               {0, 1, -.5, 1},
                               {0, 1, .5, -1},
                               {1, 0, .5, -1},
                               {1, 0, .5, 0},
                               {0, 0, .5, 0}}},
    [HOBE_PROFILE_T] = {"T",
                        1,
                        8,
                        {{0, -.5, -.5, 0},
                         {0, .5, -.5, 0},
                         {0, .5, .5, -1},
                         {.5, 0, .5, -1},
                         {.5, 0, .5, 0},
                         {-.5, 0, .5, 0},
                         {-.5, 0, .5, -1},
                         {0, -.5, .5, -1}}},
    [HOBE_PROFILE_ANGLE] =
        {"angle",
         1,
         6,
         {{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 1, 1, 0}, {0, 0, 1, 0}}},
};

const char *hobe_profile_name(enum hobe_profile profile)
{
    return profiles[profile].name;
}

static const char *warping_words(enum hobe_warping warping)
{
    return warping == HOBE_WARPING_PAPER ? "the paper's closed form" : "solved";
}

/* ---- the paper's branches of w -------------------------------------------------------------- */

/* Eq. 34: y (z - h), -y z and y (z + h), h the distance of the flanges' middles. */
static struct hobe_parts parts_of_I(const struct hobe_profile_sizes *s)
{
    const double h = s->height - s->flange, B = s->width, f = s->flange;
    return (struct hobe_parts){
        3, {{0, 0, s->web, h - f, -1, 0}, {0, h / 2, B, f, 1, -h}, {0, -h / 2, B, f, 1, h}}};
}

/* Eq. 36: y z (W - H)/(W + H) everywhere. */
static struct hobe_parts parts_of_hollow(double W, double H, double t)
{
    const double a = (W - H) / (W + H), y = (W - t) / 2, z = (H - t) / 2, inner = H - 2 * t;
    return (struct hobe_parts){
        4,
        {{0, z, W, t, a, 0}, {0, -z, W, t, a, 0}, {y, 0, t, inner, a, 0}, {-y, 0, t, inner, a, 0}}};
}

/* ---- public --------------------------------------------------------------------------------- */

static int positive(double x)
{
    return x > 0 && isfinite(x);
}

/* Both flanges of an I-section, one above the other. */
static enum hobe_status check_top(const struct hobe_profile_sizes *s, struct hobe_error *err)
{
    if (!positive(s->top_width) || !positive(s->top_flange))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "I: top_width and top_flange must be > 0 (m), got %g and %g", s->top_width,
                         s->top_flange);
    if (s->flange + s->top_flange >= s->height)
        return hobe_fail(
            err, HOBE_BAD_INPUT, NULL,
            "I: both flanges together must be thinner than the height of %g, got %g and %g",
            s->height, s->flange, s->top_flange);
    if (s->web >= s->top_width)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "I: the web must be thinner than the top_width of %g, got %g",
                         s->top_width, s->web);
    return HOBE_OK;
}

static int equal_flanges(const struct hobe_profile_sizes *s)
{
    return s->top_width == s->width && s->top_flange == s->flange;
}

static enum hobe_status check_sizes(enum hobe_profile profile, const struct hobe_profile_sizes *s,
                                    struct hobe_error *err)
{
    const char *name = profiles[profile].name;
    const int flanges = equal_flanges(s) ? profiles[profile].flanges : 1;
    if (!positive(s->height) || !positive(s->width) || !positive(s->flange) || !positive(s->web))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: height, width, flange and web must be > 0 (m), got %g, %g, %g and %g",
                         name, s->height, s->width, s->flange, s->web);
    if (profile != HOBE_PROFILE_I && !equal_flanges(s))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: only an I has a top_width (got %g) and a top_flange (got %g)", name,
                         s->top_width, s->top_flange);
    if (flanges * s->flange >= s->height)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: the flange must be thinner than %sthe height of %g, got %g", name,
                         flanges > 1 ? "half " : "", s->height, s->flange);
    if (s->web >= s->width)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "%s: the web must be thinner than the width of %g, got %g", name, s->width,
                         s->web);
    return equal_flanges(s) ? HOBE_OK : check_top(s, err);
}

static void write_text(enum hobe_profile profile, const struct hobe_profile_sizes *s,
                       enum hobe_warping warping, char *text, size_t size)
{
    if (equal_flanges(s))
        snprintf(text, size, "%s %g m high, %g m wide, flange %g m, web %g m, w: %s",
                 profiles[profile].name, s->height, s->width, s->flange, s->web,
                 warping_words(warping));
    else
        snprintf(text, size, "I %g m high, flanges %g x %g m and %g x %g m (top), web %g m, w: %s",
                 s->height, s->width, s->flange, s->top_width, s->top_flange, s->web,
                 warping_words(warping));
}

hobe_section *hobe_section_profile(enum hobe_profile profile,
                                   const struct hobe_profile_sizes *sizes,
                                   enum hobe_warping warping, struct hobe_error *err)
{
    struct hobe_profile_sizes s = *sizes;
    const int corners = profiles[profile].corners;
    double point[MOST_CORNERS][2];
    if (s.top_width == 0)
        s.top_width = s.width;
    if (s.top_flange == 0)
        s.top_flange = s.flange;
    if (check_sizes(profile, &s, err))
        return NULL;
    if (warping == HOBE_WARPING_PAPER && !equal_flanges(&s)) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL,
                  "I: warping = \"paper\" (eq. 34) is for equal flanges, got %g x %g and %g x %g "
                  "m; use \"solved\"",
                  s.width, s.flange, s.top_width, s.top_flange);
        return NULL;
    }
    for (int i = 0; i < corners; i++) {
        const struct corner *c = profiles[profile].corner + i;
        point[i][0] = c->b * (c->h > 0 ? s.top_width : s.width) + c->w * s.web;
        point[i][1] = c->h * s.height + c->f * (c->h > 0 ? s.top_flange : s.flange);
    }
    const struct hobe_parts parts = parts_of_I(&s);
    const int closed_form = profile == HOBE_PROFILE_I && equal_flanges(&s);
    hobe_section *section = hobe_section_outline(1, &corners, (const double(*)[2])point,
                                                 closed_form ? &parts : NULL, warping, err);
    if (section)
        write_text(profile, &s, warping, section->text, sizeof section->text);
    return section;
}

hobe_section *hobe_section_hollow(double width, double height, double thickness,
                                  enum hobe_warping warping, struct hobe_error *err)
{
    const double y = width / 2, z = height / 2, t = thickness;
    if (!positive(width) || !positive(height) || !positive(t)) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL,
                  "hollow: width, height and thickness must be > 0 (m), got %g, %g and %g", width,
                  height, t);
        return NULL;
    }
    if (2 * t >= fmin(width, height)) {
        hobe_fail(err, HOBE_BAD_INPUT, NULL,
                  "hollow: the wall must be thinner than half of %g (m), got %g",
                  fmin(width, height), t);
        return NULL;
    }
    const double point[8][2] = {{-y, -z},         {y, -z},         {y, z},         {-y, z},
                                {-y + t, -z + t}, {y - t, -z + t}, {y - t, z - t}, {-y + t, z - t}};
    const struct hobe_parts parts = parts_of_hollow(width, height, t);
    hobe_section *section =
        hobe_section_outline(2, (const int[]){4, 4}, point, &parts, warping, err);
    if (section)
        snprintf(section->text, sizeof section->text,
                 "hollow rectangle %g x %g m, wall %g m, w: %s", width, height, t,
                 warping_words(warping));
    return section;
}

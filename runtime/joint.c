/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Joints and supports: a table of kinds, each a choice of constraints; whether those of a scene
 * hold it, and whether any is one too many. */
#include "joint.h"

#include "body.h"
#include "drive.h"
#include "rank.h"
#include "spring.h"
#include "vector3.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Which relative motions a joint stops, by its axis; of rotations CROSSED leaves two axes at a
 * right angle: that of the first part and the second one, of the second part; STIFF stops strains
 * of the slopes, too; of translations APART leaves those that keep the distance. */
enum stopped { NONE, ALL, STIFF, APART, ACROSS, ALONG, CROSSED };

enum { MOTIONS = 80 }; /* characters that name six motions */

static const struct kind {
    const char *name;
    enum stopped shift, turn;
} kinds[] = {
    [HOBE_JOINT_FIXED] = {"fixed", ALL, ALL},
    [HOBE_JOINT_SPHERICAL] = {"spherical", ALL, NONE},
    [HOBE_JOINT_REVOLUTE] = {"revolute", ALL, ACROSS},
    [HOBE_JOINT_UNIVERSAL] = {"universal", ALL, CROSSED},
    [HOBE_JOINT_CYLINDRICAL] = {"cylindrical", ACROSS, ACROSS},
    [HOBE_JOINT_PRISMATIC] = {"prismatic", ACROSS, ALL},
    [HOBE_JOINT_PLANAR] = {"planar", ALONG, ACROSS},
    [HOBE_JOINT_INLINE] = {"inline", ACROSS, NONE},
    [HOBE_JOINT_INPLANE] = {"inplane", ALONG, NONE},
    [HOBE_JOINT_DISTANCE] = {"distance", APART, NONE},
    [HOBE_JOINT_RIGID] = {"rigid", ALL, STIFF},
};

/* Joined places must coincide to this fraction of the beams' length. */
static const double COINCIDENT = 1e-6;

const char *hobe_joint_name(enum hobe_joint_kind kind)
{
    return kind >= 0 && kind < sizeof kinds / sizeof *kinds ? kinds[kind].name : NULL;
}

/* ---- what is asked for ----------------------------------------------------------------------- */

static enum hobe_status check_axes(const struct hobe_joint *joint, struct hobe_error *err)
{
    const struct kind *kind = kinds + joint->kind;
    const double *axis = joint->axis, *second = joint->second;
    const double size[2] = {length3(axis), length3(second)};
    const int driven = joint->angle || (joint->position && kind->shift != APART);
    const int needed[2] = {kind->shift > APART || kind->turn > APART || driven,
                           kind->turn == CROSSED};
    static const char *const key[2] = {"axis", "second"};
    for (int i = 0; i < 2; i++)
        if (!isfinite(size[i]) || needed[i] != (size[i] > 0))
            return hobe_fail(err, HOBE_BAD_INPUT, joint->where,
                             needed[i] ? "a %sjoint of kind %s needs %s, a direction {x, y, z} "
                                         "other than {0, 0, 0}"
                                       : "a %sjoint of kind %s has no %s; leave it out",
                             driven ? "driven " : "", kind->name, key[i]);
    if (needed[1] && fabs(dot3(axis, second)) > 1e-9 * size[0] * size[1])
        return hobe_fail(err, HOBE_BAD_INPUT, joint->where,
                         "the axes {%g, %g, %g} and {%g, %g, %g} of a universal joint must be at a "
                         "right angle",
                         axis[0], axis[1], axis[2], second[0], second[1], second[2]);
    return HOBE_OK;
}

static enum hobe_status check_drives(const struct hobe_joint *joint, struct hobe_error *err)
{
    const hobe_drive *const drive[2] = {joint->angle, joint->position};
    static const char *const key[2] = {"angle", "position"};
    const enum stopped turn = kinds[joint->kind].turn;
    if (joint->angle && turn != ALL && turn != ACROSS)
        return hobe_fail(
            err, HOBE_BAD_INPUT, joint->where,
            turn == STIFF
                ? "the angle of a joint of kind %s cannot be driven; that of kind fixed can"
                : "a joint of kind %s lets its axis tilt, so that no angle about it "
                  "can be driven; revolute and cylindrical ones keep it",
            kinds[joint->kind].name);
    for (int i = 0; i < 2; i++)
        if (drive[i] && !isnan(drive_jump(drive[i])))
            return hobe_fail(err, HOBE_BAD_INPUT, joint->where,
                             "the %s of a joint cannot jump, at t = %g s; only a velocity may",
                             key[i], drive_jump(drive[i]));
    return HOBE_OK;
}

enum hobe_status joint_check(const struct hobe_joint *joint, struct hobe_error *err)
{
    for (int i = 0; i < 2; i++)
        if (joint->beam[i] && !(joint->at[i] >= 0 && joint->at[i] <= 1))
            return hobe_fail(err, HOBE_BAD_INPUT, joint->where,
                             "at must be a fraction of the beam's length from 0 to 1, got %g",
                             joint->at[i]);
    if (!hobe_joint_name(joint->kind))
        return hobe_fail(err, HOBE_BAD_INPUT, joint->where, "there is no kind of joint %d",
                         (int)joint->kind);
    const enum hobe_status status = check_drives(joint, err);
    return status ? status : check_axes(joint, err);
}

/* ---- ties ------------------------------------------------------------------------------------ */

void joint_direction(const struct tied *side, const double t[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = dot3(side->frame[i], t);
}

/* A direction s of b stays at a right angle to the direction t of a. */
static void keep_normal(struct tie *tie, const double t[3], const double s[3])
{
    double a[3], b[3];
    struct constraint *c = tie_constraint(tie);
    joint_direction(tie->side, t, a);
    joint_direction(tie->side + 1, s, b);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            c->turn[i][j] = a[i] * b[j];
}

/* All turning about a driven axis, too, which the drive turns. */
static void stop_turning(struct tie *tie, enum stopped turn, const double t[3][3],
                         const double second[3])
{
    if (turn == ALL || tie->angle)
        tie_turning(tie);
    if (turn == STIFF)
        tie_slopes(tie);
    for (int i = 1; turn == ACROSS && !tie->angle && i < 3; i++)
        keep_normal(tie, t[i], t[0]);
    if (turn == CROSSED)
        keep_normal(tie, t[0], second);
}

/* (|g + d|^2 - |g|^2)/(2 |g|) = 0, g the gap in the reference; s + s^2/(2 |g|) if driven. */
static void keep_distance(struct tie *tie, const double gap[3])
{
    struct constraint *c = tie_constraint(tie);
    c->bend = 1 / length3(gap);
    c->driven = tie->position != NULL;
    for (int a = 0; a < 3; a++)
        c->hold[a] = gap[a] * c->bend;
}

/* A driven shift is stopped along the axis, too, where the drive has it. */
static void stop_shifting(struct tie *tie, enum stopped shift, const double t[3][3],
                          const double gap[3])
{
    const int driven = tie->position != NULL;
    const int stops[3] = {shift == ALONG || driven, shift != ALONG, shift != ALONG};
    if (shift == APART) {
        keep_distance(tie, gap);
        return;
    }
    for (int i = 0; i < 3; i++) {
        struct constraint *c = stops[i] || shift == ALL ? tie_constraint(tie) : NULL;
        if (c && shift == ALL && !driven)
            c->hold[i] = 1;
        else if (c) {
            joint_direction(tie->side, t[i], c->slide);
            c->driven = driven && i == 0;
        }
    }
}

/* Finds a place on a body: the point that is given, or where the other part is. */
static enum hobe_status find_on_body(const struct hobe_joint *joint, int i,
                                     const struct part part[2], struct tied side[2],
                                     struct hobe_error *err)
{
    static const int yz[2] = {1, 2};
    const double *point = i == 1 && joint->at_point == 2 ? joint->to : joint->point;
    if (!joint->at_point && !part[1 - i].beam)
        return hobe_fail(err, HOBE_BAD_INPUT, joint->where,
                         "the place on body \"%s\" is missing: point, {x, y, z} in the reference",
                         part[i].body->spec.name);
    if (!joint->at_point)
        point = side[1 - i].position;
    tied_on_body(part[i].body, point, yz, side + i);
    return HOBE_OK;
}

/* Finds both parts, the ground without any. */
static enum hobe_status find_parts(const hobe_model *model, const struct hobe_joint *joint,
                                   struct part part[2], struct hobe_error *err)
{
    const int parts = joint->beam[1] ? 2 : 1;
    part[0] = (struct part){NULL, NULL};
    for (int i = 0; i < parts; i++)
        if (model_find_part(model, joint->beam[i], joint->where, part + 2 - parts + i, err))
            return HOBE_UNKNOWN;
    if (part[0].body && part[0].body == part[1].body)
        return hobe_fail(err, HOBE_BAD_INPUT, joint->where,
                         "body \"%s\" cannot be joined to itself", part[0].body->spec.name);
    if (joint->at_point && !part[0].body && !part[1].body)
        return model_refuse_point(joint->beam[0], joint->where, err);
    return HOBE_OK;
}

enum hobe_status joint_places(const hobe_model *model, const struct hobe_joint *joint,
                              struct tied side[2], double gap[3], int *apart,
                              struct hobe_error *err)
{
    const int ground = !joint->beam[1];
    struct part part[2];
    double length = 0;
    enum hobe_status status = find_parts(model, joint, part, err);
    side[0] = (struct tied){.frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    memcpy(side[0].D0, side[0].frame, sizeof side[0].frame);
    memcpy(side[0].position, joint->to, sizeof side[0].position);
    for (int i = ground; !status && i < 2; i++)
        if (part[i].beam) {
            tied_at(model_place(part[i].beam, joint->at[i - ground]), side + i);
            length = fmax(length, part[i].beam->length);
        }
    for (int i = ground; !status && i < 2; i++)
        if (part[i].body)
            status = find_on_body(joint, i, part, side, err);
    for (int a = 0; !status && a < 3; a++)
        gap[a] = side[1].position[a] - side[0].position[a];
    *apart = !status && length3(gap) > COINCIDENT * length;
    return status;
}

/* Finds both places and the gap from the first to the second. */
static enum hobe_status find_places(const hobe_model *model, const struct hobe_joint *joint,
                                    struct tied side[2], double gap[3], struct hobe_error *err)
{
    const int two = joint->beam[1] != NULL;
    int apart;
    const enum hobe_status status = joint_places(model, joint, side, gap, &apart, err);
    if (status)
        return status;
    if (kinds[joint->kind].turn == STIFF && side[0].place.beam && side[1].place.beam)
        return hobe_fail(err, HOBE_BAD_INPUT, joint->where,
                         "a joint of kind rigid needs a body or the ground beside a beam, but "
                         "\"%s\" and \"%s\" are beams; take fixed",
                         joint->beam[0], joint->beam[1]);
    if (kinds[joint->kind].shift == APART)
        return apart ? HOBE_OK
                     : hobe_fail(err, HOBE_BAD_INPUT, joint->where,
                                 "a joint of kind distance needs places that are apart; those of "
                                 "\"%s\" and %s coincide",
                                 joint->beam[0], two ? joint->beam[1] : "the ground");
    if (two && apart)
        return hobe_fail(
            err, HOBE_BAD_INPUT, joint->where,
            "the joined places of \"%s\" and \"%s\" are %g m apart; they must coincide",
            joint->beam[0], joint->beam[1], length3(gap));
    return HOBE_OK;
}

static enum hobe_status add_joint(hobe_model *model, const struct hobe_joint *joint,
                                  struct hobe_error *err)
{
    struct tied side[2];
    double gap[3], t[3][3] = {{0}}, second[3][3] = {{0}};
    const enum hobe_status status = find_places(model, joint, side, gap, err);
    if (status)
        return status;
    struct tie *tie = tie_add(model, side, side + 1, err);
    if (!tie)
        return HOBE_NO_MEMORY;
    tie->where = joint->where;
    tie->name = joint->name;
    tie->angle = joint->angle;
    tie->position = joint->position;
    if (length3(joint->axis) > 0)
        triad3(joint->axis, t);
    joint_direction(tie->side, t[0], tie->axis);
    if (length3(joint->second) > 0)
        triad3(joint->second, second);
    stop_turning(tie, kinds[joint->kind].turn, (const double(*)[3])t, second[0]);
    stop_shifting(tie, kinds[joint->kind].shift, (const double(*)[3])t, gap);
    return HOBE_OK;
}

enum hobe_status joint_parts(hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < model->joints.count; i++)
        status = add_joint(model, (const struct hobe_joint *)model->joints.item + i, err);
    for (size_t i = 0; !status && i < model->ties.count; i++)
        status = tie_resolve(model, model_tie(model, i), err);
    return status;
}

/* ---- too few --------------------------------------------------------------------------------- */

/* The work of a constraint on the rigid motion of what holds one of its places: translations along
 * and rotations about x, y, z through a point, over a length; in six columns. */
static void put_rigid(struct rank *rank, long column, const struct tied *side, const double J[3][3],
                      const double point[3], double length)
{
    double turn[3], arm[3];
    for (int a = 0; a < 3; a++) {
        arm[a] = side->position[a] - point[a];
        rank_put(rank, column + a, J[0][a]);
    }
    for (int i = 0; i < 3; i++) {
        cross3(i ? side->D0[i] : arm, J[i], turn);
        for (int a = 0; a < 3; a++)
            rank_put(rank, column + 3 + a, turn[a] / length);
    }
}

/* The number of the part that a place is on, beams before bodies; -1: the ground. */
static long part_of(const hobe_model *model, const struct tied *side)
{
    if (side->body)
        return (long)model->beams.count + (side->body - model_body(model, 0));
    return side->place.beam ? side->place.beam - model_beam(model, 0) : -1;
}

/* A point of a part and its size, from which its rotations are counted. */
static double extent(const hobe_model *model, size_t part, const double **point)
{
    if (part < model->beams.count) {
        *point = model_beam(model, part)->end[0];
        return model_beam(model, part)->length;
    }
    const struct body *body = model_body(model, part - model->beams.count);
    *point = body->spec.centre;
    return body_radius(body);
}

/* The rows J of a tie or spring. */
static enum hobe_status add_rows(const hobe_model *model, const struct tie *tie, int rows,
                                 double J[TIE_CONSTRAINTS][TIE_VECTORS][3], const size_t *root,
                                 const unsigned char *held, struct rank *rank,
                                 struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    int independent;
    for (int k = 0; !status && k < rows; k++) {
        for (int s = 0; s < 2; s++) {
            const long part = part_of(model, tie->side + s);
            if (part < 0 || held[root[part]])
                continue;
            const double *point, length = extent(model, root[part], &point);
            put_rigid(rank, 6 * (long)root[part], tie->side + s, (const double(*)[3])J[k] + 3 * s,
                      point, length);
        }
        status = rank_add(rank, &independent, err);
    }
    return status;
}

/* Appends "translations along x, y" for what is not stopped. */
static void list_motions(const char *kind, const char *how, const long stopped[3],
                         char text[MOTIONS])
{
    const int free = !stopped[0] + !stopped[1] + !stopped[2];
    size_t used = strlen(text);
    if (free)
        used += (size_t)snprintf(text + used, MOTIONS - used, "%s%s%s %s", used ? " and " : "",
                                 kind, free > 1 ? "s" : "", how);
    for (int a = 0, listed = 0; a < 3; a++)
        if (!stopped[a])
            used += (size_t)snprintf(text + used, MOTIONS - used, "%s %c", listed++ ? "," : "",
                                     "xyz"[a]);
}

/* Names the motions that no constraint stops of the group of a part. */
static enum hobe_status name_motions(const hobe_model *model, size_t part, const long stopped[6],
                                     struct hobe_error *err)
{
    char text[MOTIONS] = "";
    const size_t beams = model->beams.count;
    list_motions("translation", "along", stopped, text);
    list_motions("rotation", "about", stopped + 3, text);
    if (part >= beams)
        return hobe_fail(err, HOBE_UNCONSTRAINED, model_body(model, part - beams)->spec.where,
                         "body \"%s\" is free to move: %s; hold it by a support, or join it to a "
                         "held beam",
                         model_body(model, part - beams)->spec.name, text);
    return hobe_fail(err, HOBE_UNCONSTRAINED, model_beam(model, part)->spec.where,
                     "beam \"%s\" is free to move: %s; hold it by a clamp or a support, or join it "
                     "to a held beam",
                     model_beam(model, part)->name, text);
}

enum hobe_status joint_check_held(const hobe_model *model, const size_t *root,
                                  const unsigned char *held, struct hobe_error *err)
{
    struct rank rank;
    double J[TIE_CONSTRAINTS][TIE_VECTORS][3];
    const size_t parts = model->beams.count + model->bodies.count;
    enum hobe_status status = rank_open(&rank, 6 * (long)parts, err);
    for (size_t i = 0; !status && i < model->ties.count; i++) {
        const struct tie *tie = model_tie(model, i);
        tie_jacobian(tie, J);
        if (!tie->corner && !tie->rigidity)
            status = add_rows(model, tie, tie->constraints, J, root, held, &rank, err);
    }
    for (size_t i = 0; !status && i < model->springs.count; i++) {
        const int rows = spring_jacobian(model_spring(model, i), J);
        status = add_rows(model, &model_spring(model, i)->tie, rows, J, root, held, &rank, err);
    }
    for (size_t i = 0; !status && i < parts; i++)
        for (int m = 0; !status && root[i] == i && !held[i] && m < 6; m++)
            if (!rank.row_of[6 * i + (size_t)m])
                status = name_motions(model, i, rank.row_of + 6 * i, err);
    rank_close(&rank);
    return status;
}

/* ---- too many -------------------------------------------------------------------------------- */

static enum hobe_status fail_redundant(const struct tie *tie, struct hobe_error *err)
{
    const struct tied *side = tie->side + 1;
    const struct place place = side->place;
    char at[30] = "";
    if (place.beam)
        snprintf(at, sizeof at, " at %.4g", (place.element + place.xi) / place.beam->spec.elements);
    return hobe_fail(err, HOBE_BAD_INPUT, tie->where,
                     "the %s%s%s%s of %s \"%s\"%s stops motions that clamps or joints before it "
                     "stop already; leave it out, or choose a kind that stops less",
                     tie->corner ? "corner" : "joint", tie->name ? " \"" : "",
                     tie->name ? tie->name : "", tie->name ? "\"" : "",
                     side->body ? "body" : "beam",
                     side->body ? side->body->spec.name : place.beam->name, at);
}

enum hobe_status joint_check_redundant(const hobe_model *model, struct hobe_error *err)
{
    struct rank rank;
    double J[TIE_CONSTRAINTS][TIE_VECTORS][3];
    enum hobe_status status = rank_open(&rank, 3 * model->unknowns, err);
    for (size_t i = 0; !status && i < model->ties.count; i++) {
        const struct tie *tie = model_tie(model, i);
        int independent = 1;
        tie_jacobian(tie, J);
        for (int k = 0; !status && k < tie->constraints && !model->held[tie->multiplier]; k++) {
            for (const struct tie_term *t = tie->term; t < tie->term + tie->terms; t++) {
                const long unknown = model->unknown[tie->vector[t->entry]];
                for (int a = 0; unknown >= 0 && a < 3; a++)
                    rank_put(&rank, 3 * unknown + a, t->weight * J[k][t->what][a]);
            }
            status = rank_add(&rank, &independent, err);
            if (!status && !independent)
                status = fail_redundant(tie, err);
        }
    }
    rank_close(&rank);
    return status;
}

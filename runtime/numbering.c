/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which vectors a model has, which of them are held, and the numbers of the others. */
#include "numbering.h"

#include "body.h"
#include "constraint.h"
#include "joint.h"
#include "kernel_vectors.h"
#include "spring.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Beams in the order added, then bodies, then a block of multipliers for every join, two for every
 * body and three for every joint: more than enough. */
static enum hobe_status allocate_vectors(hobe_model *model, struct hobe_error *err)
{
    model->vectors = 0;
    for (size_t i = 0; i < model->beams.count; i++) {
        struct beam *beam = model_beam(model, i);
        beam->first = model->vectors;
        model->vectors += (long)beam->step * (beam->spec.elements - 1) + beam->kernel->vectors;
    }
    model->beam_vectors = model->vectors;
    for (size_t i = 0; i < model->bodies.count; i++) {
        model_body(model, i)->first = model->vectors;
        model->vectors += BODY_VECTORS;
    }
    model->moving = model->vectors;
    const size_t n = (size_t)model->vectors + model->joins.count + 2 * model->bodies.count +
                     3 * model->joints.count;
    model->alias = hobe_alloc(n, sizeof *model->alias, err);
    model->unknown = hobe_alloc(n, sizeof *model->unknown, err);
    model->held = hobe_alloc(n, sizeof *model->held, err);
    model->dead = hobe_alloc(3 * n, sizeof *model->dead, err);
    if (!model->alias || !model->unknown || !model->held || !model->dead)
        return HOBE_NO_MEMORY;
    for (size_t v = 0; v < n; v++)
        model->alias[v] = (long)v;
    return HOBE_OK;
}

/* Vectors that a section does not carry are held at zero, where the elements have them still. */
static void hold_mode(hobe_model *model, const struct beam *beam, const char *mode)
{
    const struct hobe_kernel *k = beam->kernel;
    for (int e = 0; e < beam->spec.elements; e++)
        for (int v = 0; v < k->vectors; v++)
            if (!strcmp(k->mode[k->vector[v].mode], mode))
                model->held[model_vector(model, beam, e, v)] = 1;
}

/* They are named, and so is the element that does without. */
static enum hobe_status leave_out(hobe_model *model, const struct beam *beam,
                                  struct hobe_error *err)
{
    const struct hobe_kernel *asked = beam->spec.kernel;
    char text[400];
    for (int m = 0; m < asked->modes; m++) {
        if (!beam->dropped[m])
            continue;
        snprintf(
            text, sizeof text,
            "beam \"%.200s\": section mode %s vanishes or depends on earlier modes and is left "
            "out",
            beam->name, asked->mode[m]);
        if (model_add_note(model, text, err))
            return HOBE_NO_MEMORY;
        hold_mode(model, beam, asked->mode[m]);
    }
    if (beam->kernel == asked)
        return HOBE_OK;
    snprintf(text, sizeof text,
             "beam \"%.200s\": what is left of %.50s is %.50s, and costs no more than that",
             beam->name, asked->name, beam->kernel->name);
    return model_add_note(model, text, err);
}

static enum hobe_status hold_dropped(hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = HOBE_OK;
    for (size_t i = 0; !status && i < model->beams.count; i++)
        status = leave_out(model, model_beam(model, i), err);
    return status;
}

static enum hobe_status note_spurious(hobe_model *model, struct hobe_error *err)
{
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        struct hobe_rest rest;
        char text[240];
        hobe_element_rest(beam->law[0], &rest);
        if (rest.zero <= 6)
            continue;
        snprintf(text, sizeof text,
                 "beam \"%s\": with integration = \"paper\" element %s has %d zero-energy modes, "
                 "%d of them spurious; supports may not hold them",
                 beam->name, beam->spec.kernel->name, rest.zero, rest.zero - 6);
        if (model_add_note(model, text, err))
            return HOBE_NO_MEMORY;
    }
    return HOBE_OK;
}

/* Where a share of the section's stiffness is further than this from 1, it is said. */
static const double NOTED = 0.01;

/* An element is as stiff as its section but for what its modes and its law keep it from: torsion
 * without a warping function, Poisson's coupling that sections cannot follow, a law on the axis. */
static enum hobe_status note_stiffness(hobe_model *model, struct hobe_error *err)
{
    static const char *const names[HOBE_STRAINS] = {"EA", "EIyy", "EIzz", "GJ"};
    for (size_t i = 0; i < model->beams.count; i++) {
        const struct beam *beam = model_beam(model, i);
        struct hobe_rest rest;
        char text[600];
        hobe_element_rest(beam->law[0], &rest);
        int used = snprintf(text, sizeof text, "beam \"%.200s\": %.99s with mechanics %s has",
                            beam->name, beam->spec.kernel->name,
                            hobe_mechanics_name(hobe_element_mechanics(beam->law[0])));
        const int none = used;
        for (int s = 0; s < HOBE_STRAINS; s++)
            if (rest.share[s] != 0 && fabs(rest.share[s] - 1) > NOTED)
                used += snprintf(text + used, sizeof text - (size_t)used, "%s %.4g times the %s",
                                 used > none ? "," : "", rest.share[s], names[s]);
        if (used == none)
            continue;
        snprintf(text + used, sizeof text - (size_t)used, " of its section");
        if (model_add_note(model, text, err))
            return HOBE_NO_MEMORY;
    }
    return HOBE_OK;
}

int node_at(const struct beam *beam, double at, int *element)
{
    const struct hobe_kernel *k = beam->kernel;
    const struct place place = model_place(beam, at);
    *element = place.element;
    for (int n = 0; n < k->nodes; n++)
        if (fabs(k->node[n] - place.xi) < 1e-9 && hobe_kernel_vector(k, n, 0, 0) >= 0)
            return n;
    return -1;
}

/* Such a clamp holds slopes of the axis; of an outline that cubic modes curve, those are not the
 * mean. */
static enum hobe_status note_free_clamp(hobe_model *model, const struct beam *beam,
                                        struct hobe_error *err)
{
    char text[500];
    int cubic = 0;
    for (int m = 0; m < beam->kernel->modes; m++)
        cubic |= !strcmp(beam->kernel->mode[m], "yyy") || !strcmp(beam->kernel->mode[m], "zzz");
    if (!cubic)
        return HOBE_OK;
    snprintf(
        text, sizeof text,
        "beam \"%.200s\": a clamp with warping = \"free\" holds the slopes y and z on the axis, "
        "from which the cubic modes of %.99s let the outline turn away: too soft near the clamp",
        beam->name, beam->spec.kernel->name);
    return model_add_note(model, text, err);
}

static enum hobe_status hold_clamps(hobe_model *model, struct hobe_error *err)
{
    for (size_t i = 0; i < model->clamps.count; i++) {
        const struct hobe_clamp *c = (const struct hobe_clamp *)model->clamps.item + i;
        const struct beam *beam = model_find_beam(model, c->beam, c->where, err);
        int e;
        if (!beam)
            return HOBE_UNKNOWN;
        const int node = node_at(beam, c->at, &e);
        if (node < 0)
            return hobe_fail(
                err, HOBE_BAD_INPUT, c->where,
                "a clamp must sit on a node: beam \"%s\" has %d elements of type %s and "
                "none of their nodes with a position at %g",
                beam->name, beam->spec.elements, beam->spec.kernel->name, c->at);
        for (int v = 0; v < beam->kernel->vectors; v++) {
            const struct hobe_vector *is = beam->kernel->vector + v;
            if (is->node == node && (!c->free_warping || (is->mode <= 2 && !is->slope)))
                model->held[model_vector(model, beam, e, v)] = 1;
        }
        if (c->free_warping && note_free_clamp(model, beam, err))
            return HOBE_NO_MEMORY;
    }
    return HOBE_OK;
}

/* A corner between held sections has nothing to say: its multipliers would be undetermined. */
static void hold_idle_corners(hobe_model *model)
{
    for (size_t i = 0; i < model->ties.count; i++) {
        const struct tie *tie = model_tie(model, i);
        unsigned char held = 1;
        for (int v = 0; v < tie->vectors - tie->blocks; v++)
            held &= model->held[tie->vector[v]];
        if (tie->corner)
            model->held[tie->multiplier] = held;
    }
}

/* The beam that a vector was laid out for. */
static size_t owner(const hobe_model *model, long vector)
{
    size_t i = model->beams.count - 1;
    while (model_beam(model, i)->first > vector)
        i--;
    return i;
}

size_t group_of(const size_t *group, size_t i)
{
    while (group[i] != i)
        i = group[i];
    return i;
}

void group_parts(const hobe_model *model, size_t *group)
{
    for (size_t i = 0; i < model->beams.count + model->bodies.count; i++)
        group[i] = i;
    for (long v = 0; v < model->beam_vectors; v++)
        if (model->alias[v] != v)
            group[group_of(group, owner(model, v))] =
                group_of(group, owner(model, model->alias[v]));
}

/* A group with a clamp is held in all six rigid motions; others depend on joints and supports. What
 * is free may move in time, and is only remembered. */
static enum hobe_status check_held(hobe_model *model, struct hobe_error *err)
{
    const size_t n = model->beams.count + model->bodies.count;
    size_t *group = hobe_alloc(n, sizeof *group, &model->loose);
    unsigned char *clamped =
        hobe_alloc(n, 1, &model->loose); /* for each root, whether its group has a clamp */
    enum hobe_status status = group && clamped ? HOBE_OK : HOBE_NO_MEMORY;
    if (!status)
        group_parts(model, group);
    for (size_t c = 0; !status && c < model->clamps.count; c++) {
        const char *name = ((const struct hobe_clamp *)model->clamps.item)[c].beam;
        const struct beam *beam = model_find_beam(model, name, NULL, NULL);
        clamped[group_of(group, (size_t)(beam - model_beam(model, 0)))] = 1;
    }
    for (size_t i = 0; !status && i < n; i++)
        group[i] = group_of(group, i);
    if (!status)
        status = joint_check_held(model, group, clamped, &model->loose);
    hobe_free(group);
    hobe_free(clamped);
    return status == HOBE_NO_MEMORY ? model_check_held(model, err) : HOBE_OK;
}

void number_unknowns(hobe_model *model)
{
    model->unknowns = 0;
    for (long v = 0; v < model->vectors; v++)
        model->unknown[v] = model->alias[v] == v && !model->held[v] ? model->unknowns++ : -1;
}

enum hobe_status number_model(hobe_model *model, struct hobe_error *err)
{
    enum hobe_status status = allocate_vectors(model, err);
    if (!status)
        status = join_beams(model, err);
    if (!status)
        status = body_ties(model, err);
    if (!status)
        status = joint_parts(model, err);
    if (!status)
        status = spring_build(model, err);
    if (!status)
        status = hold_dropped(model, err);
    if (!status)
        status = hold_clamps(model, err);
    if (!status)
        status = check_held(model, err);
    if (!status)
        status = note_spurious(model, err);
    if (!status)
        status = note_stiffness(model, err);
    if (status)
        return status;
    hold_idle_corners(model);
    number_unknowns(model);
    return joint_check_redundant(model, err);
}

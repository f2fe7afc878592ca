/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "enrich.h"

#include "trust.h"

#include <stdlib.h>

enum { MOST_ROUNDS = 10 };

/* Of the model at hand. */
struct job {
    struct hobe_reduced *reduced;
    const struct hobe_reduce *options;
    double started, worst; /* the largest indicator of this round */
};

/* Adds to the basis what a state of the model lacks, and makes the energy anew. */
static enum hobe_status add_lack(struct job *job, hobe_model *model, const hobe_solution *state,
                                 struct hobe_error *err)
{
    struct hobe_reduced *r = job->reduced;
    struct trust trust;
    double indicator, size = 0;
    double *lack = hobe_alloc((size_t)(3 * model->vectors), sizeof *lack, err);
    if (!lack)
        return HOBE_NO_MEMORY;
    enum hobe_status status = trust_open(&trust, model, err);
    if (!status)
        status = trust_measure(&trust, state, &size, &indicator, lack, err);
    trust_close(&trust);
    if (!status)
        status = basis_add(&r->basis, model, job->options, lack, err);
    hobe_free(lack);
    return status ? status : reduced_finish(r, job->started, err);
}

static enum hobe_status try_loads(struct job *job, hobe_model *model, struct hobe_error *err)
{
    hobe_model *small = NULL;
    hobe_solution *state = NULL;
    struct hobe_solution_info info = {.indicator = 0};
    enum hobe_status status = hobe_reduced_model(job->reduced, model, &small, err);
    if (!status)
        status = hobe_static(small, &(struct hobe_newton){0}, &state, err);
    hobe_model_free(small);
    if (!status)
        hobe_solution_info(state, &info);
    if (info.indicator > job->worst)
        job->worst = info.indicator;
    if (info.indicator > job->options->accuracy)
        status = add_lack(job, model, state, err);
    hobe_solution_free(state);
    return status;
}

static enum hobe_status try_all(struct job *job, struct hobe_error *err)
{
    const struct hobe_reduce *o = job->options;
    job->worst = 0;
    enum hobe_status status = try_loads(job, job->reduced->model, err);
    for (int i = 0; !status && i < o->load_count; i++)
        status = try_loads(job, o->loads[i], err);
    return status;
}

enum hobe_status enrich(struct hobe_reduced *r, const struct hobe_reduce *o, double started,
                        struct hobe_error *err)
{
    struct job job = {r, o, started, 0};
    for (int round = 0; round < MOST_ROUNDS; round++) {
        const long before = r->basis.n;
        const enum hobe_status status = try_all(&job, err);
        if (status)
            return status;
        if (job.worst <= o->accuracy) {
            r->info.accuracy = o->accuracy;
            return HOBE_OK;
        }
        if (r->basis.n == before || (o->modes > 0 && !o->closed && r->basis.n > o->modes))
            break;
    }
    return hobe_fail(err, HOBE_NOT_CONVERGED, NULL,
                     "%ld unknowns may still lack %.2g of the displacements under the loads of "
                     "interest; allow more modes, or an accuracy above %.2g",
                     r->basis.n, job.worst, o->accuracy);
}

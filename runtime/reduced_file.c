/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bases as bytes.
 *
 *     struct head, centre [beam_vectors][3] if there is one, fields [unknowns][beam_vectors][3]
 *
 * in the memory layout of the program that wrote them; the energy is made anew. */
#include "journal.h"
#include "reduced.h"

#include <math.h>
#include <string.h>

static const char MAGIC[8] = "hobeRED2";

struct head {
    char magic[8];
    uint64_t sum; /* journal_sum of all behind it */
    int64_t method, closed, unknowns, vectors, centre;
    double accuracy;
    struct fingerprint fingerprint;
};

static size_t bytes_of(const struct head *head)
{
    return sizeof *head +
           (size_t)(3 * head->vectors * (head->unknowns + head->centre)) * sizeof(double);
}

static uint64_t sum_of(const void *bytes, size_t size)
{
    const size_t from = offsetof(struct head, method);
    return journal_sum((const char *)bytes + from, size - from);
}

enum hobe_status hobe_reduced_write(const hobe_reduced *r, void **bytes, size_t *size,
                                    struct hobe_error *err)
{
    const long vectors = r->model->vectors, beams = r->model->beam_vectors;
    struct head head = {.method = r->info.method,
                        .closed = r->info.closed,
                        .unknowns = r->basis.n,
                        .vectors = beams,
                        .centre = r->centre != NULL,
                        .accuracy = r->info.accuracy,
                        .fingerprint = r->fingerprint};
    memcpy(head.magic, MAGIC, sizeof MAGIC);
    *size = bytes_of(&head);
    *bytes = hobe_alloc(*size, 1, err);
    if (!*bytes)
        return HOBE_NO_MEMORY;
    double *to = (double *)((char *)*bytes + sizeof head);
    if (r->centre)
        memcpy(to, r->centre, (size_t)(3 * beams) * sizeof *to);
    to += 3 * beams * head.centre;
    for (long j = 0; j < r->basis.n; j++)
        memcpy(to + 3 * beams * j, r->basis.field + 3 * vectors * j,
               (size_t)(3 * beams) * sizeof *to);
    memcpy(*bytes, &head, sizeof head);
    head.sum = sum_of(*bytes, *size);
    memcpy(*bytes, &head, sizeof head);
    return HOBE_OK;
}

/* The bytes are whole, and of this model. */
static enum hobe_status check(const hobe_model *model, const void *bytes, size_t size,
                              struct head *head, struct hobe_error *err)
{
    struct fingerprint print;
    if (size < sizeof *head || memcmp(bytes, MAGIC, sizeof MAGIC) != 0)
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "this is no basis of a reduced model, or one of another version");
    memcpy(head, bytes, sizeof *head);
    const int sound = head->vectors > 0 && head->unknowns > 0 &&
                      head->unknowns <= (int64_t)(size / sizeof(double)) / head->vectors &&
                      (head->centre == 0 || head->centre == 1) && size == bytes_of(head);
    if (!sound || head->sum != sum_of(bytes, size))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "the basis of a reduced model is damaged or cut off");
    const enum hobe_status status = reduced_fingerprint(model, &print, err);
    if (!status &&
        (head->vectors != model->beam_vectors || !reduced_same(&print, &head->fingerprint)))
        return hobe_fail(err, HOBE_BAD_INPUT, NULL,
                         "this basis was made of other beams, joins or supports than the scene's");
    return status;
}

static enum hobe_status take(struct hobe_reduced *r, const struct head *head, const double *from,
                             struct hobe_error *err)
{
    const size_t size = (size_t)(3 * r->model->vectors), beams = (size_t)(3 * head->vectors);
    const size_t n = (size_t)head->unknowns;
    if (head->centre) {
        r->centre = hobe_alloc(size, sizeof *r->centre, err);
        if (!r->centre)
            return HOBE_NO_MEMORY;
        memcpy(r->centre, from, beams * sizeof *from);
        from += beams;
    }
    r->basis.field = hobe_alloc(n * size, sizeof *r->basis.field, err);
    if (!r->basis.field)
        return HOBE_NO_MEMORY;
    r->basis.n = r->basis.room = (long)n;
    for (size_t j = 0; j < n; j++)
        memcpy(r->basis.field + j * size, from + j * beams, beams * sizeof *from);
    return HOBE_OK;
}

enum hobe_status hobe_reduced_read(hobe_model *model, const void *bytes, size_t size,
                                   hobe_reduced **reduced, struct hobe_error *err)
{
    const double started = hobe_seconds();
    struct head head;
    *reduced = NULL;
    enum hobe_status status = hobe_model_build(model, err);
    if (!status)
        status = check(model, bytes, size, &head, err);
    hobe_reduced *r = status ? NULL : hobe_alloc(1, sizeof *r, err);
    if (!r)
        return status ? status : HOBE_NO_MEMORY;
    r->model = model;
    r->info = (struct hobe_reduced_info){.method = (enum hobe_reduce_method)head.method,
                                         .closed = (int)head.closed,
                                         .accuracy = head.accuracy};
    status = take(r, &head, (const double *)((const char *)bytes + sizeof head), err);
    if (!status)
        status = reduced_finish(r, started, err);
    if (status)
        hobe_reduced_free(r);
    else
        *reduced = r;
    return status;
}

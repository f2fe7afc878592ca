/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mixture.h"

#include "load.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Appends the items of a list, each of `size` bytes with three numbers at `value`, scaled. */
static enum hobe_status add_items(struct list *list, const struct list *from, size_t size,
                                  size_t value, double weight, struct hobe_error *err)
{
    for (size_t i = 0; i < from->count; i++) {
        char *to = list_append(list, size, err);
        if (!to)
            return HOBE_NO_MEMORY;
        memcpy(to, (const char *)from->item + i * size, size);
        for (int a = 0; a < 3; a++)
            ((double *)(to + value))[a] *= weight;
    }
    return HOBE_OK;
}

/* The centrifugal force goes with the square of the speed, and has one sign. */
static void add_spin(hobe_model *to, const hobe_model *from, double weight)
{
    if (!from->spun || !(weight > 0))
        return;
    const double speed = to->spun ? to->spin.speed : 0;
    to->spin = from->spin;
    to->spin.speed = sqrt(speed * speed + weight * from->spin.speed * from->spin.speed);
    to->spun = 1;
    to->arm = from->arm;
}

static enum hobe_status add(struct mixture *mixture, const hobe_model *from, double weight,
                            struct hobe_error *err)
{
    hobe_model *to = &mixture->model;
    for (long i = 0; i < 3 * to->vectors; i++)
        mixture->dead[i] += weight * from->dead[i];
    add_spin(to, from, weight);
    enum hobe_status status = add_items(&to->forces, &from->forces, sizeof(struct force),
                                        offsetof(struct force, spec.value), weight, err);
    if (!status)
        status = add_items(&to->moments, &from->moments, sizeof(struct moment),
                           offsetof(struct moment, spec.value), weight, err);
    if (!status)
        status = add_items(&to->gravities, &from->gravities, sizeof(struct gravity),
                           offsetof(struct gravity, g), weight, err);
    return status;
}

enum hobe_status mixture_open(struct mixture *mixture, int count, hobe_model *const *models,
                              const double *weight, struct hobe_error *err)
{
    const struct list none = {0};
    hobe_model *model = &mixture->model;
    *model = *models[0];
    model->forces = model->moments = model->gravities = none;
    model->spun = 0;
    model->arm = NULL;
    mixture->dead = model->dead = hobe_alloc((size_t)(3 * model->vectors), sizeof(double), err);
    enum hobe_status status = mixture->dead ? HOBE_OK : HOBE_NO_MEMORY;
    for (int i = 0; !status && i < count; i++)
        if (weight[i] != 0)
            status = add(mixture, models[i], weight[i], err);
    return status ? status : load_find(model, err);
}

void mixture_close(struct mixture *mixture)
{
    hobe_free(mixture->dead);
    hobe_free(mixture->model.forces.item);
    hobe_free(mixture->model.moments.item);
    hobe_free(mixture->model.gravities.item);
}

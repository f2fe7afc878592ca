/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh_triangle.h"

#include "linsolve.h"

#include <math.h>

void hobe_mesh_matrix_free(struct hobe_mesh_matrix *m)
{
    hobe_free(m->start);
    hobe_free(m->row);
    hobe_free(m->value);
    hobe_free(m->scale);
}

/* A column has room for 6 `per` entries of each triangle at its node; rows are -1 where free. */
enum hobe_status hobe_mesh_matrix_new(const struct hobe_mesh *mesh, int per,
                                      struct hobe_mesh_matrix *m, struct hobe_error *err)
{
    const size_t n = (size_t)(per * mesh->nodes);
    const size_t block = (size_t)(per * NODES), entries = block * block * (size_t)mesh->triangles;
    *m = (struct hobe_mesh_matrix){
        (int)n, hobe_alloc(n + 1, sizeof *m->start, err), hobe_alloc(entries, sizeof *m->row, err),
        hobe_alloc(entries, sizeof *m->value, err), hobe_alloc(n, sizeof *m->scale, err)};
    if (!m->start || !m->row || !m->value || !m->scale)
        return HOBE_NO_MEMORY;
    for (int t = 0; t < mesh->triangles; t++)
        for (int i = 0; i < NODES; i++)
            for (int a = 0; a < per; a++)
                m->start[per * mesh->triangle[t][i] + a + 1] += (long)block;
    for (size_t i = 0; i < n; i++)
        m->start[i + 1] += m->start[i];
    for (size_t i = 0; i < entries; i++)
        m->row[i] = -1;
    return HOBE_OK;
}

void hobe_mesh_matrix_add(struct hobe_mesh_matrix *m, long row, long column, double value)
{
    long p = m->start[column];
    while (m->row[p] != row && m->row[p] >= 0)
        p++;
    m->row[p] = row;
    m->value[p] += value;
}

void hobe_mesh_matrix_close(struct hobe_mesh_matrix *m)
{
    long to = 0, from = 0;
    for (int c = 0; c < m->n; c++) {
        const long first = to, end = m->start[c + 1];
        for (; from < end && m->row[from] >= 0; from++) {
            const long row = m->row[from];
            const double value = m->value[from];
            long p = to++;
            for (; p > first && m->row[p - 1] > row; p--) {
                m->row[p] = m->row[p - 1];
                m->value[p] = m->value[p - 1];
            }
            m->row[p] = row;
            m->value[p] = value;
            if (row == c)
                m->scale[c] = 1 / sqrt(value);
        }
        from = end;
        m->start[c] = first;
    }
    m->start[m->n] = to;
}

hobe_linsolve *hobe_mesh_matrix_factor(const struct hobe_mesh_matrix *m, struct hobe_error *err)
{
    long column;
    hobe_linsolve *solver = hobe_linsolve_analyse(m->n, m->start, m->row, err);
    if (solver && hobe_linsolve_factor(solver, m->value, m->scale, &column, err)) {
        hobe_linsolve_free(solver);
        return NULL;
    }
    return solver;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files for ParaView and its kin, as text (VTK file formats, XML: UnstructuredGrid, Collection). */
#include "output_vtk.h"

#include <string.h>

/* VTK_BIQUADRATIC_QUADRATIC_WEDGE, whose nodes are in the order of struct hobe_solid. */
enum { WEDGE_TYPE = 32 };

static void open_array(struct hobe_text *text, const char *type, const char *name, int components)
{
    hobe_text_add(text,
                  "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" "
                  "format=\"ascii\">\n",
                  type, name, components);
}

static void close_array(struct hobe_text *text)
{
    hobe_text_add(text, "</DataArray>\n");
}

static void add_vectors(struct hobe_text *text, const char *name, int count, double (*v)[3])
{
    open_array(text, "Float64", name, 3);
    for (int i = 0; i < count; i++)
        hobe_text_add(text, "%.10g %.10g %.10g\n", v[i][0], v[i][1], v[i][2]);
    close_array(text);
}

/* A symmetric tensor in VTK's order, xx, yy, zz, xy, yz, xz. */
static void add_tensor(struct hobe_text *text, const double t[6], double shear)
{
    hobe_text_add(text, "%.8g %.8g %.8g %.8g %.8g %.8g\n", t[0], t[1], t[2], shear * t[5],
                  shear * t[3], shear * t[4]);
}

static void add_stress(struct hobe_text *text, const struct hobe_solid *solid)
{
    open_array(text, "Float64", "stress", 6);
    for (int i = 0; i < solid->points; i++)
        add_tensor(text, solid->stress[i].cauchy, 1);
    close_array(text);
    open_array(text, "Float64", "strain", 6);
    for (int i = 0; i < solid->points; i++)
        add_tensor(text, solid->stress[i].strain, 0.5); /* engineering shear to the tensor's */
    close_array(text);
    open_array(text, "Float64", "von Mises", 1);
    for (int i = 0; i < solid->points; i++)
        hobe_text_add(text, "%.8g\n", solid->stress[i].mises);
    close_array(text);
}

static void add_cells(struct hobe_text *text, const struct hobe_solid *solid)
{
    hobe_text_add(text, "<Cells>\n");
    open_array(text, "Int32", "connectivity", 1);
    for (int c = 0; c < solid->cells; c++)
        for (int i = 0; i < HOBE_WEDGE; i++)
            hobe_text_add(text, "%d%c", solid->cell[c][i], i < HOBE_WEDGE - 1 ? ' ' : '\n');
    close_array(text);
    open_array(text, "Int32", "offsets", 1);
    for (int c = 1; c <= solid->cells; c++)
        hobe_text_add(text, "%d\n", c * HOBE_WEDGE);
    close_array(text);
    open_array(text, "UInt8", "types", 1);
    for (int c = 0; c < solid->cells; c++)
        hobe_text_add(text, "%d\n", WEDGE_TYPE);
    close_array(text);
    hobe_text_add(text, "</Cells>\n");
}

void hobe_vtk_solid(const struct hobe_solid *solid, struct hobe_text *text)
{
    hobe_text_add(text,
                  "<?xml version=\"1.0\"?>\n"
                  "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                  "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
                  "<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n<Points>\n",
                  solid->points, solid->cells);
    add_vectors(text, "points", solid->points, solid->point);
    hobe_text_add(text, "</Points>\n");
    add_cells(text, solid);
    hobe_text_add(text, "<PointData Vectors=\"displacement\">\n");
    add_vectors(text, "displacement", solid->points, solid->displacement);
    if (solid->stress)
        add_stress(text, solid);
    hobe_text_add(text, "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

/* Text between quotes in XML. */
static void add_quoted(struct hobe_text *text, const char *quoted)
{
    for (; *quoted; quoted++) {
        const char *entity = *quoted == '&'   ? "&amp;"
                             : *quoted == '<' ? "&lt;"
                             : *quoted == '"' ? "&quot;"
                                              : NULL;
        hobe_text_bytes(text, entity ? entity : quoted, entity ? strlen(entity) : 1);
    }
}

void hobe_vtk_series(int count, const char *const *file, const double *time, struct hobe_text *text)
{
    hobe_text_add(text, "<?xml version=\"1.0\"?>\n"
                        "<VTKFile type=\"Collection\" version=\"0.1\" "
                        "byte_order=\"LittleEndian\">\n<Collection>\n");
    for (int i = 0; i < count; i++) {
        hobe_text_add(text, "<DataSet timestep=\"%.17g\" part=\"0\" file=\"", time[i]);
        add_quoted(text, file[i]);
        hobe_text_add(text, "\"/>\n");
    }
    hobe_text_add(text, "</Collection>\n</VTKFile>\n");
}

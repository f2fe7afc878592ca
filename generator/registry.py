# SPDX-License-Identifier: GPL-3.0-or-later
"""C text of the registry: all elements, for each machine they are compiled for."""

from . import ctext

REGISTRY = """\
/* The elements built in.  Written by `python -m generator`: do not edit. */
#include "kernel.h"

#include <stdlib.h>
#include <string.h>

{tables}
/* Whether the environment leaves this machine to choose. */
static int allowed(const char *machine)
{{
    const char *only = getenv("HOBE_MACHINE");
    return !only || !strcmp(only, machine);
}}

const struct hobe_kernel *const *hobe_kernels(void)
{{
{choices}
    return portable;
}}

const char *hobe_machine(void)
{{
{names}
    return "portable";
}}
"""

TABLE = """{externs}

static const struct hobe_kernel *const {machine}[] = {{
{items}
    NULL,
}};
"""

CHOICE = """    if (allowed("{machine}") && {runs})
        return {machine};
"""

NAME = """    if (hobe_kernels() == {machine})
        return "{machine}";
"""

MACHINES = {  # the best first: what a processor must have
    "avx512": ("avx512f", "fma"),
    "avx2": ("avx2", "fma"),
    "portable": (),
}


def write(elements):
    """The tables of built-in kernels, one for each machine they are compiled for."""
    symbols = ["hobe_kernel_" + ctext.identifier(e.declaration.name) for e in elements]
    tables, choices, names = [], [], []
    for machine, features in MACHINES.items():
        suffix = f"_{machine}" if features else ""
        table = TABLE.format(
            machine=machine, items="\n".join(f"    &{s}{suffix}," for s in symbols),
            externs="\n".join(f"extern const struct hobe_kernel {s}{suffix};" for s in symbols))
        runs = " && ".join(f'__builtin_cpu_supports("{f}")' for f in features)
        condition = f"#ifdef HOBE_{machine.upper()}\n"
        tables.append(f"{condition}{table}#endif\n" if features else table)
        if features:
            choices.append(f"{condition}{CHOICE.format(machine=machine, runs=runs)}#endif")
            names.append(f"{condition}{NAME.format(machine=machine)}#endif")
    return REGISTRY.format(tables="\n".join(tables), choices="\n".join(choices),
                           names="\n".join(names))

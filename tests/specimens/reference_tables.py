#!/usr/bin/python3
"""Makes the virtual oocyte's and embryo's tables: configuration 1 from GetFEM's solid of revolution, the others' forces from thin
shells, as the solid differs from the shell in configuration 1.

    apt install python3-getfem
    /usr/bin/python3 tests/specimens/reference_tables.py --output resources/reference

A thin shell is too stiff where the wall bends over the needle's rim, at every angle of the holder; a solid in three dimensions
beyond 12 um is out of reach. The shapes of configurations 2 to 4 stay the shells'. Thin shells: resources/reference/thin-shell-*. A shape of
configuration 1 at every depth of the thin shells' tables of its cell, forces likewise.
"""
import argparse
import csv
import pathlib

import getfem as gf
import numpy as np

import solid_specimens

THIN_SHELL = pathlib.Path(__file__).parents[2] / 'resources' / 'reference'
CELLS = {'mouse-oocyte': (44.0, 7.5), 'mouse-embryo': (53.0, 13.0)}  # the measured punctures: um, uN
DEEPEST_UM, STEP_UM, LAYERS = 56.0, 1.0, 4


def shell_of(cell):
    return cell.replace('mouse-', 'thin-shell-')


def read(path):
    with open(path, newline='') as file:
        rows = list(csv.reader(file))
    return rows[0], np.array(rows[1:], dtype=float)


def write(path, names, rows):
    with open(path, 'w', newline='') as file:
        out = csv.writer(file, lineterminator='\n')
        out.writerow(names)
        out.writerows([f'{value + 0.0:.6g}' for value in row] for row in rows)


def between(known, values, at):
    """Cubics through the nearest four of the solid's depths; values (depths, ...)."""
    out = []
    for x in at:
        first = int(np.clip(np.searchsorted(known, x) - 2, 0, len(known) - 4))
        near = known[first:first + 4]
        weights = [np.prod([(x - b) / (a - b) for b in near if b != a]) for a in near]
        out.append(np.tensordot(weights, values[first:first + 4], 1))
    return np.array(out)


class Solid:
    """The common geometry's curve to DEEPEST_UM, by the depth of the outer membrane's pole."""

    def __init__(self):
        _, rows, faces, _ = solid_specimens.compute(solid_specimens.draw(0), DEEPEST_UM, STEP_UM, LAYERS)
        table = np.array(rows)
        table[0] = 0.0
        self.depth, self.force, self.pressure = table.T
        # The elements' corners; outer r, z, inner r, z.
        self.angle = faces[0][0][0][::2]
        self.shape = np.array([[outer[1], outer[2], inner[1], inner[2]] for outer, inner in faces])[:, :, ::2]

    def at(self, depths, puncture_um, puncture_uN):
        """Force and pressure of the modulus that passes the puncture."""
        ratio = puncture_uN / between(self.depth, self.force, [puncture_um])[0]
        return ratio * between(self.depth, self.force, depths), ratio * between(self.depth, self.pressure, depths)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--output', type=pathlib.Path, default=pathlib.Path('.'))
    options = parser.parse_args()
    gf.util('trace level', 0)
    gf.util('warning level', 0)
    options.output.mkdir(parents=True, exist_ok=True)
    solid = Solid()
    for cell, puncture in CELLS.items():
        _, shell = read(THIN_SHELL / f'{shell_of(cell)}-1-force.csv')
        depths = shell[:, 0]
        force, pressure = solid.at(depths, *puncture)
        write(options.output / f'{cell}-1-force.csv', ['indentation_um', 'force_uN', 'pressure_kPa'],
              np.column_stack([depths, force, pressure]))
        shown = depths[(depths % 2 == 0) | (depths == depths[-1])]
        rows = [(depth, angle, *values) for depth, shape in zip(shown, between(solid.depth, solid.shape, shown))
                for angle, values in zip(solid.angle, np.round(shape, 3).T)]
        write(options.output / f'{cell}-1-profile.csv',
              ['indentation_um', 'theta0_rad', 'outer_r_um', 'outer_z_um', 'inner_r_um', 'inner_z_um'], rows)

        # The others, by the ratio at the same depth.
        of_force = {d: f / s if s else 1.0 for d, f, s in zip(depths, force, shell[:, 1])}
        of_pressure = {d: p / s if s else 1.0 for d, p, s in zip(depths, pressure, shell[:, 2])}
        for name in ('2-force', '3-force', '4-force', '1-field', '2-field', '3-field'):
            names, table = read(THIN_SHELL / f'{shell_of(cell)}-{name}.csv')
            depth = table[:, names.index('indentation_um')]
            for column, ratios in (('force_uN', of_force), ('lateral_force_uN', of_force), ('pressure_kPa', of_pressure)):
                table[:, names.index(column)] *= [ratios[d] for d in depth]
            write(options.output / f'{cell}-{name}.csv', names, table)
        print(f'{cell}: {force[-1]:.4f} uN at {depths[-1]:g} um; over the thin shell at 10 um '
              f'{of_force[10.0]:.3f}, at 30 um {of_force[30.0]:.3f}', flush=True)


if __name__ == '__main__':
    main()

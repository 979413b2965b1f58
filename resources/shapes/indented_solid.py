#!/usr/bin/python3
"""Fits the outer section of a solid shell under a needle, and the force on it, as functions of sizes, stiffening, elongation and depth.

    apt install python3-numpy
    build/release/bin/solid_sections 640 > sections.csv
    /usr/bin/python3 resources/shapes/indented_solid.py sections.csv resources/shapes/indented_solid.json

The displacement of the outer surface over its radius at rest is the depth times a sum of components (principal ones of all
sections); their coefficients, and the logarithm of the force, are polynomials in the logarithms of thickness, tip and holder
over the outer radius, in ln(1 + b / 0.3), b the wall's stiffening, and in that of the outline's length over width, and
Chebyshev's polynomials in the depth, by least squares. Prints what cells left out of the fit differ by (eightfold cross-validation).
"""
import json
import sys

import numpy as np

CENTRE = np.append(np.log([0.15, 0.05, 0.35]), [0.0, 0.0])
WIDTH = np.array([1.1, 1.7, 0.85, 1.0, 0.2])  # so that the polynomials' variables are within 1.3 or so
STIFFENING_SCALE = 0.3
DEPTH_CENTRE, DEEPEST_RATIO = 0.45, 0.85
# For powers of the variables of stiffening and elongation: the highest sum of the sizes' powers, and so many more with the
# depth's degree. What both do together is left out.
HIGHEST_SUMS, DEPTH_BEYOND = {(0, 0): 5, (1, 0): 4, (2, 0): 2, (0, 1): 3, (0, 2): 2}, 2
COMPONENTS = 16
ANGLE_STEP_DEG = 4
FOLDS = 8


def powers():
    return np.array([(h, a, o, s, e, d)
                     for (s, e), highest in HIGHEST_SUMS.items()
                     for h in range(highest + 1) for a in range(highest + 1 - h)
                     for o in range(highest + 1 - h - a) for d in range(highest + DEPTH_BEYOND + 1 - h - a - o)])


def basis(parameters, depth):
    u = (parameters - CENTRE) / WIDTH
    angle = np.arccos(np.clip(depth / DEPTH_CENTRE - 1, -1, 1))
    return np.stack([np.prod(u**p[:5], axis=1) * np.cos(p[5] * angle) for p in powers()], axis=1)


def left_out(rows, values, cells):
    error = np.zeros_like(values)
    for fold in range(FOLDS):
        out = cells % FOLDS == fold
        error[out] = rows[out] @ np.linalg.lstsq(rows[~out], values[~out], rcond=None)[0] - values[out]
    return error


def rms(values):
    return np.sqrt((values**2).mean())


def rounded(table):
    return [[float(f'{value:.7g}') for value in row] for row in table]


def main():
    table = np.loadtxt(sys.argv[1], delimiter=',')
    cells, (thickness, tip, holder, stiffening, aspect, depth_um, force, pressure) = table[:, 0].astype(int), table[:, 1:9].T
    radius = 50 + thickness / 2
    depth = depth_um / radius
    used = (depth > 0) & (depth <= DEEPEST_RATIO)
    angle_deg = np.arange(0, 181, ANGLE_STEP_DEG)
    places = table[:, 9:].reshape(len(table), -1, 2)[:, ::ANGLE_STEP_DEG // 2] / radius[:, None, None]
    elongation = np.log((50 * np.sqrt(aspect) + thickness / 2) / (50 / np.sqrt(aspect) + thickness / 2))
    rest = places[depth_um == 0][np.cumsum(depth_um == 0) - 1]  # a curve begins at rest
    sizes = np.log(np.stack([thickness, tip, holder], axis=1) / radius[:, None])
    parameters = np.column_stack([sizes, np.log1p(stiffening / STIFFENING_SCALE), elongation])[used]
    moved = (places - rest)[used].reshape(used.sum(), -1)
    cells, depth, radius, force, pressure = cells[used], depth[used], radius[used], force[used], pressure[used]
    kinds = {'round': (stiffening == 0) & (aspect == 1), 'stiffening': stiffening > 0, 'out of round': aspect != 1}
    kinds = {kind: which[used] for kind, which in kinds.items()}

    rows = basis(parameters, depth)
    components = np.linalg.svd(moved, full_matrices=False)[2][:COMPONENTS]
    by_depth = depth[:, None] * rows
    section_terms = np.linalg.lstsq(by_depth, moved @ components.T, rcond=None)[0]
    error = left_out(by_depth, moved @ components.T, cells) @ components - (moved - moved @ components.T @ components)
    for kind, which in kinds.items():
        print(f'section, cells left out, {kind}: {rms(np.sqrt((error[which]**2).sum(axis=1) / len(angle_deg))):.5f} outer radii RMS')
    log_force = np.log(force / radius**2 / depth) - 1.2 * parameters[:, 0]
    force_terms = np.linalg.lstsq(rows, log_force, rcond=None)[0]
    error = left_out(rows, log_force, cells)
    for kind, which in kinds.items():
        print(f'force, cells left out, {kind}: {rms(error[which]):.4f} of ln RMS')

    # Over the force: what is left of it for the liquid in a wall that yields by itself.
    log_pressure = np.log(pressure * radius**2 / force)
    pressure_terms = np.linalg.lstsq(rows, log_pressure, rcond=None)[0]
    print(f'pressure, cells left out: {rms(left_out(rows, log_pressure, cells)):.4f} of ln RMS')

    with open(sys.argv[2], 'w', encoding='utf-8') as file:
        json.dump({
            'description': 'Outer section of an incompressible solid shell under a needle opposite the holding pipette, '
                           'and the force on it: see indented_solid.py',
            'parameter_centre': [round(x, 7) for x in CENTRE], 'parameter_width': list(WIDTH),
            'parameter_from': [round(x, 5) for x in parameters.min(axis=0)],
            'parameter_to': [round(x, 5) for x in parameters.max(axis=0)],
            'depth_centre': DEPTH_CENTRE, 'deepest_ratio': DEEPEST_RATIO, 'angle_deg': angle_deg.tolist(),
            'powers': powers().tolist(), 'components': rounded(components), 'section_terms': rounded(section_terms),
            'force_terms': rounded(force_terms[None])[0],
            'pressure_terms': rounded(pressure_terms[None])[0]}, file, separators=(',', ':'))
        file.write('\n')


main()

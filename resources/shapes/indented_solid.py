#!/usr/bin/python3
"""Fits the outer section of a solid shell under a needle, and the force on it, as functions of sizes and depth.

    apt install python3-numpy
    build/release/bin/solid_sections 640 > sections.csv
    /usr/bin/python3 resources/shapes/indented_solid.py sections.csv resources/shapes/indented_solid.json

The displacement of the outer surface over its radius at rest is the depth times a sum of components (principal ones of all
sections); their coefficients, and the logarithm of the force, are polynomials in the logarithms of thickness, tip and holder
over the outer radius and Chebyshev's polynomials in the depth, by least squares. Prints what cells left out of the fit differ
by (eightfold cross-validation).
"""
import json
import sys

import numpy as np

LOG_SIZE_CENTRE = np.log([0.15, 0.05, 0.35])
LOG_SIZE_WIDTH = np.array([1.1, 1.7, 0.85])  # so that the polynomials' variables are within 1.3 or so
DEPTH_CENTRE, DEEPEST_RATIO = 0.45, 0.85
HIGHEST_SUM, DEPTH_BEYOND = 4, 2  # of the sizes' powers; the depth's degree and these together: that many more
COMPONENTS = 12
ANGLE_STEP_DEG = 4
FOLDS = 8


def powers():
    top = HIGHEST_SUM + DEPTH_BEYOND
    return np.array([(h, a, o, d)
                     for h in range(HIGHEST_SUM + 1) for a in range(HIGHEST_SUM + 1 - h)
                     for o in range(HIGHEST_SUM + 1 - h - a) for d in range(top + 1 - h - a - o)])


def basis(log_sizes, depth):
    u = (log_sizes - LOG_SIZE_CENTRE) / LOG_SIZE_WIDTH
    angle = np.arccos(np.clip(depth / DEPTH_CENTRE - 1, -1, 1))
    return np.stack([np.prod(u**p[:3], axis=1) * np.cos(p[3] * angle) for p in powers()], axis=1)


def left_out(rows, values, cells):
    error = np.zeros_like(values)
    for fold in range(FOLDS):
        out = cells % FOLDS == fold
        error[out] = rows[out] @ np.linalg.lstsq(rows[~out], values[~out], rcond=None)[0] - values[out]
    return error


def rounded(table):
    return [[float(f'{value:.7g}') for value in row] for row in table]


def main():
    table = np.loadtxt(sys.argv[1], delimiter=',')
    cells, (thickness, tip, holder, depth_um, force, pressure) = table[:, 0].astype(int), table[:, 1:7].T
    radius = 50 + thickness / 2
    depth = depth_um / radius
    used = (depth > 0) & (depth <= DEEPEST_RATIO)
    angle_deg = np.arange(0, 181, ANGLE_STEP_DEG)
    places = table[:, 7:].reshape(len(table), -1, 2)[:, ::ANGLE_STEP_DEG // 2] / radius[:, None, None]
    rest = np.stack([np.sin(np.radians(angle_deg)), np.cos(np.radians(angle_deg))], axis=1)
    log_sizes = np.log(np.stack([thickness, tip, holder], axis=1) / radius[:, None])[used]
    moved = (places - rest)[used].reshape(used.sum(), -1)
    cells, depth, radius, force, pressure = cells[used], depth[used], radius[used], force[used], pressure[used]

    rows = basis(log_sizes, depth)
    components = np.linalg.svd(moved, full_matrices=False)[2][:COMPONENTS]
    by_depth = depth[:, None] * rows
    section_terms = np.linalg.lstsq(by_depth, moved @ components.T, rcond=None)[0]
    error = left_out(by_depth, moved @ components.T, cells) @ components - (moved - moved @ components.T @ components)
    print(f'section, cells left out: {np.sqrt((error**2).sum(axis=1).mean() / len(angle_deg)):.5f} outer radii RMS')
    log_force = np.log(force / radius**2 / depth) - 1.2 * log_sizes[:, 0]
    force_terms = np.linalg.lstsq(rows, log_force, rcond=None)[0]
    print(f'force, cells left out: {np.sqrt((left_out(rows, log_force, cells)**2).mean()):.4f} of ln RMS')

    # Over the force: what is left of it for the liquid in a wall that yields by itself.
    log_pressure = np.log(pressure * radius**2 / force)
    pressure_terms = np.linalg.lstsq(rows, log_pressure, rcond=None)[0]
    print(f'pressure, cells left out: {np.sqrt((left_out(rows, log_pressure, cells)**2).mean()):.4f} of ln RMS')

    with open(sys.argv[2], 'w', encoding='utf-8') as file:
        json.dump({
            'description': 'Outer section of an incompressible solid shell under a needle opposite the holding pipette, '
                           'and the force on it: see indented_solid.py',
            'log_size_centre': [round(x, 7) for x in LOG_SIZE_CENTRE], 'log_size_width': list(LOG_SIZE_WIDTH),
            'log_size_from': [round(x, 5) for x in log_sizes.min(axis=0)],
            'log_size_to': [round(x, 5) for x in log_sizes.max(axis=0)],
            'depth_centre': DEPTH_CENTRE, 'deepest_ratio': DEEPEST_RATIO, 'angle_deg': angle_deg.tolist(),
            'powers': powers().tolist(), 'components': rounded(components), 'section_terms': rounded(section_terms),
            'force_terms': rounded(force_terms[None])[0],
            'pressure_terms': rounded(pressure_terms[None])[0]}, file, separators=(',', ':'))
        file.write('\n')


main()

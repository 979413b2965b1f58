#!/usr/bin/python3
"""Makes specimens whose holder is not opposite the needle, or whose needle runs beside the centre, from those of
solid_specimens.py.

    build/release/bin/fem_make_reference is needed.
    /usr/bin/python3 tests/specimens/turned_specimens.py --program build/release/bin/fem_make_reference SOLIDS --output FOLDER

An axisymmetric solid can't be pushed askew. Shape and force are those of the program's thin shell, turned; the force is
multiplied at each depth by the solid's over the shell's, both opposite the holder. So this truth shares the shell's code with
the program's identification: it tests how a force carries over to other angles and offsets, not how large it is.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess

import numpy as np

MODULUS_KPA = 179.33
THICKEST = 0.16  # over the radius: the faces of a thicker wall, offset from the shell's middle, would cross in the dimple


def read(file):
    with open(file, newline='') as lines:
        rows = list(csv.DictReader(lines))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def shell(program, geometry, folder, name, deepest, angle=0.0, offset=0.0):
    """Runs the shell; False where it ends early."""
    tip, half = geometry['tip_radius_um'], geometry['holder_half_width_um']
    command = [program, '--folder', folder, '--name', name, '--configuration', '4' if offset > 0 else '1',
               '--radius-um', geometry['middle_radius_um'], '--thickness-um', geometry['thickness_um'],
               '--young-modulus-kpa', MODULUS_KPA, '--tip-radius-um', tip, '--tip-bond-per-um', 11.173 * 5 / tip,
               '--holder-ring-um', geometry['holder_ring_um'], '--holder-half-width-um', half, '--holder-bond-per-um',
               5.587 * 5 / half, '--max-indentation-um', deepest, '--step-um', 2, '--holder-angle-deg', angle]
    if offset > 0:
        command += ['--offset-um', offset]
    return subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL).returncode == 0


def turn(program, solid, folder, number):
    """A turned specimen of one that the needle met head on; False where there is none."""
    geometry = json.loads(pathlib.Path(f'{solid}-geometry.json').read_text())
    dice = np.random.default_rng(8100 + number)
    angle, offset = float(dice.uniform(10, 90)) if dice.random() < 0.75 else 0.0, 0.0
    if angle == 0.0 or dice.random() < 0.5:
        offset = float(dice.uniform(2, 12))
    forces = read(f'{solid}-1-force.csv')
    deepest = min(46.0, float(forces['indentation_um'][-1]))
    if geometry['thickness_um'] > THICKEST * geometry['middle_radius_um'] or deepest < 20:
        return False
    name = f'{pathlib.Path(solid).name}-turned'
    if not shell(program, geometry, folder / 'shell', name, deepest):
        return False
    if not shell(program, geometry, folder, f'{name}-1', deepest, angle, offset):
        return False
    straight, turned = read(folder / 'shell' / f'{name}-force.csv'), read(folder / f'{name}-1-force.csv')
    depth = turned['indentation_um']

    def ratio(column):
        own = np.interp(depth, straight['indentation_um'], straight[column])
        real = np.interp(depth, forces['indentation_um'], forces[column])
        return np.divide(real, own, out=np.ones_like(own), where=own > 0)

    of_force, of_pressure = ratio('force_uN'), ratio('pressure_kPa')
    with open(folder / f'{name}-1-force.csv', 'w', newline='') as file:
        out = csv.writer(file, lineterminator='\n')
        out.writerow(['indentation_um', 'force_uN', 'lateral_force_uN', 'pressure_kPa'])
        for k, at in enumerate(depth):
            out.writerow([f'{at:.5g}', f'{turned["force_uN"][k] * of_force[k]:.6g}',
                          f'{turned["lateral_force_uN"][k] * of_force[k]:.6g}',
                          f'{turned["pressure_kPa"][k] * of_pressure[k]:.6g}'])
    geometry |= {'holder_angle_deg': round(angle, 3), 'offset_um': round(offset, 3)}
    (folder / f'{name}-geometry.json').write_text(json.dumps(geometry, indent=2) + '\n')
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('solids', type=pathlib.Path, help='folder of specimens, met head on, round, not sucked')
    parser.add_argument('--program', required=True, help='fem_make_reference')
    parser.add_argument('--output', type=pathlib.Path, default=pathlib.Path('.'))
    options = parser.parse_args()
    (options.output / 'shell').mkdir(parents=True, exist_ok=True)
    for file in sorted(options.solids.glob('specimen-*-geometry.json')):
        solid = str(file)[:-len('-geometry.json')]
        geometry = json.loads(file.read_text())
        if geometry.get('aspect_ratio', 1) != 1 or geometry.get('suction_kPa', 0) or geometry.get('stiffening', 0):
            continue
        number = int(pathlib.Path(solid).name.split('-')[1])
        print(pathlib.Path(solid).name, 'turned' if turn(options.program, solid, options.output, number) else 'left out',
              flush=True)


if __name__ == '__main__':
    main()

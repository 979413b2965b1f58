#!/usr/bin/python3
"""Makes the tables of specimens of any geometry with GetFEM: force, pressure, shape, loads and tension of a shell full of
liquid under a needle opposite the holding pipette.

    apt install python3-getfem
    /usr/bin/python3 tests/specimens/solid_specimens.py --first 1 --count 24 --output resources/reference
    /usr/bin/python3 tests/specimens/solid_specimens.py --first 1001 --count 300 --output specimens

An axisymmetric solid of incompressible material (mixed Q2/Q1 elements, generic assembly of GetFEM), full of an incompressible
liquid. It shares neither code nor elements with the program. Units: um, uN, kPa. Specimen 0 is the mouse oocyte's geometry. All
have a middle radius of 50 um (lengths scale) and the modulus with which specimen 0 carries 7.5 uN at 44 um.

Specimens from 1001 on are unlike the program's model in more than their sizes: out of round (a spheroid about the needle's axis,
semi-axes in the ratio 1/1.15 to 1.15), sucked into the holding pipette's mouth before the needle comes, and of a wall that
stiffens with strain, mu/(2 b) (exp(b (I1 - 3)) - 1), each in a part of them. `--gent`: walls stiffen by Gent's law instead,
-mu/(2 b) ln(1 - b (I1 - 3)), which is the same at small strain and has a largest one.
"""
import argparse
import csv
import json
import math
import pathlib
import typing

import getfem as gf
import numpy as np

MID_RADIUS_UM = 50.0
MODULUS_KPA = 179.33  # 17.9 kPa, scaled so that specimen 0 passes 7.5 uN at 44 um
TIP_BOND = 11.173 * 5.0  # density of the tip's bond times its radius, over the modulus
HOLDER_BOND = 5.587 * 5.0
BULK_RATIO = 111.7  # of the liquid
# The pressure holds an element's volume on average; under a fine tip its parts would swell and turn inside out. This
# holds them one by one. It adds nothing where the volume is kept.
LOCAL_VOLUME = 20.0
FIRST_UNLIKE = 1001  # the number from which on specimens are out of round, sucked and stiffening
SUCTION_STEPS = 4
MEMBRANE_STEPS = 5  # of the force table; loads and tension change slowly
OUTER_COLUMNS, INNER_COLUMNS = 1000, 5000  # first numbers of mesh regions


class Draw(typing.NamedTuple):
    """A specimen: lengths in um on a middle radius of 50 um."""
    thickness: float
    tip: float
    holder: float  # outer radius
    aspect: float = 1.0  # semi-axis along the needle over that across, of the middle surface
    suction: float = 0.0  # in the holder's mouth, over the modulus
    stiffening: float = 0.0  # b
    has_limit: bool = False  # Gent's law


def draw(index):
    if index == 0:
        return Draw(5.0, 5.0, 22.5)
    dice = np.random.default_rng(7100 + index)
    while True:
        outer_radius = dice.uniform(35, 65)
        thickness = math.exp(dice.uniform(math.log(3), math.log(15)))
        tip = math.exp(dice.uniform(math.log(0.5), math.log(8)))
        holder = math.exp(dice.uniform(math.log(10), math.log(40)))
        middle = outer_radius - 0.5 * thickness
        if holder < 0.75 * outer_radius and thickness < 0.35 * middle:
            scale = MID_RADIUS_UM / middle
            sizes = Draw(thickness * scale, tip * scale, holder * scale)
            return sizes if index < FIRST_UNLIKE else unlike(sizes, dice)


def unlike(sizes, dice):
    """Those sizes, out of round, sucked and stiffening by chance."""
    aspect, suction, stiffening = 1.0, 0.0, 0.0
    if dice.random() < 0.6:
        aspect = math.exp(dice.uniform(-math.log(1.15), math.log(1.15)))
    if dice.random() < 0.6:
        # A wide mouth in a thin wall takes less before the cell is swallowed.
        suction = math.exp(dice.uniform(math.log(0.002), math.log(0.02))) * min(1.0, 2 * sizes.thickness / sizes.holder)
    if dice.random() < 0.4:
        stiffening = math.exp(dice.uniform(math.log(0.05), math.log(0.5)))
    return sizes._replace(aspect=aspect, suction=suction, stiffening=stiffening)


def angles(tip, thickness, holder, coarse=2.3):
    """Element borders from the needle's pole to the holder's. An element is about half a tip's radius long under the tip
    and `coarse` um far from it: shorter ones at the tip's edge crease, as the surface of a compressed solid does."""
    fine = np.linspace(0, math.pi, 20001)
    size = np.minimum(coarse, np.maximum(0.52 * coarse / 2.6 * tip, 0.25 * MID_RADIUS_UM * fine))
    sums = np.concatenate([[0], np.cumsum(0.5 * np.diff(fine) * MID_RADIUS_UM * (1 / size[1:] + 1 / size[:-1]))])
    return np.interp(np.linspace(0, sums[-1], math.ceil(sums[-1]) + 1), sums, fine)


class Spheroid:
    """The middle surface: semi-axes along the needle and across it, with the geometric mean MID_RADIUS_UM."""

    def __init__(self, aspect):
        self.along, self.across = MID_RADIUS_UM * math.sqrt(aspect), MID_RADIUS_UM / math.sqrt(aspect)

    def point(self, t, away):
        """(r, z) at the eccentric angle t from the needle's pole, `away` um outwards along the normal."""
        r, z = self.across * np.sin(t), self.along * np.cos(t)
        n = np.array([np.sin(t) / self.across, np.cos(t) / self.along])
        n = n / np.hypot(*n)
        return r + away * n[0], z + away * n[1]

    def tangent(self, t):
        d = np.array([self.across * np.cos(t), -self.along * np.sin(t)])
        return d / np.hypot(*d)

    def curvature(self, t):
        """Of the meridian, 1/um."""
        return self.across * self.along / np.hypot(self.across * np.cos(t), self.along * np.sin(t))**3

    def is_outside(self, points):
        return np.all((points[0] / self.across)**2 + (points[1] / self.along)**2 > 1.0)

    def areas(self, theta):
        """Between neighbouring angles, um^2."""
        at, weight = np.polynomial.legendre.leggauss(8)
        t = 0.5 * (theta[1:] + theta[:-1])[:, None] + 0.5 * np.diff(theta)[:, None] * at
        line = np.hypot(self.across * np.cos(t), self.along * np.sin(t))
        return math.pi * np.diff(theta) * ((self.across * np.sin(t) * line) @ weight)


class Solid:
    def __init__(self, draw, coarse=2.3, across=4):
        self.draw = draw
        thickness, tip, holder = self.thickness, self.tip, self.holder = draw.thickness, draw.tip, draw.holder
        self.middle = Spheroid(draw.aspect)
        theta = angles(tip, thickness, holder, coarse)
        layers = np.linspace(-thickness / 2, thickness / 2, across + 1)
        mesh = gf.Mesh('empty', 2)
        quadratic = gf.GeoTrans('GT_QK(2,2)')
        for t0, t1 in zip(theta[:-1], theta[1:]):
            for s0, s1 in zip(layers[:-1], layers[1:]):
                t, away = np.tile(np.linspace(t0, t1, 3), 3), np.repeat(np.linspace(s0, s1, 3), 3)
                r, z = self.middle.point(t, away)
                mesh.add_convex(quadratic, np.vstack([np.where((t < 1e-12) | (t > math.pi - 1e-12), 0.0, r), z]))
        self.mesh = mesh
        outer, inner, axis = [], [], []
        faces = mesh.outer_faces()
        for cv, f in faces.T:
            p = mesh.pts()[:, mesh.pid_in_faces(np.array([[cv], [f]]))]
            if np.all(np.abs(p[0]) < 1e-9):
                axis.append((cv, f))
            else:
                (outer if self.middle.is_outside(p) else inner).append((cv, f))
        for region, group in ((1, outer), (2, inner), (3, axis)):
            mesh.set_region(region, np.array(group).T)
        upper = [g for g in outer if mesh.pts()[:, mesh.pid_in_faces(np.array([[g[0]], [g[1]]]))][1].mean() > 0]
        lower = [g for g in outer if g not in upper]
        mesh.set_region(4, np.array(upper).T)
        mesh.set_region(5, np.array(lower).T)
        # Columns of elements, from the needle's pole to the holder's; the faces of each at the outside and the inside.
        self.theta, self.across = theta, across
        for first, group in ((OUTER_COLUMNS, outer), (INNER_COLUMNS, inner)):
            for cv, f in group:
                mesh.set_region(first + cv // across, np.array([[cv], [f]]))

        mfu = gf.MeshFem(mesh, 2)
        mfu.set_fem(gf.Fem('FEM_QK(2,2)'))
        mfp = gf.MeshFem(mesh, 1)
        mfp.set_fem(gf.Fem('FEM_QK(2,1)'))
        mim = gf.MeshIm(mesh, gf.Integ('IM_GAUSS_PARALLELEPIPED(2,6)'))
        self.mfu, self.mim = mfu, mim
        md = gf.Model('real')
        md.add_fem_variable('u', mfu)
        md.add_fem_variable('p', mfp)
        md.add_variable('P', 1)
        e = 1e-3 * MODULUS_KPA
        md.add_initialized_data('mu', [e / 3])
        md.add_initialized_data('kappa', [BULK_RATIO * e])
        md.add_initialized_data('down', [0.0])
        md.add_initialized_data('kt', [0.0])
        md.add_initialized_data('a', [tip])
        half = holder * 5.0 / 22.5
        self.half, self.ring = half, holder - half
        md.add_initialized_data('kr', [HOLDER_BOND / half * e])
        md.add_initialized_data('ring', [self.ring])
        md.add_initialized_data('half', [half])
        # Where the needle bonds: the shape that the holder's suction gave.
        md.add_initialized_fem_data('u0', mfu, np.zeros(mfu.nbdof()))
        # The hoop stretch is 1 + u_r / r; the corners on the axis are no integration points.
        stretch = '(1+u(1)/X(1))'
        jacobian = '((1+Grad_u(1,1))*(1+Grad_u(2,2))-Grad_u(1,2)*Grad_u(2,1))'
        strain = f'(sqr(1+Grad_u(1,1))+sqr(Grad_u(1,2))+sqr(Grad_u(2,1))+sqr(1+Grad_u(2,2))+sqr{stretch}-3)'
        if draw.stiffening > 0:
            md.add_initialized_data('b', [draw.stiffening])
            wall = f'-mu/2*log(1-b*{strain})/b' if draw.has_limit else f'mu/2*(exp(b*{strain})-1)/b'
        else:
            wall = f'mu/2*{strain}'
        energy = (f'2*pi*X(1)*({wall}'
                  f'-p*({jacobian}*{stretch}-1)+{LOCAL_VOLUME}*mu/2*sqr({jacobian}*{stretch}-1))')
        md.add_nonlinear_term(mim, energy)
        # The liquid: V = -(1/3) of the flux of the position through the inner face, whose normal points into it.
        position = '[X(1)+u(1);X(2)+u(2)]'
        cofactor = '[1+Grad_u(2,2),-Grad_u(2,1);-Grad_u(1,2),1+Grad_u(1,1)]'
        flux = f'({position}.({cofactor}*Normal))'
        md.add_nonlinear_term(mim, f'P*2*pi*X(1)*{stretch}*{flux}/3', 2)
        # The flux above is -(V): adding P V0 - P^2 V0 / (2 kappa) closes the potential -P (V - V0) - P^2 V0/(2 kappa).
        self.volume0 = volume0 = -gf.asm('generic', mim, 0, '2*pi*X(1)*(X.Normal)/3', 2)
        md.add_initialized_data('V0', [volume0 / self._measure(mim)])
        md.add_nonlinear_term(mim, '(P*V0-P*P*V0/(2*kappa))*X(1)')
        md.add_nonlinear_term(mim, 'pi*X(1)*kt*pos_part(1-sqr(X(1)/a))*(sqr(u(1)-u0(1))+sqr(u(2)-u0(2)+down))', 4)
        md.add_nonlinear_term(mim, 'pi*X(1)*kr*pos_part(1-sqr((X(1)-ring)/half))*(sqr(u(1))+sqr(u(2)))', 5)
        if draw.suction > 0:
            # A pull along the wall's present normal; its work is no potential where the ring gives.
            md.add_initialized_data('suction', [0.0])
            md.add_initialized_data('mouth', [self.ring - self.half])
            md.add_nonlinear_term(mim, f'-suction*2*pi*X(1)*Heaviside(mouth-X(1))*{stretch}*(({cofactor}*Normal).Test_u)', 5)
        md.add_initialized_data('axis', [[1, 0], [0, 0]])
        md.add_initialized_data('zero', [0, 0])
        md.add_generalized_Dirichlet_condition_with_multipliers(mim, 'u', mfu, 3, 'zero', 'axis')
        self.md = md
        self.suck(draw.suction * e)
        md.set_variable('kt', [TIP_BOND / tip * e])
        self.rest_pressure = float(md.variable('P')[0])
        self.rest_pole = self.faces()[0][2][0]

    def suck(self, suction):
        """Pulls the wall into the holder's mouth, uN/um^2; there the needle meets it."""
        for part in range(1, SUCTION_STEPS + 1) if suction > 0 else ():
            self.md.set_variable('suction', [suction * part / SUCTION_STEPS])
            if not self.solve(0.0):
                raise RuntimeError('the holder swallows the cell')
        self.md.set_variable('u0', self.md.variable('u'))

    def _measure(self, mim):
        return gf.asm('generic', mim, 0, 'X(1)', -1)

    def state(self):
        return self.md.from_variables()

    def solve(self, down, guess=None):
        """Newton from `guess` (or where the model is); the model is left as it was where that fails."""
        before = self.md.from_variables()
        if guess is not None:
            self.md.to_variables(guess)
        self.md.set_variable('down', [down])
        try:
            good = self.md.solve('max_res', 1e-7, 'max_iter', 9, 'lsearch', 'simplest', 'alpha min', 0.3)[1] == 1
        except RuntimeError:
            good = False
        if not good or not np.all(np.isfinite(self.md.from_variables())):
            self.md.to_variables(before)
            return False
        return True

    def force(self):
        """Of the tip along its push, uN."""
        expression = '2*pi*X(1)*kt*pos_part(1-sqr(X(1)/a))*(down+u(2)-u0(2))'
        return float(gf.asm_generic(self.mim, 0, expression, 4, self.md))

    def loads(self):
        """(r, z) of what liquid, needle and holder exert on each column of elements, summed round the axis, uN."""
        cofactor = '[1+Grad_u(2,2),-Grad_u(2,1);-Grad_u(1,2),1+Grad_u(1,1)]'
        liquid = f'-P*2*pi*X(1)*(1+u(1)/X(1))*({cofactor}*Normal)'
        tip = '(-2*pi*X(1)*kt*pos_part(1-sqr(X(1)/a))*[u(1)-u0(1);u(2)-u0(2)+down])'
        holder = '(-2*pi*X(1)*kr*pos_part(1-sqr((X(1)-ring)/half))*u)'

        def total(expression, region):
            return np.array([gf.asm_generic(self.mim, 0, f'({expression}).[{axes}]', region, self.md)
                             for axes in ('1;0', '0;1')])

        out = []
        for column, (t0, t1) in enumerate(zip(self.theta[:-1], self.theta[1:])):
            tool = tip if 0.5 * (t0 + t1) < 0.5 * math.pi else holder
            out.append(total(liquid, INNER_COLUMNS + column) + total(tool, OUTER_COLUMNS + column))
        return np.array(out, dtype=float)

    def tension(self):
        """Half the trace of the stress resultant at the middle of each column, per present length, uN/um: the force
        through a material section across the wall over the present length of the middle surface there."""
        t = 0.5 * (self.theta[:-1] + self.theta[1:])
        at, weight = np.polynomial.legendre.leggauss(12)
        away = 0.5 * self.thickness * at
        x, z = self.middle.point(t[:, None], away)
        middle_r, middle_z = self.middle.point(t, 0.0)
        points = np.vstack([np.append(x.ravel(), middle_r), np.append(z.ravel(), middle_z)])

        def values(expression):
            return np.asarray(self.md.interpolation(expression, points, self.mesh), dtype=float)

        stretch = 1 + values('u(1)') / points[0]
        f = values('Grad_u').reshape(2, 2, -1, order='F') + np.eye(2)[:, :, None]
        jacobian = f[0, 0] * f[1, 1] - f[0, 1] * f[1, 0]
        mu = 1e-3 * MODULUS_KPA / 3
        q = -values('p') + LOCAL_VOLUME * mu * (jacobian * stretch - 1)
        strain = self.draw.stiffening * ((f**2).sum(axis=(0, 1)) + stretch**2 - 3)
        mu = mu / (1 - strain) if self.draw.has_limit else mu * np.exp(strain)
        cofactor = np.array([[f[1, 1], -f[1, 0]], [-f[0, 1], f[0, 0]]])
        piola = mu * f + q * stretch * cofactor
        hoop = mu * stretch + q * jacobian
        n = x.size
        along = self.middle.tangent(t)  # the meridian's direction at rest
        pull = np.einsum('ijck,jc->ick', piola[:, :, :n].reshape(2, 2, *x.shape), along)
        across = 0.5 * self.thickness * weight
        now = np.einsum('ijc,jc->ic', f[:, :, n:], along)
        length = np.hypot(*now)
        meridian = np.einsum('ick,ck,k->ic', pull, x, across)
        meridian = np.einsum('ic,ic->c', meridian, now / length) / (stretch[n:] * points[0][n:])
        longer = 1 + np.outer(self.middle.curvature(t), away)  # than the middle surface, at rest
        parallel = (hoop[:n].reshape(x.shape) * longer) @ across / length
        return 0.5 * (meridian + parallel)

    def faces(self):
        """(angle, outer r, z, inner r, z) of the nodes on both faces, by the angle from the needle's pole."""
        mfu, u = self.mfu, self.md.variable('u')
        nodes = mfu.basic_dof_nodes()[:, ::2]
        ux, uz = u[0::2], u[1::2]
        t = np.arctan2(nodes[0], nodes[1])
        out = []
        for region in (1, 2):
            on = mfu.basic_dof_on_region(region)[::2] // 2
            order = on[np.argsort(t[on])]
            out.append((t[order], nodes[0][order] + ux[order], nodes[1][order] + uz[order]))
        return out


def extrapolate(known, to):
    """The state at depth `to` by the polynomial through the last three (depth, state)."""
    known = known[-3:]
    guess = 0
    for i, (at, state) in enumerate(known):
        weight = math.prod((to - other) / (at - other) for j, (other, _) in enumerate(known) if j != i)
        guess = guess + weight * state
    return guess


def is_membrane_step(step):
    return step > 0 and step % MEMBRANE_STEPS == 0


def compute(draw, deepest, step, layers):
    """(solid, force rows, shapes, membrane) by the depth of the outer membrane's pole, um; as deep as Newton gets."""
    solid = Solid(draw, across=layers)
    solid.solve(0.0)
    known = [(0.0, solid.state())]
    rows, shapes, membrane = [], [], []
    area = solid.middle.areas(solid.theta)
    depth, h = 0.0, 0.25 * step
    while True:
        faces = solid.faces()
        pressure = float(solid.md.variable('P')[0]) - solid.rest_pressure
        rows.append((solid.rest_pole - faces[0][2][0], solid.force(), 1e3 * pressure))
        shapes.append(faces)
        membrane.append((1e3 * solid.loads() / area[:, None], solid.tension()) if is_membrane_step(len(rows) - 1) else None)
        target = depth + step
        if target > deepest + 1e-9:
            break
        while depth < target - 1e-9:
            to = target if depth + 1.2 * h > target else depth + h
            if solid.solve(to, extrapolate(known, to)):
                h = min(step, max(h, to - depth) * 1.4)
                depth = to
                known = known[-2:] + [(depth, solid.state())]
            else:
                h = 0.4 * (to - depth)
                if h < 0.002:
                    return solid, rows, shapes, membrane
    return solid, rows, shapes, membrane


def write(folder, index, draw, solid, rows, shapes, membrane):
    """NAME-1-force.csv, NAME-1-profile.csv, NAME-1-membrane.csv and NAME-geometry.json, as resources/reference has them."""
    name = f'specimen-{index}'
    with open(folder / f'{name}-1-force.csv', 'w', newline='') as file:
        out = csv.writer(file, lineterminator='\n')
        out.writerow(['indentation_um', 'force_uN', 'pressure_kPa'])
        for row in rows:
            out.writerow([f'{max(value, 0.0):.5g}' for value in row])
    with open(folder / f'{name}-1-profile.csv', 'w', newline='') as file:
        out = csv.writer(file, lineterminator='\n')
        out.writerow(['indentation_um', 'theta0_rad', 'outer_r_um', 'outer_z_um', 'inner_r_um', 'inner_z_um'])
        for step, (row, (outer, inner)) in enumerate(zip(rows, shapes)):
            if step % 2 and step + 1 < len(rows):
                continue  # the shape changes more slowly than the force
            for k in range(len(outer[0])):
                out.writerow([f'{max(row[0], 0.0):.5g}', f'{outer[0][k]:.5f}'] +
                             [f'{value + 0.0:.3f}' for value in (outer[1][k], outer[2][k], inner[1][k], inner[2][k])])
    with open(folder / f'{name}-1-membrane.csv', 'w', newline='') as file:
        out = csv.writer(file, lineterminator='\n')
        out.writerow(['indentation_um', 'theta0_rad', 'load_r_kPa', 'load_z_kPa', 'tension_uN_per_um'])
        middle = 0.5 * (solid.theta[:-1] + solid.theta[1:])
        for step in filter(is_membrane_step, range(len(rows))):
            load, tension = membrane[step]
            for k in range(len(middle)):
                out.writerow([f'{rows[step][0]:.5g}', f'{middle[k]:.5f}'] +
                             [f'{value:.4g}' for value in (*load[k], tension[k])])
    geometry = {
        'middle_radius_um': MID_RADIUS_UM,
        'thickness_um': round(solid.thickness, 6),
        'tip_radius_um': round(solid.tip, 6),
        'holder_ring_um': round(solid.ring, 6),
        'holder_half_width_um': round(solid.half, 6),
        'young_modulus_kPa': MODULUS_KPA,
    }
    if index >= FIRST_UNLIKE:
        geometry |= {'aspect_ratio': round(draw.aspect, 6), 'suction_kPa': round(draw.suction * MODULUS_KPA, 6),
                     'stiffening': round(draw.stiffening, 6)}
    (folder / f'{name}-geometry.json').write_text(json.dumps(geometry, indent=2) + '\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--first', type=int, default=0, help='specimen number; the same number, the same specimen')
    parser.add_argument('--count', type=int, default=1)
    parser.add_argument('--deepest-um', type=float, default=48.0, help='on a middle radius of 50 um')
    parser.add_argument('--step-um', type=float, default=2.0)
    parser.add_argument('--layers', type=int, default=4, help='elements across the wall; 3 takes half the time: 0.5 % of force')
    parser.add_argument('--gent', action='store_true', help="walls stiffen by Gent's law; those that don't are left out")
    parser.add_argument('--output', type=pathlib.Path, default=pathlib.Path('.'))
    options = parser.parse_args()
    gf.util('trace level', 0)
    gf.util('warning level', 0)
    options.output.mkdir(parents=True, exist_ok=True)
    for index in range(options.first, options.first + options.count):
        drawn = draw(index)._replace(has_limit=options.gent)
        if options.gent and not drawn.stiffening > 0:
            continue
        try:
            solid, rows, shapes, membrane = compute(drawn, options.deepest_um, options.step_um, options.layers)
        except RuntimeError as error:
            print(f'specimen {index}: {error}', flush=True)
            continue
        write(options.output, index, drawn, solid, rows, shapes, membrane)
        print(f'specimen {index}: thickness {solid.thickness:.2f}, tip {solid.tip:.2f}, holder {solid.holder:.2f} um, '
              f'aspect {solid.draw.aspect:.3f}, suction {solid.draw.suction:.4f}, stiffening {solid.draw.stiffening:.2f}; '
              f'{rows[-1][1]:.3f} uN at {rows[-1][0]:.2f} um', flush=True)


if __name__ == '__main__':
    main()

#!/usr/bin/python3
"""Films of an indented cell by wave optics, for validation only: nothing in the tracker is set against them.

    python3 wave_films.py OUTPUT --count 12 --seed 7 [--contrast bright|phase|hoffman|dic]

Shares no code and no formula with the virtual microscope: the specimen's transmission exp(i phi - a) is imaged with a
partially coherent condenser (Abbe's sum over source points; Goodman, Introduction to Fourier Optics, ch. 7), a pupil
with defocus, and the contrast's own filter: a phase ring (Zernike), a slit with a three-step modulator (Hoffman and
Gross 1975), or two sheared images (Nomarski). Shapes: axisymmetric sections of the finite-element reference
(resources/reference). Each film is a folder: frame_00000.png ..., film.json (pixel size, contrast), t.csv and
t_contours.csv in the columns of a simulated recording's truth. Needs Debian's python3-numpy and python3-opencv.
"""
import argparse
import csv
import json
import os

import cv2
import numpy as np

WAVELENGTH_UM = 0.55
GRID_UM = 0.4          # spacing of the optical field
RESOURCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../resources/reference")
EMBRYO_RADIUS_UM = 50.0


def read_csv(name):
    with open(os.path.join(RESOURCES, name)) as file:
        return list(csv.DictReader(file))


class Shapes:
    """Half sections (rho, z) of both faces of the zona by depth, needle from +z, um; apex first."""

    def __init__(self, which):
        self.force = [(float(r["indentation_um"]), float(r["force_uN"])) for r in read_csv(f"mouse-{which}-1-force.csv")]
        rows, self.depths, self.sections = read_csv(f"mouse-{which}-1-profile.csv"), [], []
        by_depth = {}
        for row in rows:
            by_depth.setdefault(float(row["indentation_um"]), []).append(row)
        for depth, group in sorted(by_depth.items()):
            if "outer_r_um" in group[0]:
                outer, inner = ([(float(r[f"{face}_r_um"]), float(r[f"{face}_z_um"])) for r in group]
                                for face in ("outer", "inner"))
            else:
                middle = np.array([(float(r["x_mid_um"]), float(r["z_mid_um"])) for r in group])
                tangent = np.gradient(middle, axis=0)
                normal = np.stack([tangent[:, 1], -tangent[:, 0]], 1)
                normal /= np.linalg.norm(normal, axis=1)[:, None]
                if (normal * middle).sum() < 0:
                    normal = -normal
                outer, inner = middle + 2.5 * normal, middle - 2.5 * normal
                half = middle[:, 0] >= 0
                outer, inner = [tuple(p) for p in outer[half]], [tuple(p) for p in inner[half]]
            def ordered(points):
                points = np.array(points)
                return points[::-1] if points[0, 1] < points[-1, 1] else points
            self.depths.append(depth)
            self.sections.append((resampled(ordered(outer)), resampled(ordered(inner))))

    def at(self, depth):
        depth = float(np.clip(depth, self.depths[0], self.depths[-1]))
        k = min(max(int(np.searchsorted(self.depths, depth)) - 1, 0), len(self.depths) - 2)
        t = (depth - self.depths[k]) / (self.depths[k + 1] - self.depths[k])
        return tuple((1 - t) * self.sections[k][f] + t * self.sections[k + 1][f] for f in (0, 1))

    def force_at(self, depth):
        return float(np.interp(depth, *zip(*self.force)))


def resampled(points, count=240):
    points = np.array(points, float)
    points[0, 0] = points[-1, 0] = 0.0
    way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    at = np.linspace(0, way[-1], count)
    return np.stack([np.interp(at, way, points[:, k]) for k in (0, 1)], 1)


def thickness(section, s_um, v_um):
    """Thickness of the body of revolution of a half section (rho, z), at axial places s and lateral places v, um."""
    fine = 4
    rho_max = section[:, 0].max() + 2
    edges = np.arange(0, rho_max, GRID_UM / 2)
    low, high = s_um[0], s_um[-1]
    size = (len(edges) - 1, int((high - low) / GRID_UM) + 1)
    polygon = np.concatenate([section, [[0, section[-1, 1]], [0, section[0, 1]]]])
    at = np.stack([polygon[:, 0] / (GRID_UM / 2) - 0.5, (polygon[:, 1] - low) / GRID_UM], 1)
    mask = np.zeros((size[1] * fine, size[0] * fine), np.uint8)
    cv2.fillPoly(mask, [np.round(((at + 0.5) * fine - 0.5) * 16).astype(np.int32)], 255, shift=4, lineType=cv2.LINE_AA)
    mask = cv2.resize(mask.astype(np.float32) / 255, size, interpolation=cv2.INTER_AREA)   # (s, rho)
    v = np.abs(v_um)[None, :]
    chord = np.sqrt(np.maximum(edges[1:, None] ** 2 - v ** 2, 0)) - np.sqrt(np.maximum(edges[:-1, None] ** 2 - v ** 2, 0))
    return 2 * mask @ chord                                                               # (s, v)


class Optics:
    def __init__(self, contrast, shape, random):
        self.contrast = contrast
        fy, fx = np.meshgrid(np.fft.fftfreq(shape[0], GRID_UM), np.fft.fftfreq(shape[1], GRID_UM), indexing="ij")
        self.fx, self.fy = fx, fy
        aperture = random.uniform(0.35, 0.55)
        self.cutoff = aperture / WAVELENGTH_UM
        self.defocus_um = {"bright": random.choice([-1, 1]) * random.uniform(4, 14)}.get(contrast, random.uniform(-3, 3))
        self.angle = random.uniform(0, 2 * np.pi)
        self.polarity = random.choice([-1, 1])
        along = (np.cos(self.angle), np.sin(self.angle))
        if contrast == "hoffman":
            place = 0.75 * self.cutoff * self.polarity
            self.source = [(p * along[0] - w * along[1], p * along[1] + w * along[0])
                           for k, w in enumerate(np.linspace(-0.45, 0.45, 6) * self.cutoff)
                           for p in (place * (0.94 + 0.03 * (k % 2)), place * (1.02 + 0.03 * (k % 2)))]
        elif contrast == "phase":
            ring = 0.55 * self.cutoff
            self.source = [(ring * np.cos(a), ring * np.sin(a)) for a in np.linspace(0, 2 * np.pi, 12, endpoint=False)]
        else:
            reach = random.uniform(0.3, 0.6) * self.cutoff
            self.source = [(0, 0)] + [(r * reach * np.cos(a), r * reach * np.sin(a)) for r, n in ((0.5, 4), (1.0, 8))
                                      for a in np.linspace(0, 2 * np.pi, n, endpoint=False) + r]
        self.bias = random.uniform(0.5, 1.2)
        self.shear_um = random.uniform(0.3, 0.6)
        self.ring_pass = random.uniform(0.25, 0.5)

    def pupil(self, source):
        ux, uy = self.fx + source[0], self.fy + source[1]
        radius2 = ux * ux + uy * uy
        p = np.where(radius2 < self.cutoff ** 2, 1.0 + 0j, 0)
        if self.contrast == "phase":
            radius = np.sqrt(radius2) / self.cutoff
            p *= np.where(abs(radius - 0.55) < 0.06, self.ring_pass * np.exp(1j * self.polarity * np.pi / 2), 1)
        if self.contrast == "hoffman":
            across = (ux * np.cos(self.angle) + uy * np.sin(self.angle)) / self.cutoff * self.polarity
            p *= 0.1 + 0.28 / (1 + np.exp(-(across - 0.62) / 0.02)) + 0.62 / (1 + np.exp(-(across - 0.88) / 0.02))
        return p * np.exp(-1j * np.pi * WAVELENGTH_UM * self.defocus_um * radius2)

    def image(self, phi, absorbed):
        def lit(transmission):
            spectrum = np.fft.fft2(transmission)
            return sum(abs(np.fft.ifft2(spectrum * self.pupil(s))) ** 2 for s in self.source)
        transmission = np.exp(1j * phi - absorbed)
        if self.contrast == "dic":
            step = np.exp(2j * np.pi * self.shear_um / 2 * (self.fx * np.cos(self.angle) + self.fy * np.sin(self.angle)))
            spectrum = np.fft.fft2(transmission)
            total = 0
            for s in self.source:
                p = spectrum * self.pupil(s)
                one, two = np.fft.ifft2(p * step), np.fft.ifft2(p / step)
                total = total + abs(one * np.exp(1j * self.bias * self.polarity) - two) ** 2
            return total / np.median(total)
        total = lit(transmission)
        return total / np.median(total)


class Film:
    def __init__(self, seed, contrast=None):
        random = np.random.default_rng(seed)
        self.random = random
        self.contrast = contrast or str(random.choice(["bright", "phase", "hoffman", "dic"]))
        self.which = str(random.choice(["oocyte", "embryo"]))
        self.shapes = Shapes(self.which)
        self.scale = random.uniform(0.75, 1.3)
        self.pixel_um = random.uniform(0.4, 0.8)
        self.size = (728, 486) if random.random() < 0.5 else (640, 480)
        self.turn = random.uniform(0, 2 * np.pi)
        fov = np.array(self.size) * self.pixel_um
        room = np.maximum(fov / 2 - 62 * self.scale, 0)
        self.center_um = fov / 2 + random.uniform(-0.6, 0.6, 2) * room
        self.grid = (int(fov[1] / GRID_UM) + 1, int(fov[0] / GRID_UM) + 1)
        self.optics = Optics(self.contrast, self.grid, random)
        self.dn_zona, self.dn_ooplasm = random.uniform(0.008, 0.02), random.uniform(0.012, 0.035)
        self.tip_um, self.taper = random.uniform(1.0, 4.0), np.tan(np.radians(random.uniform(1.5, 5)))
        self.wall = random.uniform(0.15, 0.35)
        self.dn_glass_needle = random.uniform(0.03, 0.14)
        self.shaft_um = random.uniform(8, 20)
        self.holder_outer, self.holder_inner = random.uniform(25, 50) * self.scale, random.uniform(8, 18) * self.scale
        self.dn_holder = random.uniform(0.01, 0.06)
        self.levels = random.uniform(0.3, 0.6)
        self.contrast_gain = random.uniform(0.6, 1.0)
        self.full_well, self.read = random.uniform(3e3, 2e4), random.uniform(3, 15)
        self.jpeg = int(random.choice([0, 0, 75, 90]))
        self.deepest = random.uniform(0.35, 0.9) * self.shapes.depths[-1]
        self.outcome = str(random.choice(["retract", "hold", "puncture"], p=[0.4, 0.3, 0.3]))
        n = 240
        self.grains = np.stack([random.uniform(0, 1, n) ** (1 / 3), random.uniform(0, 2 * np.pi, n),
                                random.uniform(-1, 1, n), random.uniform(0.5, 1.5, n), random.normal(0, 0.25, n)], 1)
        self.specks = np.stack([random.uniform(0, fov[0], 14), random.uniform(0, fov[1], 14), random.uniform(0.6, 2.5, 14),
                                random.normal(0, 0.8, 14)], 1)
        y, x = np.mgrid[0:self.grid[0], 0:self.grid[1]] * GRID_UM
        axis = np.array([np.cos(self.turn), np.sin(self.turn)])       # from the cell's centre towards the needle
        self.axis, self.across = axis, np.array([-axis[1], axis[0]])
        dx, dy = x - self.center_um[0], y - self.center_um[1]
        self.s, self.v = dx * axis[0] + dy * axis[1], dx * self.across[0] + dy * self.across[1]
        top = self.shapes.at(0)[0][0, 1] * self.scale
        self.rest_top, self.rest_bottom = top, self.shapes.at(0)[0][-1, 1] * self.scale

    def path(self, count):
        """Of the tip beyond the resting outline, um, and of the membrane; the state."""
        free, push = count // 5, count * 2 // 5
        way = np.concatenate([np.linspace(-25, 0, free, endpoint=False), np.linspace(0, self.deepest, push)])
        rest = count - len(way)
        if self.outcome == "hold":
            way = np.concatenate([way, np.full(rest, self.deepest)])
        elif self.outcome == "retract":
            way = np.concatenate([way, np.linspace(self.deepest, -20, rest)])
        else:
            way = np.concatenate([way, self.deepest + np.linspace(0, 5, rest)])
        for k, tip in enumerate(way):
            punctured = self.outcome == "puncture" and k >= free + push + 2
            yield tip, 0.0 if punctured else max(tip, 0.0), "punctured" if punctured else "contact" if tip > 0 else "free"

    def glass(self, distance_behind, lateral, radius, inner, dn):
        """Optical path of a hollow rod, rad; radii as functions of the place along it."""
        k = 2 * np.pi / WAVELENGTH_UM
        outer = np.sqrt(np.maximum(radius ** 2 - lateral ** 2, 0)) - np.sqrt(np.maximum(inner ** 2 - lateral ** 2, 0))
        return np.where(distance_behind > 0, 2 * k * dn * outer, 0)

    def frame(self, tip, membrane):
        k = 2 * np.pi / WAVELENGTH_UM
        outer, inner = (self.scale * f for f in self.shapes.at(membrane / self.scale))
        reach = 75 * self.scale
        s_um, v_um = np.arange(-reach, reach, GRID_UM), np.arange(0, reach, GRID_UM)
        phi = np.zeros(self.grid)
        maps = []
        for section in (outer, inner):
            body = thickness(section, s_um, v_um).astype(np.float32)
            maps.append(cv2.remap(body, (abs(self.v) / GRID_UM).astype(np.float32), ((self.s + reach) / GRID_UM).astype(np.float32),
                                  cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT))
        phi += k * (self.dn_zona * (maps[0] - maps[1]) + self.dn_ooplasm * maps[1])
        absorbed = 0.0012 * maps[1]
        for ratio, angle, out, size, strength in self.grains:
            radius = 0.85 * ratio * np.sqrt(max(1 - out * out, 0)) * abs(self.rest_top)
            at = self.center_um + radius * (np.cos(angle) * self.axis + np.sin(angle) * self.across) - 0.4 * membrane * self.axis * max(np.cos(angle), 0) * ratio
            self.blob(phi, at, size, strength)
        for x, y, size, strength in self.specks:
            self.blob(phi, (x, y), size, strength)
        tip_s = self.rest_top - tip
        behind = self.s - tip_s
        radius = np.minimum(self.tip_um + self.taper * np.maximum(behind, 0), self.shaft_um)
        radius = np.where(behind < self.tip_um, np.sqrt(np.maximum(self.tip_um ** 2 - (self.tip_um - behind) ** 2, 0)), radius)
        phi += self.glass(behind, self.v, radius, (1 - self.wall) * radius * (behind > self.tip_um), self.dn_glass_needle)
        below = self.rest_bottom - self.s + 0.35 * (self.holder_inner ** 2) / abs(self.rest_bottom)
        phi += self.glass(below, self.v, np.full(self.grid, self.holder_outer), np.full(self.grid, self.holder_inner), self.dn_holder)
        light = self.optics.image(phi, absorbed)
        light = self.levels * (1 + self.contrast_gain * (light - 1))
        image = cv2.resize(light.astype(np.float32), self.size, interpolation=cv2.INTER_AREA)
        electrons = np.clip(image, 0, 1) * self.full_well
        image = (electrons + self.random.normal(0, 1, image.shape) * np.sqrt(electrons + self.read ** 2)) / self.full_well
        image = np.clip(255 * image, 0, 255).astype(np.uint8)
        if self.jpeg:
            image = cv2.imdecode(cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, self.jpeg])[1], cv2.IMREAD_GRAYSCALE)
        return image, outer, inner, tip_s

    def blob(self, phi, at, size, strength):
        r = int(4 * size / GRID_UM) + 1
        x, y = int(at[0] / GRID_UM), int(at[1] / GRID_UM)
        if x < r or y < r or x + r >= self.grid[1] or y + r >= self.grid[0]:
            return
        yy, xx = np.mgrid[-r:r + 1, -r:r + 1] * GRID_UM
        phi[y - r:y + r + 1, x - r:x + r + 1] += strength * np.exp(-(xx ** 2 + yy ** 2) / (2 * size ** 2))

    def place(self, section):
        """A half section, mirrored and placed, as a closed polygon in um of the image; pixel centres at whole pixels."""
        whole = np.concatenate([section, section[-2:0:-1] * (-1, 1)])
        corner = 0.5 * GRID_UM - 0.5 * self.pixel_um   # areas of grid cells and pixels begin at the same corner
        return self.center_um + whole[:, 1:] * self.axis + whole[:, :1] * self.across + corner

    def write(self, folder, count):
        os.makedirs(folder)
        with open(os.path.join(folder, "film.json"), "w") as file:
            json.dump({"pixel_size_um": self.pixel_um, "contrast": self.contrast, "specimen": self.which, "scale": self.scale,
                       "outcome": self.outcome, "cell_radius_um": self.rest_top, "frame_rate_hz": 30}, file, indent=1)
        rows = csv.writer(open(os.path.join(folder, "t.csv"), "w"))
        rows.writerow(["frame", "time_s", "state", "tip_x_um", "tip_y_um", "indentation_um", "force_uN"])
        contours = csv.writer(open(os.path.join(folder, "t_contours.csv"), "w"))
        contours.writerow(["frame", "membrane", "point", "x_um", "y_um"])
        for k, (tip, membrane, state) in enumerate(self.path(count)):
            image, outer, inner, tip_s = self.frame(tip, membrane)
            cv2.imwrite(os.path.join(folder, f"frame_{k:05d}.png"), image)
            at = self.place(np.array([[0.0, tip_s]]))[0]
            # At the same strain forces grow with area.
            force = self.scale ** 2 * self.shapes.force_at(membrane / self.scale)
            rows.writerow([k, k / 30, state, at[0], at[1], membrane, force])
            for name, section in (("outer", outer), ("inner", inner)):
                for i, p in enumerate(self.place(section)):
                    contours.writerow([k, name, i, round(p[0], 4), round(p[1], 4)])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output")
    parser.add_argument("--count", type=int, default=12)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--frames", type=int, default=40)
    parser.add_argument("--contrast", choices=["bright", "phase", "hoffman", "dic"])
    options = parser.parse_args()
    for k in range(options.count):
        Film(options.seed + k, options.contrast).write(os.path.join(options.output, f"film_{options.seed + k:04d}"), options.frames)


if __name__ == "__main__":
    main()

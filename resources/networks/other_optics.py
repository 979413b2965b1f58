#!/usr/bin/python3
"""Labelled pictures of the cells of other labelled pictures, as other optics show them.

    python3 other_optics.py SAMPLES --out FOLDER [--count N] [--seed N]

SAMPLES holds pictures that film_samples (a test program of this project) has drawn; FOLDER gets as many of the same kind of
files. Of a sample only the outlines are kept. Cell and tools become bodies of revolution about their axes, cut into slices
along the line of sight, each of which is blurred by how far it lies from the focus. The optical path that they add up to is
shown by its difference along a direction (relief), by what it is above its wide blur (phase contrast), or by its curvature
(bright field), in which strong contrasts saturate; or by an objective with a condenser of finite aperture, in bright field, by
Zernike's ring, Hoffman's modulator or two sheared images (Abbe's sum over points of the condenser; Goodman, Introduction to
Fourier Optics, chapter 7). Needs Debian's python3-opencv, python3-numpy, python3-scipy and python3-torch.
"""
import argparse
import csv
import os
import sys

import cv2
import numpy as np
from scipy import fft

from any_contrast import area, away_from, moved
from training import Tables

REACH = 1.7                  # of the picture about the cell, in radii
RADII_PX = (32, 130)         # of cells drawn
WAVE_RADIUS_PX = 140         # of cells while waves pass them, which takes fine pixels
RADIUS_UM = (30.0, 60.0)
FINER = 4                    # times, pixels on which distances from outlines are found
SLICES, BLURS = 36, 6        # of half a cell; as many different blurs
WAVELENGTH_UM = 0.55
GLASS_RAD_PER_UM = 1.6       # 2 pi 0.14 / 0.55 um
FIELDS = ["file", "tip_x_px", "tip_y_px", "direction_x", "direction_y", "tip_radius_px", "center_x_px", "center_y_px",
          "outer_radius_px", "contrast", "family", "frame"]


def blurred(field, sigma):
    return cv2.GaussianBlur(field, (0, 0), max(float(sigma), 0.05))


class Scene:
    """Slices of a cell and the paths through its tools; lengths are um but for outlines, px."""

    def __init__(self, outlines, size, along, middle, radius_px, random):
        self.size, self.random = size, random
        self.radius_um = random.uniform(*RADIUS_UM)
        self.pixel_um = self.radius_um / radius_px
        self.outer = away_from(outlines["outer"], size, FINER)
        self.inner = away_from(outlines["inner"], size, FINER)
        within_px = -float(self.inner.min())
        self.gap_px = within_px * random.uniform(0.01, 0.15) if self.chance(0.6) else 0.0
        self.along, self.middle, self.radius_px = along, middle, radius_px
        self.tools = [away_from(outlines[name], size, FINER) for name in ("holder", "needle") if name in outlines]

    def chance(self, share):
        return self.random.random() < share

    def cell(self, cone):
        """Paths (h, w, 3) through outer and inner boundary and ooplasm, um, each slice blurred by `cone` times its distance from the
        focus."""
        w, h = self.size
        fields = np.dstack([self.outer, self.inner, self.inner + np.float32(self.gap_px)])
        x, y = np.meshgrid(np.arange(w, dtype=np.float32) - self.middle[0], np.arange(h, dtype=np.float32) - self.middle[1])
        across = np.array([-self.along[1], self.along[0]], np.float32)
        z, rho = x * self.along[0] + y * self.along[1], x * across[0] + y * across[1]
        reach_px = 1.15 * self.radius_px
        edges_px = reach_px * np.linspace(0, 1, SLICES + 1) ** 1.3
        focus_px = self.radius_px * abs(self.random.normal(0, 0.06))
        most_px = reach_px + focus_px
        sums = np.zeros((BLURS, h, w, 3), np.float32)
        side = np.where(rho < 0, np.float32(-1), np.float32(1))
        for low, high in zip(edges_px, edges_px[1:]):
            depth_px = 0.5 * (low + high)
            lateral = side * np.sqrt(rho * rho + np.float32(depth_px * depth_px))
            at_x = self.middle[0] + z * self.along[0] + lateral * across[0]
            at_y = self.middle[1] + z * self.along[1] + lateral * across[1]
            inside = np.clip(0.5 - cv2.remap(fields, at_x.astype(np.float32), at_y.astype(np.float32), cv2.INTER_LINEAR,
                                             borderMode=cv2.BORDER_REPLICATE), 0, 1)
            for off_px in (abs(depth_px - focus_px), depth_px + focus_px):
                sums[min(BLURS - 1, int(BLURS * (off_px / most_px) ** 0.7))] += inside * np.float32(high - low)
        total = np.zeros((h, w, 3), np.float32)
        for k in range(BLURS):
            total += blurred(sums[k], cone * most_px * ((k + 0.5) / BLURS) ** (1 / 0.7))
        return total * np.float32(self.pixel_um)

    def glass(self):
        """Path through the tools, um: rods, hollow as a rule."""
        total = np.zeros(self.size[::-1], np.float32)
        for away in self.tools:
            depth = np.clip(-away, 0, None)
            if not np.any(depth > 0):
                continue
            half = float(np.percentile(depth[depth > 0], 97))
            rod = 2 * np.sqrt(np.clip(depth * (2 * half - depth), 0, None))
            if self.chance(0.8):
                share = self.random.uniform(0.4, 0.85)
                bore = np.clip(depth - (1 - share) * half, 0, None)
                rod = rod - 2 * np.sqrt(np.clip(bore * (2 * share * half - bore), 0, None))
            total += rod * np.float32(self.pixel_um)
        return blurred(total, 0.6)

    def grain(self):
        h, w = self.size[1], self.size[0]
        noise = self.random.normal(size=(h, w)).astype(np.float32)
        fine, coarse = (blurred(noise, self.random.uniform(*s) / self.pixel_um) for s in ((0.4, 1.2), (1.5, 4)))
        return fine / (fine.std() + 1e-6) + np.float32(self.random.uniform(0, 1)) * coarse / (coarse.std() + 1e-6)

    def path(self, cone):
        """Optical path, rad, and the share of zona and ooplasm of each pixel's in-focus section."""
        random = self.random
        outer, inner, core = np.moveaxis(self.cell(cone), 2, 0)
        zona, ooplasm = random.uniform(0.06, 0.3), random.uniform(0.04, 0.42)
        fluid = random.uniform(-0.05, 0.05) if self.chance(0.3) else 0.0
        path = zona * (outer - inner) + fluid * (inner - core) + ooplasm * core
        sections = [np.clip(0.5 - away, 0, 1) for away in (self.outer, self.inner, self.inner + np.float32(self.gap_px))]
        if self.chance(0.8):
            path = path + self.grain() * blurred(sections[2], 1) * np.float32(random.uniform(0, 0.35))
        path = path + GLASS_RAD_PER_UM * random.uniform(0.3, 1) * self.glass()
        for _ in range(random.poisson(1.5)):      # debris
            path = path + self.blob(random.uniform(0.8, 4))
        return path.astype(np.float32), sections[0] - sections[1], sections[2]

    def blob(self, radius_um):
        u = np.arange(self.size[0], dtype=np.float32)[None] - self.random.uniform(0, self.size[0])
        v = np.arange(self.size[1], dtype=np.float32)[:, None] - self.random.uniform(0, self.size[1])
        away_um2 = (u * u + v * v) * np.float32(self.pixel_um ** 2)
        ball = 2 * np.sqrt(np.clip(radius_um ** 2 - away_um2, 0, None))
        return ball * np.float32(self.random.uniform(0.05, 0.4) * self.random.choice([-1, 1]))


def saturated(part, random):
    """`part` so strong that a share of it saturates, in one of several ways."""
    strength = np.percentile(np.abs(part), random.uniform(95, 99.7)) + 1e-6
    part = part / np.float32(strength)
    way = random.integers(5)
    if way == 0:
        return np.tanh(np.float32(random.uniform(0.7, 1.6)) * part)
    if way == 1:
        return np.sin(np.clip(np.float32(random.uniform(0.6, 1.1)) * part, -1.9, 1.9))
    if way == 2:
        return part / (1 + np.abs(part)) * 2
    return np.clip(part, -random.uniform(1, 3), random.uniform(1, 3))


def relief(path, scene):
    random = scene.random
    angle, shear_px = random.uniform(0, 2 * np.pi), random.uniform(0.3, 2.0) / scene.pixel_um
    shift = 0.5 * max(shear_px, 0.7) * np.array([np.cos(angle), np.sin(angle)])
    moved_by = lambda s: cv2.warpAffine(path, np.float32([[1, 0, s[0]], [0, 1, s[1]]]), scene.size, flags=cv2.INTER_LINEAR,
                                        borderMode=cv2.BORDER_REPLICATE)
    light = saturated(moved_by(shift) - moved_by(-shift), random)
    if scene.chance(0.5):          # Hoffman's shading
        shade = blurred(path, random.uniform(1, 4) / scene.pixel_um)
        light = light + np.float32(random.normal(0, 0.25)) * shade / (np.abs(shade).max() + 1e-6)
    return light


def phase(path, scene):
    random = scene.random
    small = cv2.resize(path, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA)
    reach_px = random.uniform(2.5, 14) / scene.pixel_um / 4
    wide = blurred(small, reach_px)
    if scene.chance(0.4):          # with a longer tail
        wide = 0.6 * wide + 0.4 * blurred(small, 2.2 * reach_px)
    wide = cv2.resize(wide, scene.size, interpolation=cv2.INTER_LINEAR)
    denser = path - np.float32(random.uniform(0.55, 1.0)) * wide
    denser = np.where(denser > 0, denser, np.float32(random.uniform(0.6, 2.5)) * denser)
    return np.float32(random.choice([-1, 1], p=[0.75, 0.25])) * saturated(denser, random)


def bright(path, scene):
    random = scene.random
    fine = blurred(path, random.uniform(0.2, 1.2) / scene.pixel_um)
    curvature = cv2.Laplacian(fine, cv2.CV_32F, ksize=3)
    if scene.chance(0.4):          # both signs dark, as where a rim refracts the light out of the objective
        lines = blurred(np.abs(curvature), random.uniform(0.2, 0.6) / scene.pixel_um)
        return -saturated(lines, random) + np.float32(random.normal(0, 0.15)) * saturated(curvature, random)
    return np.float32(random.choice([-1, 1])) * saturated(curvature, random)


def by_path(scene):
    path, zona, ooplasm = scene.path(scene.random.choice([0.0, scene.random.uniform(0.02, 0.5)], p=[0.2, 0.8]))
    path = blurred(path, scene.random.uniform(0.25, 0.8) / scene.pixel_um)
    way = scene.random.choice([relief, phase, bright], p=[0.35, 0.4, 0.25])
    light = way(path, scene)
    if way is not relief and scene.chance(0.7):
        light = light - np.float32(scene.random.uniform(-0.2, 0.4)) * zona - np.float32(scene.random.uniform(0, 0.7)) * ooplasm
    return light, way.__name__


def by_waves(scene):
    """Light through an objective of finite aperture, whose condenser's points are added up."""
    random = scene.random
    path, zona, ooplasm = scene.path(random.uniform(0, 0.08))
    path = blurred(path, 0.15 / scene.pixel_um)
    n = fft.next_fast_len(max(path.shape) + 32)
    padded = lambda field: cv2.copyMakeBorder(field, 0, n - field.shape[0], 0, n - field.shape[1], cv2.BORDER_REFLECT_101)
    absorbed = random.uniform(0, 0.1) * zona + random.uniform(0, 0.25) * ooplasm
    through = np.exp(1j * padded(path) - padded(absorbed.astype(np.float32))).astype(np.complex64)
    way = random.choice(["bright", "phase", "hoffman", "dic"])
    aperture = random.uniform(0.25, 0.5) / WAVELENGTH_UM
    step = 1 / (n * scene.pixel_um)
    f = fft.fftfreq(n, scene.pixel_um).astype(np.float32)
    fx, fy = f[None, :], f[:, None]
    square = fx * fx + fy * fy
    defocus_um = random.normal(0, 6) if way == "bright" else random.normal(0, 2)
    pupil = np.where(square < aperture ** 2, np.exp(-1j * np.pi * WAVELENGTH_UM * defocus_um * square), 0).astype(np.complex64)
    angle = random.uniform(0, 2 * np.pi)
    ahead = np.cos(angle) * fx + np.sin(angle) * fy
    if way == "phase":
        ring, half = random.uniform(0.35, 0.75) * aperture, random.uniform(0.04, 0.1) * aperture
        turns = np.arange(12) * (2 * np.pi / 12) + random.uniform(0, 1)
        source = [(ring * np.cos(t), ring * np.sin(t)) for t in turns]
        amplitude = random.uniform(0.25, 0.7) * np.exp(1j * random.choice([-1, 1], p=[0.25, 0.75]) * random.uniform(1.1, 1.7))
        pupil = np.where(np.abs(np.sqrt(square) - ring) < half + step, pupil * np.complex64(amplitude), pupil)
    elif way == "hoffman":
        at, half = random.uniform(0.45, 0.75) * aperture, random.uniform(0.06, 0.16) * aperture
        sway = random.uniform(0.1, 0.5) * aperture
        source = [(at * np.cos(angle) - v * np.sin(angle), at * np.sin(angle) + v * np.cos(angle))
                  for v in np.linspace(-sway, sway, 7)]
        grey, dark = random.uniform(0.3, 0.6), random.uniform(0, 0.25)
        pupil = pupil * np.where(ahead > at + half, 1, np.where(ahead > at - half, grey, dark)).astype(np.float32)
        if scene.chance(0.15):         # the modulator the other way round: mostly its dark part
            pupil = pupil[::-1, ::-1]
    else:
        share = random.uniform(0.2, 0.85) * aperture
        r, t = share * np.sqrt((np.arange(10) + 0.5) / 10), np.arange(10) * 2.39996
        source = list(zip(r * np.cos(t), r * np.sin(t)))
        if way == "dic":
            shear_um, bias = random.uniform(0.2, 1.0), random.uniform(0.3, 1.4)
            pupil = pupil * (2j * np.sin(np.pi * shear_um * ahead + bias)).astype(np.complex64)
    spectrum = fft.fft2(through)
    light = np.zeros((n, n), np.float32)
    for sx, sy in source:
        shifted = np.roll(spectrum, (round(sy / step), round(sx / step)), (0, 1))
        wave = fft.ifft2(shifted * pupil)
        light += wave.real ** 2 + wave.imag ** 2
    light = light[:path.shape[0], :path.shape[1]]
    return light / (np.median(light) + 1e-9) - 1, "wave " + way


def developed(light, scene):
    """As a camera's grey values, 0 to 255."""
    random = scene.random
    light = light - np.median(light)
    near = np.abs(scene.outer) < 0.06 * scene.radius_px
    strength = np.percentile(np.abs(light[near]), 95) + 1e-6
    contrast = np.exp(random.uniform(np.log(10), np.log(75)))
    grey = random.uniform(90, 185) + contrast * np.clip(light / np.float32(strength), -6, 6)
    return grey + random.normal(size=grey.shape) * random.uniform(0, 2)


def drawn(outlines, label, along, random):
    """A picture of 8 bits, its label, and a and b of its places a p + b."""
    radius_px = np.sqrt(abs(area(outlines["outer"])) / np.pi)
    middle = outlines["outer"].mean(1)
    final_px = np.exp(random.uniform(*np.log(RADII_PX)))
    is_wave = random.random() < 0.4
    work_px = WAVE_RADIUS_PX if is_wave else max(final_px, 70.0)
    low = np.maximum(np.floor(middle - REACH * radius_px), 0)
    high = np.minimum(np.ceil(middle + REACH * radius_px), np.array(label.shape[::-1]))

    def placed(radius):
        size = np.maximum(np.round((high - low) * radius / radius_px), 8).astype(int)
        a = np.diag(size / (high - low))
        return tuple(int(k) for k in size), a, 0.5 * np.diag(a) - 0.5 - np.diag(a) * low
    size, a, b = placed(work_px)
    shapes = moved(outlines, a, b)
    scene = Scene(shapes, size, along, shapes["outer"].mean(1), work_px, random)
    light, way = by_waves(scene) if is_wave else by_path(scene)
    picture = developed(light, scene)
    size, a, b = placed(final_px)
    picture = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    x0, y0, x1, y1 = *low.astype(int), *high.astype(int)
    label = cv2.resize(label[y0:y1, x0:x1], size, interpolation=cv2.INTER_NEAREST)
    return np.clip(np.round(picture), 0, 255).astype(np.uint8), label, a, b, way


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples")
    parser.add_argument("--out", required=True)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    cv2.setNumThreads(1)
    known = [one for one in Tables(options.samples).new() if {"outer", "inner"} <= one[2].keys()]
    if not known:
        parser.error(f"no picture of a cell in {options.samples}: draw some with film_samples")
    os.makedirs(options.out, exist_ok=True)
    random = np.random.default_rng(options.seed)
    with (open(os.path.join(options.out, f"samples_{options.seed}.csv"), "w") as rows,
          open(os.path.join(options.out, f"contours_{options.seed}.csv"), "w") as contours):
        table = csv.DictWriter(rows, FIELDS, extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        for k in range(options.count):
            path, row, outlines = known[random.integers(len(known))]
            label = cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
            along = np.array([float(row["direction_x"]), float(row["direction_y"])])
            picture, label, a, b, way = drawn(outlines, label, along, random)
            name = f"{options.seed + k}.png"
            cv2.imwrite(os.path.join(options.out, name), picture)
            cv2.imwrite(os.path.join(options.out, name[:-4] + "_label.png"), label)
            tip = a @ [float(row["tip_x_px"]), float(row["tip_y_px"])] + b
            center = a @ [float(row["center_x_px"]), float(row["center_y_px"])] + b
            table.writerow({**row, "file": name, "tip_x_px": tip[0], "tip_y_px": tip[1], "center_x_px": center[0], "center_y_px": center[1],
                            "tip_radius_px": float(row["tip_radius_px"]) * a[0, 0],
                            "outer_radius_px": float(row["outer_radius_px"]) * a[0, 0], "contrast": way, "family": "other optics"})
            for which, points in moved(outlines, a, b).items():
                contours.write(",".join([name, which] + [f"{value:.3f}" for value in points.T.ravel()]) + "\n")
            rows.flush()
            contours.flush()


if __name__ == "__main__":
    sys.exit(main())

"""Bodies of path_films.py's films: shapes of finite-element specimens, their optical path and its contrast."""
import json
import os
import re

import cv2
import numpy as np
from scipy.interpolate import PchipInterpolator

GRID_UM = 0.2                # spacing at which bodies are projected: finer than every pixel


def read_table(folder, number, table):
    return np.loadtxt(os.path.join(folder, f"specimen-{number}-1-{table}.csv"), delimiter=",", skiprows=1, ndmin=2)


def suitable(folder, number, geometry):
    """Neither sucked in nor stiffening, a zona that can be scaled to a sensible one, and indented deep enough, um."""
    return (geometry["suction_kPa"] == 0 and geometry["stiffening"] == 0 and 2.5 < geometry["thickness_um"] < 13.5
            and read_table(folder, number, "force")[-1, 0] > 24)


def find_specimens(folders, first, last):
    """(number, folder, geometry) of every suitable specimen, by number; the first folder that has a number counts."""
    found = {}
    for folder in folders:
        for name in os.listdir(folder):
            match = re.fullmatch(r"specimen-(\d+)-geometry\.json", name)
            if not match or not (first or 0) <= int(match[1]) <= (last or 10 ** 9):
                continue
            tables = (os.path.join(folder, f"specimen-{match[1]}-1-{table}.csv") for table in ("profile", "force"))
            if all(map(os.path.exists, tables)):
                found.setdefault(int(match[1]), (match[1], folder, name))
    specimens = []
    for _, (number, folder, name) in sorted(found.items()):
        with open(os.path.join(folder, name)) as file:
            geometry = json.load(file)
        # Geometries without these two belong to specimens of another make.
        if {"suction_kPa", "stiffening"} <= geometry.keys() and suitable(folder, number, geometry):
            specimens.append((number, folder, geometry))
    return specimens


class Specimen:
    """Half sections (rho, z) of both faces of the zona by depth, and forces; the needle comes from +z; um, uN."""

    def __init__(self, number, folder, scale):
        profile, force = read_table(folder, number, "profile"), read_table(folder, number, "force")
        rest_depths = np.unique(profile[:, 0])
        self.depths_um = rest_depths * scale
        self.sections_um = np.array([profile[profile[:, 0] == depth][:, 2:6] for depth in rest_depths]) * scale
        self.force_uN = PchipInterpolator(force[:, 0] * scale, force[:, 1] * scale * scale)
        self.deepest_force_um = force[-1, 0] * scale
        self.top_um = self.sections_um[0][0, 1]

    def sections_at(self, depth_um):
        """Outer and inner half section, from the needle's pole to the holder's; tables are interpolated linearly."""
        k = int(np.clip(np.searchsorted(self.depths_um, depth_um) - 1, 0, len(self.depths_um) - 2))
        t = np.clip((depth_um - self.depths_um[k]) / (self.depths_um[k + 1] - self.depths_um[k]), 0, 1)
        both = (1 - t) * self.sections_um[k] + t * self.sections_um[k + 1]
        return both[:, :2], both[:, 2:]

    def force_at(self, depth_um):
        return float(self.force_uN(min(depth_um, self.deepest_force_um)))

    def height_at(self, radius_um):
        """Of the resting outer face on the holder's side: where a holder's ring of this radius touches."""
        outer = self.sections_um[0]
        low = outer[outer[:, 1] < 0]
        return np.interp(radius_um, low[::-1, 0], low[::-1, 1])


def blurred(field, sigma):
    return cv2.GaussianBlur(field, (0, 0), sigma)


def mirrored(half):
    """A field over (z, rho) continued to negative rho."""
    return np.concatenate([half[:, ::-1], half], 1)


class Projector:
    """Integrates a body of revolution, given over its half section (z, rho), along the line of sight."""

    def __init__(self, reach_um, field_depth_um):
        self.count = n = int(np.ceil(reach_um / GRID_UM))
        lateral_um, sight_um = (np.arange(n) + .5) * GRID_UM, (np.arange(2 * n) + .5) * GRID_UM / 2
        radius = np.hypot(lateral_um[:, None], sight_um[None, :]) / GRID_UM - .5      # in cells of the grid
        in_focus = np.exp(-.5 * (sight_um / field_depth_um) ** 2)
        below = np.clip(np.floor(radius).astype(int), 0, n - 1)
        part, inside = radius - below, radius < n - 1
        column = np.broadcast_to(np.arange(n)[:, None], below.shape)
        self.matrices = [np.zeros((n, n), np.float32) for _ in range(2)]              # in and out of the depth of field
        for matrix, weight in zip(self.matrices, (in_focus, 1 - in_focus)):
            # Half a cell per step, before and behind the axis alike.
            step_um = np.broadcast_to(weight * GRID_UM, below.shape)
            np.add.at(matrix, (np.maximum(below, 0)[inside], column[inside]), (step_um * (1 - part))[inside])
            np.add.at(matrix, (np.minimum(below + 1, n - 1)[inside], column[inside]), (step_um * part)[inside])

    def path(self, half, blur_um):
        sharp, soft = (half @ matrix for matrix in self.matrices)
        return mirrored(sharp) + blurred(mirrored(soft), blur_um / GRID_UM)


def coverage(polygon_um, low_um, rows, columns, over=4):
    """Share of each cell of the grid (z from low_um up, rho from 0 up) inside a polygon (rho, z)."""
    mask = np.zeros((rows * over, columns * over), np.uint8)
    at = np.c_[polygon_um[:, 0] / GRID_UM * over - .5, (polygon_um[:, 1] - low_um) / GRID_UM * over - .5]
    cv2.fillPoly(mask, [np.round(at * 64).astype(np.int32)], 255, cv2.LINE_8, 6)
    return cv2.resize(mask, (columns, rows), interpolation=cv2.INTER_AREA).astype(np.float32) / 255


def sphere_chord_um(shape, center_px, radius_um, pixel_um):
    y, x = np.ogrid[:shape[0], :shape[1]]
    across_um2 = ((x - center_px[0]) ** 2 + (y - center_px[1]) ** 2) * pixel_um * pixel_um
    return 2 * np.sqrt(np.maximum(radius_um * radius_um - across_um2, 0)).astype(np.float32)


class Contrast:
    """Turns optical path into light, 1 where there is nothing; its gain is set in the film's first frame."""

    def __init__(self, plan, pixel_um, edge_zone):
        self.plan, self.pixel_um, self.edge_zone, self.gain = plan, pixel_um, edge_zone, None

    def light(self, path, zona, ooplasm):
        light = {"bright": self.bright, "relief": self.relief, "phase": self.phase}[self.plan.contrast](path)
        if zona is not None and self.plan.contrast != "relief":
            light = light * (1 - self.plan.zona_dark * zona - self.plan.ooplasm_dark * ooplasm)
        return light

    def bright(self, path):
        plan, pixel_um = self.plan, self.pixel_um
        curvature = -cv2.Laplacian(blurred(path, .2 / pixel_um), cv2.CV_32F, ksize=3) / (4 * pixel_um * pixel_um)
        gain = self.set_gain(curvature, 99.2)
        if plan.style in (0, 3):      # thin dark lines, whichever side is denser
            lines = 1 - np.exp(-np.abs(blurred(np.abs(curvature), .3 / pixel_um)) / gain)
            return 1 - plan.edge * 1.3 * lines + .12 * plan.sign * np.tanh(curvature / gain)
        return 1 - plan.sign * plan.edge * 1.2 * np.tanh(curvature / gain)      # pairs of a dark and a bright line

    def relief(self, path):
        plan, pixel_um = self.plan, self.pixel_um
        smooth = path if plan.style % 2 else blurred(path, .25 / pixel_um)
        across, down = cv2.Scharr(smooth, cv2.CV_32F, 1, 0), cv2.Scharr(smooth, cv2.CV_32F, 0, 1)
        slope = (np.cos(plan.shear_rad) * across + np.sin(plan.shear_rad) * down) / (32 * pixel_um)
        gain = self.set_gain(slope, 99.0)
        shade = blurred(path, 3 / pixel_um) * .004 * plan.sign
        response = np.tanh(slope / gain) if plan.style < 2 else np.sin(np.clip(.9 * slope / gain, -1.9, 1.9))
        return 1 + plan.edge * 1.7 * response + shade

    def phase(self, path):
        plan = self.plan
        small = cv2.resize(path, None, fx=.25, fy=.25, interpolation=cv2.INTER_AREA)
        wide = cv2.resize(blurred(small, plan.halo_um / self.pixel_um / 4), path.shape[::-1], interpolation=cv2.INTER_LINEAR)
        denser = path - (.75 + .2 * (plan.style % 2)) * wide
        gain = self.set_gain(denser, 98)
        halos = np.where(denser > 0, denser, 2.2 * denser)           # halos stand out
        return 1 - plan.edge * 1.9 * np.tanh(1.2 * halos / gain)

    def set_gain(self, response, percent):
        """From the zone of the cell's edge alone, or from all there is where there is no cell."""
        if self.gain is None:
            strength = np.abs(response)
            if self.edge_zone is not None:
                self.gain = float(np.percentile(strength[self.edge_zone], percent * .96))
            else:
                self.gain = float(np.percentile(strength[strength > .02 * strength.max()], 70))
        return self.gain

#!/usr/bin/python3
"""Films of an injection drawn as one would sketch them, from distances to outlines, with sub-pixel truth; for validation only.

    python3 sketch_films.py --specimens FOLDER [FOLDER ...] --out FILMS [--seed N] [NAME ...]
    python3 sketch_films.py --specimens FOLDER [FOLDER ...] --list

A third renderer beside the virtual microscope and path_films.py, with no optics in common: bright field is grey with dark lines
along the outlines, relief the slope of a height that rises from the outlines as a ball's does, phase contrast that height less
its wide blur. Shapes and forces are those of finite-element specimens (tests/specimens/solid_specimens.py), scaled by s in length
and s^2 in force. The needle comes from any side. There are twelve films of each contrast and two without a cell. A film is a folder
as path_films.py writes it; measure_films.py measures it. Nothing in the tracker may be set against these films but for those with
the seed 20261125, whose failures were looked at. Needs Debian's python3-numpy, python3-scipy and python3-opencv.
"""
import zlib

import cv2
import numpy as np

from film_folders import axes, closed, draw_films
from path_optics import Specimen

LOOKED_AT_SEED = 20261125
FINE = 3                     # cells of an outline's mask to a pixel
SIZES_PX = [(640, 480), (720, 576), (800, 600), (1024, 768)]
CONTRASTS = ["bright", "relief", "phase"]
FILMS_EACH = 12
OUTCOMES = ["hold", "puncture", "retract", "puncture"]
SHAFT_UM = 20.0              # greatest radius of the needle's shaft
NO_CELL = {"top_um": 48.0, "tip_um": 2.5, "holder_um": 18.0, "hole_um": 9.0}


class Plan:
    """All that is drawn once for a film."""

    def __init__(self, name, index, contrast, random, specimen):
        u = random.uniform
        self.name, self.contrast, self.has_cell = name, contrast, specimen is not None
        self.size_px = SIZES_PX[index % len(SIZES_PX)]
        self.frame_rate_hz, self.speed_um_s = int(random.choice([20, 25, 30])), u(6, 18)
        self.outcome = OUTCOMES[index % len(OUTCOMES)] if specimen else "none"
        self.free_frames, self.frames = int(random.integers(10, 20)), int(random.integers(60, 90))
        if specimen:
            self.number, self.folder, geometry = specimen
            self.scale = np.clip(u(36, 58) / 50, 2.5 / geometry["thickness_um"], 12 / geometry["thickness_um"])
            self.tip_um = geometry["tip_radius_um"] * self.scale
            ring, half = geometry["holder_ring_um"] * self.scale, geometry["holder_half_width_um"] * self.scale
            self.holder_um, self.hole_um = ring + half, ring - half
        else:
            self.scale, self.tip_um, self.holder_um, self.hole_um = 1.0, NO_CELL["tip_um"], NO_CELL["holder_um"], NO_CELL["hole_um"]
        self.pixel_um = float(np.clip(108 * self.scale / (self.size_px[1] * u(.36, .62)), .3, 1.1))
        self.axis_rad = u(-np.pi, np.pi)
        self.tilt_rad, self.taper = np.radians(u(-8, 8)), u(.03, .12)
        self.wall_share, self.is_filled = u(.15, .45), random.random() < .3
        self.level, self.noise = u(110, 185), u(1.5, 7)
        self.line_px = u(.9, 1.7)                                    # of dark lines, as standard deviations
        self.outer_line, self.inner_line, self.tool_line = u(.2, .5), u(.12, .4), u(.3, .6)
        self.fringe = u(0, .15) if random.random() < .5 else 0       # bright, beside a line
        self.ooplasm, self.grain, self.grain_px = u(-.02, .14), u(0, .05), u(.8, 2.2)
        self.gap_um = u(.8, 4) if random.random() < .5 else 0
        self.blur_px = u(.4, .9) if random.random() < .75 else u(1.2, 2.0)
        self.shade, self.shade_rad = u(0, .25), u(0, 2 * np.pi)
        self.drift_px = np.array([u(-.08, .08), u(-.08, .08)]) * (random.random() < .4)   # of the stage, a frame
        self.strength, self.shear_rad = u(.25, .6), u(0, 2 * np.pi)
        self.zona_index, self.ooplasm_index = u(.3, .6), u(.7, 1.3)
        self.halo_um, self.sign = u(6, 18), 1 if random.random() < .8 else -1
        self.specks, self.has_neighbour = int(random.integers(0, 12)), specimen is not None and random.random() < .2
        self.shift = np.array([u(-.06, .06), u(-.06, .06)])
        self.jpeg = int(random.integers(55, 92)) if random.random() < .3 else None
        self.bubbles = [] if specimen else [(u(.1, .9), u(.1, .9), u(4, 15)) for _ in range(4)]

    def path(self, specimen):
        """By frame: the tip beyond the resting pole and the membrane's depth, um; force, uN; state."""
        step = self.speed_um_s / self.frame_rate_hz
        if specimen is None:
            yield from ((-30 + step * k, 0.0, 0.0, "free") for k in range(self.frames))
            return
        push = int((self.frames - self.free_frames) * (.65 if self.outcome != "retract" else .5))
        step = min(step, min(specimen.depths_um[-1], .8 * specimen.top_um) / push)
        tip = 0.0
        for frame in range(self.frames):
            k = frame - self.free_frames
            if k <= push:
                tip = step * (k - .4)
            elif self.outcome == "puncture":
                tip += .3 * step if k < push + 6 else 0
            elif self.outcome == "retract" and k > push + 5:
                tip -= 1.2 * step
            if self.outcome == "puncture" and k > push:
                yield tip, 0.0, 0.0, "punctured"
            else:
                yield tip, max(tip, 0.0), specimen.force_at(tip) if tip > 0 else 0.0, "contact" if tip > 0 else "free"


class Film:
    def __init__(self, plan, seed):
        self.plan, self.random = plan, np.random.default_rng([seed, zlib.crc32(plan.name.encode())])
        width, height = plan.size_px
        self.y, self.x = np.mgrid[:height, :width].astype(np.float32)
        self.along, self.across = axes(plan.axis_rad)
        self.middle_px = np.array([width, height]) * (.5 + plan.shift)
        self.specimen = Specimen(plan.number, plan.folder, plan.scale) if plan.has_cell else None
        self.top_um = self.specimen.top_um if plan.has_cell else NO_CELL["top_um"]
        self.texture = cv2.GaussianBlur(self.random.normal(size=(height, width)).astype(np.float32), (0, 0), plan.grain_px)
        self.texture /= self.texture.std()
        self.draw_loose()
        self.gain = None

    def draw_loose(self):
        """Specks, bubbles and a neighbour: middle and radius, px, of balls that stay where they are."""
        plan, random, cell_px = self.plan, self.random, self.top_um / self.plan.pixel_um
        self.balls = [(x * plan.size_px[0], y * plan.size_px[1], r / plan.pixel_um) for x, y, r in plan.bubbles]
        for _ in range(plan.specks):
            at = random.uniform(0, 1, 2) * plan.size_px
            away = at - self.middle_px
            if np.hypot(*away) > 1.4 * cell_px and abs(away @ self.across) > 30 / plan.pixel_um:
                self.balls.append((*at, random.uniform(1, 3.5) / plan.pixel_um))
        if plan.has_neighbour:
            at = self.middle_px + 2.3 * cell_px * self.across * random.choice([-1, 1]) - .3 * cell_px * self.along
            self.balls.append((*at, .95 * cell_px))

    def place(self, points_um, drift_px):
        """Pixels of points (rho, z)."""
        return self.middle_px + drift_px + (points_um[..., :1] * self.across + points_um[..., 1:] * self.along) / self.plan.pixel_um

    def beyond(self, polygon_px):
        """Signed distance to a closed polygon, px, below 0 inside; 60 where it is farther off."""
        low = np.floor(polygon_px.min(0)).astype(int) - 62
        high = np.ceil(polygon_px.max(0)).astype(int) + 62
        low, high = np.maximum(low, 0), np.minimum(high, self.plan.size_px)
        mask = np.zeros(((high[1] - low[1]) * FINE, (high[0] - low[0]) * FINE), np.uint8)
        corners = (polygon_px - low + .5) * FINE - .5
        cv2.fillPoly(mask, [np.round(corners * 64).astype(np.int32)], 1, cv2.LINE_8, 6)
        signed = cv2.distanceTransform(1 - mask, cv2.DIST_L2, cv2.DIST_MASK_PRECISE) - cv2.distanceTransform(mask, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
        signed = cv2.resize(signed, (high[0] - low[0], high[1] - low[1]), interpolation=cv2.INTER_AREA) / FINE
        whole = np.full(self.x.shape, 60, np.float32)
        whole[low[1]:high[1], low[0]:high[0]] = np.minimum(signed, 60)
        return whole

    def rod(self, end_px, way, radius_um, taper, most_um):
        """Signed distance to a rod that begins at `end_px` and runs along `way`, and its radius behind that, px."""
        x, y = self.x - end_px[0], self.y - end_px[1]
        behind, beside = x * way[0] + y * way[1], np.abs(y * way[0] - x * way[1])
        radius = np.minimum(radius_um / self.plan.pixel_um + taper * np.maximum(behind, 0), most_um / self.plan.pixel_um)
        side, end = beside - radius, -behind
        return np.where((side > 0) & (end > 0), np.hypot(side, end), np.maximum(side, end)), radius

    def tools(self, tip_px, drift_px):
        """[(outer distance, inner distance or None, radius)] of needle and holder, px."""
        plan = self.plan
        way, _ = axes(plan.axis_rad + plan.tilt_rad)
        outer, radius = self.rod(tip_px, way, plan.tip_um, plan.taper, SHAFT_UM)
        lumen = None if plan.is_filled else outer + np.maximum(plan.wall_share * radius, .6)
        height_um = self.specimen.height_at(plan.holder_um * .75) if self.specimen else -self.top_um
        mouth = self.place(np.array([[0.0, height_um]]), drift_px)[0]
        holder, wide = self.rod(mouth, -self.along, plan.holder_um, 0, plan.holder_um)
        hole, _ = self.rod(mouth, -self.along, plan.hole_um, 0, plan.hole_um)
        return [(outer, lumen, radius), (np.maximum(holder, -hole), None, wide)]

    def bodies(self, outlines, tip_px, drift_px):
        """Light of a frame, 1 where there is nothing, before the camera."""
        draw = self.lines if self.plan.contrast == "bright" else self.heights
        return draw(outlines, self.tools(tip_px, drift_px))

    def lines(self, outlines, tools):
        plan = self.plan
        light = np.ones_like(self.x)
        if outlines:
            outer, inner = (self.beyond(outline) for outline in outlines)
            within = 1 / (1 + np.exp(np.clip((inner + plan.gap_um / plan.pixel_um) / .6, -30, 30)))
            light -= within * (plan.ooplasm + plan.grain * self.texture)
            light -= self.line(outer, plan.outer_line) + self.line(inner, plan.inner_line)
            if plan.gap_um:
                light -= self.line(inner + plan.gap_um / plan.pixel_um, .7 * plan.inner_line)
        for x, y, radius in self.balls:
            light -= self.line(np.hypot(self.x - x, self.y - y) - radius, plan.outer_line)
        for outer, lumen, _ in tools:
            light -= self.line(outer, plan.tool_line)
            if lumen is not None:
                light -= self.line(lumen, .6 * plan.tool_line)
            else:
                light -= .1 / (1 + np.exp(np.clip(outer / .6, -30, 30)))
        return light

    def line(self, away, depth):
        s = away / self.plan.line_px
        return depth * np.exp(-.5 * s * s) - self.plan.fringe * np.exp(-.5 * (s - 2.5) ** 2)

    def heights(self, outlines, tools):
        plan = self.plan
        height = np.zeros_like(self.x)
        if outlines:
            outer, inner = (-self.beyond(outline) * plan.pixel_um for outline in outlines)
            radius = outer.max()
            body = inner - plan.gap_um
            height += plan.zona_index * (chord(outer, radius) - chord(inner, radius))
            height += plan.ooplasm_index * chord(body, radius) * (1 + plan.grain * self.texture)
        for x, y, radius in self.balls:
            sign = -1 if self.plan.bubbles else 1
            height += sign * plan.ooplasm_index * chord((radius - np.hypot(self.x - x, self.y - y)) * plan.pixel_um, radius * plan.pixel_um)
        for outer, lumen, radius in tools:
            height += 3 * chord(-outer * plan.pixel_um, radius * plan.pixel_um)
            if lumen is not None:
                height -= 3 * chord(-lumen * plan.pixel_um, radius * plan.pixel_um)
        height = cv2.GaussianBlur(height.astype(np.float32), (0, 0), plan.blur_px)
        if plan.contrast == "relief":
            response = np.cos(plan.shear_rad) * cv2.Scharr(height, cv2.CV_32F, 1, 0) + np.sin(plan.shear_rad) * cv2.Scharr(height, cv2.CV_32F, 0, 1)
        else:
            small = cv2.GaussianBlur(cv2.resize(height, None, fx=.25, fy=.25, interpolation=cv2.INTER_AREA), (0, 0), plan.halo_um / plan.pixel_um / 4)
            response = -plan.sign * (height - cv2.resize(small, plan.size_px, interpolation=cv2.INTER_LINEAR))
        if self.gain is None:
            near = np.hypot(self.x - self.middle_px[0], self.y - self.middle_px[1]) < 1.1 * self.top_um / plan.pixel_um
            self.gain = np.percentile(np.abs(response[near]), 97) + 1e-6
        return 1 + plan.strength * np.tanh(response / self.gain)

    def frame(self, outlines, tip_px, drift_px):
        plan = self.plan
        light = self.bodies(outlines, tip_px, drift_px)
        if plan.contrast == "bright":
            light = cv2.GaussianBlur(light.astype(np.float32), (0, 0), plan.blur_px)
        ramp = np.cos(plan.shade_rad) * (self.x / plan.size_px[0] - .5) + np.sin(plan.shade_rad) * (self.y / plan.size_px[1] - .5)
        level = plan.level * light * (1 + plan.shade * ramp) + self.random.normal(0, plan.noise, light.shape)
        picture = np.clip(np.round(level), 0, 255).astype(np.uint8)
        if plan.jpeg:
            picture = cv2.imdecode(cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, plan.jpeg])[1], cv2.IMREAD_GRAYSCALE)
        return picture

    def frames(self):
        """As write_film takes them."""
        for k, (tip_um, depth_um, force_uN, state) in enumerate(self.plan.path(self.specimen)):
            drift_px = k * self.plan.drift_px
            tip_px = self.place(np.array([[0.0, self.top_um - tip_um]]), drift_px)[0]
            outlines = None
            if self.specimen:
                outlines = [self.place(closed(half), drift_px) for half in self.specimen.sections_at(depth_um)]
            yield self.frame(outlines, tip_px, drift_px), tip_px, depth_um, force_uN, state, outlines


def chord(depth, radius):
    """Of a ball of `radius`, so far within its outline."""
    return 2 * np.sqrt(np.clip(depth * (2 * radius - depth), 0, None))


def catalogue(specimens, seed):
    random = np.random.default_rng(seed)
    chosen = random.permutation(len(specimens))
    plans = []
    for c, contrast in enumerate(CONTRASTS):
        for k in range(FILMS_EACH):
            plans.append(Plan(f"{contrast}{k:02d}", k, contrast, random, specimens[chosen[(len(CONTRASTS) * k + c) % len(chosen)]]))
        for k in range(2):
            plans.append(Plan(f"empty_{contrast}{k}", k, contrast, random, None))
    return plans


if __name__ == "__main__":
    draw_films(__doc__, LOOKED_AT_SEED, catalogue, Film)

#!/usr/bin/python3
"""Films of an injection by optical path, with sub-pixel truth, for validation only.

    python3 path_films.py --specimens FOLDER [FOLDER ...] --out FILMS [--frames N] [--seed N] [NAME ...]
    python3 path_films.py --specimens FOLDER [FOLDER ...] --list

Shares no code and no formula with the virtual microscope. The cell, its needle and its holder are bodies of revolution
whose axes lie in the plane of focus. Shapes and forces are those of finite-element specimens, in the tables that
tests/specimens/solid_specimens.py writes, scaled by s in length and s^2 in force (the same modulus). Each body is
integrated along the line of sight with a weight for the depth of field; what lies outside that depth is blurred. The
optical path becomes bright field (its curvature and absorption, or mere dark lines), relief (a saturating slope along
a shear direction) or phase contrast (the path less its wide blur). There are ten films of each contrast and three
without a cell. Each film is a folder: frame_00000.png ..., film.json (pixel size, contrast), t.csv and t_contours.csv in
the columns of a simulated recording's truth. A film depends on the seed and on the specimens that the folders hold.
Nothing in the tracker may be set against these films but for those with the seed 20261124, whose failures were looked at, and
single ones of other seeds that docs/method.md names.
Needs Debian's python3-numpy, python3-scipy and python3-opencv.
"""
import zlib

import cv2
import numpy as np

from film_folders import axes, closed, draw_films
from path_optics import GRID_UM, Contrast, Projector, Specimen, blurred, coverage, mirrored, sphere_chord_um

LOOKED_AT_SEED = 20261124
MARGIN_UM = 10.0             # of a tool's grid before the tool's end, room for its blur
FINE_PIXEL_UM = 0.45         # pixels above this size are drawn at twice the resolution, then averaged
GLASS_RAD_PER_UM = 1.6       # optical path of glass in water: 2 pi 0.14 / 0.55 um
TOOL_BLUR_UM = 2.5           # of the parts of a tool outside the depth of field
SHAFT_UM = 22.0              # greatest radius of the needle's shaft
CELL_REACH_UM = 54.0         # about the outer radius of a specimen of scale 1
REST_TOP_UM = 48.0           # where the needle would touch in a film without a cell
SIZES_PX = [(640, 480), (800, 600), (1024, 768), (720, 576)]
CONTRASTS = ["bright", "relief", "phase"]
FILMS_EACH = 10
NO_CELL = {"thickness_um": 5.0, "tip_radius_um": 2.5, "holder_ring_um": 15.0, "holder_half_width_um": 5.0, "aspect_ratio": 1.0}


class Plan:
    """All that is drawn once for a film. The order of the draws is part of what a seed means."""

    def __init__(self, name, index, contrast, random, specimen):
        uniform = random.uniform
        self.name, self.contrast, self.style = name, contrast, index % 4
        self.frame_rate_hz = int(random.choice([25, 30]))
        self.size_px = SIZES_PX[index % 4]
        self.number, self.folder, geometry = specimen
        scale = uniform(36, 58) / 50
        # Zona at most 12 um, tip at most 6 um, holder at most 35 um; none of them vanishes.
        scale = min(scale, 12 / geometry["thickness_um"], 6 / geometry["tip_radius_um"], 35 / (1.29 * geometry["holder_ring_um"]))
        self.scale = max(scale, 3 / geometry["thickness_um"], .5 / geometry["tip_radius_um"], .72)
        across_um = 2 * CELL_REACH_UM * self.scale * geometry["aspect_ratio"] ** .5
        self.pixel_um = float(np.clip(across_um / (self.size_px[1] * uniform(.34, .62)), .3, 1.0))
        self.axis_rad = np.radians(uniform(-40, 40) if index % 3 == 2 else uniform(-12, 12)) + (np.pi if random.random() < .45 else 0)
        self.tilt_rad = np.radians(uniform(-9, 9))                   # of the needle's shaft about its tip
        self.taper, self.lumen = uniform(.03, .14), uniform(.55, .82)   # radius per length; share of the needle's radius
        self.rounded = uniform(.2, .9)                               # length of the needle's rim, in tip radii
        self.field_depth_um, self.defocus_um = uniform(2.5, 7), uniform(2.5, 6)
        self.gap_um = 0 if index % 4 == 3 else uniform(.8, 5)        # between zona and ooplasm
        self.grain_rad, self.grain_um = uniform(.1, 1.2), uniform(.4, 1.1)
        self.spread_um = uniform(.3, .65)                            # point spread, as a standard deviation
        self.noise, self.shot = uniform(1.5, 5.5), uniform(0, 2.5)   # grey levels; shot noise at level 150
        self.level = uniform(120, 190) if contrast == "bright" else uniform(100, 150)
        self.uneven = uniform(.02, .16)
        self.speed_um_s = uniform(5, 20)
        self.free_frames, self.frames = int(random.integers(8, 21)), int(random.integers(66, 106))
        self.outcome = ["puncture", "hold", "retract"][index % 3] if index < 9 else "puncture"
        self.polar_body, self.other_cell = random.random() < .3, index in (4, 7)
        self.debris, self.dust = int(random.integers(0, 10)), int(random.integers(0, 7))
        self.shift = (uniform(-.05, .05), uniform(-.07, .07))        # of the cell, in widths and heights of the image
        self.soft_shaft = random.random() < .4
        self.sign = 1 if index % 2 else -1
        self.shear_rad = np.radians(uniform(0, 360))
        self.edge = uniform(.16, .34)                                # contrast of the zona's edge
        if contrast == "phase":
            self.edge = uniform(.22, .36)
        self.halo_um = uniform(3.5, 9)
        self.zona_dark, self.ooplasm_dark = uniform(-.04, .10), uniform(0, .16)
        self.zona_rad, self.ooplasm_rad = uniform(.13, .23), uniform(.23, .42)   # optical path per um
        self.tip_um = geometry["tip_radius_um"] * self.scale
        self.ring_um, self.half_um = geometry["holder_ring_um"] * self.scale, geometry["holder_half_width_um"] * self.scale
        self.bubbles, self.has_cell = [], True

    def without_cell(self, random, bubbles):
        self.has_cell = self.other_cell = self.polar_body = False
        self.outcome, self.pixel_um, self.frames, self.debris = "none", .6, 60, 14
        self.tip_um, self.ring_um, self.half_um = (NO_CELL[k] for k in ("tip_radius_um", "holder_ring_um", "holder_half_width_um"))
        for _ in range(bubbles):                                     # place in widths and heights, radius, optical path
            self.bubbles.append((random.uniform(.1, .9), random.uniform(.1, .9), random.uniform(4, 14), random.uniform(.3, 1.2)))
        return self

    def path(self, specimen):
        """By frame: how far the tip is beyond the resting pole and how deep the membrane is, um; force, uN; state."""
        if specimen is None:
            yield from ((-25 + .4 * k, 0, 0.0, "free") for k in range(self.frames))
            return
        step = self.speed_um_s / self.frame_rate_hz
        push = int((self.frames - self.free_frames) * (.62 if self.outcome != "retract" else .45))
        step = min(step, min(specimen.depths_um[-1], .82 * specimen.top_um) / push)
        tip = -self.free_frames * step - .2
        for frame in range(self.frames):
            k = frame - self.free_frames
            if k <= push:
                tip = k * step + .3 * step
            elif self.outcome == "puncture":
                tip += step * .35 if k < push + 8 else 0
            elif self.outcome == "retract" and k > push + 6:
                tip -= 1.15 * step
            if self.outcome == "puncture" and k > push:
                # The membrane springs back at once, or in two frames.
                slow = k == push + 1 and self.sign > 0
                yield tip, max(0, push * step * (.35 if slow else 0)), 0.0, "punctured"
            else:
                membrane = max(tip, 0)
                yield tip, membrane, specimen.force_at(membrane) if tip > 0 else 0.0, "contact" if tip > 0 else "free"


class Film:
    """Draws a film; fields over the image have `over` fine pixels to a pixel."""

    def __init__(self, plan, seed):
        self.plan = plan
        self.random = np.random.default_rng(zlib.crc32(plan.name.encode()) + seed)
        self.over = 2 if plan.pixel_um > FINE_PIXEL_UM else 1
        width, height = plan.size_px
        self.fine_size, self.fine_um = (width * self.over, height * self.over), plan.pixel_um / self.over
        self.along, _ = axes(plan.axis_rad)
        middle = np.array([width * (.5 + plan.shift[0]), height * (.5 + plan.shift[1])])
        self.center_px = middle - self.along * 4 / plan.pixel_um
        self.diagonal_um = np.hypot(width, height) * plan.pixel_um
        self.specimen = Specimen(plan.number, plan.folder, plan.scale) if plan.has_cell else None
        self.top_um = self.specimen.top_um if plan.has_cell else REST_TOP_UM
        if plan.has_cell:
            outer = self.specimen.sections_um
            reach_um = max(outer[..., 0].max(), outer[..., 1].max(), -outer[..., 1].min()) + 4 + 2.5 * plan.defocus_um
            self.projector = Projector(reach_um, plan.field_depth_um)
        self.contrast = Contrast(plan, self.fine_um, self.edge_zone() if plan.has_cell else None)
        self.draw_needle()
        self.draw_holder()
        self.draw_loose()
        self.draw_light()
        self.drawn_depth = None
        if plan.has_cell:
            self.draw_grains()

    def edge_zone(self):
        y, x = np.ogrid[:self.fine_size[1], :self.fine_size[0]]
        center = self.center_px * self.over
        radius_um = np.hypot(x - center[0], y - center[1]) * self.fine_um
        return (radius_um > .93 * self.top_um) & (radius_um < 1.05 * self.top_um)

    def place(self, points_um):
        """Pixels of points (rho, z)."""
        along, across = axes(self.plan.axis_rad)
        return self.center_px + (points_um[..., :1] * across + points_um[..., 1:] * along) / self.plan.pixel_um

    def placed(self, field, left_um, low_um, axis_rad, origin_px):
        """A field over (z, rho) that begins at (low, left), in fine pixels of the image."""
        along, across = axes(axis_rad)
        origin, step = origin_px * self.over + (self.over - 1) / 2, self.fine_um / GRID_UM
        rows = [[v[0] * step, v[1] * step, -(v @ origin) * step - start / GRID_UM - .5]
                for v, start in ((across, left_um), (along, low_um))]
        return cv2.warpAffine(field, np.array(rows), self.fine_size, flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP, borderValue=0)

    def tool(self, outer_um, lumen_um, reach_um):
        """Optical path of a glass tool over (z, rho), and where it begins across; half sections begin at the tool's end."""
        projector = Projector(int(np.ceil(reach_um / GRID_UM)) * GRID_UM, self.plan.field_depth_um)
        rows = int((self.diagonal_um + MARGIN_UM) / GRID_UM)
        glass = coverage(outer_um, -MARGIN_UM, rows, projector.count)
        if lumen_um is not None:
            glass = glass - coverage(lumen_um, -MARGIN_UM, rows, projector.count)
        path = projector.path(glass, TOOL_BLUR_UM) * GLASS_RAD_PER_UM
        return blurred(path, self.plan.spread_um / GRID_UM), -projector.count * GRID_UM

    def draw_needle(self):
        plan, tip_um, end = self.plan, self.plan.tip_um, [[0, self.diagonal_um]]
        rim_um = plan.rounded * tip_um
        turn = np.linspace(0, np.pi / 2, 30)
        rim = np.c_[tip_um * np.sin(turn) ** .6, rim_um * (1 - np.cos(turn))]
        behind_um = np.linspace(0, self.diagonal_um, 400)
        radius_um = np.minimum(tip_um + plan.taper * behind_um, SHAFT_UM)
        radius_um = np.maximum(radius_um - plan.taper * rim_um, tip_um)
        shaft = behind_um > rim_um
        outer = np.r_[rim, np.c_[radius_um[shaft], behind_um[shaft]], end]
        mouth_um = .4 * rim_um + .15
        lumen = np.r_[[[0, mouth_um]], [[plan.lumen * tip_um * .9, mouth_um]],
                      np.c_[radius_um[shaft] * plan.lumen, behind_um[shaft]], end]
        self.needle, self.needle_left_um = self.tool(outer, lumen, radius_um.max() + 9)
        if plan.soft_shaft:           # the shaft leaves the focus from 70 um behind its tip on
            soft = blurred(self.needle, 2.2 / GRID_UM)
            part = np.clip((np.arange(len(soft)) * GRID_UM - 70) / 150, 0, 1)[:, None].astype(np.float32)
            self.needle = self.needle * (1 - part) + soft * part

    def draw_holder(self):
        """Its z runs down the tube, from its mouth."""
        ring_um, half_um, lip_um = self.plan.ring_um, self.plan.half_um, self.plan.half_um * .95
        turn = np.linspace(0, np.pi, 40)
        lip = np.c_[ring_um - half_um * np.cos(turn), lip_um - lip_um * np.sin(turn)]
        wall = np.r_[lip, [[ring_um + half_um, self.diagonal_um], [ring_um - half_um, self.diagonal_um]]]
        path, left_um = self.tool(wall, None, ring_um + half_um + 9)
        height_um = self.specimen.height_at(ring_um) if self.specimen else -REST_TOP_UM
        self.fixed = self.placed(path, left_um, -MARGIN_UM, self.plan.axis_rad + np.pi, self.place(np.array([0.0, height_um])))

    def draw_loose(self):
        """Debris away from the cell and the tools, another cell, bubbles."""
        plan, random, pixel_um = self.plan, self.random, self.fine_um
        center, shape = self.center_px * self.over, self.fine_size[::-1]
        radius = (self.top_um if self.specimen else 55) / pixel_um
        self.loose = np.zeros(shape, np.float32)
        for _ in range(plan.debris):
            for _ in range(20):
                at = random.uniform(0, 1, 2) * self.fine_size
                x, y = at - center
                if np.hypot(x, y) > 1.3 * radius and abs(x * self.along[1] - y * self.along[0]) > 35 / pixel_um:
                    self.loose += sphere_chord_um(shape, at, random.uniform(.8, 3), pixel_um) * random.uniform(.1, .5)
                    break
        if plan.other_cell:
            across = np.array([-self.along[1], self.along[0]]) * random.choice([-1, 1])
            at = center + across * radius * 2.1 - self.along * radius * random.uniform(.2, .7)
            path = sphere_chord_um(shape, at, .93 * radius * pixel_um, pixel_um) * plan.zona_rad
            path += sphere_chord_um(shape, at, .75 * radius * pixel_um, pixel_um) * (plan.ooplasm_rad - plan.zona_rad)
            self.loose += blurred(path, 1.6 / pixel_um) * .5
        for x, y, radius_um, strength in plan.bubbles:
            self.loose -= sphere_chord_um(shape, (x * shape[1], y * shape[0]), radius_um, pixel_um) * strength
        self.loose = blurred(self.loose, plan.spread_um / pixel_um)

    def draw_light(self):
        """Uneven lamp, and specks on the camera's window."""
        random, (width, height) = self.random, self.plan.size_px
        y, x = np.mgrid[:height, :width].astype(np.float32)
        turn = random.uniform(0, 2 * np.pi)
        ramp = (x / width - .5) * np.cos(turn) + (y / height - .5) * np.sin(turn)
        bowl = (x / width - .5) ** 2 + (y / height - .5) ** 2
        self.lamp = 1 + self.plan.uneven * ramp - self.plan.uneven * random.uniform(0, 1.2) * bowl
        for _ in range(self.plan.dust):
            radius = np.hypot(x - random.uniform(0, width), y - random.uniform(0, height)) / random.uniform(3, 9)
            self.lamp *= 1 - random.uniform(.03, .1) * np.exp(-radius ** 4) * (.5 + radius)

    def draw_grains(self):
        size = 2 * self.projector.count
        noise = self.random.normal(size=(size, size)).astype(np.float32)
        fine, coarse = blurred(noise, self.plan.grain_um / GRID_UM), blurred(noise[::-1], 2.2 / GRID_UM)
        self.grains = fine / fine.std() + .6 * coarse / coarse.std()

    def cell(self, depth_um):
        """Optical path, sections of zona and of ooplasm over (z, rho)."""
        plan, n = self.plan, self.projector.count
        outer, inner = self.specimen.sections_at(depth_um)
        low_um = -n * GRID_UM
        whole, inside = coverage(outer, low_um, 2 * n, n), coverage(inner, low_um, 2 * n, n)
        z, rho = (np.arange(2 * n) + .5) * GRID_UM + low_um, (np.arange(n) + .5) * GRID_UM
        # The gap between zona and ooplasm closes where the needle presses.
        wall_um = cv2.distanceTransform((mirrored(inside) > .5).astype(np.uint8), cv2.DIST_L2, 5) * GRID_UM
        near = np.exp(-(rho[None, :] ** 2 + (z[:, None] - inner[0, 1]) ** 2) / (.5 * self.top_um) ** 2)
        gap_um = plan.gap_um * (1 - near * min(1, depth_um / (plan.gap_um + .1)) * .9) + .3
        filled = np.clip((wall_um[:, n:] - gap_um) / GRID_UM + .5, 0, 1).astype(np.float32)
        path = self.projector.path(plan.zona_rad * (whole - inside) + plan.ooplasm_rad * filled, plan.defocus_um)
        # Grains move with the dimple.
        x, z = np.meshgrid(np.r_[-rho[::-1], rho], z)
        lag_um = depth_um * np.exp(-(x ** 2 + (z - self.top_um + depth_um) ** 2) / (.6 * self.top_um) ** 2)
        grains = cv2.remap(self.grains, (x / GRID_UM + n - .5).astype(np.float32), ((z + lag_um) / GRID_UM + n - .5).astype(np.float32),
                           cv2.INTER_LINEAR)
        ooplasm = mirrored(filled)
        path = path + grains * blurred(ooplasm, 1 / GRID_UM) * plan.grain_rad * .22
        return [blurred(field, plan.spread_um / GRID_UM) for field in (path, mirrored(whole - inside), ooplasm)]

    def outlines(self, depth_um):
        """Both faces of the zona as closed polygons, pixels."""
        if not self.specimen:
            return None
        return [self.place(closed(half)) for half in self.specimen.sections_at(depth_um)]

    def frame(self, tip_px, depth_um):
        plan, random = self.plan, self.random
        path = self.fixed + self.loose + self.placed(self.needle, self.needle_left_um, -MARGIN_UM, plan.axis_rad + plan.tilt_rad, tip_px)
        zona = ooplasm = None
        if self.specimen:
            if self.drawn_depth != depth_um:
                low_um, self.drawn_depth = -self.projector.count * GRID_UM, depth_um
                self.drawn = [self.placed(field, low_um, low_um, plan.axis_rad, self.center_px) for field in self.cell(depth_um)]
            cell, zona, ooplasm = self.drawn
            path = path + cell
        if plan.polar_body:
            at = self.place(np.array([[-.86, -.18]]) * (self.specimen.sections_um[0][:, 2].max() - 4))[0] * self.over
            path = path + sphere_chord_um(path.shape, at, 4.2, self.fine_um) * .2
        light = self.contrast.light(path, zona, ooplasm)
        light = cv2.resize(light, plan.size_px, interpolation=cv2.INTER_AREA) if self.over > 1 else light
        level = plan.level * self.lamp * light * random.normal(1, .004)      # the lamp flickers
        shot = plan.shot * np.sqrt(np.maximum(level, 1) / 150)
        level = level + random.normal(size=level.shape) * np.hypot(plan.noise, shot)
        return np.clip(np.round(level), 0, 255).astype(np.uint8)

    def frames(self):
        """As write_film takes them."""
        for tip_um, depth_um, force_uN, state in self.plan.path(self.specimen):
            tip_px = self.place(np.array([0.0, self.top_um - tip_um]))
            yield self.frame(tip_px, depth_um), tip_px, depth_um, force_uN, state, self.outlines(depth_um)


def catalogue(specimens, seed):
    """Plans of all films: a specimen each, in turns where there are too few."""
    random = np.random.default_rng(seed)
    chosen = random.permutation(len(specimens))
    plans = []
    for c, contrast in enumerate(CONTRASTS):
        for k in range(FILMS_EACH):
            specimen = specimens[chosen[(len(CONTRASTS) * k + c) % len(chosen)]]
            plans.append(Plan(f"{contrast}{k:02d}", k, contrast, random, specimen))
    for k, contrast in enumerate(CONTRASTS):
        plan = Plan(f"empty_{contrast}", k, contrast, random, (0, "", NO_CELL))
        plans.append(plan.without_cell(random, 0 if contrast == "relief" else 5))
    return plans


if __name__ == "__main__":
    draw_films(__doc__, LOOKED_AT_SEED, catalogue, Film)

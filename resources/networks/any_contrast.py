"""Pictures drawn from outlines alone, as no microscope makes them: any grey in any region, any profile across a boundary.

A network that has learnt one optical model has learnt its profiles too. Here the geometry is all that is kept of a sample:
each region has a grey value and a texture of its own, and across each boundary lies a sum, drawn at random, of a step, a
line, a pair of lines of opposite sign and a halo, the same all round or changing with the boundary's direction as relief
does; or the path of light through a shell or a tube, its slope or its curvature. The boundary is where the profile is
centred, or where the path begins.

Needs Debian's python3-opencv and python3-numpy.
"""
import cv2
import numpy as np

FINE = 1.25            # drawn pixels per network sample
MOST_PX = 1400         # of a drawn picture's side
SHIFT = 5              # bits of a polygon's corner below a pixel
MET = 0.43             # pixels that a polygon filled by OpenCV is too large, in the mean over its directions: it fills those its line meets


def outlines_of(path):
    """{file: {"outer" | "inner" | "needle" | "holder": points (2, n), px}} of a contours*.csv, without rows still being written."""
    found = {}
    with open(path) as file:
        for line in file:
            if line.endswith("\n"):
                name, which, *values = line.strip().split(",")
                found.setdefault(name, {})[which] = np.array(values, float).reshape(-1, 2).T
    return found


def area(points):
    """Of a closed polygon (2, n); above 0 where it runs from x to y."""
    x, y = points
    return 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)


def moved(outlines, a, b):
    """Points p of each outline (2, n) as a p + b."""
    return {key: a @ points + np.reshape(b, (2, 1)) for key, points in outlines.items()}


def any_needle(tip, way, half, behind, random):
    """Outline (2, n) of a needle that ends at `tip` and points along `way`, of any width about half width `half` and any
    end: cut off straight, rounded off, a half ball, or bevelled; its half width `behind` the tip, and its radius there."""
    half = min(25.0, half * np.exp(random.uniform(np.log(0.7), np.log(6))))
    taper = random.uniform(0, min(0.15, 0.8 * half / behind))
    radius = half - taper * behind
    end = random.choice(["straight", "rounded", "ball", "bevel"], p=[0.4, 0.25, 0.2, 0.15])
    corner = {"straight": 0.0, "rounded": random.uniform(0.1, 0.9), "ball": 1.0, "bevel": 0.0}[end] * radius
    turn = np.linspace(0, np.pi / 2, 12)
    back, aside = corner * (1 - np.cos(turn)), radius - corner + corner * np.sin(turn)
    far = np.linspace(1, 40, 20) * behind
    back, aside = np.r_[back, far], np.r_[aside, radius + taper * far]
    points = np.stack([np.r_[-back, -back[::-1]], np.r_[aside, -aside[::-1]]])  # along, across
    if end == "bevel":
        slope = random.uniform(0.5, 2.5) * random.choice([-1, 1])
        points[0] -= np.maximum(0, np.abs(slope) * radius + slope * points[1]) * (points[0] > -1e-9)
        points[1] += np.sign(slope) * radius  # the tip is its foremost corner
    across = np.array([-way[1], way[0]])
    return tip[:, None] + np.outer(way, points[0]) + np.outer(across, points[1]), half, radius


def drawn_anew(outlines, label, random, unit):
    """A picture (float, 0 to 255 for the most part) of the shape of `label`, in which 5 is another body. `outlines` in its pixels
    may lack any; `unit`: a network's sample in pixels."""
    h, w = label.shape
    fine = float(np.clip(FINE / unit, 0, MOST_PX / max(h, w)))
    size = (max(8, round(w * fine)), max(8, round(h * fine)))
    a = np.diag([size[0] / w, size[1] / h])
    b = 0.5 * np.diag(a) - 0.5  # the middle of a pixel is its place
    other = cv2.resize((label == 5).astype(np.uint8), size, interpolation=cv2.INTER_NEAREST)
    picture = Scene(size, moved(outlines, a, b), other, random, unit * fine).draw()
    return cv2.resize(picture, (w, h), interpolation=cv2.INTER_AREA if fine > 1 else cv2.INTER_LINEAR)


class Scene:
    """`unit`: a network's sample in pixels of the picture drawn."""

    def __init__(self, size, outlines, other, random, unit):
        self.size, self.outlines, self.other, self.random, self.unit = size, outlines, other, random, unit
        self.shear = random.uniform(0, 2 * np.pi)
        self.relief = random.choice([0.0, 1.0, random.uniform(0, 1)], p=[0.45, 0.3, 0.25])  # share that changes with direction
        self.focus = unit * np.exp(random.uniform(np.log(0.5), np.log(2.5)))  # blur common to all
        self.strength = random.uniform(15, 60)

    def draw(self):
        random = self.random
        picture = self.texture(random.uniform(0, 0.15)) + np.float32(random.normal(0, 0.2))
        if np.any(self.other):
            picture = self.with_body(picture, inside_of(self.other), 0.5)
        if "outer" in self.outlines:
            picture = self.with_cell(picture)
        for name in ("holder", "needle"):
            if name in self.outlines:
                picture = self.with_tool(picture, self.away(self.outlines[name]))
        return 128 + random.normal(0, 15) + self.strength * cv2.GaussianBlur(picture, (0, 0), max(0.4, 0.5 * self.focus))

    def chance(self, share):
        return self.random.random() < share

    def away(self, points):
        return away_from(points, self.size)

    def texture(self, strength):
        """Grain of two sizes."""
        w, h = self.size
        grain = np.zeros((h, w), np.float32)
        for _ in range(2):
            sigma = self.unit * np.exp(self.random.uniform(np.log(0.7), np.log(9)))
            step = max(1.0, sigma / 2)
            small = np.empty((max(2, int(h / step)), max(2, int(w / step))), np.float32)
            cv2.randn(small, 0, 1)
            small = cv2.GaussianBlur(small, (0, 0), sigma / step)
            grain += cv2.resize(small / (small.std() + 1e-3), (w, h), interpolation=cv2.INTER_LINEAR) * self.random.uniform(0, 1)
        return np.float32(strength) * grain

    def turning(self, away):
        """How a relief's contrast changes with a boundary's direction: 1 all round without relief."""
        if self.relief == 0:
            return 1.0
        smooth = cv2.GaussianBlur(away, (0, 0), 2 * self.unit)
        x, y = cv2.Sobel(smooth, cv2.CV_32F, 1, 0), cv2.Sobel(smooth, cv2.CV_32F, 0, 1)
        along = (np.cos(self.shear) * x + np.sin(self.shear) * y) / (np.hypot(x, y) + 1e-3)
        return (1 - self.relief) + self.relief * along

    def profile(self, away, least=0.0):
        """What a boundary adds to the picture."""
        random = self.random
        width = np.hypot(self.unit * np.exp(random.uniform(np.log(0.6), np.log(4))), 0.5 * self.focus)
        s = np.clip(away / np.float32(width), -12, 12)
        spot = np.exp(-0.5 * s * s)
        line, pair = random.normal(0, 0.8, 2) * (random.random(2) < 0.65)
        if abs(line) + abs(pair) < least:
            line = np.sign(random.normal()) * least
        added = (np.float32(line) + np.float32(1.6 * pair) * s) * spot
        if self.chance(0.25):  # rings of diffraction
            added = added + np.float32(random.normal(0, 0.3)) * spot * np.cos(2.2 * s)
        added = added * self.turning(away)
        if self.chance(0.3):  # a halo on one side or both
            reach = self.unit * np.exp(random.uniform(np.log(3), np.log(40)))
            halo = np.exp(-np.abs(away) / np.float32(reach))
            side = random.choice([0, 1, 2], p=[0.5, 0.3, 0.2])
            if side < 2:
                halo = halo * inner_share(away if side else -away, width)
            added = added + np.float32(random.normal(0, 0.6)) * halo
        return added

    def with_body(self, picture, away, least):
        """Over it a region of its own grey, its boundary's profile and texture."""
        share = inner_share(away, np.hypot(self.unit * np.exp(self.random.uniform(np.log(0.4), np.log(2.5))), 0.4 * self.focus))
        grey = np.float32(self.random.normal(0, 0.5) * self.chance(0.7))
        clear = np.float32(self.random.choice([1.0, self.random.uniform(0, 1)]))
        body = grey + self.texture(self.random.uniform(0, 0.4) * self.chance(0.7))
        return picture * (1 - share * (1 - clear)) + share * body + self.profile(away, least)

    def with_cell(self, picture):
        random = self.random
        outer = self.away(self.outlines["outer"])
        if self.chance(0.12):  # cumulus cells
            picture = self.with_blobs(picture, outer)
        picture = self.with_body(picture, outer, 0.35)
        if "inner" not in self.outlines:
            return picture
        inner = self.away(self.outlines["inner"])
        gap = -float(inner.min()) * random.uniform(0.01, 0.15) * self.chance(0.5)  # a perivitelline space
        if self.chance(0.35):
            picture = picture + self.path(outer, inner, inner + np.float32(gap) if gap and self.chance(0.7) else None)
            if self.chance(0.4):
                return picture
        picture = self.with_body(picture, inner, 0.0 if self.chance(0.25) else 0.3)
        if gap:
            picture = self.with_body(picture, inner + np.float32(gap), 0.2)
        for _ in range(random.integers(0, 3) * self.chance(0.4)):  # bodies in the cell
            r = -float(inner.min()) * random.uniform(0.05, 0.35)
            ys, xs = np.nonzero(inner < -1.1 * r)
            if len(xs):
                k = random.integers(len(xs))
                y, x = np.ogrid[:self.size[1], :self.size[0]]
                picture = self.with_body(picture, (np.hypot(x - xs[k], y - ys[k]) - r).astype(np.float32), 0.1)
        return picture

    def path(self, outer, inner, core=None):
        """The path of light through a body and one within it as if both were round, its slope, its curvature, or what it is
        above its surroundings; strong ones saturate."""
        r = max(4.0, -float(outer.min()))
        weights = self.random.normal(0, 1, 2)
        bodies = [(weights[0], outer), (weights[1], inner)]
        if core is not None:  # a shell, and within it a body of its own
            bodies = [(weights[0], outer), (-weights[0], inner), (weights[1], core)]
        path = sum(np.float32(weight) * np.sqrt(np.clip(-away * (2 * r + away), 0, None)) / r for weight, away in bodies)
        path = cv2.GaussianBlur(path.astype(np.float32), (0, 0), max(0.5, 0.6 * self.focus))
        x, y = cv2.Sobel(path, cv2.CV_32F, 1, 0), cv2.Sobel(path, cv2.CV_32F, 0, 1)
        way = self.random.choice(4)
        if way == 3:
            reach = self.unit * np.exp(self.random.uniform(np.log(6), np.log(40)))
            part = path - np.float32(self.random.uniform(0.5, 1)) * cv2.GaussianBlur(path, (0, 0), reach)
        else:
            part = (path, np.cos(self.shear) * x + np.sin(self.shear) * y, cv2.Laplacian(path, cv2.CV_32F))[way]
        part = part / np.float32(np.percentile(np.abs(part), 98) + 1e-3)
        if self.chance(0.3):
            part = np.tanh(part * np.float32(self.random.uniform(1, 2.5)))
        return part * np.float32(self.random.uniform(0.2, 1.2))

    def with_blobs(self, picture, outer):
        r = -float(outer.min())
        mask = np.zeros(self.size[::-1], np.uint8)
        ys, xs = np.nonzero((outer > 0) & (outer < 0.6 * r))
        if not len(xs):
            return picture
        for k in self.random.integers(0, len(xs), self.random.integers(3, 40)):
            cv2.circle(mask, (int(xs[k]), int(ys[k])), max(1, int(r * self.random.uniform(0.03, 0.12))), 1, -1)
        return self.with_body(picture, inside_of(mask), 0.2)

    def with_tool(self, picture, away):
        """A rod, hollow as a rule."""
        wall = np.float32(self.unit * np.exp(self.random.uniform(np.log(0.8), np.log(10))))
        is_hollow = self.chance(0.75)
        if self.chance(0.4):
            strength = np.float32(self.random.uniform(1, 2.5))
            picture = picture + strength * self.path(away, away + wall if is_hollow else np.full_like(away, 1e4))
            if self.chance(0.6):
                return picture
        picture = self.with_body(picture, away, 0.5)
        return self.with_body(picture, away + wall, 0.2) if is_hollow else picture


def inside_of(mask):
    """Signed distance from a mask's border, px, above 0 outside."""
    if not np.any(mask):
        return np.full(mask.shape, 1e4, np.float32)
    out = cv2.distanceTransform(1 - mask, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    within = cv2.distanceTransform(mask, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    return np.where(mask > 0, 0.5 - within, out - 0.5)


def away_from(points, size, over=1):
    """Signed distance from a closed polygon (2, n), px, above 0 outside; found on `over` times finer pixels."""
    mask = np.zeros((size[1] * over, size[0] * over), np.uint8)
    corners = np.round(np.clip((points.T + 0.5) * over - 0.5, -3e4, 3e4) * (1 << SHIFT)).astype(np.int32)
    cv2.fillPoly(mask, [corners], 1, cv2.LINE_8, SHIFT)
    away = inside_of(mask)
    if over > 1:
        away = cv2.resize(away, size, interpolation=cv2.INTER_AREA)
    return (away + np.float32(MET)) / over


def inner_share(away, width):
    """1 inside, 0 outside, a soft step between."""
    return 1 / (1 + np.exp(np.clip(np.float32(1.7 / width) * away, -30, 30)))


class Drawings:
    """Pictures drawn anew, each shown `REUSE` times in the mean among others, since drawing takes longer than learning."""
    REUSE, MOST = 5, 150

    def __init__(self):
        self.kept = []

    def pick(self, make, random):
        """A drawing kept, or what make() gives."""
        if len(self.kept) < 8 or random.random() < 1 / self.REUSE:
            made = make()
            if len(self.kept) < self.MOST:
                self.kept.append(made)
            else:
                self.kept[random.integers(self.MOST)] = made
            return made
        return self.kept[random.integers(len(self.kept))]

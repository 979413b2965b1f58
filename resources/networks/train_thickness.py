#!/usr/bin/python3
"""Trains the thickness network, which reads the ring of an image along a cell's outline and says how thick the zona
pellucida is, in any contrast, from all sides of the cell at once.

    build/release/bin/film_samples --count 4000 --split wide --first 2080001 --specimens tables --out wide
    build/release/bin/film_samples --count 1500 --split tuning --first 2090001 --specimens tables --out tuning
    python3 train_thickness.py wide,tuning thickness.onnx --minutes 45

Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning and wide families,
a tenth of them drawn from the samples' outlines alone (any_contrast.py).
The ring has NORMALS rows, evenly spaced along the outline, and COLUMNS samples from the outside to the inside, the outline
on sample ZERO; GUESS of them are the thickness as supposed. Its five planes: grey values (median 0, mean deviation 1), the
normal's x and y, how many pixels a sample takes (spacing_of in training.py), and the supposed thickness over the outline's radius
(curving_of). The answer: logits of the logarithm of the thickness over the supposed one, in BINS from LOW to HIGH.
"""
import cv2
import numpy as np
import torch
from torch import nn

from any_contrast import Drawings, area, drawn_anew, moved
from strips import evenly
from training import Block, Feed, Tables, arguments_of, export, normalised, sampled, spacing_of, train, varied

NORMALS, COLUMNS, ZERO, GUESS = 96, 64, 20, 14.0
BINS, LOW, HIGH, LABEL_SIGMA = 49, -1.2, 1.2, 0.03
NARROWEST = 0.03       # of a ring, in radii: a zona is not supposed thinner
ANEW = 0.1             # share of the pictures drawn from the outlines alone
STRETCHED = 0.4        # share of the rings whose zona is made thicker or thinner
AT_NEEDLE = np.cos(np.radians(50))  # normals that say nothing of the thickness at rest
REACH = 1.75           # kept of a picture about the cell, in radii


def curving_of(thickness, radius):
    """What the network is shown of how thick a shell the zona is supposed to be."""
    return float(np.clip(np.log2(thickness / radius) + 3, -3, 3)) / 2


class ThicknessNetwork(nn.Module):
    """Input (n, 5, NORMALS, COLUMNS), output (n, BINS)."""

    def __init__(self):
        super().__init__()
        self.look = nn.Sequential(Block(5, 24, stride=2, size=5), Block(24, 32), Block(32, 48, stride=2), Block(48, 48),
                                  Block(48, 64, stride=2), Block(64, 64), nn.Conv2d(64, 96, (1, COLUMNS // 8)), nn.ReLU())
        self.judge = nn.Sequential(nn.Linear(192, 64), nn.ReLU(), nn.Linear(64, BINS))

    def forward(self, x):
        x = self.look(x)
        return self.judge(torch.cat([x.mean((2, 3)), x.amax((2, 3))], 1))


def outward(points):
    """Unit normals (2, n) of a closed polygon of positive area."""
    along = np.roll(points, -1, 1) - np.roll(points, 1, 1)
    return np.stack([along[1], -along[0]]) / np.maximum(np.hypot(*along), 1e-9)


def thickness_of(outer, inner, way):
    """Median distance of the outer from the inner boundary away from the needle, px."""
    points = evenly(outer, 180)
    fine = evenly(inner, 1440)
    gaps = np.sqrt(((points[:, :, None] - fine[:, None, :]) ** 2).sum(0).min(1))
    if way is not None:
        from_middle = points - points.mean(1, keepdims=True)
        gaps = gaps[-(way @ from_middle) / np.hypot(*from_middle) < AT_NEEDLE]
    return float(np.median(gaps))


class Samples:
    """Pictures of cells: as much as lies about the cell, its outer boundary, thickness and radius, px, and what is needed to draw
    it anew: labels and outlines, of the first MOST_ANEW."""
    MOST_ANEW = 3000

    def __init__(self, folders):
        self.tables, self.items, self.shapes, self.drawings = Tables(folders), [], [], Drawings()
        self.load()

    def load(self):
        for path, row, outlines in self.tables.new():
            if not {"outer", "inner"} <= outlines.keys():
                continue
            image = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
            if image is None:
                continue
            outer, inner = (p if area(p) > 0 else p[:, ::-1] for p in (outlines["outer"], outlines["inner"]))
            middle, radius = outer.mean(1), np.sqrt(area(outer) / np.pi)
            inside = np.all((outer > 2) & (outer < np.array(image.shape[::-1])[:, None] - 3), 0)
            if np.mean(inside) < 0.6:
                continue
            way = np.array([float(row["direction_x"]), float(row["direction_y"])]) if row["tip_x_px"] else None
            thickness = thickness_of(outer, inner, way)
            low = np.maximum(np.floor(middle - REACH * radius).astype(int), 0)
            high = np.minimum(np.ceil(middle + REACH * radius).astype(int), image.shape[::-1])
            part = (slice(low[1], high[1]), slice(low[0], high[0]))
            item = (image[part].copy(), outer - low[:, None], thickness, radius)
            self.items.append(item)
            if len(self.shapes) < self.MOST_ANEW:
                label = cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
                if label is not None:
                    self.shapes.append((label[part].copy(), moved(outlines, np.eye(2), -low), *item[1:]))

    def anew(self, random):
        label, outlines, outer, thickness, radius = self.shapes[random.integers(len(self.shapes))]
        picture = drawn_anew(outlines, label, random, max(0.25, min(2.5, thickness / GUESS)))
        return np.clip(picture, 0, 255), outer, thickness, radius

    def pick(self, random):
        if self.shapes and random.random() < ANEW:
            return self.drawings.pick(lambda: self.anew(random), random)
        return self.items[random.integers(len(self.items))]

    def draw(self, random):
        image, outer, thickness, radius = self.pick(random)
        if random.random() < 0.5:
            image, outer = image[:, ::-1], np.stack([image.shape[1] - 1 - outer[0], outer[1]])[:, ::-1]
        wild = random.random() < 0.2
        guess = thickness * np.exp(np.clip(random.normal(0, 0.45 if wild else 0.13), -1, 1))
        guess = max(guess, NARROWEST * radius)
        stretch = np.exp(random.uniform(-0.18, 0.18)) if random.random() < STRETCHED else 1.0
        # An outline as it is followed: off as a whole, by a few harmonics, and by what each place is.
        points = evenly(outer, NORMALS, random.random())
        angle = np.arange(NORMALS) * 2 * np.pi / NORMALS
        coarse = 3.0 if random.random() < 0.15 else 1.0
        off = coarse * random.normal(0, 0.06 * guess + 0.15) + sum(
            coarse * random.normal(0, 0.04 * guess + 0.1) / k * np.cos(k * angle + random.uniform(0, 2 * np.pi)) for k in range(1, 7))
        guess *= stretch
        planes = ring_of(varied(image, guess / GUESS, random), points, radius, guess, random.uniform(0, 2 * np.pi),
                         lambda away: stretched(away + off[:, None], thickness, stretch))
        return planes, np.float32(np.log(stretch * thickness / guess))


def stretched(away, thickness, stretch):
    """Where to look in the picture for what is seen `away` px outside the outer boundary once the zona is `stretch` times as
    thick."""
    within = np.clip(-away, 0, stretch * thickness)
    return away + within - within / stretch


def ring_of(picture, points, radius, guess, turn=0.0, look_at=lambda away: away):
    """What the network sees along `points` (2, NORMALS) of a picture that is blurred for its samples, turned by `turn`, where
    `look_at` says where on a normal a sample lies, px outwards, by where it should."""
    normals = outward(points)
    spacing = guess / GUESS
    at = look_at(np.repeat((ZERO - np.arange(COLUMNS))[None] * spacing, NORMALS, 0))
    x, y = (points[k][:, None] + normals[k][:, None] * at for k in (0, 1))
    grey = normalised(sampled(picture, x, y))
    c, s = np.cos(turn), np.sin(turn)
    ways = [np.repeat(way[:, None], COLUMNS, 1) for way in (c * normals[0] - s * normals[1], s * normals[0] + c * normals[1])]
    planes = [grey, *ways, np.full_like(grey, spacing_of(spacing)), np.full_like(grey, curving_of(guess, radius))]
    return np.stack(planes).astype(np.float32)


def loss_of(logits, truth):
    place = torch.linspace(LOW, HIGH, BINS, device=logits.device)
    label = torch.exp(-0.5 * ((place - truth[:, None]) / LABEL_SIGMA) ** 2)
    label = label / label.sum(1, keepdim=True)
    logs = torch.log_softmax(logits, 1)
    off = ((torch.exp(logs) * place).sum(1) - truth).abs()
    return (-(label * logs).sum(1) + 2 * off).mean(), off.detach().median()


def main():
    options = arguments_of(__doc__, 45)
    samples = Samples(options.samples)
    network = ThicknessNetwork()
    train(network, options, samples, Feed(samples.draw, options.batch or 64, options.workers), loss_of)
    export(network, options.output, (1, 5, NORMALS, COLUMNS), "ring", "thickness")


if __name__ == "__main__":
    main()

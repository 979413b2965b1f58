#!/usr/bin/python3
"""Trains the boundary network, which reads the strip of normals along a rough outline of a cell and says on each normal
where the zona's outer and inner boundaries lie, in any contrast.

    build/release/bin/film_samples --count 3200 --first 20001 --out samples     (a test program of this project draws them)
    python3 train_boundary.py samples boundary.onnx --minutes 80

The network shipped was trained for 45 minutes of one core, then for 35 more with --start, at half the rate and with
narrower dents in the outlines (`rough` as it is now); 5,500 steps of 8 strips after the first 7,900.
Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning families only.
The strip has NORMALS rows, the first WRAP of which are repeated after the last and the last before the first, and
COLUMNS samples from the inside to the outside, RADIUS_SAMPLES of them to the outline's radius; the outline lies on
sample ZERO. Its four planes: grey values (median 0, mean deviation 1), the normal's x and y, and how many pixels a
sample takes (SPACING_OF of train and program alike).
"""
import os

import cv2
import numpy as np
import torch
from torch import nn

from any_contrast import Drawings, drawn_anew, moved
from training import UNetwork, arguments_of, export, normalised, outlines_in, sampled, spacing_of, train, varied

NORMALS, WRAP, COLUMNS, ZERO, RADIUS_SAMPLES = 128, 16, 96, 58, 160
LABEL_SIGMA = 1.0      # of the label's spot, samples
ON_INNER = 0.12        # share of the outlines that lie on the inner boundary
MOSTLY = 0.6           # of the normals must meet the outer boundary
ANEW, REACH = 0.15, 1.7 # share of the pictures drawn from the outlines alone; how far about the cell, in radii
TIGHT = 0.5            # share of the loss for the mean of the spot


def boundary_network(widths=(12, 24, 40, 56)):
    """Input (n, 4, NORMALS + 2 WRAP, COLUMNS), output (n, 2, NORMALS + 2 WRAP, COLUMNS): logits of the outer and the inner
    boundary's place on each normal."""
    stem = nn.Sequential(nn.Conv2d(4, widths[0], (3, 7), (1, 2), (1, 3), bias=False), nn.BatchNorm2d(widths[0]), nn.ReLU())
    return UNetwork(stem, widths, nn.ConvTranspose2d(widths[0], 2, (1, 4), (1, 2), (0, 1)))


def evenly(points, count):
    """`count` points (2, count) at equal arc lengths of a closed polygon (2, n)."""
    closed = np.hstack([points, points[:, :1]])
    length = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(closed)))])
    at = np.arange(count) * length[-1] / count
    return np.stack([np.interp(at, length, closed[0]), np.interp(at, length, closed[1])])


def outward(points):
    """Unit normals (2, n) of a closed polygon of positive area."""
    tangent = np.roll(points, -1, 1) - np.roll(points, 1, 1)
    normal = np.stack([tangent[1], -tangent[0]])
    return normal / np.maximum(np.hypot(*normal), 1e-9)


def area(points):
    x, y = points
    return 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)


def crossings(points, normals, polygon, reach):
    """Signed way along each normal to the polygon's crossing next to 0; NaN where none is within `reach`, low to high."""
    a, b = polygon, np.roll(polygon, -1, 1)
    d = b - a
    across = normals[0][:, None] * d[1] - normals[1][:, None] * d[0]
    w = a[:, None, :] - points[:, :, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        s = (w[0] * d[1] - w[1] * d[0]) / across
        t = (w[0] * normals[1][:, None] - w[1] * normals[0][:, None]) / across
    s = np.where((t >= 0) & (t < 1) & (s > reach[0]) & (s < reach[1]), s, np.inf)
    best = s[np.arange(len(s)), np.argmin(np.abs(s), 1)]
    return np.where(np.isfinite(best), best, np.nan)


class Samples:
    """Pictures of a folder that show a cell, with both boundaries; `load` takes in what has been added since."""

    def __init__(self, folder):
        self.folder, self.items, self.known, self.drawings = folder, [], set(), Drawings()
        self.load()

    def load(self):
        for name, outlines in outlines_in(self.folder).items():
            if name in self.known or "outer" not in outlines or "inner" not in outlines:
                continue
            path = os.path.join(self.folder, name)
            image, label = cv2.imread(path, cv2.IMREAD_GRAYSCALE), cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
            if image is None or label is None:
                continue
            self.known.add(name)
            for key in ("outer", "inner"):
                if area(outlines[key]) < 0:
                    outlines[key] = outlines[key][:, ::-1]
            self.items.append((image, label, outlines))

    def draw(self, random):
        item = self.items[random.integers(len(self.items))]
        if random.random() < ANEW:
            return strip_of(*self.drawings.pick(lambda: anew(*item, random), random), random)
        image, _, outlines = item
        return strip_of(image, outlines["outer"], outlines["inner"], random)


def anew(image, label, outlines, random):
    """The part about the cell of a picture of the same shapes, and the outer and the inner boundary in it."""
    outer, inner = outlines["outer"], outlines["inner"]
    middle, radius = outer.mean(1), np.sqrt(area(outer) / np.pi)
    low = np.maximum(np.floor(middle - REACH * radius).astype(int), 0)
    high = np.minimum(np.ceil(middle + REACH * radius).astype(int), image.shape[::-1])
    part = drawn_anew(moved(outlines, np.eye(2), -low), label[low[1]:high[1], low[0]:high[0]], random, radius / RADIUS_SAMPLES)
    return part, outer - low[:, None], inner - low[:, None]


def rough(outer, random):
    """An outline as detection may give it: wrong by an offset, a few harmonics, a dimple too many or too few."""
    points = evenly(outer, 4 * NORMALS)
    radius = np.sqrt(area(points) / np.pi)
    normal = outward(points)
    angle = np.arctan2(*(points - points.mean(1, keepdims=True))[::-1])
    coarse = 3.0 if random.random() < 0.25 else 1.0
    off = random.normal(0, 0.018 * coarse) * np.ones_like(angle)
    for k in range(1, 6):
        off += coarse * random.normal(0, 0.012) / np.sqrt(k) * np.cos(k * angle + random.uniform(0, 2 * np.pi))
    for _ in range(random.choice(4, p=[0.4, 0.3, 0.2, 0.1])):
        away = np.angle(np.exp(1j * (angle - random.uniform(-np.pi, np.pi))))
        width = np.exp(random.uniform(np.log(0.04), np.log(0.4)))
        off += random.uniform(-0.2, 0.2) * min(1.0, width / 0.08) * np.exp(-0.5 * (away / width) ** 2)
    if random.random() < 0.3:  # the outline without its own dimple: the circle through its far points
        middle = points.mean(1, keepdims=True)
        way = points - middle
        far = np.percentile(np.hypot(*way), 70)
        points = points + random.uniform(0.3, 1.0) * (middle + way * far / np.hypot(*way) - points)
    return points + np.clip(off, -0.19, 0.28) * radius * normal


def strip_of(image, outer, inner, random):
    # A detection may have taken the inner boundary for the outer one.
    outline = rough(inner if random.random() < ON_INNER else outer, random)
    if random.random() < 0.5:
        image, width = image[:, ::-1], image.shape[1]
        outline, outer, inner = (np.stack([width - 1 - p[0], p[1]])[:, ::-1] for p in (outline, outer, inner))
    radius = np.sqrt(abs(area(outline)) / np.pi)
    spacing = radius / RADIUS_SAMPLES
    points = np.roll(evenly(outline, NORMALS), random.integers(NORMALS), 1)
    normals = outward(points)
    reach = (-ZERO * spacing, (COLUMNS - 1 - ZERO) * spacing)
    truth = np.stack([crossings(points, normals, p, reach) for p in (outer, inner)]) / spacing + ZERO
    # Only what the strip needs.
    low = np.floor(points.min(1) + 2 * reach[0]).astype(int) - 8
    high = np.ceil(points.max(1) - 2 * reach[0]).astype(int) + 8
    low, high = np.maximum(low, 0), np.minimum(high, image.shape[::-1])
    if np.any(high - low < 16) or np.isfinite(truth[0]).mean() < MOSTLY:
        return None
    part = varied(image[low[1]:high[1], low[0]:high[0]], spacing, random)
    offsets = (np.arange(COLUMNS) - ZERO) * spacing
    # A picture may be turned: that is, its normals.
    angle = random.uniform(0, 2 * np.pi)
    seen = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]) @ normals
    wrapped = np.arange(-WRAP, NORMALS + WRAP) % NORMALS
    points, normals, seen, truth = points[:, wrapped], normals[:, wrapped], seen[:, wrapped], truth[:, wrapped]
    x = (points[0] - low[0])[:, None] + normals[0][:, None] * offsets
    y = (points[1] - low[1])[:, None] + normals[1][:, None] * offsets
    grey = sampled(part, x, y)
    plane = np.ones_like(grey)
    strip = np.stack([normalised(grey), plane * seen[0][:, None], plane * seen[1][:, None],
                      plane * spacing_of(spacing)])
    return strip.astype(np.float32), truth.astype(np.float32)


def loss_of(logits, truth):
    """Cross entropy with a spot at the truth, and how far the mean of the place is off, in samples."""
    known = torch.isfinite(truth)
    truth = torch.where(known, truth, torch.zeros_like(truth))
    place = torch.arange(COLUMNS, dtype=torch.float32, device=logits.device)
    label = torch.exp(-0.5 * ((place - truth[..., None]) / LABEL_SIGMA) ** 2)
    label = label / label.sum(-1, keepdim=True).clamp(min=1e-6)
    logs = torch.log_softmax(logits, -1)
    crossed = -(label * logs).sum(-1)
    mean = (torch.exp(logs) * place).sum(-1)
    off = (mean - truth).abs()
    weight = known.float() * torch.tensor([1.0, 0.5], device=logits.device)[None, :, None]
    total = weight.sum()
    return ((crossed + TIGHT * torch.minimum(off, 1 + 0.2 * off)) * weight).sum() / total, off[:, 0][known[:, 0]].detach().median()


def main():
    options = arguments_of(__doc__, 80)
    samples = Samples(options.samples)
    network = boundary_network()
    train(network, options, samples, samples.draw, 8, loss_of)
    export(network, options.output, (1, 4, NORMALS + 2 * WRAP, COLUMNS), "strip", "boundaries")


if __name__ == "__main__":
    main()

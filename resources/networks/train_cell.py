#!/usr/bin/python3
"""Trains the cell network, which looks at what lies within and about a circle and says whether that is a cell whose outer
boundary the circle follows; not a bubble, its halo, the end of a pipette, debris or nothing.

    build/release/bin/film_samples --split tuning --count 3000 --out samples      (a test program of this project draws them)
    build/release/bin/film_samples --split wide --first 110001 --count 9000 --empty yes --out samples
    python3 train_cell.py samples cell.onnx --minutes 25

Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning and wide families
only, some of them drawn from the samples' outlines alone (any_contrast.py).
The patch has SIDE samples each way, the circle in its middle, RADIUS_SAMPLES of them to its radius. Its two planes: grey
values (median 0, mean deviation 1), and how many pixels a sample takes. The answer: the logit of a cell.
"""

import cv2
import numpy as np
import torch
from torch import nn

from any_contrast import Drawings, drawn_anew, moved
from training import Block, Feed, Tables, arguments_of, export, normalised, other_look, spacing_of, train

SIDE, RADIUS_SAMPLES = 80, 25.0
HELD_OUT = 12          # every so manieth picture only checks
ANEW = 0.25            # share of the pictures drawn from the outlines alone
CELL_SHARE = 0.45      # of the patches
CACHE_SIDE = 720       # longest side of a sample kept in memory, pixels
MOUTH_REACH = 90       # of a holding pipette's end, pixels
LEAST_PX = 12.0        # radius of what is looked at


class CellNetwork(nn.Module):
    """Input (n, 2, SIDE, SIDE), output (n, 1): the logit of a cell."""

    def __init__(self):
        super().__init__()
        self.look = nn.Sequential(Block(2, 16, stride=2, size=5), Block(16, 24), Block(24, 32, stride=2), Block(32, 40),
                                  Block(40, 48, stride=2), Block(48, 48), Block(48, 48, stride=2), nn.Conv2d(48, 24, 1), nn.ReLU())
        self.judge = nn.Sequential(nn.Linear(24 * (SIDE // 16) ** 2, 48), nn.ReLU(), nn.Linear(48, 1))

    def forward(self, x):
        return self.judge(self.look(x).flatten(1))


class Item:
    """A picture: grey values, labels, outlines, the cell's centre and radius or none, and bubbles likewise; all px."""

    def __init__(self, image, label, outlines, cell, tip):
        self.image, self.label, self.outlines, self.cell, self.tip = image, label, outlines, cell, tip
        self.bubbles = bubbles_of(label) if cell is None else []
        self.mouth = mouth_of(label, outlines["holder"]) if "holder" in outlines else None


def mouth_of(label, outline):
    """A holding pipette's end, its middle half its width further back, and that half width; none where it isn't in view."""
    h, w = label.shape
    end = outline.T[np.argmin(np.hypot(outline[0] - w / 2, outline[1] - h / 2))]
    low = np.clip(end.astype(int) - MOUTH_REACH, 0, [w, h])
    high = np.clip(end.astype(int) + MOUTH_REACH, 0, [w, h])
    inside = (label[low[1]:high[1], low[0]:high[0]] == 4).astype(np.uint8)
    if np.count_nonzero(inside) < 100:
        return None
    away = cv2.distanceTransform(inside, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    half = float(away.max())
    # Of the places as far inside as any, the one nearest to the end.
    y, x = np.nonzero(away > 0.9 * half)
    middles = low + np.stack([x, y], 1)
    return end, middles[np.argmin(np.hypot(*(middles - end).T))].astype(float), half


def bubbles_of(label):
    """Centre and radius of each other body of a picture without cells."""
    count, _, stats, centres = cv2.connectedComponentsWithStats((label == 5).astype(np.uint8))
    return [(centres[k], float(max(stats[k][2], stats[k][3]) / 2)) for k in range(1, count) if stats[k][4] > 80]


class Samples:
    """Pictures of a folder; `load` takes in what has been added since."""

    def __init__(self, folders):
        self.tables, self.items, self.held_out = Tables(folders), [], []
        self.drawings = {kind: Drawings() for kind in (True, False)}
        self.load()

    def load(self):
        for path, row, outlines in self.tables.new():
            item = self.read(path, row, outlines)
            if item is None:
                continue
            (self.held_out if len(self.tables.known) % HELD_OUT == 0 else self.items).append(item)

    def read(self, path, row, outlines):
        image = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
        label = cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
        if image is None or label is None:
            return None
        ratio = min(1.0, CACHE_SIDE / max(image.shape))
        size = (round(image.shape[1] * ratio), round(image.shape[0] * ratio))
        image = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
        label = cv2.resize(label, size, interpolation=cv2.INTER_NEAREST)
        place = lambda a, b: np.array([float(row[a]), float(row[b])]) * ratio
        cell = (place("center_x_px", "center_y_px"), float(row["outer_radius_px"]) * ratio) if row["outer_radius_px"] else None
        tip = place("tip_x_px", "tip_y_px")
        is_inside = np.all(tip > 0) and np.all(tip < size)
        return Item(image, label, moved(outlines, ratio * np.eye(2), [0.5 * ratio - 0.5] * 2), cell, tip if is_inside else None)

    def pick(self, items, wants_cell, random):
        """One of them with a cell; or one of any, those without ten times as readily."""
        while True:
            item = items[random.integers(len(items))]
            if wants_cell and item.cell is None:
                continue
            if not wants_cell and item.cell is not None and random.random() < 0.9:
                continue
            return item

    def draw(self, random, items=None):
        items = items or self.items
        is_cell = random.random() < CELL_SHARE
        item = self.pick(items, is_cell, random)
        circle = cell_circle(item, random) if is_cell else other_circle(item, random)
        if circle[1] < LEAST_PX:
            return None
        turn = random.uniform(0, 2 * np.pi), random.random() < 0.5
        spacing = circle[1] / RADIUS_SAMPLES
        if items is self.items and random.random() < ANEW:
            picture = self.drawings[is_cell].pick(lambda: anew(item, circle, turn, random), random)
            picture = other_look(picture.copy(), 1.0, random)
        else:
            picture = patch(item.image, circle, turn, spacing, random)
        return (np.stack([normalised(picture), np.full((SIDE, SIDE), spacing_of(spacing))]).astype(np.float32),
                np.float32(is_cell))


def cell_circle(item, random):
    centre, radius = item.cell
    return centre + random.normal(0, 0.05, 2) * radius, radius * np.exp(random.normal(0, 0.05))


def other_circle(item, random):
    """A circle that is no cell's outline."""
    h, w = item.image.shape
    chance = random.random()
    if item.mouth and random.random() < 0.2:
        end, middle, half = item.mouth
        radius = half * np.exp(random.uniform(-0.3, 0.7))
        return middle + random.uniform(-0.5, 1.2) * (end - middle) + random.normal(0, 0.15, 2) * half, radius
    if item.cell is not None:
        centre, radius = item.cell
        if chance < 0.5:  # too wide or too small
            ratio = random.uniform(1.5, 2.3) if random.random() < 0.6 else random.uniform(0.3, 0.5)
            return centre + random.normal(0, 0.12, 2) * radius, ratio * radius
        way = random.uniform(0, 2 * np.pi)
        away = random.uniform(0.7, 2.2) * radius
        return centre + away * np.array([np.cos(way), np.sin(way)]), radius * np.exp(random.normal(0, 0.3))
    if item.bubbles and chance < 0.7:
        centre, radius = item.bubbles[random.integers(len(item.bubbles))]
        ratio = np.exp(random.normal(0, 0.12)) if random.random() < 0.5 else np.exp(random.uniform(-0.7, 1.3))
        return centre + random.normal(0, 0.1, 2) * radius * ratio, radius * ratio
    if item.tip is not None and chance < 0.85:
        return item.tip + random.normal(0, 10, 2), np.exp(random.uniform(np.log(12), np.log(90)))
    radius = np.exp(random.uniform(np.log(15), np.log(0.45 * min(h, w))))
    return random.uniform(0, 1, 2) * (w, h), radius


def frame_of(circle, turn, spacing):
    """Patch coordinates of a point of the picture: a p + b."""
    angle, is_mirrored = turn
    a = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]) / spacing
    if is_mirrored:
        a[:, 0] *= -1
    return a, np.full(2, (SIDE - 1) / 2) - a @ circle[0]


def patch(image, circle, turn, spacing, random):
    reach = int(np.ceil(spacing * SIDE * 0.75)) + 8
    low = np.maximum(np.floor(circle[0]).astype(int) - reach, 0)
    high = np.minimum(np.ceil(circle[0]).astype(int) + reach, image.shape[::-1])
    if np.any(high - low < 8):
        return np.zeros((SIDE, SIDE), np.float32)
    part = image[low[1]:high[1], low[0]:high[0]].astype(np.float32)
    if spacing > 1:
        part = cv2.GaussianBlur(part, (0, 0), 0.5 * spacing)
    a, b = frame_of((circle[0] - low, circle[1]), turn, spacing)
    seen = cv2.warpAffine(part, np.hstack([a, b[:, None]]), (SIDE, SIDE), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return other_look(seen, 1.0, random)


def anew(item, circle, turn, random):
    a, b = frame_of(circle, turn, circle[1] / RADIUS_SAMPLES)
    label = cv2.warpAffine(item.label, np.hstack([a, b[:, None]]), (SIDE, SIDE), flags=cv2.INTER_NEAREST, borderMode=cv2.BORDER_CONSTANT)
    return drawn_anew(moved(item.outlines, a, b), label, random, 1.0)


def loss_of(answer, truth):
    wrong = ((answer[:, 0] > 0) != (truth > 0.5)).float().mean()
    # No single picture is worth more than a confident answer to it: some patches can't be told.
    return nn.functional.binary_cross_entropy_with_logits(answer[:, 0], 0.98 * truth + 0.01), wrong


def main():
    options = arguments_of(__doc__, 25)
    samples = Samples(options.samples)
    network = CellNetwork()
    train(network, options, samples, Feed(samples.draw, options.batch or 32, options.workers), loss_of)
    with torch.no_grad():
        patches, truth = Feed(lambda random: samples.draw(random, samples.held_out), 6000).next("cpu")
        share = torch.sigmoid(network(patches)[:, 0]).numpy()
    truth = truth.numpy() > 0.5
    for least in (0.02, 0.05, 0.1, 0.2, 0.3, 0.5):
        print(f"held out, above {least}: cells {np.mean(share[truth] > least):.4f}, others {np.mean(share[~truth] > least):.4f}")
    export(network, options.output, (1, 2, SIDE, SIDE), "patch", "cell")


if __name__ == "__main__":
    main()

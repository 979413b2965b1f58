#!/usr/bin/python3
"""Trains the scene network, which labels each pixel of a micrograph: zona, inside of the cell, needle, holding pipette,
another body, background; and where the needle's tip is.

    build/release/bin/film_samples --count 4400 --out samples         (a test program of this project draws them)
    python3 train_scene.py samples scene.onnx --minutes 60

Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning families only;
the validation families stay unseen. The picture is scaled so that the cell covers 14 to 190 network pixels, turned,
mirrored, its grey values stretched, bent and inverted: nothing of polarity or brightness is left to learn. Half of
the pictures are drawn from the samples' outlines alone (any_contrast.py).
"""

import cv2
import numpy as np
import torch
from torch import nn

from any_contrast import SHIFT, Drawings, drawn_anew, moved
from training import Block, Feed, Tables, UNetwork, arguments_of, export, normalised, other_look, train

CLASSES = 6            # background, zona, inside, needle, holding pipette, other body
SIDE = 192             # of a training picture, network pixels
CACHE_SIDE = 720       # longest side of a sample kept in memory, pixels
ANEW = 0.5             # share of the pictures drawn from the outlines alone
TIP_SIGMA = 1.5        # of the tip's heat spot, output pixels
CLASS_WEIGHTS = [0.5, 2.0, 1.0, 2.5, 1.0, 1.0]


def scene_network(widths=(12, 20, 32, 48, 64)):
    """Input (n, 1, h, w), h and w multiples of 32; output (n, 7, h/2, w/2): logits of the six classes, then of the tip."""
    return UNetwork(Block(1, widths[0], stride=2, size=5), widths, nn.Conv2d(widths[0], CLASSES + 1, 1))


class Samples:
    """Pictures and labels of a folder; `load` takes in what has been added since."""

    def __init__(self, folders):
        self.tables, self.items, self.drawings = Tables(folders), [], Drawings()
        self.load()

    def load(self):
        for path, row, outlines in self.tables.new():
            self.items.append(self.read(path, row, outlines))

    def read(self, path, row, outlines):
        image = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
        label = cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
        ratio = min(1.0, CACHE_SIDE / max(image.shape))
        size = (round(image.shape[1] * ratio), round(image.shape[0] * ratio))
        image = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
        label = cv2.resize(label, size, interpolation=cv2.INTER_NEAREST)
        number = lambda key: float(row[key]) * ratio if row[key] else None
        outlines = moved(outlines, ratio * np.eye(2), [0.5 * ratio - 0.5] * 2)
        return (image, label, outlines, (number("tip_x_px"), number("tip_y_px")),
                (number("center_x_px"), number("center_y_px"), number("outer_radius_px")))

    def draw(self, random):
        if random.random() < ANEW:
            x, y, heat = self.drawings.pick(lambda: self.view(random, True), random)
        else:
            x, y, heat = self.view(random, False)
        return normalised(other_look(x, 1.0, random))[None], y, heat

    def view(self, random, is_anew):
        """A part of a sample as the network sees it, turned; labels and heat of the tip."""
        image, label, outlines, tip, cell = self.items[random.integers(len(self.items))]
        h, w = image.shape
        whole = SIDE / max(h, w)
        if cell[2] is not None and random.random() < 0.6:
            scale = np.exp(random.uniform(np.log(14), np.log(190))) / (2 * cell[2])
            middle = np.array(cell[:2]) + random.normal(0, 0.4, 2) * cell[2]
            if random.random() < 0.5:
                middle = random.uniform(0, 1, 2) * (w, h)
        else:
            scale = whole * random.uniform(0.9, 1.6)
            middle = np.array([w, h]) / 2 + random.normal(0, 0.15, 2) * (w, h)
        scale = min(scale, 3.0)
        angle = random.uniform(0, 2 * np.pi)
        a = scale * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        if random.random() < 0.5:
            a[:, 0] *= -1
        m = np.hstack([a, (np.array([SIDE, SIDE]) / 2 - a @ middle)[:, None]])
        # Beyond the picture there is nothing to draw but what an outline holds.
        border = cv2.BORDER_CONSTANT if is_anew else cv2.BORDER_REFLECT_101
        y = cv2.warpAffine(label, m, (SIDE, SIDE), flags=cv2.INTER_NEAREST, borderMode=border)
        if is_anew:
            outlines = moved(outlines, m[:, :2], m[:, 2])
            y = labels_of(outlines, y)
            x = drawn_anew(outlines, y, random, 1.0)
        else:
            if scale < 0.7:
                image = cv2.GaussianBlur(image, (0, 0), 0.42 / scale)
            x = cv2.warpAffine(image, m, (SIDE, SIDE), flags=cv2.INTER_LINEAR, borderMode=border).astype(np.float32)
        heat = np.zeros((SIDE // 2, SIDE // 2), np.float32)
        if tip[0] is not None and 0 <= tip[0] < w and 0 <= tip[1] < h:
            at = (m @ np.array([*tip, 1.0])) / 2
            u, v = np.meshgrid(np.arange(SIDE // 2), np.arange(SIDE // 2))
            heat = np.exp(-((u - at[0]) ** 2 + (v - at[1]) ** 2) / (2 * TIP_SIGMA ** 2)).astype(np.float32)
        return x, y[::2, ::2].astype(np.int64), heat


def labels_of(outlines, label):
    """The other bodies of a label picture, and what the outlines hold."""
    label = np.where(label == 5, np.uint8(5), np.uint8(0))
    for name, value in (("outer", 1), ("inner", 2), ("holder", 4), ("needle", 3)):
        if name in outlines:
            cv2.fillPoly(label, [np.round(outlines[name].T * (1 << SHIFT)).astype(np.int32)], value, cv2.LINE_8, SHIFT)
    return label


def loss_of(out, labels, heat):
    weights = torch.tensor(CLASS_WEIGHTS, device=out.device)
    # Weighted classes would come out more probable than they are.
    logits = out[:, :CLASSES] + torch.log(weights)[:, None, None]
    crossed = nn.functional.cross_entropy(logits, labels, weight=weights)
    share = torch.softmax(logits, 1)
    truth = nn.functional.one_hot(labels, CLASSES).permute(0, 3, 1, 2).float()
    both = (share * truth).sum((0, 2, 3))
    dice = 1 - ((2 * both + 1) / (share.sum((0, 2, 3)) + truth.sum((0, 2, 3)) + 1)).mean()
    tip = nn.functional.binary_cross_entropy_with_logits(out[:, CLASSES], heat, pos_weight=torch.tensor(20.0, device=out.device))
    return crossed + dice + 2 * tip, tip.detach()


def main():
    options = arguments_of(__doc__, 60)
    samples = Samples(options.samples)
    network = scene_network()
    train(network, options, samples, Feed(samples.draw, options.batch or 12, options.workers), loss_of)
    export(network, options.output, (1, 1, SIDE, 256), "picture", "scene")


if __name__ == "__main__":
    main()

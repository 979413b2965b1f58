#!/usr/bin/python3
"""Trains the boundary network, which reads the strip of normals along a rough outline of a cell and says on each normal
where the zona's outer and inner boundaries lie, in any contrast.

    build/release/bin/film_samples --count 3200 --first 20001 --out samples     (a test program of this project draws them)
    python3 train_boundary.py samples boundary.onnx --minutes 11 --batch 256 --workers 4

Pictures may be added to the folder meanwhile. A graphics processor reads some 2,300 strips a second, one core 20,
1.4 times as many with --bfloat16.
Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning and wide families only.
The strip has NORMALS rows, the first WRAP of which are repeated after the last and the last before the first, and
COLUMNS samples from the inside to the outside, RADIUS_SAMPLES of them to the outline's radius; the outline lies on
sample ZERO. Its four planes: grey values (median 0, mean deviation 1), the normal's x and y, and how many pixels a
sample takes (spacing_of in training.py).
"""
import itertools
import multiprocessing

import cv2
import numpy as np
import torch
from torch import nn

from any_contrast import area, drawn_anew, moved
from strips import COLUMNS, NORMALS, RADIUS_SAMPLES, WRAP, Pictures, drawn
from training import Tables, UNetwork, arguments_of, export, train

LABEL_SIGMA = 1.0      # of the label's spot, samples
REACH = 1.7            # how far about the cell a picture is drawn from its outlines, in radii
ANEW = 0.12            # share of the strips of such pictures
TIGHT = 0.5            # share of the loss for the mean of the spot
COMMON = 0.5           # and for what all normals are off together, which is what a thickness is wrong by
ENOUGH = 40            # normals that count as all
MOST_COMMON = 4.0      # samples


def boundary_network(widths=(18, 36, 60, 84)):
    """Input (n, 4, NORMALS + 2 WRAP, COLUMNS), output (n, 2, NORMALS + 2 WRAP, COLUMNS): logits of the outer and the inner
    boundary's place on each normal."""
    stem = nn.Sequential(nn.Conv2d(4, widths[0], (3, 7), (1, 2), (1, 3), bias=False), nn.BatchNorm2d(widths[0]), nn.ReLU())
    return UNetwork(stem, widths, nn.ConvTranspose2d(widths[0], 2, (1, 4), (1, 2), (0, 1)))


def pictures_in(tables):
    """Those that are new in the tables and show a cell: picture, label, outlines of positive area."""
    for path, _, outlines in tables.new():
        if not {"outer", "inner"} <= outlines.keys():
            continue
        image, label = cv2.imread(path, cv2.IMREAD_GRAYSCALE), cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
        if image is None or label is None:
            continue
        for key in ("outer", "inner"):
            if area(outlines[key]) < 0:
                outlines[key] = outlines[key][:, ::-1]
        yield image, label, outlines


def anew(label, outlines, random):
    """The part about the cell of a picture of the same shapes, of 8 bits, and the outer and the inner boundary in it."""
    outer, inner = outlines["outer"], outlines["inner"]
    middle, radius = outer.mean(1), np.sqrt(area(outer) / np.pi)
    low = np.maximum(np.floor(middle - REACH * radius).astype(int), 0)
    high = np.minimum(np.ceil(middle + REACH * radius).astype(int), label.shape[::-1])
    part = drawn_anew(moved(outlines, np.eye(2), -low), label[low[1]:high[1], low[0]:high[0]], random, radius / RADIUS_SAMPLES)
    return np.clip(part, 0, 255).astype(np.uint8), outer - low[:, None], inner - low[:, None]


class StripFeed:
    """Batches of strips of a folder's pictures, and of what is drawn anew from their outlines: by workers, or one a batch."""
    COARSE_EVERY = 8                  # batches, one of cells wider than the others, half as many
    MOST, MOST_COARSE, MOST_ANEW, OUTLINES = 50000, 3000, 20000, 400
    MOST_ON_CPU = 9000

    def __init__(self, folders, count, workers):
        self.tables, self.count, self.drawn = Tables(folders), count, 0
        self.items, self.shapes, self.fine, self.random = self.tables.known, [], None, np.random.default_rng(1)
        context = multiprocessing.get_context("fork")
        self.queue = context.Queue(64) if workers else None
        for seed in range(workers):
            context.Process(target=self.work, args=(seed + 2,), daemon=True).start()

    def work(self, seed):
        torch.set_num_threads(1)
        cv2.setRNGSeed(seed)
        random, shapes = np.random.default_rng(seed), []
        while True:
            if len(shapes) < self.OUTLINES:
                new = itertools.islice(pictures_in(self.tables), self.OUTLINES - len(shapes))
                shapes += [item[1:] for item in new]
            if shapes:
                self.queue.put(anew(*shapes[random.integers(len(shapes))], random))

    def begin(self, device):
        self.fine = Pictures(self.MOST if device.type == "cuda" else self.MOST_ON_CPU, 480, 640, device)
        self.coarse = Pictures(self.MOST_COARSE if device.type == "cuda" else 100, 1200, 1600, device)
        self.new = Pictures(self.MOST_ANEW if device.type == "cuda" else 500, 480, 640, device)

    def load(self):
        for image, label, outlines in pictures_in(self.tables):
            size = (outlines["outer"].max(1) - outlines["outer"].min(1)).max()
            for pictures, most_px in ((self.fine, 270), (self.coarse, 430)):
                if pictures.takes(image) and size < most_px:
                    pictures.add(image, outlines["outer"], outlines["inner"])
                    break
            if len(self.shapes) < self.OUTLINES:
                self.shapes.append((label, outlines))

    def draw_anew(self):
        if self.queue is None:
            pictures = [anew(*self.shapes[self.random.integers(len(self.shapes))], self.random)]
        else:
            pictures = [self.queue.get() for _ in range(self.queue.qsize())]
        for picture, outer, inner in pictures:
            if self.new.takes(picture):
                self.new.add(picture, outer, inner)

    @torch.no_grad()
    def next(self, device):
        """A batch: strips and the boundaries' places, as tensors."""
        if self.fine is None:
            self.begin(device)
            self.load()
        batches = self.drawn // self.count
        self.draw_anew()
        is_coarse = self.coarse.count > 0 and batches % self.COARSE_EVERY == self.COARSE_EVERY - 1
        new = round(ANEW * self.count) if self.new.count else 0
        parts = [drawn(self.coarse, max(1, (self.count - new) // 2), 608) if is_coarse else drawn(self.fine, self.count - new, 384)]
        if new:
            parts.append(drawn(self.new, new, 384))
        self.drawn += self.count
        return tuple(torch.cat(part) for part in zip(*parts))


def loss_of(logits, truth):
    """Cross entropy with a spot at the truth, how far the mean of the place is off, and all means together, in samples."""
    known = torch.isfinite(truth)
    truth = torch.where(known, truth, torch.zeros_like(truth))
    place = torch.arange(COLUMNS, dtype=torch.float32, device=logits.device)
    label = torch.exp(-0.5 * ((place - truth[..., None]) / LABEL_SIGMA) ** 2)
    label = label / label.sum(-1, keepdim=True).clamp(min=1e-6)
    logs = torch.log_softmax(logits, -1)
    crossed = -(label * logs).sum(-1)
    off = (torch.exp(logs) * place).sum(-1) - truth
    count = known.sum(2)
    common = ((off.clamp(-MOST_COMMON, MOST_COMMON) * known).sum(2) / count.clamp(min=1)).abs() * (count > ENOUGH)
    off = off.abs()
    weight = known.float() * torch.tensor([1.0, 0.5], device=logits.device)[None, :, None]
    single = ((crossed + TIGHT * torch.minimum(off, 1 + 0.2 * off)) * weight).sum() / weight.sum().clamp(min=1)
    return single + COMMON * common.mean(), off[:, 0][known[:, 0]].detach().median()


def main():
    options = arguments_of(__doc__, 80)
    feed = StripFeed(options.samples, options.batch or 16, options.workers)
    network = boundary_network()
    train(network, options, feed, feed, loss_of)
    export(network, options.output, (1, 4, NORMALS + 2 * WRAP, COLUMNS), "strip", "boundaries")


if __name__ == "__main__":
    main()

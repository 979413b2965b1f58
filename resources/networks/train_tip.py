#!/usr/bin/python3
"""Trains the tip network, which reads the patch of an image about the supposed tip of a needle, laid along the needle, and
says where in it the tip is, in any contrast.

    build/release/bin/film_samples --count 3200 --first 20001 --out samples     (a test program of this project draws them)
    build/release/bin/film_samples --count 4000 --split wide --first 140001 --punctured yes --out samples
    build/release/bin/film_samples --count 1800 --first 200001 --plain yes --out samples
    build/release/bin/film_samples --count 1500 --split wide --first 700001 --specimens tables --out fine    (fine tips)
    python3 train_tip.py samples,fine tip.onnx --minutes 90

Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning and wide families.
The patch has WIDTH samples along the needle, the supposed tip on sample AHEAD_OF, and HEIGHT across; WIDTH_SAMPLES of
them are the needle's half width, unless that is less than LEAST_PX or more than MOST_PX pixels a sample. --fine trains a
second network that looks at wide needles from nearer by; half of what it sees is drawn from outlines alone (any_contrast.py),
most of it with needles of any width and end. --quick trains a small one, for the frames between two readings by these. The two
planes: grey values (median 0, mean deviation 1), and how many pixels a sample takes. Some pictures show a droplet that
the needle has expelled.
"""

import numpy as np
import torch
from torch import nn

from training import Feed, TipSamples, UNetwork, arguments_of, export, normalised, sampled, spacing_of, train, varied

LABEL_SIGMA = 1.0
WITH_DROPLET = 0.12    # share of the pictures


def tip_network(widths):
    """Input (n, 2, HEIGHT, WIDTH), output (n, 1, HEIGHT, WIDTH): logits of the tip's place. A level for each of `widths`."""
    stem = nn.Sequential(nn.Conv2d(2, widths[0], 5, 2, 2, bias=False), nn.BatchNorm2d(widths[0]), nn.ReLU())
    return UNetwork(stem, widths, nn.ConvTranspose2d(widths[0], 1, 4, 2, 1))


class Samples(TipSamples):
    """How the whole end is looked at, and from how far off the tip may be supposed, along and across, in samples."""
    WIDTH, HEIGHT, AHEAD_OF, LEVELS = 96, 64, 56, (12, 24, 40, 56)
    WIDTH_SAMPLES, LEAST_PX, MOST_PX, ERROR = 5.0, 0.5, 3.0, (9, 3)
    ANEW = 0.0  # with half of them drawn anew, tips inside an ooplasm were read 4 um short

    def __init__(self, folder):
        super().__init__(folder, self.WIDTH_SAMPLES)

    def draw(self, random):
        image, tip, way, half, _ = self.pick(self.items, random)
        if random.random() < 0.5:
            image, width = image[:, ::-1], image.shape[1]
            tip, way = np.array([width - 1 - tip[0], tip[1]]), way * (-1, 1)
        spacing = float(np.clip(half * np.exp(random.normal(0, 0.25)) / self.WIDTH_SAMPLES, self.LEAST_PX, self.MOST_PX))
        wild = 2.0 if random.random() < 0.3 else 1.0
        angle = np.arctan2(way[1], way[0]) + random.normal(0, 0.02 * wild)
        way = np.array([np.cos(angle), np.sin(angle)])
        across = np.array([-way[1], way[0]])
        error = wild * random.normal(0, self.ERROR)
        error = np.clip(error, (-36, -26), (50, 26))
        at = tip + spacing * (error[0] * way + error[1] * across)
        back = tip - at
        truth = np.array([self.AHEAD_OF + back @ way / spacing, (self.HEIGHT - 1) / 2 + back @ across / spacing])
        if np.any((truth < 0) | (truth >= (self.WIDTH, self.HEIGHT))):
            return None
        reach = int(np.ceil(spacing * np.hypot(self.WIDTH, self.HEIGHT))) + 8
        low = np.maximum(np.floor(at).astype(int) - reach, 0)
        high = np.minimum(np.ceil(at).astype(int) + reach, image.shape[::-1])
        if np.any(high - low < 8):
            return None
        part = image[low[1]:high[1], low[0]:high[0]]
        if random.random() < WITH_DROPLET:
            part = with_droplet(part, tip - low, way, half, random)
        part = varied(part, spacing, random)
        u, v = np.meshgrid(np.arange(self.WIDTH) - self.AHEAD_OF, np.arange(self.HEIGHT) - (self.HEIGHT - 1) / 2)
        x, y = ((at - low)[k] + spacing * (u * way[k] + v * across[k]) for k in (0, 1))
        grey = normalised(sampled(part, x, y))
        return np.stack([grey, np.full_like(grey, spacing_of(spacing))]).astype(np.float32), truth.astype(np.float32)


class FineSamples(Samples):
    """The same from nearer by, once the tip is known to a few of the samples above."""
    WIDTH_SAMPLES, LEAST_PX, MOST_PX, ERROR = 12.0, 0.5, 1.5, (4, 3)
    ANEW, ANY_NEEDLE = 0.5, 0.7


class QuickSamples(Samples):
    """A small look, for tips that were read a few frames ago."""
    WIDTH, HEIGHT, AHEAD_OF, LEVELS = 64, 48, 40, (12, 20, 32)
    WIDTH_SAMPLES, LEAST_PX, MOST_PX, ERROR = 8.0, 0.5, 2.0, (4, 2)


def with_droplet(part, tip, way, half, random):
    """A picture in which the needle has expelled a droplet: a disc about its tip, with a rim of its own."""
    radius = half * np.exp(random.uniform(np.log(0.8), np.log(4)))
    y, x = np.mgrid[:part.shape[0], :part.shape[1]].astype(np.float32)
    centre = tip + random.uniform(0.1, 1.0) * radius * way
    away = np.hypot(x - centre[0], y - centre[1]) - np.float32(radius)
    width = np.float32(max(0.7, half * random.uniform(0.05, 0.3)))
    spread = part.std() + 3
    added = random.normal(0, 1.5) * np.exp(-0.5 * (away / width) ** 2) + random.normal(0, 0.5) / (1 + np.exp(np.clip(2 * away / width, -30, 30)))
    if random.random() < 0.5:  # behind the needle's outline
        along, across = (x - tip[0]) * way[0] + (y - tip[1]) * way[1], (y - tip[1]) * way[0] - (x - tip[0]) * way[1]
        added = added * np.where((along < 0) & (np.abs(across) < half), random.uniform(0, 1), 1)
    return (part + spread * added).astype(np.float32)


def loss_of(logits, truth):
    n, _, height, width = logits.shape
    u, v = (torch.arange(size, dtype=torch.float32, device=logits.device) for size in (width, height))
    v = v[:, None]
    spot = torch.exp(-0.5 * (((u - truth[:, 0, None, None]) ** 2 + (v - truth[:, 1, None, None]) ** 2)
                             / LABEL_SIGMA ** 2)).reshape(n, -1)
    logs = torch.log_softmax(logits.reshape(n, -1), 1)
    crossed = -(spot / spot.sum(1, keepdim=True).clamp(min=1e-6) * logs).sum(1)
    share = torch.exp(logs).reshape(n, height, width)
    mean = torch.stack([(share * u).sum((1, 2)), (share * v).sum((1, 2))], 1)
    off = (mean - truth).norm(dim=1)
    return (crossed + 0.5 * torch.minimum(off, 1 + 0.2 * off)).mean(), off.detach().median()


def main():
    options = arguments_of(__doc__, 30, {"fine": "the network that looks from nearer by (tip_fine.onnx)",
                                         "quick": "the small network for the frames between (tip_quick.onnx)"})
    samples = (FineSamples if options.fine else QuickSamples if options.quick else Samples)(options.samples)
    network = tip_network(samples.LEVELS)
    train(network, options, samples, Feed(samples.draw, options.batch or 16, options.workers), loss_of)
    export(network, options.output, (1, 2, samples.HEIGHT, samples.WIDTH), "patch", "tip")


if __name__ == "__main__":
    main()

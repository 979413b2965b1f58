#!/usr/bin/python3
"""Trains the tip width network, which reads the patch of an image about a needle's tip, laid along the needle, and says how
wide the needle is there, in any contrast, and how surely.

    build/release/bin/film_samples --count 3600 --first 80041 --out samples     (a test program of this project draws them)
    build/release/bin/film_samples --count 800 --first 90001 --plain yes --out samples
    build/release/bin/film_samples --count 1500 --split wide --first 700001 --specimens tables --out fine    (fine tips)
    python3 train_tip_width.py samples,fine tip_width.onnx --minutes 25

Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning and wide families,
a third of them drawn from the samples' outlines alone (any_contrast.py).
The patch has WIDTH samples along the needle, the tip on sample AHEAD_OF, and HEIGHT across; WIDTH_SAMPLES of them are
the needle's half width some way behind, unless that is less than LEAST_PX or more than MOST_PX pixels a sample. Its two
planes: grey values (median 0, mean deviation 1), and how many pixels a sample takes. The answer: the logarithm of half
the width at the tip in samples, and that of its standard deviation.
"""

import numpy as np
import torch
from torch import nn

from training import Block, Feed, TipSamples, arguments_of, export, normalised, sampled, spacing_of, train, varied

WIDTH, HEIGHT, AHEAD_OF = 80, 48, 56
WIDTH_SAMPLES, LEAST_PX, MOST_PX = 7.0, 0.4, 3.0
HELD_OUT = 12   # every so manieth picture only checks


class WidthNetwork(nn.Module):
    """Input (n, 2, HEIGHT, WIDTH), output (n, 2): mean and logarithm of the standard deviation."""

    def __init__(self):
        super().__init__()
        self.look = nn.Sequential(Block(2, 16, stride=2, size=5), Block(16, 24), Block(24, 32, stride=2), Block(32, 32),
                                  Block(32, 48, stride=2), Block(48, 48), nn.Conv2d(48, 16, 1), nn.ReLU())
        self.judge = nn.Sequential(nn.Linear(16 * (HEIGHT // 8) * (WIDTH // 8), 48), nn.ReLU(), nn.Linear(48, 2))

    def forward(self, x):
        return self.judge(self.look(x).flatten(1))


class Samples(TipSamples):
    ANEW = 0.35  # share of the pictures drawn from the outlines alone

    def keep(self, item):
        (self.held_out if len(self.tables.known) % HELD_OUT == 0 else self.items).append(item)

    def draw(self, random, items=None):
        image, tip, way, half, radius = self.pick(items or self.items, random)
        if random.random() < 0.5:
            image, width = image[:, ::-1], image.shape[1]
            tip, way = np.array([width - 1 - tip[0], tip[1]]), way * (-1, 1)
        spacing = float(np.clip(half * np.exp(random.normal(0, 0.25)) / WIDTH_SAMPLES, LEAST_PX, MOST_PX))
        angle = np.arctan2(way[1], way[0]) + random.normal(0, 0.015)
        way = np.array([np.cos(angle), np.sin(angle)])
        across = np.array([-way[1], way[0]])
        wild = 4.0 if random.random() < 0.15 else 1.0
        error = np.array([random.normal(0, 1.3 * wild), random.normal(0, 0.6 * wild)])
        at = tip + spacing * (error[0] * way + error[1] * across)
        reach = int(np.ceil(spacing * np.hypot(WIDTH, HEIGHT))) + 8
        low = np.maximum(np.floor(at).astype(int) - reach, 0)
        high = np.minimum(np.ceil(at).astype(int) + reach, image.shape[::-1])
        if np.any(high - low < 8):
            return None
        part = varied(image[low[1]:high[1], low[0]:high[0]], spacing, random)
        u, v = np.meshgrid(np.arange(WIDTH) - AHEAD_OF, np.arange(HEIGHT) - (HEIGHT - 1) / 2)
        x, y = ((at - low)[k] + spacing * (u * way[k] + v * across[k]) for k in (0, 1))
        grey = normalised(sampled(part, x, y))
        planes = np.stack([grey, np.full_like(grey, spacing_of(spacing))]).astype(np.float32)
        return planes, np.float32(np.log(radius / spacing))


def loss_of(answer, truth):
    sigma_log = answer[:, 1].clamp(-3.5, 1.0)
    off = (answer[:, 0] - truth).abs() * torch.exp(-sigma_log)
    # Normal near by, and no single picture decides: beyond two standard deviations it grows in proportion.
    return (torch.where(off < 2, 0.5 * off ** 2, 2 * off - 2) + sigma_log).mean(), (answer[:, 0] - truth).detach().abs().median()


def main():
    options = arguments_of(__doc__, 25)
    samples = Samples(options.samples, WIDTH_SAMPLES)
    network = WidthNetwork()
    train(network, options, samples, Feed(samples.draw, options.batch or 24, options.workers), loss_of)
    with torch.no_grad():
        patches, truth = Feed(lambda random: samples.draw(random, samples.held_out), 2000).next("cpu")
        answer = network(patches)
        off = (answer[:, 0] - truth).numpy()
        sigma = torch.exp(answer[:, 1].clamp(-3.5, 1.0)).numpy()
    print(f"held out: off {np.mean(off):.3f} +- {np.std(off):.3f}, median {np.median(np.abs(off)):.3f}; over its own "
          f"sigma (median {np.median(sigma):.3f}): {np.std(off / sigma):.2f}")
    export(network, options.output, (2, 2, HEIGHT, WIDTH), "patch", "width")


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Trains the puncture network, which reads the patch of an image about a needle's tip that is past a cell's resting
outline and says where along the needle the membrane crosses it, in any contrast: at the tip while the needle pushes, near
the resting outline once the membrane has given way.

    build/release/bin/film_samples --count 1500 --split wide --first 2150001 --pushed yes --out pushed
    build/release/bin/film_samples --count 5000 --split wide --first 2121001 --punctured soon --out soon
    python3 train_puncture.py pushed,soon puncture.onnx --minutes 30

Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning and wide families.
The patch has SIZE samples along the needle, the tip on sample TIP, and SIZE across; DEPTH of them are the tip's depth
past the resting outline, unless that is less than LEAST_PX or more than MOST_PX pixels a sample. Its three planes: grey
values (median 0, mean deviation 1), how many pixels a sample takes, and how far each sample lies within the resting
outline, over the tip's depth. The answer: logits of the membrane's depth as a share of the tip's, in BINS from LOW to HIGH.
"""
import cv2
import numpy as np
import torch
from torch import nn

from training import Block, Feed, Tables, arguments_of, export, normalised, sampled, spacing_of, train, varied

SIZE, TIP, DEPTH = 64, 40, 16.0
LEAST_PX, MOST_PX, LEAST_DEPTH_PX = 0.35, 4.0, 1.5
BINS, LOW, HIGH, LABEL_SIGMA = 24, 0.0, 1.15, 0.04
MOST_WITHIN = 2.0
REACH_DEPTHS, LEAST_REACH_PX, MOST_REACH_PX = 4.2, 40, 460  # kept of a picture about the tip


class PunctureNetwork(nn.Module):
    """Input (n, 3, SIZE, SIZE), output (n, BINS)."""

    def __init__(self):
        super().__init__()
        self.look = nn.Sequential(Block(3, 16, stride=2, size=5), Block(16, 24, stride=2), Block(24, 24), Block(24, 40, stride=2),
                                  Block(40, 40), Block(40, 48, stride=2), nn.Conv2d(48, 24, 1), nn.ReLU())
        self.judge = nn.Sequential(nn.Linear(24 * (SIZE // 16) ** 2, 64), nn.ReLU(), nn.Linear(64, BINS))

    def forward(self, x):
        return self.judge(self.look(x).flatten(1))


class Samples:
    """Pictures of cells with the needle past the resting outline: as much as lies about the tip, tip, direction, centre, px,
    and the depths of tip and membrane, px."""

    def __init__(self, folders):
        self.tables, self.items = Tables(folders), []
        self.load()

    def load(self):
        for path, row, _ in self.tables.new():
            if not row["tip_depth_px"] or float(row["tip_depth_px"]) < LEAST_DEPTH_PX:
                continue
            image = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
            tip, way, centre = (np.array([float(row[a]), float(row[b])]) for a, b in
                                (("tip_x_px", "tip_y_px"), ("direction_x", "direction_y"), ("center_x_px", "center_y_px")))
            depth, membrane = float(row["tip_depth_px"]), float(row["membrane_depth_px"])
            if image is None or np.any(tip < 2) or np.any(tip > np.array(image.shape[::-1]) - 3):
                continue
            reach = np.clip(REACH_DEPTHS * depth, LEAST_REACH_PX, MOST_REACH_PX)
            low = np.maximum(np.floor(tip - reach).astype(int), 0)
            high = np.minimum(np.ceil(tip + reach).astype(int), image.shape[::-1])
            self.items.append((image[low[1]:high[1], low[0]:high[0]].copy(), tip - low, way / np.hypot(*way), centre - low, depth,
                               min(membrane, depth)))

    def draw(self, random):
        image, tip, way, centre, depth, membrane = self.items[random.integers(len(self.items))]
        if random.random() < 0.5:
            image, width = image[:, ::-1], image.shape[1]
            tip, centre = (np.array([width - 1 - p[0], p[1]]) for p in (tip, centre))
            way = way * (-1, 1)
        wild = 3.0 if random.random() < 0.1 else 1.0
        seen = max(depth * (1 + 0.03 * wild * random.normal()) + wild * random.normal(0, 0.35), 0.7 * depth, LEAST_DEPTH_PX)
        angle = np.arctan2(way[1], way[0]) + random.normal(0, 0.012)
        way = np.array([np.cos(angle), np.sin(angle)])
        across = np.array([-way[1], way[0]])
        # The tip is off, and its depth with it.
        off = wild * random.normal(0, 0.35)
        at = tip + off * way + random.normal(0, 0.2) * across
        seen = max(seen + off, LEAST_DEPTH_PX)
        truth = 1 - (depth - membrane + off) / seen
        spacing = float(np.clip(seen * np.exp(random.normal(0, 0.06)) / DEPTH, LEAST_PX, MOST_PX))
        return planes_of(image, at, way, centre, seen, spacing, random), np.float32(truth)


def planes_of(image, at, way, centre, depth, spacing, random):
    across = np.array([-way[1], way[0]])
    reach = int(np.ceil(spacing * 1.45 * TIP)) + 8
    low = np.maximum(np.floor(at).astype(int) - reach, 0)
    high = np.minimum(np.ceil(at).astype(int) + reach, image.shape[::-1])
    part = varied(image[low[1]:high[1], low[0]:high[0]], spacing, random)
    u, v = np.meshgrid(np.arange(SIZE) - TIP, np.arange(SIZE) - (SIZE - 1) / 2)
    x, y = ((at - low)[k] + spacing * (u * way[k] + v * across[k]) for k in (0, 1))
    grey = normalised(sampled(part, x, y))
    entry = at - depth * way
    within = (np.hypot(*(entry - centre)) - np.hypot(x + low[0] - centre[0], y + low[1] - centre[1])) / depth
    return np.stack([grey, np.full_like(grey, spacing_of(spacing)), np.clip(within, -MOST_WITHIN, MOST_WITHIN)]).astype(np.float32)


def loss_of(logits, truth):
    place = torch.linspace(LOW, HIGH, BINS, device=logits.device)
    truth = truth.clamp(LOW, HIGH)
    label = torch.exp(-0.5 * ((place - truth[:, None]) / LABEL_SIGMA) ** 2)
    label = label / label.sum(1, keepdim=True)
    logs = torch.log_softmax(logits, 1)
    off = (torch.exp(logs) * place).sum(1) - truth
    return (-(label * logs).sum(1) + off.abs()).mean(), off.detach().abs().median()


def main():
    options = arguments_of(__doc__, 30)
    samples = Samples(options.samples)
    network = PunctureNetwork()
    train(network, options, samples, Feed(samples.draw, options.batch or 32, options.workers), loss_of)
    export(network, options.output, (1, 3, SIZE, SIZE), "patch", "share")


if __name__ == "__main__":
    main()

"""What the scripts that train the networks share: layers, pictures made various, and the loop.

Needs Debian's python3-torch, python3-opencv and python3-numpy.
"""
import argparse
import csv
import glob
import os
import time

import cv2
import numpy as np
import torch
from torch import nn

REDUCING_BLUR = 0.42   # before samples further apart than a pixel, in samples


class Block(nn.Sequential):
    def __init__(self, inputs, outputs, stride=1, size=3):
        super().__init__(nn.Conv2d(inputs, outputs, size, stride, size // 2, bias=False), nn.BatchNorm2d(outputs),
                         nn.ReLU())


class UNetwork(nn.Module):
    """`stem`, a U of as many levels as there are `widths`, and `out`."""

    def __init__(self, stem, widths, out):
        super().__init__()
        self.stem, self.out = stem, out
        self.first = Block(widths[0], widths[0])
        self.down = nn.ModuleList(
            nn.Sequential(Block(a, b, stride=2), Block(b, b)) for a, b in zip(widths, widths[1:]))
        self.up = nn.ModuleList(Block(a + b, a) for a, b in reversed(list(zip(widths, widths[1:]))))

    def forward(self, x):
        x = self.first(self.stem(x))
        kept = [x]
        for down in self.down:
            x = down(x)
            kept.append(x)
        for up, skip in zip(self.up, kept[-2::-1]):
            x = up(torch.cat([nn.functional.interpolate(x, scale_factor=2.0, mode="nearest"), skip], 1))
        return self.out(x)


def normalised(picture):
    """Zero median, unit spread (mean absolute deviation), as the program does before it asks a network."""
    x = picture.astype(np.float32)
    x -= np.median(x)
    return np.clip(x / (np.abs(x).mean() + 1e-3), -6, 6)


def spacing_of(spacing_px):
    """What a network is shown of how finely a picture is sampled."""
    return float(np.clip(np.log2(spacing_px), -3, 3)) / 2


def varied(part, spacing_px, random):
    """A part of a picture with other greys, blur and noise, then blurred for samples `spacing_px` apart."""
    part = np.ascontiguousarray(part).astype(np.float32)
    if random.random() < 0.2:
        part = 255 - part
    if random.random() < 0.3:
        part = 255 * (np.clip(part, 0, 255) / 255) ** np.float32(np.exp(random.uniform(-0.5, 0.5)))
    if random.random() < 0.3:
        part = cv2.GaussianBlur(part, (0, 0), random.uniform(0.3, 1.0))
    if random.random() < 0.5:
        part = part + cv2.randn(np.empty_like(part), 0, random.uniform(0, 5))
    if spacing_px > 1:
        part = cv2.GaussianBlur(part, (0, 0), REDUCING_BLUR * spacing_px)
    return part


def sampled(part, x, y):
    return cv2.remap(part, x.astype(np.float32), y.astype(np.float32), cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)


def rows_of(folder):
    """The rows of the samples*.csv of a folder that are whole."""
    for path in sorted(glob.glob(os.path.join(folder, "samples*.csv"))):
        with open(path) as file:
            yield from (row for row in csv.DictReader(file) if row["frame"] is not None)


class TipSamples:
    """Pictures of a folder that show a needle's tip, each with its tip, direction, half width some way behind and radius at the
    tip, px; `load` takes in what has been added since."""

    def __init__(self, folder):
        self.folder, self.items, self.held_out, self.known = folder, [], [], set()
        self.load()

    def load(self):
        for row in rows_of(self.folder):
            if row["file"] not in self.known:
                self.known.add(row["file"])
                self.read(row)

    def read(self, row):
        tip, way = (np.array([float(row[a]), float(row[b])]) for a, b in
                    (("tip_x_px", "tip_y_px"), ("direction_x", "direction_y")))
        path = os.path.join(self.folder, row["file"])
        image, label = cv2.imread(path, cv2.IMREAD_GRAYSCALE), cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
        if image is None or label is None or np.any(tip < 2) or np.any(tip > np.array(image.shape[::-1]) - 3):
            return
        way = way / np.hypot(*way)
        across = np.array([-way[1], way[0]])
        behind = tip - 0.05 * max(image.shape) * way
        line = behind + np.arange(-60, 60.5, 0.5)[:, None] * across
        x, y = np.round(line).astype(int).T
        inside = (x >= 0) & (y >= 0) & (x < image.shape[1]) & (y < image.shape[0])
        half = 0.25 * np.count_nonzero(label[y[inside], x[inside]] == 3)
        if half >= 0.5:
            self.keep((image, tip, way, half, float(row["tip_radius_px"])))

    def keep(self, item):
        self.items.append(item)


def draw_batch(draw, is_usable, count):
    """`count` samples that are usable, of draw(): inputs and truths as tensors."""
    drawn = []
    while len(drawn) < count:
        one = draw()
        if one is not None and is_usable(one):
            drawn.append(one)
    return tuple(torch.from_numpy(np.stack(part)) for part in zip(*drawn))


def arguments_of(text, minutes):
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples")
    parser.add_argument("output")
    parser.add_argument("--minutes", type=float, default=minutes)
    parser.add_argument("--start", help="weights to go on from (.pt)")
    parser.add_argument("--rate", type=float, default=4e-3)
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    torch.set_num_threads(options.threads)
    torch.manual_seed(1)
    cv2.setNumThreads(1)
    cv2.setRNGSeed(1)
    return options


def train(network, options, samples, loss_of_batch):
    """Steps until the time is up, at a rate that falls; `loss_of_batch()`: the loss, and a figure to be printed."""
    print(f"{len(samples.items)} samples, {sum(p.numel() for p in network.parameters())} parameters", flush=True)
    if options.start:
        network.load_state_dict(torch.load(options.start))
    optimiser = torch.optim.AdamW(network.parameters(), lr=options.rate, weight_decay=1e-4)
    begin, step, losses, figures = time.time(), 0, [], []
    while (share := (time.time() - begin) / (60 * options.minutes)) < 1:
        for group in optimiser.param_groups:
            group["lr"] = options.rate * min(1, (step + 1) / 50) * (0.5 + 0.5 * np.cos(np.pi * share)) + 1e-5
        loss, figure = loss_of_batch()
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimiser.step()
        losses.append(loss.item())
        figures.append(figure)
        step += 1
        if step % 100 == 0:
            samples.load()
            print(f"step {step}  {time.time() - begin:.0f} s  loss {np.mean(losses[-100:]):.3f}  "
                  f"median off {np.mean(figures[-100:]):.2f}  {len(samples.items)} samples", flush=True)
            torch.save(network.state_dict(), options.output[:-5] + ".pt")
    network.eval()
    torch.save(network.state_dict(), options.output[:-5] + ".pt")


def export(network, path, shape, input_name, output_name):
    torch.onnx.export(network, torch.zeros(*shape), path, opset_version=11, input_names=[input_name],
                      output_names=[output_name])

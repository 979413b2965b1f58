#!/usr/bin/python3
"""Trains the tip network, which reads the patch of an image about the supposed tip of a needle, laid along the needle, and
says where in it the tip is, in any contrast.

    build/release/bin/film_samples --count 3200 --first 20001 --out samples     (a test program of this project draws them)
    python3 train_tip.py samples tip.onnx --minutes 30

Needs Debian's python3-torch, python3-opencv and python3-numpy. Trained on drawn pictures of the tuning families only.
The patch has WIDTH samples along the needle, the supposed tip on sample AHEAD_OF, and HEIGHT across; WIDTH_SAMPLES of
them are the needle's half width, unless that is less than LEAST_PX or more than MOST_PX pixels a sample. Its two
planes: grey values (median 0, mean deviation 1), and how many pixels a sample takes.
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

from train_boundary import BoundaryNetwork, REDUCING_BLUR, spacing_of
from train_scene import normalised

WIDTH, HEIGHT, AHEAD_OF = 96, 64, 56
WIDTH_SAMPLES, LEAST_PX, MOST_PX = 5.0, 0.5, 3.0
LABEL_SIGMA = 1.0


class TipNetwork(BoundaryNetwork):
    """Input (n, 2, HEIGHT, WIDTH), output (n, 1, HEIGHT, WIDTH): logits of the tip's place."""

    def __init__(self, widths=(12, 24, 40, 56)):
        super().__init__(widths)
        self.stem = nn.Sequential(nn.Conv2d(2, widths[0], 5, 2, 2, bias=False), nn.BatchNorm2d(widths[0]), nn.ReLU())
        self.out = nn.ConvTranspose2d(widths[0], 1, 4, 2, 1)


class Samples:
    """Pictures of a folder that show a needle's tip; `load` takes in what has been added since."""

    def __init__(self, folder):
        self.folder, self.items, self.known = folder, [], set()
        self.load()

    def load(self):
        for path in sorted(glob.glob(os.path.join(self.folder, "samples*.csv"))):
            with open(path) as file:
                for row in csv.DictReader(file):
                    if row["frame"] is not None and row["file"] not in self.known:
                        self.known.add(row["file"])
                        self.read(row)

    def read(self, row):
        tip, way = (np.array([float(row[a]), float(row[b])]) for a, b in
                    (("tip_x_px", "tip_y_px"), ("direction_x", "direction_y")))
        path = os.path.join(self.folder, row["file"])
        image, label = cv2.imread(path, cv2.IMREAD_GRAYSCALE), cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
        if image is None or label is None:
            return
        if np.any(tip < 2) or np.any(tip > np.array(image.shape[::-1]) - 3):
            return
        way = way / np.hypot(*way)
        across = np.array([-way[1], way[0]])
        behind = tip - 0.05 * max(image.shape) * way
        line = behind + np.arange(-60, 60.5, 0.5)[:, None] * across
        x, y = np.round(line).astype(int).T
        inside = (x >= 0) & (y >= 0) & (x < image.shape[1]) & (y < image.shape[0])
        half = 0.25 * np.count_nonzero(label[y[inside], x[inside]] == 3)
        if half >= 0.5:
            self.items.append((image, tip, way, half))

    def draw(self, random):
        image, tip, way, half = self.items[random.integers(len(self.items))]
        if random.random() < 0.5:
            image, width = image[:, ::-1], image.shape[1]
            tip, way = np.array([width - 1 - tip[0], tip[1]]), way * (-1, 1)
        spacing = float(np.clip(half * np.exp(random.normal(0, 0.25)) / WIDTH_SAMPLES, LEAST_PX, MOST_PX))
        wild = 2.0 if random.random() < 0.3 else 1.0
        angle = np.arctan2(way[1], way[0]) + random.normal(0, 0.02 * wild)
        way = np.array([np.cos(angle), np.sin(angle)])
        across = np.array([-way[1], way[0]])
        error = np.array([random.normal(0, 9 * wild), random.normal(0, 3 * wild)])
        error = np.clip(error, (-36, -26), (50, 26))
        at = tip + spacing * (error[0] * way + error[1] * across)
        back = tip - at
        truth = np.array([AHEAD_OF + back @ way / spacing, (HEIGHT - 1) / 2 + back @ across / spacing])
        reach = int(np.ceil(spacing * np.hypot(WIDTH, HEIGHT))) + 8
        low = np.maximum(np.floor(at).astype(int) - reach, 0)
        high = np.minimum(np.ceil(at).astype(int) + reach, image.shape[::-1])
        if np.any(high - low < 8):
            return None
        part = np.ascontiguousarray(image[low[1]:high[1], low[0]:high[0]]).astype(np.float32)
        if random.random() < 0.2:
            part = 255 - part
        if random.random() < 0.3:
            part = 255 * (np.clip(part, 0, 255) / 255) ** np.float32(np.exp(random.uniform(-0.5, 0.5)))
        if random.random() < 0.3:
            part = cv2.GaussianBlur(part, (0, 0), random.uniform(0.3, 1.0))
        if random.random() < 0.5:
            part = part + cv2.randn(np.empty_like(part), 0, random.uniform(0, 5))
        if spacing > 1:
            part = cv2.GaussianBlur(part, (0, 0), REDUCING_BLUR * spacing)
        u, v = np.meshgrid(np.arange(WIDTH) - AHEAD_OF, np.arange(HEIGHT) - (HEIGHT - 1) / 2)
        x, y = ((at - low)[k] + spacing * (u * way[k] + v * across[k]) for k in (0, 1))
        grey = cv2.remap(part, x.astype(np.float32), y.astype(np.float32), cv2.INTER_LINEAR,
                         borderMode=cv2.BORDER_REPLICATE)
        return np.stack([normalised(grey), np.full_like(grey, spacing_of(spacing))]), truth.astype(np.float32)


def batch(samples, random, count):
    drawn = []
    while len(drawn) < count:
        one = samples.draw(random)
        if one is not None and 0 <= one[1][0] < WIDTH and 0 <= one[1][1] < HEIGHT:
            drawn.append(one)
    xs, ts = zip(*drawn)
    return torch.from_numpy(np.stack(xs).astype(np.float32)), torch.from_numpy(np.stack(ts))


def loss_of(logits, truth):
    n = len(logits)
    u, v = torch.arange(WIDTH, dtype=torch.float32), torch.arange(HEIGHT, dtype=torch.float32)[:, None]
    spot = torch.exp(-0.5 * (((u - truth[:, 0, None, None]) ** 2 + (v - truth[:, 1, None, None]) ** 2)
                             / LABEL_SIGMA ** 2)).reshape(n, -1)
    logs = torch.log_softmax(logits.reshape(n, -1), 1)
    crossed = -(spot / spot.sum(1, keepdim=True).clamp(min=1e-6) * logs).sum(1)
    share = torch.exp(logs).reshape(n, HEIGHT, WIDTH)
    mean = torch.stack([(share * u).sum((1, 2)), (share * v).sum((1, 2))], 1)
    off = (mean - truth).norm(dim=1)
    return (crossed + 0.5 * torch.minimum(off, 1 + 0.2 * off)).mean(), off.detach()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples")
    parser.add_argument("output")
    parser.add_argument("--minutes", type=float, default=30)
    parser.add_argument("--start", help="weights to go on from (.pt)")
    parser.add_argument("--rate", type=float, default=4e-3)
    options = parser.parse_args()
    torch.set_num_threads(1)
    torch.manual_seed(1)
    cv2.setNumThreads(1)
    cv2.setRNGSeed(1)
    random = np.random.default_rng(1)
    samples = Samples(options.samples)
    network = TipNetwork()
    print(f"{len(samples.items)} samples, {sum(p.numel() for p in network.parameters())} parameters", flush=True)
    if options.start:
        network.load_state_dict(torch.load(options.start))
    optimiser = torch.optim.AdamW(network.parameters(), lr=options.rate, weight_decay=1e-4)
    begin, step, mean, offs = time.time(), 0, None, []
    while True:
        share = (time.time() - begin) / (60 * options.minutes)
        if share >= 1:
            break
        for group in optimiser.param_groups:
            group["lr"] = options.rate * min(1, (step + 1) / 50) * (0.5 + 0.5 * np.cos(np.pi * share)) + 1e-5
        patches, truth = batch(samples, random, 16)
        loss, off = loss_of(network(patches), truth)
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimiser.step()
        offs.append(off.median().item())
        mean = loss.item() if mean is None else 0.98 * mean + 0.02 * loss.item()
        step += 1
        if step % 100 == 0:
            print(f"step {step}  {time.time() - begin:.0f} s  loss {mean:.3f}  median off {np.mean(offs[-100:]):.2f} samples",
                  flush=True)
            torch.save(network.state_dict(), options.output[:-5] + ".pt")
    network.eval()
    torch.save(network.state_dict(), options.output[:-5] + ".pt")
    torch.onnx.export(network, torch.zeros(1, 2, HEIGHT, WIDTH), options.output, opset_version=11,
                      input_names=["patch"], output_names=["tip"])


if __name__ == "__main__":
    main()

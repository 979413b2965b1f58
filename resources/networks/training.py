"""What the scripts that train the networks share: layers, pictures made various, and the loop.

Needs Debian's python3-torch, python3-opencv and python3-numpy.
"""
import argparse
import csv
import glob
import multiprocessing
import os
import time

import cv2
import numpy as np
import torch
from torch import nn

from any_contrast import Drawings, any_needle, drawn_anew, moved, outlines_of

REDUCING_BLUR = 0.42   # before samples further apart than a pixel, in samples


class Block(nn.Sequential):
    def __init__(self, inputs, outputs, stride=1, size=3):
        super().__init__(nn.Conv2d(inputs, outputs, size, stride, size // 2, bias=False), nn.BatchNorm2d(outputs),
                         nn.ReLU())


class Up(nn.Module):
    """To the level above: what a convolution of the lower level, enlarged twice, and of the level's own adds up to. The former
    is a transposed convolution, which takes less than half as long as to enlarge first."""

    def __init__(self, below, own):
        super().__init__()
        self.enlarge, self.join = nn.ConvTranspose2d(below, own, 4, 2, 1), nn.Conv2d(own, own, 3, 1, 1, bias=False)

    def forward(self, below, own):
        return torch.relu(self.enlarge(below) + self.join(own))


class UNetwork(nn.Module):
    """`stem`, a U of as many levels as there are `widths`, and `out`."""

    def __init__(self, stem, widths, out):
        super().__init__()
        self.stem, self.out = stem, out
        self.first = Block(widths[0], widths[0])
        self.down = nn.ModuleList(
            nn.Sequential(Block(a, b, stride=2), Block(b, b)) for a, b in zip(widths, widths[1:]))
        self.up = nn.ModuleList(Up(b, a) for a, b in reversed(list(zip(widths, widths[1:]))))

    def forward(self, x):
        x = self.first(self.stem(x))
        kept = [x]
        for down in self.down:
            x = down(x)
            kept.append(x)
        for up, own in zip(self.up, kept[-2::-1]):
            x = up(x, own)
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
    """A part of a picture as another microscope and camera might show it, then blurred for samples `spacing_px` apart."""
    part = other_look(np.ascontiguousarray(part).astype(np.float32), spacing_px, random)
    if spacing_px > 1:
        part = cv2.GaussianBlur(part, (0, 0), REDUCING_BLUR * spacing_px)
    return part


def other_look(picture, unit_px, random):
    """A picture (float, 0 to 255) with its boundaries in place but other contrast, light, optics and camera. `unit_px`:
    how many of its pixels the network sees as one."""
    chance = lambda share: random.random() < share
    unit = max(1.0, unit_px)
    if chance(0.25):
        picture = 255 - picture
    if chance(0.12):
        picture = other_contrast(picture, unit, random)
    if chance(0.3):
        picture = 255 * (np.clip(picture, 0, 255) / 255) ** np.float32(np.exp(random.uniform(-0.7, 0.7)))
    if chance(0.2):  # a halo, or a camera that sharpens
        wide = np.exp(random.uniform(np.log(1.5), np.log(25))) * unit
        picture = picture + np.float32(random.uniform(-0.5, 1.5)) * (picture - blurred(picture, wide))
    if chance(0.15):
        picture = with_bodies(picture, unit, random)
    if chance(0.3):
        picture = shaded(picture, random)
    if chance(0.35):
        picture = cv2.GaussianBlur(picture, (0, 0), unit * random.uniform(0.3, 1.3))
    elif chance(0.06):  # out of focus
        half = int(round(unit * random.uniform(1, 2.5)))
        disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * half + 1, 2 * half + 1)).astype(np.float32)
        picture = cv2.filter2D(picture, -1, disc / disc.sum())
    if chance(0.55):
        strength = random.uniform(0, 8) if chance(0.3) else random.uniform(0, 4)
        noise = cv2.randn(np.empty_like(picture), 0, strength)
        if chance(0.25):  # with a grain of its own
            noise = 2 * cv2.GaussianBlur(noise, (0, 0), random.uniform(0.5, 1.2))
        picture = picture + noise
    if chance(0.06):  # columns that differ
        picture = picture + random.normal(0, random.uniform(0, 2.5), picture.shape[1]).astype(np.float32)
    if chance(0.12):
        quality = [cv2.IMWRITE_JPEG_QUALITY, int(random.integers(15, 85))]
        picture = cv2.imdecode(cv2.imencode(".jpg", np.clip(picture, 0, 255).astype(np.uint8), quality)[1],
                               cv2.IMREAD_GRAYSCALE).astype(np.float32)
    if chance(0.08):  # blacks or whites cut off
        low, high = np.percentile(picture, [random.uniform(0, 6), random.uniform(94, 100)])
        picture = np.clip(picture, low, high)
    return picture


def blurred(picture, sigma_px):
    """Blurred, from a reduced copy where that is wide."""
    step = max(1, int(sigma_px / 3))
    if step == 1:
        return cv2.GaussianBlur(picture, (0, 0), sigma_px)
    size = tuple(max(2, n // step) for n in picture.shape[::-1])
    small = cv2.GaussianBlur(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), (0, 0), sigma_px / step)
    return cv2.resize(small, picture.shape[::-1], interpolation=cv2.INTER_LINEAR)


def other_contrast(picture, unit, random):
    """Mixed with its derivative in some direction (relief) and its second derivative (a change of focus), each of the
    picture's own spread. All three are even about a line or odd about a step, so boundaries stay where they are."""
    fine = cv2.GaussianBlur(picture, (0, 0), unit * random.uniform(0.6, 1.5))
    angle = random.uniform(0, 2 * np.pi)
    parts = [np.cos(angle) * cv2.Sobel(fine, cv2.CV_32F, 1, 0) + np.sin(angle) * cv2.Sobel(fine, cv2.CV_32F, 0, 1),
             cv2.Laplacian(fine, cv2.CV_32F)]
    spread = picture.std()
    mixed = random.uniform(0, 1) * (picture - picture.mean())
    for part in parts:
        mixed = mixed + np.float32(random.normal(0, 0.7) * spread / (part.std() + 1e-3)) * part
    return 128 + mixed * (spread / (mixed.std() + 1e-3))


def with_bodies(picture, unit, random):
    """With a few specks, blots and threads over it, darker or brighter."""
    h, w = picture.shape
    cover = np.zeros((h, w), np.float32)
    for _ in range(random.integers(1, 5)):
        at = (int(random.uniform(0, w)), int(random.uniform(0, h)))
        grey = float(random.normal(0, 45))
        if random.random() < 0.3:
            cv2.line(cover, at, (int(random.uniform(0, w)), int(random.uniform(0, h))), grey,
                     max(1, int(unit * random.uniform(0.5, 3))), cv2.LINE_AA)
        else:
            size = np.exp(random.uniform(np.log(1), np.log(12))) * unit
            axes = (max(1, int(size)), max(1, int(size * random.uniform(0.4, 1))))
            thick = -1 if random.random() < 0.6 else max(1, int(0.3 * size))
            cv2.ellipse(cover, at, axes, random.uniform(0, 180), 0, 360, grey, thick, cv2.LINE_AA)
    return picture + cv2.GaussianBlur(cover, (0, 0), unit * random.uniform(0.3, 1.5))


def shaded(picture, random):
    """Under light that changes from side to side, or towards the corners."""
    h, w = picture.shape
    u, v = np.linspace(-1, 1, w, dtype=np.float32)[None, :], np.linspace(-1, 1, h, dtype=np.float32)[:, None]
    slope = random.normal(0, 0.25, 2).astype(np.float32)
    light = slope[0] * u + slope[1] * v + np.float32(random.normal(0, 0.12)) * (u * u + v * v)
    if random.random() < 0.5:
        return picture * np.clip(1 + light, 0.15, 2.5)
    return picture + 100 * light


def sampled(part, x, y):
    return cv2.remap(part, x.astype(np.float32), y.astype(np.float32), cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)


class Tables:
    """The pictures that the samples*.csv and contours*.csv of one or more folders, separated by commas, list."""

    def __init__(self, folders):
        self.folders, self.known, self.sizes = folders.split(","), set(), {}

    def new(self):
        """Path, row and outlines of each picture not given before. Tables that have not grown are not read again."""
        for folder in self.folders:
            for table in sorted(glob.glob(os.path.join(folder, "samples*.csv"))):
                contours = os.path.join(folder, os.path.basename(table).replace("samples", "contours"))
                sizes = [os.path.getsize(path) for path in (table, contours)]
                if self.sizes.get(table) == sizes:
                    continue
                outlines = outlines_of(contours)
                with open(table) as file:
                    for row in csv.DictReader(file):
                        path = os.path.join(folder, row["file"])
                        if row["frame"] is not None and row["file"] in outlines and path not in self.known:
                            self.known.add(path)
                            yield path, row, outlines[row["file"]]
                self.sizes[table] = sizes


class TipSamples:
    """Pictures that show a needle's tip, as much of each as lies about the tip, with its tip, direction, half width some way behind
    and radius at the tip, px, and for drawings its labels, its outlines and how far behind that is; `load` takes in what has been
    added since."""
    ANEW = 0.5        # share of the pictures drawn from the outlines alone
    ANY_NEEDLE = 0.0  # of these, the share with a needle of any width and end
    REACH = 210       # of a drawing about the tip, in samples
    LEAST_KEPT_PX, MOST_KEPT_PX = 130, 420  # of a picture about the tip; between them twice REACH
    BEHIND = 0.05     # where the needle is measured, of a picture's longer side

    def __init__(self, folders, width_samples):
        """`width_samples`: of a needle's half width."""
        self.tables, self.items, self.held_out, self.drawings = Tables(folders), [], [], Drawings()
        self.width_samples = width_samples
        self.load()

    def load(self):
        for path, row, outlines in self.tables.new():
            self.read(path, row, outlines)

    def pick(self, items, random):
        """Picture, tip, direction, half width and radius of one of `items`, as it is or drawn anew."""
        item = items[random.integers(len(items))]
        if items is self.held_out or random.random() > self.ANEW:
            return item[:5]
        return self.drawings.pick(lambda: self.anew(item, random), random)

    def anew(self, item, random):
        _, tip, way, half, radius, label, outlines, behind = item
        if random.random() < self.ANY_NEEDLE:
            needle, half, radius = any_needle(tip, way, half, behind, random)
            outlines = {**outlines, "needle": needle}
        unit = half / self.width_samples
        reach = min(self.REACH * unit, 400)
        low = np.maximum(np.floor(tip - reach).astype(int), 0)
        high = np.minimum(np.ceil(tip + reach).astype(int), label.shape[::-1])
        picture = drawn_anew(moved(outlines, np.eye(2), -low), label[low[1]:high[1], low[0]:high[0]], random, unit)
        return picture, tip - low, way, half, radius

    def read(self, path, row, outlines):
        tip, way = (np.array([float(row[a]), float(row[b])]) for a, b in
                    (("tip_x_px", "tip_y_px"), ("direction_x", "direction_y")))
        image, label = cv2.imread(path, cv2.IMREAD_GRAYSCALE), cv2.imread(path[:-4] + "_label.png", cv2.IMREAD_UNCHANGED)
        if image is None or label is None or np.any(tip < 2) or np.any(tip > np.array(image.shape[::-1]) - 3):
            return
        way = way / np.hypot(*way)
        across = np.array([-way[1], way[0]])
        behind = self.BEHIND * max(image.shape)
        line = tip - behind * way + np.arange(-60, 60.5, 0.5)[:, None] * across
        x, y = np.round(line).astype(int).T
        inside = (x >= 0) & (y >= 0) & (x < image.shape[1]) & (y < image.shape[0])
        half = 0.25 * np.count_nonzero(label[y[inside], x[inside]] == 3)
        if half < 0.5:
            return
        reach = np.clip(2 * self.REACH * half / self.width_samples, self.LEAST_KEPT_PX, self.MOST_KEPT_PX)
        low = np.maximum(np.floor(tip - reach).astype(int), 0)
        high = np.minimum(np.ceil(tip + reach).astype(int), image.shape[::-1])
        image, label = (one[low[1]:high[1], low[0]:high[0]].copy() for one in (image, label))
        if self.ANEW == 0:
            label = outlines = None
        else:
            outlines = moved(outlines, np.eye(2), -low)
        self.keep((image, tip - low, way, half, float(row["tip_radius_px"]), label, outlines, behind))

    def keep(self, item):
        self.items.append(item)


class Feed:
    """Batches of what `draw(random)` gives: tuples of arrays, or None, which counts for nothing. With workers, so many processes
    draw, and a batch is taken at random from the last MOST samples that they have drawn, each of which is shown about REUSE times,
    with other noise in its first plane, the grey values."""
    MOST, REUSE, CHUNK, NOISE = 150000, 4, 32, 0.15

    def __init__(self, draw, count, workers=0):
        self.draw, self.count, self.is_shared = draw, count, workers > 0
        self.random, self.drawn, self.shown, self.kept = np.random.default_rng(1), 0, 0, None
        if self.is_shared:
            context = multiprocessing.get_context("fork")
            self.queue = context.Queue(2 * workers)
            for seed in range(workers):
                context.Process(target=self.work, args=(seed + 2,), daemon=True).start()

    def work(self, seed):
        torch.set_num_threads(1)
        cv2.setRNGSeed(seed)
        random = np.random.default_rng(seed)
        while True:
            inputs, *others = self.stack(random, self.CHUNK)
            self.queue.put((inputs.astype(np.float16), *others))

    def stack(self, random, count):
        drawn = []
        while len(drawn) < count:
            one = self.draw(random)
            if one is not None:
                drawn.append(one)
        return tuple(np.stack(part) for part in zip(*drawn))

    def next(self, device):
        """A batch, as tensors."""
        if not self.is_shared:
            return tuple(torch.from_numpy(part).to(device) for part in self.stack(self.random, self.count))
        while self.drawn < 8 * self.count or self.shown > self.REUSE * self.drawn or not self.queue.empty():
            self.keep(tuple(torch.from_numpy(part).to(device) for part in self.queue.get()))
        self.shown += self.count
        picked = torch.randint(min(self.drawn, self.MOST), (self.count,), device=device)
        inputs, *others = (part[picked] for part in self.kept)
        inputs = inputs.float()
        inputs[:, :1] += self.NOISE * torch.rand((self.count, 1, 1, 1), device=device) ** 2 * torch.randn_like(inputs[:, :1])
        return inputs, *others

    def keep(self, chunk):
        if self.kept is None:
            self.kept = tuple(torch.empty((self.MOST, *part.shape[1:]), dtype=part.dtype, device=part.device) for part in chunk)
        at = torch.arange(self.drawn, self.drawn + self.CHUNK, device=chunk[0].device) % self.MOST
        for kept, part in zip(self.kept, chunk):
            kept[at] = part
        self.drawn += self.CHUNK


def arguments_of(text, minutes, flags=None):
    """`flags`: {name: help} of further options that are there or not."""
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples", help="a folder of pictures, or more of them, separated by commas")
    parser.add_argument("output")
    parser.add_argument("--minutes", type=float, default=minutes)
    parser.add_argument("--start", help="weights to go on from (.pt, or a network as shipped, .onnx)")
    parser.add_argument("--rate", type=float, default=4e-3)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1, help="of the weights at first and of what is drawn")
    parser.add_argument("--workers", type=int, default=0, help="processes that draw, for a machine with a graphics processor")
    parser.add_argument("--batch", type=int, help="samples a step")
    parser.add_argument("--bfloat16", action="store_true",
                        help="compute in bfloat16 as far as that is safe: 1.4 times as fast on processors with avx512_bf16")
    for name, help_text in (flags or {}).items():
        parser.add_argument(f"--{name}", action="store_true", help=help_text)
    options = parser.parse_args()
    torch.set_num_threads(options.threads)
    torch.manual_seed(options.seed)
    cv2.setNumThreads(1)
    cv2.setRNGSeed(options.seed)
    return options


def go_on_from(network, path, inputs, batches=20):
    """Takes weights over. A shipped network's batch normalisation has gone into its weights: it is put back by what the
    layers give in a few batches of inputs(), so that the network answers as before."""
    if path.endswith(".pt"):
        network.load_state_dict(torch.load(path, map_location="cpu"))
        return
    import onnx
    from onnx import numpy_helper
    graph = onnx.load(path).graph
    values = {one.name: torch.from_numpy(numpy_helper.to_array(one).copy()) for one in graph.initializer}
    shipped = [[values[name] for name in node.input[1:]] for node in graph.node if node.op_type in ("Conv", "ConvTranspose", "Gemm")]
    modules = dict(network.named_modules())
    layers = [one for one in modules.values() if isinstance(one, (nn.Conv2d, nn.ConvTranspose2d, nn.Linear))]
    norms = {previous: one for previous, one in zip(modules.values(), list(modules.values())[1:])
             if isinstance(one, nn.BatchNorm2d)}
    # The graph runs the layers in the order of forward(), which is not that of the members.
    order = []
    hooks = [layer.register_forward_hook(lambda one, *_: order.append(one)) for layer in layers]
    network.eval()
    with torch.no_grad():
        network(inputs())
    for hook in hooks:
        hook.remove()
    if len(order) != len(shipped):
        raise SystemExit(f"{path}: {len(shipped)} layers, {len(order)} wanted")
    means = {}
    with torch.no_grad():
        for layer, (weight, *bias) in zip(order, shipped):
            layer.weight.copy_(weight)
            norm = norms.get(layer)
            if norm is None:
                if bias:
                    layer.bias.copy_(*bias)
                continue
            norm.running_mean.zero_()
            norm.running_var.fill_(1 - norm.eps)
            norm.weight.fill_(1)
            norm.bias.copy_(*bias)
            means[norm] = []
        hooks = [norm.register_forward_pre_hook(lambda one, x: means[one].append(
            torch.stack([x[0].mean((0, 2, 3)), (x[0] ** 2).mean((0, 2, 3))]))) for norm in means]
        for _ in range(batches):
            network(inputs())
        for hook in hooks:
            hook.remove()
        for norm, seen in means.items():
            mean, square = torch.stack(seen).mean(0)
            variance = (square - mean ** 2).clamp(min=1e-6)
            norm.running_mean.copy_(mean)
            norm.running_var.copy_(variance)
            norm.weight.copy_((variance + norm.eps).sqrt())
            norm.bias.add_(mean)
    network.train()


def train(network, options, samples, feed, loss_of):
    """Steps until the time is up, at a rate that falls, with a batch of `feed` each: inputs, and what loss_of(network's answer,
    *others) takes for the loss and a figure to be printed. Make the feed before the graphics processor is touched. Minutes are
    the processor's, however busy the machine is, or the clock's where workers draw."""
    print(f"{len(samples.items)} samples, {sum(p.numel() for p in network.parameters())} parameters", flush=True)
    device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
    network.to(device)
    if options.start:
        go_on_from(network, options.start, lambda: feed.next(device)[0])
    optimiser = torch.optim.AdamW(network.parameters(), lr=options.rate, weight_decay=1e-4)
    clock = time.monotonic if options.workers else time.process_time
    begin, step, losses, figures = clock(), 0, [], []
    while (share := (clock() - begin) / (60 * options.minutes)) < 1:
        for group in optimiser.param_groups:
            group["lr"] = options.rate * min(1, (step + 1) / 50) * (0.5 + 0.5 * np.cos(np.pi * share)) + 1e-5
        inputs, *others = feed.next(device)
        with torch.autocast(device.type, torch.bfloat16, options.bfloat16):
            answer = network(inputs)
        loss, figure = loss_of(answer.float(), *others)
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimiser.step()
        losses.append(loss.detach())
        figures.append(figure)
        step += 1
        if step % 100 == 0:
            if not options.workers or samples is feed:  # else the workers hold them
                samples.load()
            mean = [torch.stack(values).mean().item() for values in (losses, figures)]
            losses, figures = [], []
            print(f"step {step}  {clock() - begin:.0f} s  loss {mean[0]:.3f}  figure {mean[1]:.2f}  {len(samples.items)} pictures, "
                  f"{feed.drawn or step * feed.count} samples drawn", flush=True)
            torch.save(network.state_dict(), options.output[:-5] + ".pt")
    network.eval().cpu()
    torch.save(network.state_dict(), options.output[:-5] + ".pt")


def export(network, path, shape, input_name, output_name):
    torch.onnx.export(network, torch.zeros(*shape), path, opset_version=11, input_names=[input_name],
                      output_names=[output_name])

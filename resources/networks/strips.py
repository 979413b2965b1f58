"""Strips of the boundary network, drawn a batch at a time on the device that the pictures are on: what `training.py` does to
one picture after the other, as tensors. A graphics processor draws some 8,000 a second, one core 25.

Needs Debian's python3-torch and python3-numpy. Pictures are (b, h, w), 0 to 255; outlines (b, POINTS, 2), px, of positive
area; `unit` (b) is how many pixels the network sees as one.
"""
import math

import numpy as np
import torch
from torch.nn import functional

from training import REDUCING_BLUR

NORMALS, WRAP, COLUMNS, ZERO, RADIUS_SAMPLES = 128, 16, 96, 58, 160
POINTS = 512           # of an outline
ON_INNER = 0.12        # share of the outlines that lie on the inner boundary
MOSTLY = 0.6           # of the normals must meet the outer boundary
# The standard's table for grey values (JPEG, ITU-T T.81, annex K).
QUANTA = torch.tensor([
    16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, 14, 13, 16, 24, 40, 57, 69, 56, 14, 17, 22, 29, 51, 87, 80, 62,
    18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112,
    100, 103, 99], dtype=torch.float32).reshape(8, 8)
COSINES = torch.tensor([[(math.sqrt(0.125) if k == 0 else 0.5) * math.cos((2 * i + 1) * k * math.pi / 16) for i in range(8)]
                        for k in range(8)])


def between(count, low, high, like):
    return low + (high - low) * torch.rand(count, device=like.device)


def log_between(count, low, high, like):
    return torch.exp(between(count, math.log(low), math.log(high), like))


def normal(count, sigma, like):
    return sigma * torch.randn(count, device=like.device)


def wide(values):
    """(b) as (b, 1, 1)."""
    return values[:, None, None]


def evenly(points, count, first=0.0):
    """`count` points (2, count) at equal arc lengths of a closed polygon (2, n), from a share of its length on."""
    closed = np.hstack([points, points[:, :1]])
    length = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(closed)))])
    at = (first + np.arange(count) / count) % 1 * length[-1]
    return np.stack([np.interp(at, length, closed[0]), np.interp(at, length, closed[1])])


class Pictures:
    """Up to `most` pictures of at most `height` x `width` pixels with both boundaries, on a device. The oldest go first."""

    def __init__(self, most, height, width, device):
        self.most, self.count, self.next = most, 0, 0
        self.images = torch.zeros((most, height, width), dtype=torch.uint8, device=device)
        self.sizes = torch.zeros((most, 2), dtype=torch.long, device=device)
        self.outer, self.inner = (torch.zeros((most, POINTS, 2), device=device) for _ in range(2))

    def takes(self, picture):
        return picture.shape[0] <= self.images.shape[1] and picture.shape[1] <= self.images.shape[2]

    def add(self, picture, outer, inner):
        """`picture` (h, w) of 8 bits, outlines (2, n) px of positive area."""
        h, w = picture.shape
        self.images[self.next, :h, :w] = torch.from_numpy(np.ascontiguousarray(picture)).to(self.images.device)
        self.sizes[self.next] = torch.tensor([w, h])
        for kept, points in ((self.outer, outer), (self.inner, inner)):
            kept[self.next] = torch.from_numpy(evenly(points, POINTS).T.astype(np.float32)).to(kept.device)
        self.next = (self.next + 1) % self.most
        self.count = max(self.count, self.next or self.most)

    def about(self, count, side):
        """`count` of them at random: `side` x `side` pixels about each cell, and its outer and inner boundary there."""
        pick = torch.randint(self.count, (count,), device=self.images.device)
        outer, inner = self.outer[pick], self.inner[pick]
        low = torch.round((outer.amin(1) + outer.amax(1) - side) / 2).long()
        span = torch.arange(side, device=low.device)[None]
        columns, rows = (torch.minimum((low[:, k:k + 1] + span).clamp(min=0), self.sizes[pick, k:k + 1] - 1) for k in (0, 1))
        part = self.images[wide(pick), rows[:, :, None], columns[:, None, :]].float()
        return part, outer - low[:, None], inner - low[:, None]


def blurred(x, sigma):
    half = math.ceil(3 * float(sigma.max()))
    t = torch.arange(-half, half + 1, device=x.device, dtype=x.dtype)
    kernel = torch.exp(-0.5 * (t / sigma.clamp(min=1e-3)[:, None]) ** 2)
    kernel = kernel / kernel.sum(1, keepdim=True)
    y = functional.pad(x[None], (half,) * 4, mode="replicate")
    y = functional.conv2d(y, kernel[:, None, None, :], groups=len(x))
    return functional.conv2d(y, kernel[:, None, :, None], groups=len(x))[0]


def blurred_wide(x, sigma):
    """By 4 px and more, at a reduced size."""
    step = 8 if float(sigma.min()) > 12 else 2
    small = blurred(functional.avg_pool2d(x[:, None], step, ceil_mode=True)[:, 0], sigma / step)
    return functional.interpolate(small[:, None], size=x.shape[1:], mode="bilinear", align_corners=False)[:, 0]


def some(x, share, change, *more):
    """x with a share of its pictures changed in place by `change(pictures, what of `more` is theirs)`."""
    chosen = torch.nonzero(torch.rand(len(x), device=x.device) < share)[:, 0]
    if len(chosen):
        x[chosen] = change(x[chosen], *(one[chosen] for one in more))


def other_contrast(x, unit):
    fine = blurred(x, unit * between(len(x), 0.6, 1.5, x))
    pad = functional.pad(fine[:, None], (1, 1, 1, 1), mode="replicate")[:, 0]
    right, left, below, above = pad[:, 1:-1, 2:], pad[:, 1:-1, :-2], pad[:, 2:, 1:-1], pad[:, :-2, 1:-1]
    angle = wide(between(len(x), 0, 2 * math.pi, x))
    slope = torch.cos(angle) * (right - left) + torch.sin(angle) * (below - above)
    spread = x.std((1, 2), keepdim=True)
    mixed = wide(between(len(x), 0, 1, x)) * (x - x.mean((1, 2), keepdim=True))
    for part in (slope, right + left + below + above - 4 * fine):
        mixed = mixed + wide(normal(len(x), 0.7, x)) * spread / (part.std((1, 2), keepdim=True) + 1e-3) * part
    return 128 + mixed * (spread / (mixed.std((1, 2), keepdim=True) + 1e-3))


def with_bodies(x, unit):
    b, h, w = x.shape
    v, u = torch.arange(h, device=x.device)[None, :, None].float(), torch.arange(w, device=x.device)[None, None, :].float()
    cover = torch.zeros_like(x)
    for k in range(4):
        grey = (torch.rand(b, device=x.device) < 1 - 0.25 * k).float() * normal(b, 45, x)
        angle, size = between(b, 0, math.pi, x), log_between(b, 1, 12, x) * unit
        short = size * between(b, 0.4, 1, x)
        du, dv = u - wide(between(b, 0, w, x)), v - wide(between(b, 0, h, x))
        along, across = (wide(torch.cos(angle)) * du + wide(torch.sin(angle)) * dv,
                         wide(torch.cos(angle)) * dv - wide(torch.sin(angle)) * du)
        away = torch.sqrt((along / wide(size)) ** 2 + (across / wide(short)) ** 2 + 1e-9)
        thread = torch.exp(-0.5 * (across / wide(unit * between(b, 0.3, 1.5, x))) ** 2)
        blot = torch.sigmoid((1 - away) * wide(torch.minimum(size, short)) * 2)
        ring = torch.exp(-0.5 * ((away - 1) / 0.15) ** 2)
        kind = wide(torch.rand(b, device=x.device))
        cover = cover + wide(grey) * torch.where(kind < 0.3, thread, torch.where(kind < 0.72, blot, ring))
    return x + blurred(cover, unit * between(b, 0.3, 1.5, x))


def shaded(x):
    b, h, w = x.shape
    u, v = torch.linspace(-1, 1, w, device=x.device)[None, None, :], torch.linspace(-1, 1, h, device=x.device)[None, :, None]
    light = wide(normal(b, 0.25, x)) * u + wide(normal(b, 0.25, x)) * v + wide(normal(b, 0.12, x)) * (u * u + v * v)
    return torch.where(wide(torch.rand(b, device=x.device)) < 0.5, x * (1 + light).clamp(0.15, 2.5), x + 100 * light)


def noisy(x):
    strength = torch.rand(len(x), device=x.device)
    strength = torch.where(strength < 0.08, between(len(x), 0, 22, x),
                           torch.where(strength < 0.3, between(len(x), 0, 8, x), between(len(x), 0, 4, x)))
    noise = torch.randn_like(x)
    some(noise, 0.25, lambda n: 2 * blurred(n, between(len(n), 0.5, 1.2, n)))  # with a grain of its own
    return x + wide(strength) * noise


def compressed(x):
    """As JPEG leaves it; sides are multiples of 8."""
    b, h, w = x.shape
    quality = between(b, 15, 85, x)
    scale = torch.where(quality < 50, 5000 / quality, 200 - 2 * quality) / 100
    quanta, cosines = (QUANTA.to(x.device) * wide(scale)).clamp(1, 255)[:, None, None], COSINES.to(x.device)
    tiles = (x.clamp(0, 255) - 128).reshape(b, h // 8, 8, w // 8, 8).permute(0, 1, 3, 2, 4)
    kept = torch.round(cosines @ tiles @ cosines.T / quanta) * quanta
    return (cosines.T @ kept @ cosines).permute(0, 1, 3, 2, 4).reshape(b, h, w) + 128


def cut_off(x):
    """Blacks and whites."""
    few = x[:, ::9, ::9].reshape(len(x), -1).sort(1)[0]
    low, high = (few.gather(1, (between(len(x), *share, x) * (few.shape[1] - 1)).long()[:, None])
                 for share in ((0, 0.06), (0.94, 1)))
    return torch.maximum(torch.minimum(x, high[:, :, None]), low[:, :, None])


def other_look(x, unit):
    """Pictures with their boundaries in place but other contrast, light, optics and camera, in place."""
    some(x, 0.25, lambda y: 255 - y)
    some(x, 0.12, other_contrast, unit)
    some(x, 0.3, lambda y: 255 * (y.clamp(0, 255) / 255) ** wide(torch.exp(between(len(y), -0.7, 0.7, y))))
    # A halo, or a camera that sharpens.
    some(x, 0.13, lambda y, u: y + wide(between(len(y), -0.5, 1.5, y)) * (y - blurred_wide(y, log_between(len(y), 4, 25, y) * u)), unit)
    some(x, 0.07, lambda y, u: y + wide(between(len(y), -0.5, 1.5, y)) * (y - blurred(y, log_between(len(y), 1.5, 4, y) * u)), unit)
    some(x, 0.15, with_bodies, unit)
    some(x, 0.3, shaded)
    some(x, 0.3, lambda y, u: blurred(y, u * between(len(y), 0.3, 1.3, y)), unit)
    some(x, 0.1, lambda y, u: blurred(y, u * between(len(y), 1.3, 3, y)), unit)
    some(x, 0.55, noisy)
    some(x, 0.06, lambda y: y + normal((len(y), 1, y.shape[2]), 1, y) * wide(between(len(y), 0, 2.5, y)))  # columns that differ
    some(x, 0.12, compressed)
    some(x, 0.08, cut_off)
    return x


def outward(points):
    """Unit normals of outlines."""
    tangent = torch.roll(points, -1, 1) - torch.roll(points, 1, 1)
    across = torch.stack([tangent[..., 1], -tangent[..., 0]], -1)
    return across / across.norm(dim=-1, keepdim=True).clamp(min=1e-9)


def radius_of(points):
    x, y = points[..., 0], points[..., 1]
    area = 0.5 * (x * torch.roll(y, -1, 1) - torch.roll(x, -1, 1) * y).sum(1)
    return torch.sqrt(area.abs() / math.pi)


def rough(points):
    """Outlines as detection may give them: wrong by an offset, a few harmonics, a dimple too many or too few."""
    b = len(points)
    way = points - points.mean(1, keepdim=True)
    angle, distance = torch.atan2(way[..., 1], way[..., 0]), way.norm(dim=-1)
    coarse = torch.where(torch.rand(b, device=points.device) < 0.25, 3.0, 1.0)
    off = (normal(b, 0.018, points) * coarse)[:, None] * torch.ones_like(angle)
    for k in range(1, 6):
        off = off + (coarse * normal(b, 0.012, points))[:, None] / math.sqrt(k) * torch.cos(
            k * angle + between(b, 0, 2 * math.pi, points)[:, None])
    count = torch.rand(b, device=points.device)
    for least in (0.4, 0.7, 0.9):
        away = torch.remainder(angle - between(b, 0, 2 * math.pi, points)[:, None] + math.pi, 2 * math.pi) - math.pi
        width = log_between(b, 0.04, 0.4, points)
        depth = (count > least).float() * between(b, -0.2, 0.2, points) * (width / 0.08).clamp(max=1)
        off = off + depth[:, None] * torch.exp(-0.5 * (away / width[:, None]) ** 2)
    # Without its own dimple: towards the circle through its far points.
    far = distance.sort(1)[0][:, int(0.7 * POINTS)]
    share = (torch.rand(b, device=points.device) < 0.3).float() * between(b, 0.3, 1, points)
    rounder = points + wide(share) * way * (far[:, None] / distance.clamp(min=1e-6) - 1)[..., None]
    return rounder + (off.clamp(-0.19, 0.28) * radius_of(points)[:, None])[..., None] * outward(points)


def normals_at(outline):
    """NORMALS points at equal arc lengths, from any of them on."""
    closed = torch.cat([outline, outline[:, :1]], 1)
    steps = (closed[:, 1:] - closed[:, :-1]).norm(dim=-1)
    length = torch.cat([torch.zeros_like(steps[:, :1]), steps.cumsum(1)], 1)
    share = torch.arange(NORMALS, device=outline.device)[None] / NORMALS + torch.rand_like(steps[:, :1])
    at = (share.remainder(1) * length[:, -1:]).contiguous()
    i = (torch.searchsorted(length, at, right=True) - 1).clamp(0, closed.shape[1] - 2)
    t = ((at - length.gather(1, i)) / (length.gather(1, i + 1) - length.gather(1, i)).clamp(min=1e-9))[..., None]
    corner = lambda j: closed.gather(1, j[..., None].expand(-1, -1, 2))
    return (1 - t) * corner(i) + t * corner(i + 1)


def crossings(points, normals, polygon, low, high):
    """Signed way along each normal to the polygon's crossing next to 0; NaN where none is between `low` and `high` (b)."""
    d = torch.roll(polygon, -1, 1) - polygon
    across = normals[..., 0:1] * d[:, None, :, 1] - normals[..., 1:2] * d[:, None, :, 0]
    to = [polygon[:, None, :, k] - points[..., k:k + 1] for k in (0, 1)]
    s = (to[0] * d[:, None, :, 1] - to[1] * d[:, None, :, 0]) / across
    t = (to[0] * normals[..., 1:2] - to[1] * normals[..., 0:1]) / across
    s = torch.where((t >= 0) & (t < 1) & (s > wide(low)) & (s < wide(high)), s, torch.full_like(s, 1e9))
    best = s.gather(2, s.abs().argmin(2, keepdim=True))[..., 0]
    return torch.where(best < 1e8, best, torch.full_like(best, float("nan")))


def drawn(pictures, count, side):
    """`count` strips (count, 4, NORMALS + 2 WRAP, COLUMNS) and where on each normal the outer and the inner boundary lie
    (count, 2, NORMALS + 2 WRAP), samples; NaN: nowhere. `side` px, a multiple of 8, holds the cells."""
    x, outer, inner = pictures.about(count, side)
    flip = torch.rand(count, device=x.device) < 0.5
    x = torch.where(wide(flip), x.flip(2), x)
    outer, inner = (torch.where(wide(flip), torch.stack([side - 1 - p[..., 0], p[..., 1]], -1).flip(1), p) for p in (outer, inner))
    # A detection may have taken the inner boundary for the outer one.
    outline = rough(torch.where(wide(torch.rand(count, device=x.device) < ON_INNER), inner, outer))
    spacing = radius_of(outline) / RADIUS_SAMPLES
    x = other_look(x, spacing.clamp(min=1))
    coarse = torch.nonzero(spacing > 1)[:, 0]
    if len(coarse):
        x[coarse] = blurred(x[coarse], REDUCING_BLUR * spacing[coarse])
    points = normals_at(outline)
    normals = outward(points)
    truth = torch.stack([crossings(points, normals, p, -ZERO * spacing, (COLUMNS - 1 - ZERO) * spacing) for p in (outer, inner)], 1)
    truth = truth / wide(spacing) + ZERO
    truth[torch.isfinite(truth[:, 0]).float().mean(1) < MOSTLY] = float("nan")
    # A picture may be turned: that is, its normals.
    angle = between(count, 0, 2 * math.pi, x)[:, None]
    seen = torch.stack([torch.cos(angle) * normals[..., 0] - torch.sin(angle) * normals[..., 1],
                        torch.sin(angle) * normals[..., 0] + torch.cos(angle) * normals[..., 1]], 1)
    wrapped = torch.arange(-WRAP, NORMALS + WRAP, device=x.device) % NORMALS
    points, normals, seen, truth = points[:, wrapped], normals[:, wrapped], seen[..., wrapped], truth[..., wrapped]
    along = (torch.arange(COLUMNS, device=x.device) - ZERO)[None, None] * wide(spacing)
    at = points[:, :, None] + normals[:, :, None] * along[..., None]
    grey = functional.grid_sample(x[:, None], at * (2 / (side - 1)) - 1, padding_mode="border", align_corners=True)[:, 0]
    grey = grey - wide(grey.reshape(count, -1).median(1)[0])
    grey = (grey / (grey.abs().mean((1, 2), keepdim=True) + 1e-3)).clamp(-6, 6)
    code = wide(torch.log2(spacing).clamp(-3, 3) / 2)
    planes = [grey, seen[:, 0, :, None].expand_as(grey), seen[:, 1, :, None].expand_as(grey), code.expand_as(grey)]
    return torch.stack(planes, 1), truth

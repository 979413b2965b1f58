#!/usr/bin/python3
"""Measures films drawn by path_films.py, sketch_films.py or wave_films.py with the program, and compares with their truth.

    python3 measure_films.py FILMS WORK [--pellucida PROGRAM] [--options="--detection scene"]

FILMS holds a folder for each film (frame_*.png, film.json, t.csv, t_contours.csv). For each of them `pellucida analyze` and
`pellucida export` run once, into WORK; what is there already is taken. Prints a line for each film and the medians by
contrast: frames with a cell, RMS distance of the outer contour from the true one (median and 95 % of the frames) and its
mean (outwards above 0), the zona's thickness over the true one less 1, in % (median of the frames without contact), tip
(median, 95 %), frames surer than 0.8 and of them wrong (outer above 2 px or tip above 3 px), frames in contact that are seen as such, punctures reported (+ frames late) and false, force RMS in % of the film's peak
over the frames in contact that have a force, and the frames in contact whose 95 % interval holds the true force. The
truth has the modulus of the profile that is measured with. Needs Debian's python3-numpy.
"""
import argparse
import csv
import json
import os
import shlex
import subprocess
import sys

import numpy as np

SURE, WRONG_OUTER_PX, WRONG_TIP_PX = 0.8, 2.0, 3.0
LATEST_FRAMES = 15   # a puncture reported later than this is none
MEDIANS = ["found", "outer50", "outer95", "mean", "thick", "tip50", "tip95", "seen", "force", "holds"]


def rows_of(*path):
    with open(os.path.join(*path)) as file:
        return list(csv.DictReader(file))


def number(text):
    return float(text) if text else np.nan


def contours_of(rows, membrane, pixel_um):
    """{frame: (n, 2) px} of a membrane, which the two tables name differently."""
    contours = {}
    for row in rows:
        if row["membrane"] == membrane:
            contours.setdefault(int(row["frame"]), []).append((float(row["x_um"]) / pixel_um, float(row["y_um"]) / pixel_um))
    return {frame: np.array(points) for frame, points in contours.items()}


def mean_radius(polygon):
    """Of the circle with the area of a closed polygon (n, 2)."""
    x, y = polygon.T
    return np.sqrt(abs(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / (2 * np.pi))


def distances(points, polygon):
    """Of points (n, 2) from a closed polygon (m, 2), above 0 outside."""
    a, b = polygon, np.roll(polygon, -1, 0)
    a, b = a[np.any(a != b, 1)], b[np.any(a != b, 1)]
    d = b - a
    w = points[:, None] - a
    t = np.clip((w * d).sum(2) / (d * d).sum(1), 0, 1)
    away = np.sqrt(((w - t[..., None] * d) ** 2).sum(2)).min(1)
    crosses = (a[:, 1] > points[:, 1:]) != (b[:, 1] > points[:, 1:])
    with np.errstate(divide="ignore", invalid="ignore"):
        x = a[:, 0] + (points[:, 1:] - a[:, 1]) * d[:, 0] / d[:, 1]
    inside = (crosses & (points[:, :1] < x)).sum(1) % 2 == 1
    return np.where(inside, -away, away)


def run(*command):
    """Its last line is printed where it fails."""
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        print(f"{command[1]}: {(done.stderr or done.stdout).strip().splitlines()[-1:]}", file=sys.stderr)


def measure(film, work, options):
    """What film.json says, and the folder of exported tables; None for this where nothing was measured."""
    name = os.path.basename(film)
    with open(os.path.join(film, "film.json")) as file:
        about = json.load(file)
    session, tables = os.path.join(work, "sessions", name), os.path.join(work, "tables", name)
    if not os.path.exists(tables):
        os.makedirs(os.path.join(work, "sessions"), exist_ok=True)
        run(options.pellucida, "analyze", film, "--output", session, "--pixel-size-um", str(about["pixel_size_um"]),
            "--fps", str(about["frame_rate_hz"]), "--no-frames", *shlex.split(options.options))
        run(options.pellucida, "export", session, "--output", tables, "--no-picture")
    return about, tables if os.path.exists(os.path.join(tables, "measurements.csv")) else None


def compare(film, about, tables):
    pixel_um = about["pixel_size_um"]
    truth = rows_of(film, "t.csv")
    true_outer, true_inner = (contours_of(rows_of(film, "t_contours.csv"), which, pixel_um) for which in ("outer", "inner"))
    rows = {int(row["frame"]): row for row in rows_of(tables, "measurements.csv")}
    has_contours = os.path.exists(os.path.join(tables, "contours.csv"))
    outer, inner = (contours_of(rows_of(tables, "contours.csv"), which, pixel_um) if has_contours else {} for which in "01")
    thickness = [(mean_radius(outer[k]) - mean_radius(inner[k])) / (mean_radius(true_outer[k]) - mean_radius(true_inner[k]))
                 for k, true in enumerate(truth) if true["state"] == "free" and all(k in c for c in (outer, inner, true_outer, true_inner))]
    off, mean, tip, sure, wrong = {}, [], {}, 0, 0
    for k, true in enumerate(truth):
        row = rows.get(k)
        if row is None:
            continue
        if k in outer and k in true_outer:
            away = distances(outer[k], true_outer[k])
            off[k] = np.sqrt((away ** 2).mean())
            mean.append(away.mean())
        place = number(row["tip_x_um"]), number(row["tip_y_um"])
        if np.all(np.isfinite(place)):
            tip[k] = np.hypot(place[0] - float(true["tip_x_um"]), place[1] - float(true["tip_y_um"])) / pixel_um
        if number(row["confidence"]) > SURE:
            sure += 1
            wrong += off.get(k, 0) > WRONG_OUTER_PX or tip.get(k, 0) > WRONG_TIP_PX
    contact = [k for k, true in enumerate(truth) if true["state"] == "contact" and k in rows]
    force = np.array([float(truth[k]["force_uN"]) for k in contact])
    found = np.array([number(rows[k]["contact_force_uN"]) for k in contact])
    lower, upper = (np.array([number(rows[k][f"contact_force_{end}_uN"]) for k in contact]) for end in ("lower", "upper"))
    has_force = found > 0
    given_way = next((k for k, true in enumerate(truth) if true["state"] == "punctured"), None)
    reported = [round(float(event["time_s"]) * about["frame_rate_hz"]) for event in rows_of(tables, "events.csv")
                if event["kind"] == "puncture"]
    real = [k for k in reported if given_way is not None and -1 <= k - given_way <= LATEST_FRAMES]
    percentile = lambda values, share: np.percentile(list(values), share) if len(values) else np.nan
    share = lambda mask: 100 * np.mean(mask) if len(mask) else np.nan
    return {"found": 100 * len(outer) / len(truth), "outer50": percentile(off.values(), 50), "outer95": percentile(off.values(), 95),
            "mean": np.mean(mean) if mean else np.nan, "thick": 100 * (percentile(thickness, 50) - 1),
            "tip50": percentile(tip.values(), 50), "tip95": percentile(tip.values(), 95),
            "sure": sure, "wrong": wrong, "seen": share([rows[k]["state"] == "contact" for k in contact]),
            "puncture": "-" if given_way is None else f"+{real[0] - given_way}" if real else "missed",
            "false": len(reported) - len(real[:1]),
            "force": 100 * np.sqrt(np.mean((found - force)[has_force] ** 2)) / force.max() if has_force.any() else np.nan,
            "holds": share((lower <= force) & (force <= upper))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("films")
    parser.add_argument("work")
    parser.add_argument("--pellucida", default="pellucida", help="the program")
    parser.add_argument("--options", default="", help="further options of `analyze`")
    options = parser.parse_args()
    films = sorted(entry.path for entry in os.scandir(options.films) if os.path.exists(os.path.join(entry.path, "film.json")))
    if not films:
        parser.error(f"{options.films} holds no film (a folder with film.json)")
    print(f"{'film':<14}{'found':>6}{'outer px':>14}{'mean':>7}{'thick %':>8}{'tip px':>13}{'sure':>6}{'wrong':>6}{'seen':>6}{'puncture':>9}{'false':>6}"
          f"{'force %':>8}{'holds':>6}")
    contrasts = {}
    for film in films:
        about, tables = measure(film, options.work, options)
        if tables is None:
            print(f"{os.path.basename(film):<14} nothing measured")
            continue
        r = compare(film, about, tables)
        contrasts.setdefault(about["contrast"], []).append(r)
        print(line_of(os.path.basename(film), r), flush=True)
    for contrast, results in list(contrasts.items()) + [("all", sum(contrasts.values(), []))]:
        middle = {key: np.nanmedian([r[key] for r in results]) if any(np.isfinite(r[key]) for r in results) else np.nan
                  for key in MEDIANS}
        counts = {key: sum(r[key] for r in results) for key in ("sure", "wrong", "false")}
        due = [r["puncture"] for r in results if r["puncture"] != "-"]
        print(line_of(contrast, {**middle, **counts, "puncture": f"{sum(p != 'missed' for p in due)} of {len(due)}"}))


def line_of(name, r):
    return (f"{name:<14}{r['found']:>6.0f}{r['outer50']:>7.2f}{r['outer95']:>7.2f}{r['mean']:>+7.2f}{r['thick']:>+8.0f}{r['tip50']:>7.2f}{r['tip95']:>6.1f}"
            f"{r['sure']:>6}{r['wrong']:>6}{r['seen']:>6.0f}{r['puncture']:>9}{r['false']:>6}{r['force']:>8.1f}{r['holds']:>6.0f}")


if __name__ == "__main__":
    sys.exit(main())

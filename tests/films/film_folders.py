"""What scripts that draw films of finite-element specimens share: their command line, and a film's folder.

A film's folder holds frame_00000.png ..., film.json (pixel size, contrast), t.csv and t_contours.csv in the columns of a
simulated recording's truth; measure_films.py reads it. Needs Debian's python3-numpy, python3-scipy and python3-opencv.
"""
import argparse
import csv
import itertools
import json
import os

import cv2
import numpy as np

from path_optics import find_specimens


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"{self.prog}: {message}\n")


def axes(angle_rad):
    """Unit vectors along an axis and across it, in the image."""
    return np.array([np.cos(angle_rad), np.sin(angle_rad)]), np.array([-np.sin(angle_rad), np.cos(angle_rad)])


def closed(half):
    """A half section (n, 2) in (rho, z) and its mirror image as a polygon in which no point comes twice."""
    return np.r_[half, (half * [-1, 1])[-2:0:-1]]


def write_film(folder, plan, top_um, frames):
    """`frames` yields a picture, the tip, px, the membrane's depth, um, the force, uN, the state, and both outlines, px, or None."""
    pixel_um = plan.pixel_um
    os.makedirs(folder)
    with open(os.path.join(folder, "film.json"), "w") as file:
        json.dump({"pixel_size_um": pixel_um, "contrast": plan.contrast, "specimen": int(plan.number) if plan.has_cell else None,
                   "scale": float(plan.scale), "outcome": plan.outcome, "cell_radius_um": float(top_um) if plan.has_cell else None,
                   "frame_rate_hz": plan.frame_rate_hz}, file, indent=1)
    with open(os.path.join(folder, "t.csv"), "w") as truth, open(os.path.join(folder, "t_contours.csv"), "w") as shapes:
        rows, contours = csv.writer(truth), csv.writer(shapes)
        rows.writerow(["frame", "time_s", "state", "tip_x_um", "tip_y_um", "indentation_um", "force_uN"])
        contours.writerow(["frame", "membrane", "point", "x_um", "y_um"])
        for k, (image, tip_px, depth_um, force_uN, state, outlines) in enumerate(frames):
            cv2.imwrite(os.path.join(folder, f"frame_{k:05d}.png"), image, [cv2.IMWRITE_PNG_COMPRESSION, 1])
            at = tip_px * pixel_um
            rows.writerow([k, k / plan.frame_rate_hz, state, at[0], at[1], depth_um, force_uN])
            for name, outline in zip(("outer", "inner"), outlines or []):
                for i, point in enumerate(outline * pixel_um):
                    contours.writerow([k, name, i, round(point[0], 4), round(point[1], 4)])


def draw_films(text, seed, catalogue, film_of):
    """The command line: `catalogue(specimens, seed)` gives the plans, `film_of(plan, seed)` a film with `frames()` and `top_um`."""
    parser = Parser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="films to make; all when none is named")
    parser.add_argument("--specimens", nargs="+", required=True, metavar="FOLDER", help="tables of finite-element specimens")
    parser.add_argument("--first", type=int, help="smallest number of a specimen")
    parser.add_argument("--last", type=int, help="greatest number of a specimen")
    parser.add_argument("--out", help="folder for the films")
    parser.add_argument("--seed", type=int, default=seed)
    parser.add_argument("--frames", type=int, help="make at most so many frames of each film")
    parser.add_argument("--list", action="store_true", help="print what the films are and make none")
    options = parser.parse_intermixed_args()
    if not options.list and not options.out:
        parser.error("--out is needed, or --list")
    if options.frames is not None and options.frames < 1:
        parser.error("--frames must be at least 1")
    if options.seed < 0:
        parser.error("--seed must not be negative")
    for folder in options.specimens:
        if not os.path.isdir(folder):
            parser.error(f"no such folder: {folder}")
    specimens = find_specimens(options.specimens, options.first, options.last)
    if not specimens:
        parser.error(f"no suitable specimen in {' '.join(options.specimens)}")
    plans = catalogue(specimens, options.seed)
    for name in options.names:
        if name not in [plan.name for plan in plans]:
            parser.error(f"no film is called {name} (--list names them)")
    plans = [plan for plan in plans if not options.names or plan.name in options.names]
    for plan in plans:
        if not options.list and os.path.exists(os.path.join(options.out, plan.name)):
            parser.error(f"{os.path.join(options.out, plan.name)} is there already")
    for plan in plans:
        print(f"{plan.name} specimen {plan.number if plan.has_cell else '-'} pixel {plan.pixel_um:.3f} um, {plan.frame_rate_hz} Hz, "
              f"{plan.frames} frames, {plan.outcome}", flush=True)
        if not options.list:
            film = film_of(plan, options.seed)
            pictures = itertools.islice(film.frames(), options.frames)
            write_film(os.path.join(options.out, plan.name), plan, film.top_um, pictures)

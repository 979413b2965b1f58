"""resources/python/pellucida_session.py against a session of the program: its exported tables, its own hashes.

python_reader.py SESSION EXPORT READER_FOLDER FIGURES_FOLDER; exits with 77 where NumPy is missing.
"""

import csv
import hashlib
import json
import pathlib
import shutil
import struct
import sys

try:
    import numpy
except ImportError:
    print("skipped: this Python has no NumPy (Debian: python3-numpy)")
    sys.exit(77)

folder, export, reader_folder, figures = [pathlib.Path(word) for word in sys.argv[1:5]]
sys.path.insert(0, str(reader_folder))
import pellucida_session  # noqa: E402


def table(name):
    with open(export / name, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def close(one, other, what):
    one, other = numpy.asarray(one, dtype=float), numpy.asarray(other, dtype=float)
    assert one.shape == other.shape, f"{what}: {one.shape} instead of {other.shape}"
    assert len(one), f"{what}: nothing to compare"
    assert numpy.allclose(one, other, rtol=1e-6, atol=1e-6, equal_nan=True), f"{what} differs"


session = pellucida_session.Session(folder)
assert session.complete and len(session) > 10

# The tables, against the exported ones.
rows = table("measurements.csv")
assert session.columns == list(rows[0])
for column in session.columns:
    if column == "state":
        assert list(session[column]) == [row[column] for row in rows]
    else:
        close(session[column], [float(row[column] or "nan") for row in rows], column)
events = table("events.csv")
assert [(event.kind, event.detail) for event in session.events] == [(row["kind"], row["detail"]) for row in events]

# The images, against the hash of all of them in session.json.
sha256 = hashlib.sha256()
for frame in session.frames:
    image = session.image(frame)
    sha256.update(struct.pack("<4q", frame, image.shape[1], image.shape[0], 8 * image.itemsize) + image.tobytes())
assert sha256.hexdigest() == session.info["provenance"]["frames_sha256"], "the images are not those that were written"

# Contours, without the repeated last point.
written = {}
for row in table("contours.csv"):
    written.setdefault((int(row["frame"]), int(row["membrane"])), []).append((row["x_um"], row["y_um"]))
assert len(written) > 10
for (frame, membrane), points in written.items():
    contours = session.membranes(frame)
    place = list(contours.cells["membrane"]).index(membrane)
    line = contours.lines[place]
    assert line[0] == line[-1]
    close(contours.xyz_um[line[:-1], :2], numpy.array(points, dtype=float), f"contour {membrane} of frame {frame}")

# Surfaces with their forces.
nodes = {}
for row in table("nodes.csv"):
    nodes.setdefault(int(row["frame"]), []).append(row)
assert nodes
for frame, rows in nodes.items():
    surface = session.surface(frame)
    close(surface.xyz_um, [[float(row[k]) for k in ("x_um", "y_um", "z_um")] for row in rows], "nodes")
    close(surface.points["force_uN"], [[float(row[k]) for k in ("fx_uN", "fy_uN", "fz_uN")] for row in rows], "forces")
    assert list(surface.points["membrane"]) == [int(row["membrane"]) for row in rows]
    # Closed and oriented outward: flat faces enclose a little less than the volume the file states.
    corners = surface.xyz_um[surface.triangles()]
    outer = surface.points["membrane"][surface.triangles()[:, 0]] == 0
    volumes = numpy.einsum("ij,ij->i", corners[:, 0], numpy.cross(corners[:, 1], corners[:, 2])) / 6.0
    assert 0.99 < volumes[outer].sum() / surface.field["volume_um3"][0] < 1.0
assert session.tools(session.frames[0]).lines

# The recorded hand.
ticks = [row for row in table("haptics.csv") if row["path"] == "hand"]
hand = [session.hand(block) for block in range(session.hand_block_count())]
time_s = numpy.concatenate([block.points["time_s"][block.lines[0]] for block in hand])
close(time_s, [float(row["time_s"]) for row in ticks], "time of the ticks")

# VTK's own objects, where this Python has VTK.
try:
    import vtkmodules.vtkCommonCore  # noqa: F401
except ImportError:
    print("without VTK: Poly.to_vtk not tried")
else:
    data = session.surface(session.frames[0]).to_vtk()
    assert data.GetNumberOfPoints() == len(session.surface(session.frames[0]).xyz_um)
    assert data.GetPointData().GetArray("displacement_um").GetNumberOfComponents() == 3

# Damage is noticed: a changed row is left out, a changed file refused.
copy = folder.parent / "damaged copy"
shutil.rmtree(copy, ignore_errors=True)
shutil.copytree(folder, copy)
lines = (copy / "measurements.csv").read_bytes().split(b"\n")
lines[3] = lines[3].replace(b"free", b"lost")
(copy / "measurements.csv").write_bytes(b"\n".join(lines))
file = copy / "surface" / f"surface_{session.frames[0]:08d}.vtp"
content = bytearray(file.read_bytes())
content[-100] ^= 1
file.write_bytes(content)
damaged = pellucida_session.Session(copy)
assert len(damaged) == len(session) - 1
try:
    damaged.surface(session.frames[0])
    raise SystemExit("a changed file was read")
except pellucida_session.SessionError as error:
    assert "not as it was written" in str(error)
for bad in (folder.parent, copy / "frames"):
    try:
        pellucida_session.Session(bad)
        raise SystemExit(f"{bad} was read as a session")
    except pellucida_session.SessionError:
        pass
assert pellucida_session.sessions_below(folder.parent) == sorted([copy, folder])

# The notebook's cells, one after the other, where this Python has matplotlib.
try:
    import matplotlib
except ImportError:
    print("without matplotlib (Debian: python3-matplotlib): the notebook was not tried")
    sys.exit(0)
matplotlib.use("Agg")
import os  # noqa: E402

os.environ.update(PELLUCIDA_SESSION=str(folder), PELLUCIDA_FIGURES=str(figures))
shutil.rmtree(figures, ignore_errors=True)
names = {"__name__": "__main__"}
for cell in json.loads((reader_folder / "figures.ipynb").read_text(encoding="utf-8"))["cells"]:
    if cell["cell_type"] == "code":
        exec("".join(cell["source"]), names)  # noqa: S102
for name in ("force_time", "force_indentation", "frame", "surface"):
    assert (figures / f"{name}.pdf").stat().st_size > 5000, name
    assert (figures / f"{name}.png").stat().st_size > 5000, name
print("all agrees")

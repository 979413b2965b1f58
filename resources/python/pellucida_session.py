"""Reads the sessions that Pellucida writes (docs/file-format.md). Needs NumPy; VTK only for `Poly.to_vtk`.

    import pellucida_session
    session = pellucida_session.Session("results/cell4")
    session["contact_force_uN"]          a column of measurements.csv, NaN where nothing was measured
    session.events                       [Event(time_s, kind, detail), ...] in the order of time
    session.image(12)                    frame 12 as an array (rows x columns)
    session.membranes(12)                its contours: points in um, closed lines, arrays by name
    session.surface(12).points["force_uN"]
    session.hand(0)                      the first block of the recorded hand

Lengths are in um, forces in uN, times in s, in the frame of the image plane: origin at the centre of the top-left
pixel, x right, y down, z into the scene. A part that a frame lacks is None. What can't be read, or does not agree with
its checksum, raises SessionError.
"""

import csv
import json
import pathlib
import struct
import xml.etree.ElementTree
import zlib
from typing import NamedTuple

import numpy

SCHEMA_VERSION = 1


class SessionError(Exception):
    """A session, or a file of it, that can't be read: what, where, why."""


class Event(NamedTuple):
    time_s: float
    kind: str
    detail: str


class Poly(NamedTuple):
    """Points with lines and faces.

    xyz_um: (points x 3). lines, polygons: lists of arrays of indices into the points; a closed line repeats its first
    index at its end. points, cells, field: arrays by name, (n,) or (n x components); of `cells` the lines come first,
    then the polygons.
    """

    xyz_um: numpy.ndarray
    lines: list
    polygons: list
    points: dict
    cells: dict
    field: dict

    def triangles(self):
        """The faces as triangles (n x 3): polygons as fans."""
        return numpy.array([(p[0], p[k], p[k + 1]) for p in self.polygons for k in range(1, len(p) - 1)], dtype=int)

    def to_vtk(self):
        """The same as vtkPolyData, with its arrays. Needs VTK."""
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

        data = vtkPolyData()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(numpy.ascontiguousarray(self.xyz_um), deep=True))
        data.SetPoints(points)
        for cells, put in ((self.lines, data.SetLines), (self.polygons, data.SetPolys)):
            array = vtkCellArray()
            for cell in cells:
                array.InsertNextCell(len(cell), [int(index) for index in cell])
            put(array)
        for arrays, owner in ((self.points, data.GetPointData()), (self.cells, data.GetCellData()),
                              (self.field, data.GetFieldData())):
            for name, values in arrays.items():
                array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
                array.SetName(name)
                owner.AddArray(array)
        return data


class Session:
    """One session folder, closed or interrupted. Data files are read when they are asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.info = _read_head(self.folder / "session.json")
        header, rows = _read_table(self.folder / "measurements.csv")
        self.columns = header
        self.frames = [int(row[0]) for row in rows]
        self._values = {}
        for place, name in enumerate(header):
            column = [row[place] for row in rows]
            if name == "state":
                self._values[name] = numpy.array(column, dtype=object)
            elif name == "frame":
                self._values[name] = numpy.array(self.frames, dtype=int)
            else:
                self._values[name] = numpy.array([float(cell) if cell else numpy.nan for cell in column])
        _, rows = _read_table(self.folder / "events.csv")
        # While a session is written, its events are in the order in which they came to be known.
        self.events = sorted((Event(float(row[0]), row[1], row[2]) for row in rows), key=lambda event: event.time_s)
        self._checksums = _read_checksums(self.folder / "checksums.csv")

    def __len__(self):
        return len(self.frames)

    def __getitem__(self, column):
        """A column of measurements.csv, one value a row."""
        return self._values[column]

    @property
    def complete(self):
        """False while the session is being written, and after a crash."""
        return bool(self.info["complete"])

    @property
    def pixel_size_um(self):
        return self.info["calibration"]["pixel_size_um"]

    def image(self, frame):
        """The image of a frame: (rows x columns), uint8 or uint16, row 0 at the top; None if it was not kept."""
        file = self._file("frames", "frame", frame, "vti")
        if not file:
            return None
        root, array = _read_vtk(file, self._checksums, self.folder)
        image = root.find("ImageData")
        low_x, high_x, low_y, high_y = [int(word) for word in image.get("WholeExtent").split()][:4]
        values = array(image.find("Piece/PointData/DataArray[@Name='intensity']"))
        return values.reshape(high_y - low_y + 1, high_x - low_x + 1)

    def membranes(self, frame):
        """The contours; `cells["membrane"]`: 0 outer, 1 inner, 2 oolemma."""
        return self._poly("membranes", "membranes", frame)

    def surface(self, frame):
        """The closed surface with displacements and, where a force was measured, forces on its points."""
        return self._poly("surface", "surface", frame)

    def tools(self, frame):
        """Needle and holding pipette as open lines; the needle's first point is its tip."""
        return self._poly("tools", "tools", frame)

    def hand_block_count(self):
        return len(sorted((self.folder / "haptics").glob("haptics_*.vtp")))

    def hand(self, block):
        """A block of the recorded hand: two lines, the hand's way and the tip's, a point a tick."""
        return self._poly("haptics", "haptics", block)

    def _file(self, folder, stem, number, ending):
        file = self.folder / folder / f"{stem}_{number:08d}.{ending}"
        return file if file.is_file() else None

    def _poly(self, folder, stem, number):
        file = self._file(folder, stem, number, "vtp")
        return _read_poly(file, self._checksums, self.folder) if file else None


def sessions_below(folder):
    """Every session in a folder and below it, as paths; the results of a batch, for example."""
    return sorted(head.parent for head in pathlib.Path(folder).rglob("session.json") if ".unfinished" not in head.parts)


def _read_head(file):
    try:
        info = json.loads(file.read_text(encoding="utf-8"))
        version = info["schema_version"]
    except FileNotFoundError:
        raise SessionError(f"{file}: no such file; give the folder of a session") from None
    except (OSError, ValueError, KeyError, TypeError) as fault:
        raise SessionError(f"{file}: can't be read ({fault}); try pellucida check --repair") from fault
    if version != SCHEMA_VERSION:
        raise SessionError(f"{file}: schema version {version}; this reader knows {SCHEMA_VERSION}")
    return info


def _read_table(file):
    """Header and rows without the checksums; rows that are torn or were changed are left out."""
    try:
        lines = file.read_bytes().split(b"\n")
    except OSError as fault:
        raise SessionError(f"{file}: can't be read ({fault})") from fault
    header = next(csv.reader([lines[0].decode("utf-8")]))
    signed = header[-1] == "row_crc32"
    rows = []
    # Behind the last line end there is nothing, or a row that was not finished.
    for line in lines[1:-1]:
        if signed:
            text, _, crc = line.rpartition(b",")
            if b"%08x" % zlib.crc32(text) != crc:
                continue
        else:
            text = line
        row = next(csv.reader([text.decode("utf-8")]), [])
        if len(row) >= len(header) - signed:
            rows.append(row)
    return header[: len(header) - signed], rows


def _read_checksums(file):
    """File name to (bytes, crc32); empty in a session of an earlier version."""
    if not file.is_file():
        return {}
    return {row[0]: (int(row[1]), int(row[2], 16)) for row in _read_table(file)[1]}


def _read_vtk(file, checksums, folder):
    """The XML tree of a VTK file, and a function that decodes one of its arrays."""
    content = file.read_bytes()
    name = file.relative_to(folder).as_posix()
    if name in checksums and checksums[name] != (len(content), zlib.crc32(content)):
        raise SessionError(f"{file}: not as it was written; try pellucida check --repair")
    # The data follow the first underscore inside <AppendedData>, which is no XML.
    place = content.find(b"<AppendedData")
    start = content.find(b"_", place) + 1
    if place < 0 or start == 0:
        raise SessionError(f"{file}: not a VTK file with appended data")
    root = xml.etree.ElementTree.fromstring(content[:place] + b"</VTKFile>")
    word = {"UInt32": "I", "UInt64": "Q"}[root.get("header_type", "UInt32")]
    decompress = {None: None, "vtkZLibDataCompressor": zlib.decompress, "vtkLZ4DataCompressor": _lz4}[
        root.get("compressor")]

    def words(offset, count):
        return struct.unpack_from(f"<{count}{word}", content, start + offset)

    def array(element):
        offset, size = int(element.get("offset")), struct.calcsize(word)
        if decompress is None:
            (byte_count,) = words(offset, 1)
            data = content[start + offset + size : start + offset + size + byte_count]
        else:
            # Number of blocks, size of a block, size of the last one if it is shorter (else 0), compressed sizes.
            (block_count,) = words(offset, 1)
            sizes = words(offset, 3 + block_count)[3:] if block_count else ()
            at = start + offset + (3 + block_count) * size
            data = b""
            for compressed in sizes:
                data += decompress(content[at : at + compressed])
                at += compressed
        kind = {"Float": "f", "Int": "i", "UInt": "u"}[element.get("type").rstrip("0123456789")]
        bits = int("".join(c for c in element.get("type") if c.isdigit()))
        values = numpy.frombuffer(data, dtype=numpy.dtype(f"<{kind}{bits // 8}"))
        components = int(element.get("NumberOfComponents", "1"))
        return values.reshape(-1, components) if components > 1 else values

    return root, array


def _read_poly(file, checksums, folder):
    root, array = _read_vtk(file, checksums, folder)
    data = root.find("PolyData")
    piece = data.find("Piece")

    def by_name(element):
        return {} if element is None else {one.get("Name"): array(one) for one in element.findall("DataArray")}

    def cells(kind):
        element = piece.find(kind)
        if element is None:
            return []
        parts = by_name(element)
        if not len(parts.get("offsets", ())):
            return []
        # An offset is where a cell's indices end.
        return numpy.split(parts["connectivity"], parts["offsets"][:-1])

    points = piece.find("Points/DataArray")
    xyz_um = array(points).reshape(-1, 3) if points is not None else numpy.zeros((0, 3))
    return Poly(xyz_um, cells("Lines"), cells("Polys"), by_name(piece.find("PointData")),
                by_name(piece.find("CellData")), by_name(data.find("FieldData")))


def _lz4(block):
    """One LZ4 block without a frame (github.com/lz4/lz4, doc/lz4_Block_format.md)."""
    result = bytearray()
    at = 0
    while at < len(block):
        token = block[at]
        at += 1
        literal_count = token >> 4
        if literal_count == 15:
            while True:
                literal_count += block[at]
                at += 1
                if block[at - 1] != 255:
                    break
        result += block[at : at + literal_count]
        at += literal_count
        if at >= len(block):
            break
        distance = block[at] | block[at + 1] << 8
        at += 2
        match_count = (token & 15) + 4
        if match_count == 19:
            while True:
                match_count += block[at]
                at += 1
                if block[at - 1] != 255:
                    break
        begin = len(result) - distance
        if distance >= match_count:
            result += result[begin : begin + match_count]
        else:
            # The match runs into what it makes: a pattern that repeats.
            pattern = bytes(result[begin:])
            result += (pattern * (match_count // distance + 1))[:match_count]
    return bytes(result)

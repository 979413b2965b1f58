#!/usr/bin/env python3
"""Ends recordings of the program at moments of chance and holds what is left against what was seen of it before.

    crash_harness.py PROGRAM FOLDER [--kills N] [--full-disks N] [--power-cuts N] [--seed S]

--kills       SIGKILL while `analyze`, `inject` or `simulate` writes
--full-disks  the same on a file system (tmpfs or ext4 on a loop device, in turns) that is full at some moment
--power-cuts  the same on ext4 on a loop device that is shut down without flushing anything (FS_IOC_SHUTDOWN), then mounted anew

Of each: `check` ends without a crash, `check --repair` mends it, a second `check` finds nothing, `export` reads all of it,
and the rows that were in the table before the end are still there: all of them after a kill and on a full disk, all but
those of the last second after a power cut. File systems are mounted by root alone. Exit code: 0, 1 for a failure, 77 where
nothing can be mounted. Standard library alone."""
import argparse
import ctypes
import fcntl
import os
import random
import shutil
import signal
import struct
import subprocess
import sys
import threading
import time
import zlib
from pathlib import Path

MOST_LOST_S = 1.0
HANG_S = 300
# A block of the hand covers a second of the session: one that is not full yet is lost with its process.
MOST_HAND_LOST_S = 1.5
FS_IOC_SHUTDOWN = 0x8004587D  # _IOR('X', 125, __u32), linux/fs.h
WITHOUT_LOG_FLUSH = 2


class Skip(Exception):
    pass


def run(command, **options):
    return subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", timeout=HANG_S, **options)


def fill(folder):
    """Every kind of recording in turns: what it is called, its arguments, where it writes."""
    session = folder / "session"
    return [("analyze", ["analyze", "virtual", "--output", session], session),
            ("inject", ["inject", "--output", session], session),
            ("analyze --no-frames", ["analyze", "virtual", "--no-frames", "--output", session], session),
            ("simulate", ["simulate", "--output", folder / "images"], folder / "images")]


class Watcher(threading.Thread):
    """Notes when each row of the table, or each image, was seen first."""

    def __init__(self, output):
        super().__init__(daemon=True)
        self.output, self.seen_s, self.ended = output, [], threading.Event()

    def count(self):
        table = self.output / "measurements.csv"
        try:
            if table.exists():
                return max(0, table.read_bytes().count(b"\n") - 1)
            return sum(1 for name in os.listdir(self.output) if name.endswith(".png"))
        except OSError:
            return 0

    def run(self):
        while not self.ended.is_set():
            now = time.monotonic()
            count = self.count()
            self.seen_s += [now] * (count - len(self.seen_s))
            time.sleep(0.004)

    def stop(self):
        self.ended.set()
        self.join()


class Result:
    def __init__(self, kind):
        self.kind, self.runs, self.before, self.faults = kind, 0, 0, []
        self.rows, self.lost_rows, self.lost_s, self.hand_lost_s, self.repaired = 0, 0, [], [], 0

    def count_run(self):
        self.runs += 1
        if self.runs % 20 == 0:
            print(f"{self.line()}", file=sys.stderr, flush=True)

    def fault(self, run_name, text):
        self.faults.append(f"{run_name}: {text}")
        print(f"FAULT {self.kind}, {run_name}: {text}", flush=True)

    def line(self):
        worst = max(self.lost_s, default=0.0)
        hand = f", of the hand at most {max(self.hand_lost_s):.2f} s" if self.hand_lost_s else ""
        return (f"{self.kind}: {self.runs} runs ({self.before} ended before anything was recorded), {self.rows} rows seen, "
                f"{self.repaired} repaired, {len(self.faults)} faults; lost {self.lost_rows} rows, at most {worst:.2f} s"
                f"{hand}")


def times_of(table):
    lines = table.read_text(errors="replace").splitlines()
    column = lines[0].split(",").index("time_s")
    return [float(line.split(",")[column]) for line in lines[1:]]


def png_is_whole(file):
    data = file.read_bytes()
    at = 8
    while at + 12 <= len(data):
        (size,) = struct.unpack(">I", data[at:at + 4])
        body = data[at + 4:at + 8 + size]
        if zlib.crc32(body) != int.from_bytes(data[at + 8 + size:at + 12 + size], "big"):
            return False
        if body[:4] == b"IEND":
            return True
        at += 12 + size
    return False


def lose(name, watcher, kept, end_s, most_lost_s, result):
    """Counts the rows behind the first `kept` ones as lost."""
    seen = len(watcher.seen_s)
    if kept >= seen:
        return
    lost_s = end_s - watcher.seen_s[kept]
    result.lost_rows += seen - kept
    result.lost_s.append(lost_s)
    if lost_s > most_lost_s:
        result.fault(name, f"{seen - kept} rows of {seen} lost, the first seen {lost_s:.2f} s before the end")


def examine(program, name, output, watcher, end_s, most_lost_s, result, scratch):
    """What is left of one run."""
    seen = len(watcher.seen_s)
    result.rows += seen
    if name == "simulate":
        images = sorted(output.glob("*.png")) if output.exists() else []
        torn = [file.name for file in images if not png_is_whole(file)]
        kept = len(images)
        if torn:
            result.fault(name, f"{len(torn)} torn images, the first {torn[0]} of {kept}")
    else:
        if not (output / "session.json").exists():
            # Nothing was on the disk yet: the head is the first file of a session.
            result.before += 1
            lose(name, watcher, 0, end_s, most_lost_s, result)
            return
        first = run([program, "check", output])
        if first.returncode not in (0, 3):
            result.fault(name, f"check: exit {first.returncode}: {first.stdout[-300:]}")
        mend = run([program, "check", output, "--repair"])
        result.repaired += "repaired:" in mend.stdout
        second = run([program, "check", output])
        if mend.returncode != 0 or second.returncode != 0 or not second.stdout.rstrip().endswith("fine"):
            result.fault(name, f"unreadable after repair: {mend.stdout[-600:]} {second.stdout[-600:]}")
            return
        times = times_of(output / "measurements.csv")
        kept = len(times)
        if kept:
            export = run([program, "export", output, "--output", scratch / "export"])
            if export.returncode != 0:
                result.fault(name, f"export: exit {export.returncode}: {export.stdout[-300:]}")
            elif name == "inject" and (scratch / "export/haptics.csv").exists():
                result.hand_lost_s.append(max(0.0, times[-1] - times_of(scratch / "export/haptics.csv")[-1]))
                if result.hand_lost_s[-1] > MOST_HAND_LOST_S:
                    result.fault(name, f"{result.hand_lost_s[-1]:.2f} s of the hand lost")
            shutil.rmtree(scratch / "export", ignore_errors=True)
    lose(name, watcher, kept, end_s, most_lost_s, result)


def start(program, arguments):
    return subprocess.Popen([str(program)] + [str(a) for a in arguments], stdout=subprocess.DEVNULL,
                            stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True, errors="replace")


def wait_for_first(process, watcher, chance):
    """Until something is recorded, and then a while; seldom not so long."""
    if chance.random() < 0.1:
        time.sleep(chance.uniform(0.0, 1.0))
        return
    limit = time.monotonic() + HANG_S
    while process.poll() is None and not watcher.seen_s and time.monotonic() < limit:
        time.sleep(0.005)
    time.sleep(chance.choice([chance.uniform(0.0, 0.3), chance.uniform(0.3, 2.5)]))


def kills(program, folder, count, chance):
    result = Result("kills")
    for i in range(count):
        place = folder / "kill"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        name, arguments, output = fill(place)[i % 4]
        watcher = Watcher(output)
        watcher.start()
        process = start(program, arguments)
        wait_for_first(process, watcher, chance)
        process.kill()
        end_s = time.monotonic()
        process.communicate()
        watcher.stop()
        result.count_run()
        examine(program, name, output, watcher, end_s, 0.0, result, folder)
    return result


class Mounted:
    """A file system of `megabytes` at `folder`/m, unmounted at the end."""

    def __init__(self, folder, kind, megabytes):
        self.at, self.image, self.kind = folder / "m", folder / "image", kind
        self.at.mkdir(parents=True, exist_ok=True)
        if kind == "ext4":
            with open(self.image, "wb") as file:
                file.truncate(megabytes << 20)
            made = run(["/sbin/mkfs.ext4", "-q", "-F", "-m", "0", self.image])
            if made.returncode != 0:
                raise Skip(f"mkfs.ext4: {made.stdout.strip()}")
        self.megabytes = megabytes
        self.mount()

    def mount(self):
        options = ["-t", "tmpfs", "-o", f"size={self.megabytes}m", "none"]
        if self.kind == "ext4":
            options = ["-o", "loop", self.image]
        done = run(["mount"] + options + [self.at])
        if done.returncode != 0:
            raise Skip(f"a {self.kind} can't be mounted here: {done.stdout.strip()}")

    def cut_power(self):
        """Nothing more reaches the image, whatever the system had yet to write."""
        descriptor = os.open(self.at, os.O_RDONLY)
        try:
            fcntl.ioctl(descriptor, FS_IOC_SHUTDOWN, struct.pack("I", WITHOUT_LOG_FLUSH))
        except OSError as error:
            raise Skip(f"the file system can't be shut down: {error}") from error
        finally:
            os.close(descriptor)

    def unmount(self):
        for _ in range(50):
            if run(["umount", self.at]).returncode == 0:
                return
            time.sleep(0.1)
        run(["umount", "-l", self.at])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.unmount()
        self.image.unlink(missing_ok=True)


def full_disks(program, folder, count, chance):
    result = Result("full disks")
    for i in range(count):
        with Mounted(folder / "disk", "tmpfs" if i % 2 else "ext4", chance.randint(1 if i % 2 else 2, 14)) as disk:
            name, arguments, output = fill(disk.at)[(i // 2) % 4]
            # Without images an hour fits on a few megabytes: the rest is taken.
            if name == "analyze --no-frames":
                (disk.at / "others").write_bytes(bytes(int(shutil.disk_usage(disk.at).free * chance.uniform(0.5, 0.98))))
            watcher = Watcher(output)
            watcher.start()
            process = start(program, arguments)
            try:
                _, err = process.communicate(timeout=HANG_S)
            except subprocess.TimeoutExpired:
                process.kill()
                _, err = process.communicate()
                result.fault(name, "hangs on a full disk")
            time.sleep(0.02)
            end_s = time.monotonic()
            watcher.stop()
            result.count_run()
            if process.returncode == 0:
                result.before += 1
                continue
            if process.returncode != 5 or "No space left on device" not in err:
                result.fault(name, f"exit {process.returncode}: {err[-300:]}")
            # On the full disk a repair may fail; it must lose nothing. What is left is examined where there is room.
            if name != "simulate" and (output / "session.json").exists():
                there = run([program, "check", output, "--repair"])
                if there.returncode not in (0, 3, 5):
                    result.fault(name, f"repair on the full disk: exit {there.returncode}: {there.stdout[-300:]}")
            copy = folder / "copy"
            shutil.rmtree(copy, ignore_errors=True)
            if output.exists():
                shutil.copytree(output, copy, symlinks=True)
            examine(program, name, copy, watcher, end_s, 0.0, result, folder)
    return result


def power_cuts(program, folder, count, chance):
    result = Result("power cuts")
    for i in range(count):
        with Mounted(folder / "disk", "ext4", 192) as disk:
            name, arguments, output = fill(disk.at)[i % 4]
            watcher = Watcher(output)
            watcher.start()
            process = start(program, arguments)
            wait_for_first(process, watcher, chance)
            disk.cut_power()
            end_s = time.monotonic()
            watcher.stop()
            process.kill()
            process.communicate()
            disk.unmount()
            disk.mount()
            result.count_run()
            examine(program, name, output, watcher, end_s, MOST_LOST_S, result, folder)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("folder", type=Path)
    for option in ("kills", "full-disks", "power-cuts"):
        parser.add_argument("--" + option, type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    folder = given.folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    program = given.program.resolve()
    if (given.full_disks or given.power_cuts) and sys.platform == "linux":
        # Mounts of our own: nobody else sees them, and they end with this process.
        libc = ctypes.CDLL(None, use_errno=True)
        if os.geteuid() != 0 or libc.unshare(0x00020000) != 0 or libc.mount(b"none", b"/", None, 0x44000, None) != 0:
            print("skipped: file systems of a limited size are mounted by root alone")
            return 77
    chance = random.Random(given.seed)
    results = []
    try:
        for kind, count in ((kills, given.kills), (full_disks, given.full_disks), (power_cuts, given.power_cuts)):
            if count:
                started = time.monotonic()
                results.append(kind(program, folder, count, chance))
                print(f"{results[-1].line()}; {time.monotonic() - started:.0f} s", flush=True)
    except Skip as reason:
        print(f"skipped: {reason}")
        return 77
    return 1 if any(result.faults for result in results) else 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    sys.exit(main())

#!/usr/bin/python3
"""Writes the mean of networks of one make, by the weights given, as a network of its own.

    python3 mean_of.py tip_fine.onnx 1 before.onnx 1 after.onnx

Needs Debian's python3-onnx and python3-numpy.
"""
import sys

import onnx
from onnx import numpy_helper


def layers_of(model):
    """The weights of each layer, in the order in which the layers run."""
    values = {one.name: one for one in model.graph.initializer}
    return [values[name] for node in model.graph.node if node.op_type in ("Conv", "ConvTranspose", "Gemm")
            for name in node.input[1:]]


def main():
    if len(sys.argv) < 4 or len(sys.argv) % 2:
        raise SystemExit(__doc__)
    output, weights, models = sys.argv[1], [float(text) for text in sys.argv[2::2]], [onnx.load(path) for path in sys.argv[3::2]]
    for parts in zip(*map(layers_of, models), strict=True):
        mean = sum(weight * numpy_helper.to_array(part) for weight, part in zip(weights, parts)) / sum(weights)
        parts[0].CopyFrom(numpy_helper.from_array(mean.astype("float32"), parts[0].name))
    onnx.save(models[0], output)


if __name__ == "__main__":
    main()

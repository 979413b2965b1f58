#!/usr/bin/python3
"""The weighted mean of two networks' weights, one of which was trained on from the other.

    python3 average.py FIRST.onnx SECOND.onnx SHARE OUTPUT.onnx      (SHARE of the second, 0 to 1)

What a network learns in addition may cost some of what it knew; on the way between the two it often keeps both (Wortsman et
al., Robust fine-tuning of zero-shot models, CVPR 2022). Needs Debian's python3-onnx and python3-numpy.
"""
import sys

import numpy as np
import onnx
from onnx import numpy_helper


def weights_of(graph):
    """The initializers of a graph's layers, in the order in which they are used."""
    values = {one.name: one for one in graph.initializer}
    return [values[name] for node in graph.node for name in node.input[1:] if name in values and node.op_type in ("Conv", "ConvTranspose", "Gemm")]


def main():
    if len(sys.argv) != 5:
        raise SystemExit(__doc__)
    first, second, share = onnx.load(sys.argv[1]), onnx.load(sys.argv[2]), float(sys.argv[3])
    pairs = list(zip(weights_of(first.graph), weights_of(second.graph), strict=True))
    for one, other in pairs:
        a, b = numpy_helper.to_array(one), numpy_helper.to_array(other)
        if a.shape != b.shape:
            raise SystemExit(f"{one.name}: {a.shape}, {other.name}: {b.shape}; the two networks are not of one kind")
        one.CopyFrom(numpy_helper.from_array(((1 - share) * a + share * b).astype(np.float32), one.name))
    onnx.save(first, sys.argv[4])


if __name__ == "__main__":
    main()

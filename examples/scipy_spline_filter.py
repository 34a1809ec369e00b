"""Runs scipy's spline filter and the certified prefilter on one volume, on one core, and compares what they return.

    cargo build --release --example prefilter
    taskset -c 0 python3 examples/scipy_spline_filter.py target/release/examples/prefilter [SIDE] [REPEATS]

Prints the median CPU times, their ratio, how many of scipy's coefficients are correctly rounded, and its largest error in ULP.
"""

import os

os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", MKL_NUM_THREADS="1")

import statistics
import subprocess
import sys
import tempfile
import time

import numpy
from scipy.ndimage import spline_filter


def median_of_scipy(volume, repeats):
    times = []
    for _ in range(repeats):
        start = time.process_time()
        result = spline_filter(volume, order=3, mode="mirror")
        times.append(time.process_time() - start)
    return statistics.median(times), result


def median_of_ours(program, volume, repeats):
    with tempfile.TemporaryDirectory() as folder:
        source, target = os.path.join(folder, "in"), os.path.join(folder, "out")
        volume.astype("<f8").tofile(source)
        # numpy's last axis is the fastest, ours the first.
        shape = [str(n) for n in reversed(volume.shape)]
        lines = subprocess.run(
            [program, source, target, *shape, "mirror", str(repeats)], check=True, capture_output=True, text=True
        ).stdout
        result = numpy.fromfile(target, dtype="<f8").reshape(volume.shape)
    return statistics.median(float(line) for line in lines.split()), result


def main():
    program = sys.argv[1]
    side = int(sys.argv[2]) if len(sys.argv) > 2 else 128
    repeats = int(sys.argv[3]) if len(sys.argv) > 3 else 9
    volume = numpy.random.default_rng(1).standard_normal((side, side, side))
    scipy_time, theirs = median_of_scipy(volume, repeats)
    our_time, ours = median_of_ours(program, volume, repeats)
    ulps = numpy.abs(theirs - ours) / numpy.spacing(numpy.abs(ours))
    print(f"{side}^3 samples, mirror, median CPU seconds of {repeats} runs")
    print(f"scipy.ndimage.spline_filter  {scipy_time:.4f}")
    print(f"isoracle, certified          {our_time:.4f}")
    print(f"ratio                        {our_time / scipy_time:.2f}")
    print(f"scipy correctly rounded      {100 * numpy.mean(theirs == ours):.2f} %")
    print(f"scipy's largest error        {ulps.max():.0f} ULP of the nearest binary64")


if __name__ == "__main__":
    main()

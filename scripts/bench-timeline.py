"""Filters and smooths with filterpy, for scripts/bench-timeline.mjs, which says on its standard input what: microseconds
a reading, and the last mean, which must be that of our own filters. filterpy has no late readings: the beliefs before the
last ones are kept here by hand, and what came after is filtered again."""

import json
import sys
import time

import numpy as np
from filterpy.kalman import KalmanFilter

given = json.load(sys.stdin)
F, V, F_two, V_two, H, W, x, P = (np.array(given[name]) for name in ("F", "V", "Ftwo", "Vtwo", "H", "W", "x", "P"))
readings, late = given["readings"], given["late"]


def fresh():
    kf = KalmanFilter(dim_x=len(x), dim_z=len(H))
    kf.F, kf.Q, kf.H, kf.R, kf.x, kf.P = F, V, H, W, x.reshape(-1, 1), P.copy()
    return kf


def in_order():
    kf = fresh()
    for y in readings:
        kf.predict()
        kf.update(y)
    return kf.x


def one_late():
    """The first of every `late` + 1 readings comes last of them."""
    kf = fresh()
    for first in range(0, len(readings), late + 1):
        block = readings[first : first + late + 1]
        kept = kf.x.copy(), kf.P.copy()
        kf.predict(F=F_two, Q=V_two)
        kf.update(block[1])
        for y in block[2:]:
            kf.predict()
            kf.update(y)
        kf.x, kf.P = kept
        for y in block:
            kf.predict()
            kf.update(y)
    return kf.x


def smoothed():
    """The first state, afterwards."""
    kf = fresh()
    means, covariances, _, _ = kf.batch_filter(readings)
    return kf.rts_smoother(means, covariances)[0][0]


def timed(body):
    began = time.process_time()
    mean = body()
    return {"us": 1e6 * (time.process_time() - began) / len(readings), "x": np.ravel(mean).tolist()}


print(json.dumps({"in order": timed(in_order), "one late": timed(one_late), "smoothed": timed(smoothed)}))

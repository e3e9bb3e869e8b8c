"""Replays the mower's log with filterpy's extended Kalman filter and numpy, for scripts/bench-log.mjs: rows a second, and
the RMS error, which must be that of our own replay. The models are those of crates/estimate/src/drive; the covariance is
predicted by filterpy's own F, Q and P."""

import json
import math
import sys
import time

import numpy as np
from filterpy.kalman import ExtendedKalmanFilter

SIGMA_DISTANCE, SIGMA_TURN, SIGMA_RANGE = 0.05, 0.02, 0.6


def read(path):
    landmarks, truth, rows = {}, [], []
    for line in open(path, encoding="utf-8"):
        if line.startswith("#") or not line.strip():
            continue
        letter, *cells = line.strip().split(",")
        numbers = [float(cell) for cell in cells]
        if letter == "L":
            landmarks[int(numbers[0])] = numbers[1:]
        elif letter == "G":
            truth.append(numbers)
        else:
            rows.append((numbers[0], letter == "R", len(rows), numbers))
    return landmarks, np.array(sorted(truth)), sorted(rows)


class Mower(ExtendedKalmanFilter):
    """Distance and turn as the input."""

    def predict_x(self, u=0):
        distance, turn = u
        theta = self.x[2]
        step = [distance * math.cos(theta), distance * math.sin(theta), turn]
        self.x = np.array([self.x[0] + step[0], self.x[1] + step[1], theta + step[2]])


def jacobian(x, at):
    dx, dy = x[0] - at[0], x[1] - at[1]
    rho = math.hypot(dx, dy)
    return np.array([[dx / rho, dy / rho, 0.0]])


def expected(x, at):
    return np.array([math.hypot(x[0] - at[0], x[1] - at[1])])


def replay(landmarks, truth, rows):
    ekf = Mower(dim_x=3, dim_z=1)
    start = truth[0]
    ekf.x, ekf.P = start[1:4].copy(), np.diag([0.04, 0.04, 0.01])
    w = np.array([[SIGMA_RANGE**2]])
    before, track = start[0], []
    for t, sighting, _, numbers in rows:
        if t < start[0]:
            continue
        if sighting:
            at = landmarks[int(numbers[1])]
            ekf.update(np.array([numbers[2]]), jacobian, expected, R=w, args=(at,), hx_args=(at,))
            continue
        distance, turn = numbers[1:]
        c, s = math.cos(ekf.x[2]), math.sin(ekf.x[2])
        dt = t - before
        ekf.F = np.array([[1.0, 0.0, -distance * s], [0.0, 1.0, distance * c], [0.0, 0.0, 1.0]])
        q = SIGMA_DISTANCE**2 * dt
        ekf.Q = np.array([[c * c * q, c * s * q, 0.0], [c * s * q, s * s * q, 0.0], [0.0, 0.0, SIGMA_TURN**2 * dt]])
        ekf.predict((distance, turn))
        before = t
        track.append((t, ekf.x[0], ekf.x[1]))
    return np.array(track)


landmarks, truth, rows = read(sys.argv[1])
began = time.perf_counter()
track = replay(landmarks, truth, rows)
rate = len(rows) / (time.perf_counter() - began)
x, y = (np.interp(track[:, 0], truth[:, 0], truth[:, i]) for i in (1, 2))
rmse = math.sqrt(np.mean((track[:, 1] - x) ** 2 + (track[:, 2] - y) ** 2))
print(json.dumps({"filterpy": round(rate), "rmse": rmse}))

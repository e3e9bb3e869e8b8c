// Two filters unrolled by hand in JavaScript, in Joseph form, with numbers in local variables: what the module is
// measured against. They are here only; the page has none.

export const reading = (step) => (step % 7) * 0.3 - 0.9

/** The Kalman step of two states: the rail robot, with its position read. */
export function kalmanInJavaScript(steps) {
  let x1 = 2,
    x2 = 4,
    p11 = 1,
    p12 = 0,
    p22 = 2
  for (let step = 0; step < steps; step++) {
    const u = 0.1,
      y = reading(step),
      t = 0.5
    x1 += t * x2
    x2 += 0.5 * u
    const q12 = p12 + t * p22
    p11 = p11 + t * p12 + t * q12 + 0.2
    p12 = q12 + 0.05
    p22 += 0.1
    const s = p11 + 0.5,
      k1 = p11 / s,
      k2 = p12 / s,
      nu = y - x1
    x1 += k1 * nu
    x2 += k2 * nu
    const a = 1 - k1
    const n11 = a * a * p11 + k1 * k1 * 0.5
    const n12 = a * (p12 - k2 * p11) + k1 * k2 * 0.5
    const n22 = p22 - 2 * k2 * p12 + k2 * k2 * p11 + k2 * k2 * 0.5
    p11 = n11
    p12 = n12
    p22 = n22
  }
  return [x1, x2]
}

// ── The 3-state EKF step of the localizer: predict, and one range–bearing sighting of a named landmark ──
export const start = {
  x: [1.5, 1.5, 0],
  P: [
    [0.01, 0, 0],
    [0, 0.01, 0],
    [0, 0, 0.01],
  ],
}
export const landmark = { id: 1, x: 6, y: 6 }
export const [range, bearing] = [6.363961, -2.3561945]

/** The EKF step of three states: predict, and one sighting. */
export function ekfInJavaScript(steps) {
  const { cos, sin, hypot, atan2, PI, floor } = Math
  const wrap = (a) => a - 2 * PI * floor((a + PI) / (2 * PI))
  let [x, y, th] = start.x
  let a = 0.01,
    b = 0,
    c = 0,
    d = 0.01,
    e = 0,
    f = 0.01
  const ds = 0,
    dth = 0
  for (let step = 0; step < steps; step++) {
    const fx = -ds * sin(th),
      fy = ds * cos(th)
    x += ds * cos(th)
    y += ds * sin(th)
    th = wrap(th + dth)
    const c2 = c + fx * f,
      e2 = e + fy * f
    a = a + fx * c + fx * c2 + 1e-4
    b = b + fx * e + fy * c2
    d = d + fy * e + fy * e2 + 1e-4
    c = c2
    e = e2
    f += 1e-4
    const dx = x - landmark.x,
      dy = y - landmark.y,
      rho = hypot(dx, dy)
    const h0 = dx / rho,
      h1 = dy / rho,
      g0 = -h1 / rho,
      g1 = h0 / rho
    const n0 = range - rho,
      n1 = wrap(bearing - wrap(atan2(dy, dx) - th))
    const m00 = a * h0 + b * h1,
      m10 = b * h0 + d * h1,
      m20 = c * h0 + e * h1
    const m01 = a * g0 + b * g1 - c,
      m11 = b * g0 + d * g1 - e,
      m21 = c * g0 + e * g1 - f
    const s00 = h0 * m00 + h1 * m10 + 0.01,
      s01 = h0 * m01 + h1 * m11,
      s11 = g0 * m01 + g1 * m11 - m21 + 0.001
    const det = s00 * s11 - s01 * s01
    const i00 = s11 / det,
      i01 = -s01 / det,
      i11 = s00 / det
    const k00 = m00 * i00 + m01 * i01,
      k01 = m00 * i01 + m01 * i11
    const k10 = m10 * i00 + m11 * i01,
      k11 = m10 * i01 + m11 * i11
    const k20 = m20 * i00 + m21 * i01,
      k21 = m20 * i01 + m21 * i11
    x += k00 * n0 + k01 * n1
    y += k10 * n0 + k11 * n1
    th = wrap(th + k20 * n0 + k21 * n1)
    const t00 = 1 - k00 * h0 - k01 * g0,
      t01 = -k00 * h1 - k01 * g1,
      t02 = k01
    const t10 = -k10 * h0 - k11 * g0,
      t11 = 1 - k10 * h1 - k11 * g1,
      t12 = k11
    const t20 = -k20 * h0 - k21 * g0,
      t21 = -k20 * h1 - k21 * g1,
      t22 = 1 + k21
    const u00 = t00 * a + t01 * b + t02 * c,
      u01 = t00 * b + t01 * d + t02 * e,
      u02 = t00 * c + t01 * e + t02 * f
    const u10 = t10 * a + t11 * b + t12 * c,
      u11 = t10 * b + t11 * d + t12 * e,
      u12 = t10 * c + t11 * e + t12 * f
    const u20 = t20 * a + t21 * b + t22 * c,
      u21 = t20 * b + t21 * d + t22 * e,
      u22 = t20 * c + t21 * e + t22 * f
    a = u00 * t00 + u01 * t01 + u02 * t02 + 0.01 * k00 * k00 + 0.001 * k01 * k01
    b = u00 * t10 + u01 * t11 + u02 * t12 + 0.01 * k00 * k10 + 0.001 * k01 * k11
    c = u00 * t20 + u01 * t21 + u02 * t22 + 0.01 * k00 * k20 + 0.001 * k01 * k21
    d = u10 * t10 + u11 * t11 + u12 * t12 + 0.01 * k10 * k10 + 0.001 * k11 * k11
    e = u10 * t20 + u11 * t21 + u12 * t22 + 0.01 * k10 * k20 + 0.001 * k11 * k21
    f = u20 * t20 + u21 * t21 + u22 * t22 + 0.01 * k20 * k20 + 0.001 * k21 * k21
  }
  return [x, y, th, a, b, c, d, e, f]
}

/**
 * The system as a program that computes what the figure shows: with the Rust of this book, with its module, with numpy
 * alone.
 */

import { partOf, systemOf } from './presets.js'

/** @typedef {import('estimate-wasm').OwnFrame} Frame */

/**
 * The matrices over a step: of a system in continuous time they are sampled.
 * @param {Frame} frame
 */
function parts({ params, F, G, V, K, tolerance }) {
  const { H, W } = systemOf(params)
  return { F, G, H, V, W, K, start: partOf('P', params)[0], tolerance: String(tolerance) }
}

/**
 * What a program begins with, in comments: what it needs and where that is, and how the matrices came about.
 * @param {string} sign @param {Frame} frame @param {string[]} needs
 */
function head(sign, { params }, needs) {
  const sampled = params.continuous ? [`F, G and V are sampled every ${params.period} s from continuous time.`] : []
  return [...needs, ...sampled].map((line) => `${sign} ${line}\n`).join('')
}

/** @param {number} number as Rust writes a float */
const float = (number) =>
  Number.isInteger(number) && Math.abs(number) < 1e21 ? number.toFixed(1) : String(number).replace('e+', 'e')

/** @param {number[][]} m */
function inRust(m) {
  if (m[0].length === 0) return `DMatrix::zeros(${m.length}, 0)`
  return `dmatrix![${m.map((row) => row.map(float).join(', ')).join('; ')}]`
}

/** @param {Frame} frame */
export function rust(frame) {
  const { F, G, H, V, W, K, start, tolerance } = parts(frame)
  const needs = [
    'The crate robot-motion-estimate, in crates/estimate of the book’s source, and nalgebra:',
    'cargo add robot-motion-estimate --rename estimate --path CHECKOUT/crates/estimate',
    'cargo add nalgebra@0.35 --no-default-features --features alloc,macros,libm-force',
  ]
  return `${head('//', frame, needs)}use estimate::dynamic::{self, System};
use nalgebra::{DMatrix, dmatrix, dvector};

fn main() -> Result<(), estimate::Error> {
    let f: DMatrix<f64> = ${inRust(F)};
    let g: DMatrix<f64> = ${inRust(G)};
    let h: DMatrix<f64> = ${inRust(H)};
    let v: DMatrix<f64> = ${inRust(V)};
    let w: DMatrix<f64> = ${inRust(W)};
    let k: DMatrix<f64> = ${inRust(K)};
    let p0: DMatrix<f64> = DMatrix::from_diagonal(&dvector![${start.map(float).join(', ')}]);
    let tolerance = ${tolerance};

    let rank = dynamic::observability(f.clone(), h.clone(), tolerance)?;
    println!("rank {} {:?}", rank.rank, rank.singular_values);
    let seen = dynamic::detectability(f.clone(), h.clone(), tolerance)?;
    println!("observable {:?}, detectable {:?}", seen.observable, seen.detectable);
    let noise = dynamic::noise_reach(f.clone(), v.clone(), tolerance)?;
    println!("reached by noise {:?}, stabilizable {:?}", noise.reachable, noise.stabilizable);

    let system = System::new(f, g, h, v, w)?;
    println!("limit {:?}", dynamic::riccati_limit(&system, tolerance)?);
    let limit = dynamic::steady_state(&system, p0.clone())?;
    println!("settles {} {:?}", limit.converged, limit.r.transpose().as_slice());
    for l in dynamic::error_eigenvalues(&system, k)? {
        println!("eigenvalue {} {}", l.re, l.im);
    }
    for r in dynamic::gain_schedule(&system, p0, 5)? {
        println!("gain {:?}", r.transpose().as_slice());
    }
    Ok(())
}
`
}

/** @param {Frame} frame */
export function javascript(frame) {
  const { F, G, H, V, W, K, start, tolerance } = parts(frame)
  const written = Object.entries({ F, G, H, V, W })
    .map(([name, m]) => `  ${name}: ${JSON.stringify(m)},`)
    .join('\n')
  const needs = [
    'The package robot-motion: ./scripts/package in the book’s source makes target/npm/robot-motion-*.tgz;',
    'npm install that file.',
  ]
  return `${head('//', frame, needs)}const core = require('robot-motion')

const system = {
${written}
}
const K = ${JSON.stringify(K)}
const P0 = ${JSON.stringify(start)}.map((variance, i, all) => all.map((_, j) => (i === j ? variance : 0)))
const tolerance = ${tolerance}

const { rank, singularValues } = core.observability(system.F, system.H, tolerance)
console.log('rank', rank, JSON.stringify(singularValues))
const { observable, detectable } = core.detectability(system.F, system.H, tolerance)
console.log(\`observable \${observable}, detectable \${detectable}\`)
const { reachable, stabilizable } = core.noiseReach(system.F, system.V, tolerance)
console.log(\`reached by noise \${reachable}, stabilizable \${stabilizable}\`)
console.log('limit', core.riccatiLimit(system, tolerance))
const limit = core.steadyStateGain(system, P0)
console.log('settles', limit.converged, JSON.stringify(limit.R.flat()))
for (const { re, im } of core.errorEigenvalues(system, K)) console.log('eigenvalue', re, im)
for (const R of core.gainSchedule(system, P0, 5)) console.log('gain', JSON.stringify(R.flat()))
`
}

/** @param {Frame} frame */
export function numpy(frame) {
  const { F, G, H, V, W, K, start, tolerance } = parts(frame)
  const n = F.length
  const list = (/** @type {number[][]} */ m) => JSON.stringify(m).replace(/,/g, ', ')
  const written = Object.entries({ F, G, H, V, W, K })
    .map(
      ([name, m]) =>
        `${name} = ${m[0].length === 0 ? `np.zeros((${m.length}, 0))` : `np.array(${list(m)}, dtype=float)`}`,
    )
    .join('\n')
  return `${head('#', frame, ['numpy alone.'])}import numpy as np

${written}
P = np.diag(np.array(${JSON.stringify(start).replace(/,/g, ', ')}, dtype=float))
tolerance = ${tolerance}

Q = np.vstack([H @ np.linalg.matrix_power(F, i) for i in range(${n})])
values = np.append(np.linalg.svd(Q, compute_uv=False), np.zeros(${n}))[:${n}]
print("rank", int(np.sum(values > tolerance * values[0])), values.tolist())
for value in np.linalg.eigvals((np.eye(${n}) - K @ H) @ F):
    print("eigenvalue", value.real, value.imag)
for k in range(5):
    P = F @ P @ F.T + V
    R = np.linalg.solve(H @ P @ H.T + W, H @ P).T
    P = (np.eye(${n}) - R @ H) @ P @ (np.eye(${n}) - R @ H).T + R @ W @ R.T
    print("gain", R.flatten().tolist())
`
}

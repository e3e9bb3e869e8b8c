// A Python with packages: the system’s, else one in a folder of the build, which gets what it lacks.
import { execFileSync, spawnSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import path from 'node:path'

const own = path.join(import.meta.dirname, '../../target/python')

/** @param {Record<string, string>} packages by the names under which they are imported */
export function python(packages = { numpy: 'numpy' }) {
  const has = (program) => spawnSync(program, ['-c', `import ${Object.keys(packages).join(', ')}`]).status === 0
  if (has('python3')) return 'python3'
  const program = path.join(own, 'bin/python3')
  if (!has(program)) {
    if (!existsSync(program)) execFileSync('python3', ['-m', 'venv', own])
    // Not the folder’s own `pip`: in a copy of this folder it still installs into the first.
    execFileSync(program, ['-m', 'pip', 'install', '--quiet', ...Object.values(packages)])
  }
  return program
}

// A Python with packages: the system’s, else one in a folder of the build, which gets what it lacks.
import { execFileSync, spawnSync } from 'node:child_process'
import path from 'node:path'

const own = path.join(import.meta.dirname, '../../target/python')

/** @param {string[]} packages by the names under which they are imported, which are their own */
export function python(packages = ['numpy']) {
  const has = (program) => spawnSync(program, ['-c', `import ${packages.join(', ')}`]).status === 0
  if (has('python3')) return 'python3'
  const program = path.join(own, 'bin/python3')
  if (!has(program)) {
    execFileSync('python3', ['-m', 'venv', own])
    execFileSync(path.join(own, 'bin/pip'), ['install', '--quiet', ...packages])
  }
  return program
}

/** A program as C99 that allocates nothing: matrices are structures of one fixed size, handed over by value. */

import { HELPERS, NEED } from './c-helpers.js'
import { caller } from './calls.js'
import { head, identifiers, remarks, source, TOLERANCE } from './frame.js'
import { helpersOf } from './helpers.js'
import { all } from './node.js'
import { RESERVED } from './reserved.js'
import { typed } from './typed.js'

/** @type {Record<string, string>} */
const MATH = { abs: 'fabs' }

/** @param {number} x a number that no division takes for a whole one */
const float = (x) => (Number.isInteger(x) && Math.abs(x) < 1e21 ? x.toFixed(1) : String(x))
/** @param {string[]} row */
const braces = (row) => `{${row.length > 0 ? row.join(', ') : '0'}}`
/** @param {string[][]} rows @param {number} [columns] */
const structure = (rows, columns = rows[0]?.length ?? 1) =>
  `{${rows.length}, ${columns}, {${rows.length > 0 ? rows.map(braces).join(', ') : '{0}'}}}`
/** @param {number[][]} m */
const data = (m) => structure(m.map((row) => row.map(String)))

/** @param {import('./frame.js').Frame} frame */
export function c(frame) {
  const { given, x, P, start, constants, varying, steps } = frame
  const names = identifiers([x, P, ...given, ...frame.lines.map(({ name }) => name)], RESERVED.c, HELPERS)
  const name = (/** @type {string} */ one) => names.get(one) ?? one
  const known = new Set([x, P, ...given])
  // A name that is a number in one line and a matrix in another is a matrix in all.
  const wide = frame.lines.filter(({ sides: [rows, columns] }) => rows > 1 || columns > 1).map((line) => line.name)
  const matrices = new Set([...known, ...wide])
  const lines = typed(frame.lines, matrices)
  const { text, called } = caller({
    number: float,
    entry: (m, i, j) => {
      if (/^\w+$/.test(m)) return `${m}.at[${i}][${j}]`
      called.add('entry')
      return `entry(${m}, ${i}, ${j})`
    },
    literal: (rows) => `(matrix)${structure(rows)}`,
    scalar: (word) => {
      if (word === 'pi') called.add('pi')
      return MATH[word] ?? word
    },
    name,
  })
  const body = lines.map(({ name: made, part, value }, i) => {
    const first = !known.has(made)
    known.add(made)
    const [top, , left] = part ?? []
    const one = part && part[1] - part[0] === 1 && part[3] - part[2] === 1
    let line = `${name(made)} = ${text(value)};`
    if (one && matrices.has(made)) line = `${name(made)}.at[${top}][${left}] = ${text(value)};`
    else if (part && !one) {
      called.add('put')
      line = `${name(made)} = put(${name(made)}, ${top}, ${left}, ${text(value)});`
    }
    const { formula, remark } = source(frame, i)
    const said = [...remarks(frame, i), remark ? `${formula}; ${remark}` : formula]
    const kind = matrices.has(made) ? 'matrix ' : 'double '
    // A comment of C holds neither the sign that begins one nor the one that ends it.
    const comment = said.map((words) => `    /* ${words.replace(/\*\//g, '* /').replace(/\/\*/g, '/ *')} */\n`).join('')
    return `${comment}    ${first ? kind : ''}${line}\n`
  })
  // What no later line reads is kept for whoever looks for it.
  const read = new Set(lines.flatMap(({ value }) => [...all(value)].map((it) => it.name)))
  const made = new Set(lines.map((line) => line.name))
  const idle = [...made].filter((one) => !read.has(one) && one !== x && one !== P && !given.includes(one))
  const most = Math.max(
    1,
    ...lines.flatMap(({ value, sides }) => [...sides, ...[...all(value)].flatMap((it) => it.sides)]),
    ...[...start, ...constants.map(([, m]) => m), ...(steps[0] ?? [])].flatMap((m) => [m.length, m[0]?.length ?? 1]),
  )
  const helpers = helpersOf(HELPERS, NEED, called).map((one) => `${HELPERS[one]}\n`)
  const inputs = given.map((one) => `matrix ${name(one)}`)
  const arguments_ = given.map((one) => (varying.includes(one) ? `steps[k].${name(one)}` : name(one)))
  const fields = varying.map((one) => `${name(one)}, `).join('')
  return `${head('   ', frame, 'cc -std=c99 filter.c -lm && ./a.out')
    .replace(/^ {3} /, '/*  ')
    .replace(/\n$/, ' */')}
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The most rows or columns of a matrix here; nothing is allocated. */
enum { MOST = ${most} };
typedef struct {
    int rows, columns;
    double at[MOST][MOST];
} matrix;

${helpers.join('\n')}
/* One step: ${name(x)} and ${name(P)} become those behind it. */
static void step(matrix *new_x, matrix *new_P${inputs.map((one) => `, ${one}`).join('')})
{
    matrix ${name(x)} = *new_x, ${name(P)} = *new_P;

${body.join('')}${idle.map((one) => `    (void)${name(one)};\n`).join('')}
    *new_x = ${name(x)};
    *new_P = ${name(P)};
}

static const struct {
    matrix ${fields}expected_x, expected_P;
} steps[] = {
${steps.map((step) => `    {${step.map(data).join(',\n     ')}},\n`).join('')}};

/* How far a matrix is from the expected one, as a part of its largest entry, or of 1. */
static double apart(matrix found, matrix expected)
{
    double off = 0, largest = 1;
    for (int i = 0; i < expected.rows; i++)
        for (int j = 0; j < expected.columns; j++) {
            off = fmax(off, fabs(found.at[i][j] - expected.at[i][j]));
            largest = fmax(largest, fabs(expected.at[i][j]));
        }
    return off / largest;
}

int main(void)
{
    matrix ${name(x)} = ${data(start[0])}, ${name(P)} = ${data(start[1])};
${constants.map(([one, m]) => `    matrix ${name(one)} = ${data(m)};\n`).join('')}
    int count = sizeof steps / sizeof *steps;
    for (int k = 0; k < count; k++) {
        step(&${name(x)}, &${name(P)}${arguments_.map((one) => `, ${one}`).join('')});
        double off = fmax(apart(${name(x)}, steps[k].expected_x), apart(${name(P)}, steps[k].expected_P));
        if (!(off <= ${TOLERANCE})) {
            printf("Step %d is off by %g.\\n", k + 1, off);
            return 1;
        }
    }
    printf("Steps that are right: %d.\\n", count);
    return 0;
}
`
}

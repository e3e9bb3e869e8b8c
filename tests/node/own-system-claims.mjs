// What the sentences of a system of one's own claim, and what has to hold of a frame that says so.
import { pattern, prints } from './claims.mjs'

export const claims = () => {
  // `6.6 × 10⁴` as a number.
  const written = (text) =>
    Number(
      text.replace(/ × 10(.+)/, (_, power) => `e${[...power].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(digit)).join('')}`),
    )
  const sizes = (directions) => directions.length
  // Seen by less than the digits: an eigenvalue other than 0 stays whatever the gain.
  const hardly = ({ observable, eigenvalues }) =>
    observable === 'yes' && eigenvalues.some(({ fixed, modulus }) => fixed && modulus > 1e-6)
  const open = (frame) => frame.observable === 'undecided' || hardly(frame)
  const apart = (list) => list.split(/, | and /).length
  return [
    [
      pattern(
        /^F is taken as what one step does, and looks like one of a differential equation: /,
        /tick “Continuous time” if it is\.$/,
      ),
      ({ looksLikeRates, params }) => looksLikeRates && !params.continuous,
    ],
    [
      pattern(
        /^The filter’s numbers have lost their digits: /,
        /P of the start, V and W lie too many powers of ten apart\.$/,
      ),
      ({ conditioned }) => !conditioned,
    ],
    [
      /^Observable: the readings tell every direction of the state\.$/,
      (frame) => frame.observable === 'yes' && !hardly(frame) && frame.rank.rank === 2,
    ],
    [
      /^Not observable: the rank is full only because rounding errors exceed so small a tolerance\.$/,
      ({ observable, rank }) => observable === 'no' && rank.rank === 2,
    ],
    [
      /^The rank is full, but whether the system is observable is undecided within the tolerance of (\S.*)\.$/,
      (frame) => open(frame) && frame.rank.rank === 2,
    ],
    [
      pattern(
        /^Observable in units that fit each state; in the units given, /,
        /the singular values lie too far apart for the rank to say so\.$/,
      ),
      ({ observable, rank }) => observable === 'yes' && rank.rank < 2,
    ],
    [
      /^Not observable: (.*) (is|are) never seen\.$/,
      ({ observable, rank }, list, verb) =>
        observable === 'no' &&
        sizes(rank.directions) === 2 - rank.rank &&
        apart(list) === sizes(rank.directions) &&
        (verb === 'are') === apart(list) > 1,
    ],
    [
      pattern(
        /^(.*) (count|counts) as unseen: less is read of it than the tolerance of (\S.*), /,
        /so whether the system is observable is undecided\.$/,
      ),
      (frame, list) => open(frame) && apart(list) === sizes(frame.rank.directions),
    ],
    [
      pattern(
        /^Badly scaled: F and H as written are observable, but the numbers through which (.*) (are|is) read are so /,
        /small beside others that rounding may hide them\.$/,
      ),
      ({ observable, badlyScaled, rank }, list) =>
        observable === 'undecided' && badlyScaled && apart(list) === sizes(rank.directions),
    ],
    [
      /^Detectable: what is not seen dies out by itself\.$/,
      ({ observable, detectable }) => detectable === 'yes' && observable !== 'yes',
    ],
    [
      /^Not detectable: what is not seen does not die out\.$/,
      ({ detectable, unseenModes, tolerance }) =>
        detectable === 'no' &&
        (unseenModes.length === 0 || Math.hypot(unseenModes[0].re, unseenModes[0].im) >= 1 - tolerance),
    ],
    [/^Whether it is detectable is undecided within the tolerance\.$/, ({ detectable }) => detectable === 'undecided'],
    [
      pattern(
        /^Counts as not detectable: what is not seen dies out so slowly that the tolerance of (\S.*) /,
        /does not tell it from what stays\.$/,
      ),
      ({ detectable, unseenModes }) => detectable === 'no' && unseenModes.every(({ re, im }) => Math.hypot(re, im) < 1),
    ],
    [
      pattern(
        /^Whether the (?:filter’s )?covariance has a limit is not said: from this start a step has no answer, /,
        /because a reading without noise tells nothing new, or because a number grows too large\.$/,
      ),
      ({ detectable, tried, doubled }) => detectable === 'yes' && tried === null && !doubled.converged,
    ],
    [
      pattern(
        /^Whether the (?:filter’s )?covariance has a limit is undecided: /,
        /something unseen dies out within the tolerance, /,
        /if at all, and from this start the covariance comes to rest in (about|more than) (\d+|\S+ × 10\S+) steps\.$/,
      ),
      ({ limit, doubled }, how, steps) =>
        limit === 'none' &&
        doubled.converged &&
        (how === 'about') === doubled.steps < 1.1e15 &&
        Math.abs(written(steps) / doubled.steps - 1) < 0.06,
    ],
    [
      /^From this start it takes more than (\S+ × 10\S+) steps\.$/,
      ({ settled, doubled }, steps) => settled === null && doubled.steps >= 0.95 * written(steps),
    ],
    [
      pattern(
        /^From this start it goes on falling as the variance of an average: /,
        /where no noise is, each reading counts\.$/,
      ),
      ({ noise, spectralRadius, params, slowly, near }) =>
        (slowly || near === null) &&
        noise.reachable === 'no' &&
        (params.gain !== 'filter' || Math.abs(spectralRadius - 1) < 1e-3),
    ],
    [/^Noise reaches every state\.$/, ({ noise }) => noise.reachable === 'yes'],
    [
      /^Whether noise reaches every state is undecided within the tolerance\.$/,
      ({ noise }) => noise.reachable === 'undecided',
    ],
    [/^There is no noise in the motion\.$/, ({ params }) => params.v.flat().every((entry) => entry === 0)],
    [
      /^Noise never moves (.*)\.$/,
      ({ noise }, list) => noise.reachable === 'no' && apart(list) === sizes(noise.unreached),
    ],
    [
      pattern(
        /^The (?:filter’s )?covariance tends to one limit from every start, /,
        /because the system is detectable and noise reaches all that does not die out\.$/,
      ),
      ({ detectable, noise, limit }) =>
        limit === 'from-every-start' && detectable === 'yes' && noise.stabilizable === 'yes',
    ],
    [
      pattern(
        /^The (?:filter’s )?covariance tends to 0 from every start, and ever more slowly: no noise moves the state, /,
        /so each reading counts for ever\.$/,
      ),
      ({ detectable, params, slowly, near }) =>
        detectable === 'yes' && (slowly || near === null) && params.v.flat().every((entry) => entry === 0),
    ],
    [
      pattern(
        /^The (?:filter’s )?covariance tends to 0 from every start: no noise moves the state, /,
        /so each reading counts for ever\.$/,
      ),
      ({ detectable, params }) => detectable === 'yes' && params.v.flat().every((entry) => entry === 0),
    ],
    [
      /^From this start, which knows what does not die out, 1 % is left after (\d+) steps?\.$/,
      ({ slowly, near, params }, steps) => !slowly && near === Number(steps) && params.spread.includes(0),
    ],
    [
      pattern(
        /^The (?:filter’s )?covariance tends to a limit from every large enough start, /,
        /because the system is detectable; /,
        /(noise does not reach|whether noise reaches) all that does not die out( is undecided)?; /,
        /so a smaller start may lead elsewhere, /,
        /and the filter may in the end stop correcting what noise does not reach\.$/,
      ),
      ({ detectable, noise, limit }, how, undecided) =>
        [limit, detectable, noise.stabilizable].join() === `from-large-start,yes,${undecided ? 'undecided' : 'no'}` &&
        how.startsWith('whether') === Boolean(undecided),
    ],
    [
      pattern(
        /^The (?:filter’s )?covariance has no limit: something unseen does not die out, and noise feeds it, /,
        /so its variance grows without end\.$/,
      ),
      ({ limit, detectable, doubled }) =>
        detectable === 'no' && (limit === 'none' || (limit === 'depends-on-start' && doubled.grows)),
    ],
    [
      pattern(
        /^(Another part|From this start a part) of it goes on falling as the variance of an average: /,
        /where no noise is, each reading counts\.$/,
      ),
      ({ settled, doubled, noise }, part) =>
        settled === null &&
        !doubled.converged &&
        noise.reachable === 'no' &&
        (part === 'Another part') === doubled.grows,
    ],
    [
      pattern(
        /^Whether the (?:filter’s )?covariance has a limit may depend on the start: /,
        /something unseen does not die out, and noise does not reach all of that\.$/,
      ),
      ({ limit, detectable, noise, doubled }) =>
        limit === 'depends-on-start' && detectable === 'no' && noise.stabilizable === 'no' && !doubled.grows,
    ],
    [
      /^Whether the (?:filter’s )?covariance has a limit is undecided within the tolerance\.$/,
      ({ limit }) => limit === 'undecided',
    ],
    [
      pattern(
        /^More digits of the numbers, or a smaller tolerance where they are exact, /,
        /may decide what is undecided\.$/,
      ),
      (frame) => !frame.badlyScaled && (open(frame) || [frame.detectable, frame.noise.reachable].includes('undecided')),
    ],
    [
      pattern(
        /^From this start it settles in (\d+|\S+ × 10\S+) steps?(, .+ s)?/,
        /(; a larger start leads to another limit)?\.$/,
      ),
      ({ near, slowly, limit, doubled, params }, steps, lasting, depends) =>
        near !== null &&
        !slowly &&
        limit !== 'none' &&
        Math.abs(written(steps) - near) <= (near < 1e4 ? 0 : 0.06 * near) &&
        Boolean(lasting) === params.period > 0 &&
        Boolean(depends) === doubled.dependsOnStart,
    ],
    [
      pattern(
        /^From this start it settles in about (\d+|\S+ × 10\S+) steps(, .+ s)?/,
        /(; a larger start leads to another limit)?\.$/,
      ),
      ({ settled, params, doubled }, steps, lasting, depends) =>
        settled === null &&
        doubled.converged &&
        Math.abs(written(steps) / doubled.steps - 1) < 0.06 &&
        Boolean(lasting) === params.period > 0 &&
        Boolean(depends) === doubled.dependsOnStart,
    ],
    [
      /^From this start it grows too slowly to show: after (\d+) steps no digit changes\.$/,
      ({ settled, limit }, steps) => settled === Number(steps) && limit === 'none',
    ],
    [
      /^From this start it has not settled after (\d+) steps\.$/,
      ({ settled, tried }, steps) => settled === null && tried === Number(steps),
    ],
    [/^From this start it outgrows every number\.$/, ({ settled, tried }) => settled === null && tried === null],
    [/^The simulated run has left every bound and stands still\.$/, ({ diverged }) => diverged],
    [
      /^No gain was found that puts the eigenvalues there, so the gain is 0\.$/,
      ({ placed, K }) => placed === false && K.flat().every((entry) => entry === 0),
    ],
    [
      pattern(
        /^With (the filter’s gain|this gain|the gain that places them)/,
        /(?: after (?:\d+) steps, a part of which goes on falling,)? the eigenvalues of the error’s matrix /,
        /reach the modulus (\S+?)(?: × \S+)?/,
        /(?:(, so an error need not die out)|(, and whether an error dies out is undecided))?\.$/,
      ),
      ({ params, spectralRadius, detectable, eigenvalues }, who, radius, lives, open) =>
        (({ 'the filter’s gain': 'filter', 'this gain': 'hand' })[who] ?? 'placement') === params.gain &&
        (spectralRadius >= 1e4 || prints(radius, spectralRadius)) &&
        Boolean(open) === (detectable === 'undecided' && eigenvalues[0].fixed) &&
        (open !== undefined || Boolean(lives) === spectralRadius >= 1),
    ],
    [
      pattern(
        /^The filter’s gain tends to one that leaves eigenvalues on the unit circle: the error falls as that of /,
        /an average, and by no factor in each step\.$/,
      ),
      ({ params, doubled, spectralRadius }) =>
        params.gain === 'filter' && doubled.averages && Math.abs(spectralRadius - 1) < 1e-3,
    ],
    [
      pattern(
        /^The (?:filter’s )?covariance tends to a limit from every large enough start, because the system is /,
        /detectable; a reading has no noise, and a filter that trusts it wholly need not lose its other errors, /,
        /so a smaller start may lead elsewhere\.$/,
      ),
      ({ limit, noise, params }) =>
        limit === 'from-large-start' && noise.stabilizable === 'yes' && params.w[0][0] === 0,
    ],
    [
      /^From this start it goes on falling, and ever more slowly, as the variance of an average\.$/,
      ({ slowly, near, noise, decay, params }) =>
        (slowly || near === null) &&
        noise.stabilizable === 'yes' &&
        (params.gain !== 'filter' || decay[0].steps === null),
    ],
    [
      /^(One|2) of them (?:counts|count) as out of reach of every gain\.$/,
      ({ badlyScaled, movable }, count) => badlyScaled && movable === 2 - (count === 'One' ? 1 : 2),
    ],
    [
      /^(One|2) of them (?:stays where it is|stay where they are) whatever the gain\.$/,
      ({ eigenvalues, movable }, count) =>
        eigenvalues.filter(({ fixed }) => fixed).length === (count === 'One' ? 1 : 2) &&
        movable === 2 - (count === 'One' ? 1 : 2),
    ],
  ]
}

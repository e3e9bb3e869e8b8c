/** What names of a reader’s would mean in other languages, or in what is around their lines there. */

const words = (/** @type {string} */ text) => text.trim().split(/\s+/)

const javascript = words(`
  abstract arguments await break case catch class const continue debugger default delete do else enum eval export
  extends false finally for function if implements import in instanceof interface let new null package private
  protected public return static super switch this throw true try typeof var void while with yield step STEPS start
  NaN Infinity undefined
`)

const c = words(`
  auto break case char const continue default do double else enum extern float for goto if inline int long register
  restrict return short signed sizeof static struct switch typedef union unsigned void volatile while main step
  steps start matrix MOST k i j expected found off most largest tolerance count j0 j1 y0 y1 jn yn gamma div abs
  signal time exp log pow sqrt sin cos tan fabs atan2 hypot remainder printf stderr exit NAN INFINITY
`)

const rust = words(`
  as break const continue crate dyn else enum extern false fn for if impl in let loop match mod move mut pub ref
  return self Self static struct super trait true type unsafe use where while async await abstract become box do
  final macro override priv try typeof unsized virtual yield gen union step main matrix SMatrix PI TAU Some None Ok
  Err Option Result Vec String Box k found expected apart off STEPS
`)

const python = words(`
  False None True and as assert async await break class continue def del elif else except finally for from global if
  import in is lambda nonlocal not or pass raise return try while with yield np step STEPS column k found expected
  off most zip max abs print range len
`)

const matlab = words(`
  break case catch classdef continue else elseif end for function global if otherwise parfor persistent return spmd
  switch try while pi eye zeros diag inv norm det trace chol sqrt sin cos atan2 exp abs round max fprintf error
  numel step steps k expected off
`)

export const RESERVED = { javascript, c, rust, python, matlab }

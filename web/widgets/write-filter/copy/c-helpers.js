/** What a copy in C stands on: matrices of a fixed size, handed over by value, and the functions that it calls. */

/** @type {Record<string, string>} */
export const HELPERS = {
  pi: 'static const double pi = 3.14159265358979323846;',
  zeros: `static matrix zeros(int rows, int columns)
{
    matrix a = {rows, columns, {{0}}};
    return a;
}`,
  identity: `static matrix identity(int n)
{
    matrix a = zeros(n, n);
    for (int i = 0; i < n; i++) a.at[i][i] = 1;
    return a;
}`,
  add: `static matrix add(matrix a, matrix b)
{
    for (int i = 0; i < a.rows; i++)
        for (int j = 0; j < a.columns; j++) a.at[i][j] += b.at[i][j];
    return a;
}`,
  subtract: `static matrix subtract(matrix a, matrix b)
{
    for (int i = 0; i < a.rows; i++)
        for (int j = 0; j < a.columns; j++) a.at[i][j] -= b.at[i][j];
    return a;
}`,
  multiply: `static matrix multiply(matrix a, matrix b)
{
    matrix c = zeros(a.rows, b.columns);
    for (int i = 0; i < a.rows; i++)
        for (int j = 0; j < b.columns; j++)
            for (int k = 0; k < a.columns; k++) c.at[i][j] += a.at[i][k] * b.at[k][j];
    return c;
}`,
  scale: `static matrix scale(double by, matrix a)
{
    for (int i = 0; i < a.rows; i++)
        for (int j = 0; j < a.columns; j++) a.at[i][j] *= by;
    return a;
}`,
  each: `static matrix each(double (*f)(double), matrix a)
{
    for (int i = 0; i < a.rows; i++)
        for (int j = 0; j < a.columns; j++) a.at[i][j] = f(a.at[i][j]);
    return a;
}`,
  transposed: `static matrix transposed(matrix a)
{
    matrix b = zeros(a.columns, a.rows);
    for (int i = 0; i < a.rows; i++)
        for (int j = 0; j < a.columns; j++) b.at[j][i] = a.at[i][j];
    return b;
}`,
  put: `static matrix put(matrix a, int top, int left, matrix b)
{
    for (int i = 0; i < b.rows; i++)
        for (int j = 0; j < b.columns; j++) a.at[top + i][left + j] = b.at[i][j];
    return a;
}`,
  block: `static matrix block(matrix a, int top, int bottom, int left, int right)
{
    matrix b = zeros(bottom - top, right - left);
    for (int i = top; i < bottom; i++)
        for (int j = left; j < right; j++) b.at[i - top][j - left] = a.at[i][j];
    return b;
}`,
  beside: `static matrix beside(matrix a, matrix b)
{
    return put(put(zeros(a.rows, a.columns + b.columns), 0, 0, a), 0, a.columns, b);
}`,
  below: `static matrix below(matrix a, matrix b)
{
    return put(put(zeros(a.rows + b.rows, a.columns), 0, 0, a), a.rows, 0, b);
}`,
  diagonal: `static matrix diagonal(matrix a)
{
    matrix b = zeros(a.rows, a.rows);
    for (int i = 0; i < a.rows; i++) b.at[i][i] = a.at[i][0];
    return b;
}`,
  diagonalOf: `static matrix diagonalOf(matrix a)
{
    matrix b = zeros(a.rows, 1);
    for (int i = 0; i < a.rows; i++) b.at[i][0] = a.at[i][i];
    return b;
}`,
  symmetric: `static matrix symmetric(matrix a)
{
    return scale(0.5, add(a, transposed(a)));
}`,
  trace: `static double trace(matrix a)
{
    double sum = 0;
    for (int i = 0; i < a.rows; i++) sum += a.at[i][i];
    return sum;
}`,
  norm: `static double norm(matrix a)
{
    double sum = 0;
    for (int i = 0; i < a.rows; i++)
        for (int j = 0; j < a.columns; j++) sum += a.at[i][j] * a.at[i][j];
    return sqrt(sum);
}`,
  entry: `static double entry(matrix a, int i, int j)
{
    return a.at[i][j];
}`,
  wrap: `/* An angle in [-pi, pi]. */
static double wrap(double angle)
{
    return remainder(angle, 2 * pi);
}`,
  stop: `static void stop(const char *why)
{
    fprintf(stderr, "%s\\n", why);
    exit(1);
}`,
  eliminated: `/* Gauss's elimination with the largest pivot of each column: b becomes the inverse of a times b. */
static double eliminated(matrix a, matrix *b)
{
    double determinant = 1;
    for (int k = 0; k < a.rows; k++) {
        int best = k;
        for (int i = k; i < a.rows; i++)
            if (fabs(a.at[i][k]) > fabs(a.at[best][k])) best = i;
        for (int j = 0; best != k && j < MOST; j++) {
            double kept = a.at[k][j];
            a.at[k][j] = a.at[best][j];
            a.at[best][j] = kept;
            kept = b->at[k][j];
            b->at[k][j] = b->at[best][j];
            b->at[best][j] = kept;
        }
        if (best != k) determinant = -determinant;
        double pivot = a.at[k][k];
        determinant *= pivot;
        if (pivot == 0) return 0;
        for (int i = 0; i < a.rows; i++) {
            double by = a.at[i][k] / pivot;
            if (i == k) continue;
            for (int j = k; j < a.columns; j++) a.at[i][j] -= by * a.at[k][j];
            for (int j = 0; j < b->columns; j++) b->at[i][j] -= by * b->at[k][j];
        }
        for (int j = 0; j < a.columns; j++) a.at[k][j] /= pivot;
        for (int j = 0; j < b->columns; j++) b->at[k][j] /= pivot;
    }
    return determinant;
}`,
  solve: `static matrix solve(matrix a, matrix b)
{
    if (eliminated(a, &b) == 0) stop("A matrix that is divided by has no inverse.");
    return b;
}`,
  determinant: `static double determinant(matrix a)
{
    matrix b = zeros(a.rows, 0);
    return eliminated(a, &b);
}`,
  cholesky: `/* The lower triangle whose product with its transpose is a. */
static matrix cholesky(matrix a)
{
    matrix l = zeros(a.rows, a.rows);
    for (int i = 0; i < a.rows; i++)
        for (int j = 0; j <= i; j++) {
            double rest = a.at[i][j];
            for (int k = 0; k < j; k++) rest -= l.at[i][k] * l.at[j][k];
            if (i == j && !(rest > 0)) stop("A matrix whose root is taken is not positive definite.");
            l.at[i][j] = i == j ? sqrt(rest) : rest / l.at[j][j];
        }
    return l;
}`,
  f: `/* Where the robot is after a move: along its heading, then the turn. */
static matrix f(matrix x, matrix u)
{
    double heading = x.at[2][0];
    matrix moved = {3, 1, {{x.at[0][0] + u.at[0][0] * cos(heading)},
                           {x.at[1][0] + u.at[0][0] * sin(heading)},
                           {wrap(heading + u.at[1][0])}}};
    return moved;
}`,
  h: `/* Range and bearing of a landmark, the bearing from the landmark. */
static matrix h(matrix x, matrix l)
{
    double dx = x.at[0][0] - l.at[0][0], dy = x.at[1][0] - l.at[1][0];
    matrix seen = {2, 1, {{hypot(dx, dy)}, {wrap(atan2(dy, dx) - x.at[2][0])}}};
    return seen;
}`,
}

/** @type {Record<string, string[]>} */
export const NEED = {
  identity: ['zeros'],
  multiply: ['zeros'],
  transposed: ['zeros'],
  block: ['zeros'],
  beside: ['zeros', 'put'],
  below: ['zeros', 'put'],
  diagonal: ['zeros'],
  diagonalOf: ['zeros'],
  symmetric: ['scale', 'add', 'transposed', 'zeros'],
  wrap: ['pi'],
  solve: ['eliminated', 'stop'],
  determinant: ['eliminated', 'zeros'],
  cholesky: ['zeros', 'stop'],
  f: ['wrap', 'pi'],
  h: ['wrap', 'pi'],
}

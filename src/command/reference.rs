//! What `--help` says below the options: formats, files, and what words mean.

/// Behind the options of `run`.
pub(super) const RUN: &str = "\
Cases: a file, a folder of files, a name of `trilith list`, `-` for a case in
standard input, or a drawing (.dxf) with --friction.

Files: --out DIR writes results.csv, results.json, and CASE.txt, the record of
each case. Columns of the CSV: case (CASE@open with open head joints), method,
status, lower, upper, tan_beta, c, e, residual, seconds (CPU), reason, and
behind them counts of work, the reference with its error and verdict, and of a
search: `starts` that reached `states`, how often the lowest was met, and the
share `unseen` of starts that would reach a new one; `over_demand` is λ over
the `demand` of the case. JSON has more: in
`conclusion` the answer of each case, in `thrust` the lines of thrust and the
resultants on bed joints, and with --states the scene and all forces and
velocities, in the formats of `trilith schema`.

Interrupted: finished rows are printed and written, files say PARTIAL inside,
and a journal in the folder of --out (or --resume) lets the same command go on,
after SIGKILL too.

Records: --record DIR compares with CASE.snap in the folder; where something is
new or changed it writes CASE.snap.new, and prints the lines that changed. With
--accept it writes CASE.snap instead. The files are those of `cargo insta`.

Exit status: 0 fine; 1 a result failed, a reference is violated or a record
changed; 2 bad input; 128 + the signal that ended it.";

/// Behind the options of `import`.
pub(super) const IMPORT: &str = "\
Blocks are closed outlines: polylines, lines and arcs that close, circles, and
INSERTs of them; each is named by its handle. SPLINE, HATCH and whatever else
is no outline are refused with layer and handle; --without leaves a layer out.
Lengths become metres. Edges that face each other within --tolerance are laid
on one line, and every corner that moves is listed; wider gaps, up to 1.5 %,
and overlaps are refused with coordinates.

Of COMPAS a BlockModel (compas_dem) and an Assembly (compas_assembly) are read,
as `to_json` writes them, whose blocks are prisms across one upright plane, x-z
by custom; `is_support` says what never moves. A block weighs its area times
its depth, times the density of its material where every block has one. Blocks
have the names of their elements, or else their numbers in the graph.";

/// Behind the options of `chart`.
pub(super) const CHART: &str = "\
The error of an answer [a, b] is max(|a - r|, |b - R|) / r from the range [r,
R] of collapse states that another code found, one number where λ is unique:
neither a wide bracket nor one number for a wide truth looks exact. A bar
reaches to the distance of the better end. A filled mark has its lower end not
above the lowest state, an open one has it above. The front holds answers that
vouch for themselves, `verified` or `bracketed`; settings that are meant to be
quick are hollow and never on it.";

/// Behind the options of `atlas`.
pub(super) const ATLAS: &str = "\
A cell is right (within 1 %), inaccurate (farther off, as an estimate, or as a
search that missed the lowest state), refused (no answer), or WRONG: what is
known refutes what a `verified` or `bracketed` answer states. Below each
picture stand the causes of the failures. Every cell compares λ_A with λ_A, the
interval's lower end with the lowest state that another code found, and every
other answer with the range of those.";

/// Behind the options of `export`.
pub(super) const EXPORT: &str = "\
A program of your own reads this JSON on standard input and writes an answer on
standard output; `trilith schema scene` and `trilith schema result` print both
formats, tests/external/highs.py is one. --external NAME=COMMAND runs it in
run, check, sweep, chart and atlas, and compares it like our own methods: a λ
above λ_A, below a proved bound or negative is violated, one outside the
verified range is marked. A number alone, `0.5` or `{\"lambda\": 0.5}`, is an
estimate and may be off by the `stated_error` that it gives, or by 1e-4; forces and velocities that hold are
`verified`; a claim that they do not bear out is `failed`, and so are crashes,
hangs and nonsense. A case may name the program in a reference (`method =
\"NAME\"`).

--compas writes a BlockModel of compas_dem: blocks in x-z about y = 0, as deep
as they weigh over their areas; `displacement` and `rotation` of the mechanism
(of the centroid, about -y; only ratios count) as attributes of the graph's
nodes; and contacts with their forces, on the block that comes second, as
attributes of its edges.";

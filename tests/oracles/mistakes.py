"""Typical mistakes of users in files, calls and commands, and words of what each is answered."""

from __future__ import annotations

#: A brake without tolerances.
BRAKE = {
    "m": "0.35 kg",
    "k": "180 N/mm",
    "L_0": "38 mm",
    "theta0": "52 deg",
    "k_x": "9 N/mm",
    "k_y": "0 N/mm",
    "k_c": "1500 N/mm",
    "F_L": "420 N",
    "mu0": "[0.3, 0.6]",
    "V": "1.2 m/s",
    "d": "10 s/m",
}
#: The same with tolerances.
TOLERANT = BRAKE | {
    "k": "180 N/mm ± 15 %",
    "theta0": "52 deg ± 1 deg",
    "k_x": "9 N/mm ± 15 %",
    "k_c": "1500 N/mm ± 15 %",
}

#: Key, what is written for it, and words of the message beside file, line, key and value: what is
#: wrong, and what to write.
FILES: list[tuple[str, str, tuple[str, ...]]] = [
    ("k", "180", ("there is no unit", '"180 N/mm')),
    ("k", "180 apples", ("'apples' is not known", '"180 N/mm')),
    ("k", "180 kg", ("'kg' (kilogram) does not measure what N/m does", '"180 N/mm')),
    ("k", "-180 N/mm", ("is out of range; it must be above 0 N/mm: without the inclined spring",)),
    ("k_x", "-1500 N/mm", ("-1500 N/mm is out of range; it must be at least 0 N/mm",)),
    (
        "k",
        "180 N/mm +- 200 %",
        ("tolerance reaches -180 N/mm, out of range; all of it must be above 0 N/mm",),
    ),
    ("k", "180,5 N/mm", ("a number with a point", '"180 N/mm')),
    ("k", "180 N/mm ± 15", ("the tolerance has no unit", "± 15 %")),
    ("theta0", "52", ("there is no unit", '"52 deg')),
    ("theta0", "200 deg", ("above 0 deg and below 180 deg",)),
    ("theta0", "0 deg", ("above 0 deg and below 180 deg",)),
    ("mu0", "45 % +- 10 %", ("points or a share", "(45 ± 10) %")),
    ("mu0", "[0.6, 0.3]", ("begins above its end", "[0.3, 0.6]")),
    ("mu0", "-0.1", ("it must be at least 0: ", "supplement of theta0")),
    ("V", "1.2 km", ("does not measure what m/s does", '"1.2 m/s"')),
    ("d", "10 m/s", ("does not measure what s/m does", '"10 s/m"')),
    ("mass", "0.35 kg", ("is not a quantity of the model kang_nam", "the keys are m, k_c")),
    ("K", "180 N/mm", ("did you mean k?",)),
    ("model", "kangnam", ("did you mean kang_nam?",)),
    ("k_c", "1500 N/mn", ("'N/mn' is not known", '"1500 N/mm"')),
    ("damping_ratio", "5", ("at least 0 and below 1",)),
    ("damping_ratio", "0.5 % +- 0.1 %", ("takes no tolerance here", 'write "0.5 %"')),
    ("F_L", "420 kg", ("does not measure what N does", '"420 N')),
    ("L_0", "38 mm sd 5 mm in [40, 41] mm", ("does not lie between the ends", '"38 mm"')),
    ("vary", "foo", ("does not move the states", "choose one of theta0")),
]

#: What a call is written after.
BEFORE = """import numpy as np, spragsym as ss
A = ss.Parameters.article
P = A(theta0=0.8, mu0=0.5)
"""

#: A call, and words of its message: argument, value, range, remedy.
CALLS: list[tuple[str, tuple[str, ...]]] = [
    ("A(theta0=49)", ("theta0 = 49", "(0, pi)", "numpy.radians")),
    ("A(theta=0.8)", ("theta is not a parameter", "did you mean theta0?")),
    ("A(mu0=-1)", ("mu0 = -1", "[0, inf)", "supplement of theta0")),
    ("A(sigma='0.1')", ("sigma = '0.1' is text; it must be real numbers",)),
    ("A(theta0=np.nan)", ("theta0 = nan", "(0, pi)")),
    ("ss.folds(0.5)", ("p = 0.5", "model.Parameters(...)")),
    ("ss.folds(A(), 'mu')", ("vary = 'mu'", "choose one of theta0, mu0")),
    (
        "ss.folds(P, between={'theta0': (1, 0)})",
        ("between['theta0'] = (1, 0)", "lower and upper end"),
    ),
    ("ss.equilibria(A())", ("theta0 is missing", "p.replace(theta0=...)")),
    ("ss.simulate(P, t_end=-1)", ("t_end = -1", "(0, inf)")),
    ("ss.simulate(P, start=(1, 2), t_end=9)", ("start has the shape (2,)", "x0, y0")),
    ("ss.simulate(P, t_end=9, backend='matlab')", ("'matlab'", "heyoka, compiled, scipy")),
    ("ss.cycle(P, near=(1, 2))", ("near has the shape (2,)", "4 numbers")),
    ("ss.load('trolly')", ("'trolly'", "did you mean trolley?")),
    ("ss.certify(P, 'no jmp')", ("claim = 'no jmp'", "no jump?")),
    (
        "ss.quasi_static_path(P, 'mu0', [0.5, 0.1, 0.7])",
        ("values do not go one way", "strictly increasing"),
    ),
    (
        "ss.equilibria(theta0=0.9)",
        ("missing a required argument: 'p'", "call it as equilibria(p, "),
    ),
    (
        "ss.equilibria(P, tol=1e-3)",
        ("unexpected keyword argument 'tol'", "call it as equilibria(p"),
    ),
    ("ss.folds(P, beetween={'mu0': (0, 1)})", ("'beetween'", "did you mean between?")),
    ("ss.simulate(P, 300)", ("too many positional arguments", "simulate(p, *, ")),
    ("ss.fate(P, t_ned=9)", ("fate: t_ned is not a parameter", "did you mean t_end?")),
    ("ss.simulate(P, vx0_=9)", ("vx0_ is no argument", "did you mean vx0?")),
    ("ss.simulate(P, kapa=0.1)", ("kapa is no argument", "did you mean kappa?")),
    ("ss.diagram(P, 'mu0')", ("missing a required argument: 'between'", "diagram(p, vary, *, ")),
    ("ss.folds(P).save('folds.xlsx')", ("folds.xlsx ends in none of .json, .csv and .nc",)),
    ("ss.open('folds.csv')", ("columns alone", "pandas.read_csv", "*.json")),
    ("ss.open('nofile.json')", ("nofile.json can't be read", "save() wrote")),
    ("ss.equilibria(P, method='fast')", ("method = 'fast'", "auto, closed, search")),
    ("ss.Study(P)", ("parameters = Parameters", "a study needs PhysicalParameters")),
    ("ss.redesign(P, 'theta', {'mu0': 0.7})", ("'theta'", "theta0, mu0")),
]

#: A command, and words of its message.
COMMANDS: list[tuple[str, tuple[str, ...]]] = [
    ("nonsense", ("nonsense", "spragsym --help")),
    ("equilibria", ("--theta0", "spragsym equilibria --help")),
    ("equilibria --theta0 x", ("--theta0", "'x'")),
    ("path --vary nonsense=0:1", ("--vary", "'nonsense'", "theta0, mu0")),
    ("equilibria --theta0 30 --theta0=40", ("--theta0", "2 times")),
    ("equilibria -V 1 --speed 2", ("--speed", "2 times")),
    ("equilibria --theta0 30 --vary mu0=0:1:3 --mu0 4", ("--mu0", "leave one of the two out")),
    ("equilibria --theta0 30 --mu0 0,5", ("--mu0", "0.5", "0.0,5")),
    ("folds --theta0 30 --vary mu0=0:1e300", ("mu0 = 1e+300", "at most 1e+06")),
    ("explore --no-open --model ''", ("--model", "empty")),
    ("report ''", ("FILE", "empty")),
    ("fates --theta0 30 --backend compiled -o a.csv", ("heyoka", "scipy")),
    ("equilibria --theta0 30 --model ''", ("neither a shipped model",)),
    ("equilibria --theta0 0", ("--theta0 = 0", "(0, 180)")),
    ("equilibria --theta0 nan", ("--theta0 = nan",)),
    ("equilibria --theta0 49 --sigma 0", ("sigma = 0", "(0, inf)")),
    ("path --vary mu0=1:0", ("--theta0 has no value while mu0 varies",)),
    ("cycles --near 1,2", ("--near has 2 numbers", "a state 4: x, y")),
    ("critical --theta0 49 --vary mu0=0:1 --vary theta0", ("--vary", "2 times")),
    ("bifurcation --plot a.txt", ("a.txt", ".pdf, .png or .svg")),
    ("bifurcation --plot missing/a.pdf", ("missing/a.pdf", "existing folder")),
    ("simulate --theta0 49 --t-end -1", ("--t-end = -1",)),
    ("simulate --theta0 49 --t-end 9 --transient 9", ("--transient = 9", "--t-end = 9")),
    ("simulate --theta0 49 -V -1", ("--speed = -1", "mirror image")),
    ("simulate --theta0 49 --rtol 2", ("--rtol = 2",)),
    ("sweep --theta0 1:2 -o a.csv", ("1:2", "start:stop:count")),
    ("sweep --theta0 1:2:1000000000000 -o a.csv", ("1000000 numbers",)),
    ("sweep --theta0 30:200:3 -o a.csv", ("--theta0[2] = 200", "degrees")),
    ("figures 2 --out a", ("NAMES", "'2'", "3, 4")),
    ("figures rmsmap --out a", ("did you mean rms-map?",)),
    ("figures --out a --format gif", ("--format", "gif", "pdf, png, svg")),
    ("export --language fortran --out a", ("fortran",)),
    ("check --again --report a.md", ("leave it or --report out",)),
    ("check --claims --model stribeck", ("leave --model out",)),
    ("report", ("FILE is missing",)),
    ("report a.toml --over k=1:2:3 --html a.html", ("--html is the page", "--plot draws")),
    ("report a.toml --csv a.csv", ("--csv and --plot", "give --over")),
    ("report a.toml --html a.txt", ("--html a.txt", ".html")),
    ("bifurcation --theta0 30 --vary mu0=0:1 --plot a.pdf", ("another --vary",)),
    ("onsets --model stick_slip --vary V=0.1:1", ("--vary = ('V',)", "two different")),
    ("cycles --theta0 42 --plot a.svg", ("--plot a.svg", "needs --vary")),
    ("cycles --theta0 42 --diagram", ("--diagram", "--vary")),
    ("cycles --theta0 42 --digits 20", ("--digits", "--prove")),
    ("fates --theta0 30 -o a.csv --plot a.svg", ("--plot a.svg", "two parameters")),
    ("folds --theta0 30 --vary mu0=0:x", ("'mu0=0:x'", "mu0=0:1:11")),
    ("equilibria --theta0 30 --vary mu0=0:1:1", ("'mu0=0:1:1'", "2 to 100000")),
    ("folds --theta0 30 --vary mu0=1:1", ("both ends are 1",)),
    ("equilibria --alpha 1,2 --vary mu0=0:1:100000 --theta0 30", ("200000 points",)),
    ("folds --theta0 30 --within x", ("--within x", "x=0:1")),
    ("folds --theta0 30 --vary k=0:1", ("--vary k", "give --vary sigma")),
    ("explore --no-open --model stribeck --method closed", ("stribeck", "leave --method out")),
]

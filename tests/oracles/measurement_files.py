"""Files of measured friction as instruments and spreadsheets write them: what each means, or that it may mean something else."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from spragsym.errors import ParameterError
from spragsym.studies.measured_tables import read_friction

#: What was measured: sliding speeds in m/s, and coefficients.
SPEED, FRICTION = (0.05, 0.2, 1.0), (0.2, 0.4, 0.45)

#: Files that say the above, by what is special about each.
READ: dict[str, str | bytes] = {
    "points": "v [m/s],mu\n0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "millimetres per second": "v [mm/s],mu\n50,0.2\n200,0.4\n1000,0.45\n",
    "kilometres per hour": "speed [km/h];friction\n0.18;0.2\n0.72;0.4\n3.6;0.45\n",
    "metres per minute": "v [m/min],mu\n3,0.2\n12,0.4\n60,0.45\n",
    "inches per second": "v [in/s],mu\n1.968503937007874,0.2\n7.874015748031496,0.4\n39.37007874015748,0.45\n",
    "unit in round brackets": "v (mm/s),mu (-)\n50,0.2\n200,0.4\n1000,0.45\n",
    "unit behind in": "v in m/s;mu\n0.05;0.2\n0.2;0.4\n1;0.45\n",
    "unit behind a stroke, DIN 1313": "v / (m/s);mu / 1\n0,05;0,2\n0,2;0,4\n1;0,45\n",
    "unit behind a stroke alone": "v/m/s;mu\n0,05;0,2\n0,2;0,4\n1;0,45\n",
    "percent": "v [m/s],mu [%]\n0.05,20\n0.2,40\n1,45\n",
    "percent and millimetres": "mu [%];v [mm/s]\n20;50\n40;200\n45;1000\n",
    "swapped columns": "mu,v [m/s]\n0.2,0.05\n0.4,0.2\n0.45,1.0\n",
    "swapped columns in mm/s": "mu;v [mm/s]\n0,2;50\n0,4;200\n0,45;1000\n",
    "an index": "n,v [m/s],mu\n1,0.05,0.2\n2,0.2,0.4\n3,1.0,0.45\n",
    "an index without name, as pandas writes it": ",v [m/s],mu\n0,0.05,0.2\n1,0.2,0.4\n2,1.0,0.45\n",
    "time and temperature": "t [s],v [m/s],T [degC],mu\n0,0.05,20,0.2\n1,0.2,21,0.4\n2,1.0,25,0.45\n",
    "a date beside": "date;v [m/s];mu\n2026-01-01;0,05;0,2\n2026-01-02;0,2;0,4\n2026-01-03;1,0;0,45\n",
    "decimal commas and semicolons": "v [m/s];µ\r\n0,05;0,2\r\n0,2;0,4\r\n1,0;0,45\r\n",
    "decimal commas and tabs": "v [m/s]\tmu\n0,05\t0,2\n0,2\t0,4\n1\t0,45\n",
    "decimal commas and blanks": "v [m/s] mu\n0,05 0,2\n0,2 0,4\n1,0 0,45\n",
    "decimal commas in quotes": '"v [m/s]","mu"\n"0,05","0,2"\n"0,2","0,4"\n"1,0","0,45"\n',
    "German names": "Gleitgeschwindigkeit [m/s];Reibwert\n0,05;0,2\n0,2;0,4\n1,0;0,45\n",
    "French names": "vitesse (m/s);frottement\n0,05;0,2\n0,2;0,4\n1,0;0,45\n",
    "Greek mu": "v [m/s];\N{GREEK SMALL LETTER MU}\n0,05;0,2\n0,2;0,4\n1,0;0,45\n",
    "micro sign": "v [m/s];\N{MICRO SIGN}\n0,05;0,2\n0,2;0,4\n1,0;0,45\n",
    "capital letters": "SPEED [m/s],COF\n0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "underscores": "sliding_speed [m/s],friction_coefficient [-]\n0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "two words": "sliding speed [m/s],coefficient of friction\n0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "tabs": "v [m/s]\tmu\n0.05\t0.2\n0.2\t0.4\n1.0\t0.45\n",
    "blanks": "v[m/s] mu\n0.05 0.2\n 0.2   0.4\n1.0 0.45\n",
    "blanks before the unit": "v [m/s]   mu [-]\n0.05 0.2\n0.2 0.4\n1.0 0.45\n",
    "bars": "v [m/s]|mu\n0.05|0.2\n0.2|0.4\n1.0|0.45\n",
    "blanks behind commas": "v [m/s], mu\n0.05, 0.2\n0.2, 0.4\n1.0, 0.45\n",
    "comments": "# rig 3\n# 2026-01-01\nv [m/s],mu\n0.05,0.2\n# stopped\n0.2,0.4\n1.0,0.45\n",
    "comments of MATLAB": "% rig 3\nv [m/s],mu\n0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "empty lines": "\n\nv [m/s],mu\n\n0.05,0.2\n0.2,0.4\n\n1.0,0.45\n\n",
    "units below the names": "v;mu\nmm/s;-\n50;0,2\n200;0,4\n1000;0,45\n",
    "units in brackets below the names": "t,v,mu\n[s],[m/s],[-]\n0,0.05,0.2\n1,0.2,0.4\n2,1.0,0.45\n",
    "byte order mark": b"\xef\xbb\xbf" + b"v [m/s],mu\n0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "UTF-16": "v [m/s];µ\r\n0,05;0,2\r\n0,2;0,4\r\n1,0;0,45\r\n".encode("utf-16"),
    "UTF-16, big end first": b"\xfe\xff" + "v [mm/s];mu\n50;0,2\n200;0,4\n1000;0,45\n".encode("utf-16-be"),
    "old Macintosh": "v [m/s],mu\r0.05,0.2\r0.2,0.4\r1.0,0.45\r",
    "exponents": "v [m/s],mu\n5e-2,2E-1\n2.0e-1,4.0E-01\n1e0,4.5e-1\n",
    "signs": "v [m/s],mu\n-0.05,0.2\n-0.2,0.4\n+1.0,+0.45\n",
    "semicolons at the end": "v [m/s];mu;\n0,05;0,2;\n0,2;0,4;\n1,0;0,45;\n",
    "semicolons at the end of data": "v [m/s];mu\n0,05;0,2;\n0,2;0,4;\n1,0;0,45;\n",
    "quotes and a third column": '"v [m/s]","mu","T"\n"0.05","0.2","20"\n"0.2","0.4","21"\n"1.0","0.45","22"\n',
}

#: Files that may mean something else, or nothing.
REFUSED: dict[str, str | bytes] = {
    "no head": "0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "no unit": "v,mu\n50,0.2\n200,0.4\n1000,0.45\n",
    "no unit, swapped": "mu,v\n0.2,0.05\n0.4,0.2\n0.45,1.0\n",
    "a unit of another quantity": "v [rpm],mu\n50,0.2\n200,0.4\n1000,0.45\n",
    "a force for the coefficient": "v [m/s],friction [N]\n0.05,200\n0.2,400\n1.0,450\n",
    "two speeds": "v [m/s],speed [km/h],mu\n0.05,0.18,0.2\n0.2,0.72,0.4\n1.0,3.6,0.45\n",
    "no speed": "t [s],mu\n0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "no coefficient": "v [m/s],F [N]\n0.05,0.2\n0.2,0.4\n1.0,0.45\n",
    "a logarithm": "log v [m/s],mu\n-1.3,0.2\n-0.7,0.4\n0,0.45\n",
    "a factor behind the unit": "v [m/s] x 1000,mu\n50,0.2\n200,0.4\n1000,0.45\n",
    "a factor in the unit": "v [10^-3 m/s],mu\n50,0.2\n200,0.4\n1000,0.45\n",
    "percent without its sign": "v [m/s],mu\n0.05,20\n0.2,40\n1.0,45\n",
    "decimal commas between commas": "v [m/s],mu\n0,05,0,2\n0,2,0,4\n1,0,0,45\n",
    "an index without a place in the head, as R writes it": "v [m/s],mu\n1,0.05,0.2\n2,0.2,0.4\n3,1.0,0.45\n",
    "thousands": "v [mm/s];mu [%]\n1,050;20\n1,200;40\n2,000;45\n",
    "thousands and decimals": "v [mm/s];mu\n1.050;0,2\n1.200;0,4\n2.000;0,45\n",
    "units twice": "v [m/s];mu\nmm/s;-\n50;0,2\n200;0,4\n1000;0,45\n",
    "a unit in a cell": "v [m/s],mu\n0.05 m/s,0.2\n0.2,0.4\n1.0,0.45\n",
    "a hole": "v [m/s],mu\n0.05,0.2\n,0.4\n1.0,0.45\n",
    "a word": "v [m/s],mu\n0.05,0.2\nfast,0.4\n1.0,0.45\n",
    "not a number": "v [m/s],mu\n0.05,0.2\n0.2,nan\n1.0,0.45\n",
    "negative": "v [m/s],mu\n0.05,0.2\n0.2,-0.4\n1.0,0.45\n",
    "empty": "",
    "a head alone": "v [m/s],mu\n",
    "Latin-1": "v [m/s];µ\n0,05;0,2\n0,2;0,4\n1,0;0,45\n".encode("latin-1"),
    "UTF-16 without its mark": "v [m/s];mu\n0,05;0,2\n0,2;0,4\n1,0;0,45\n".encode("utf-16-le"),
    "a spreadsheet": b"PK\x03\x04\x14\x00\x06\x00\x08\x00\x00\x00!\x00",
    "one column": "mu\n0.2\n0.4\n0.45\n",
    "a small second unit": "v [ms],mu\n50,0.2\n200,0.4\n1000,0.45\n",
}


def wrong(folder: Path) -> list[str]:
    """The files that are misread, refused though they are clear, or read though they are not."""
    found = []
    for meant, files in ((True, READ), (False, REFUSED)):
        for name, content in files.items():
            path = folder / "measured.csv"
            path.write_bytes(content if isinstance(content, bytes) else content.encode())
            try:
                speed, friction = read_friction(path)
            except ParameterError as error:
                if meant or ";" not in str(error):
                    found.append(f"{name}: {error}")
                continue
            if not meant or not (np.allclose(speed, SPEED, rtol=1e-12) and np.allclose(friction, FRICTION, rtol=1e-12)):
                found.append(f"{name}: read as {speed.tolist()}, {friction.tolist()}")
    return found

"""Reads a table of Libration into exact mpmath numbers: python3 read_table.py TABLE.csv [digits]"""
import csv
import sys
from mpmath import mp, mpf

mp.dps = int(sys.argv[2]) if len(sys.argv) > 2 else 60  # before the first number is read

def number(cell):  # from the decimal text itself, never through a float
    try:
        return mpf(cell)
    except ValueError:
        return cell

rows = [{name: number(cell) for name, cell in row.items()} for row in csv.DictReader(open(sys.argv[1], newline=""))]
for name, value in rows[0].items():
    print(name, mp.nstr(value, mp.dps, strip_zeros=True) if isinstance(value, mpf) else value)

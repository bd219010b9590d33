"""Reads results/reference_problems/NAME.csv without losing a digit: python3 read_reference.py NAME.csv"""
import csv
import decimal
import sys

decimal.getcontext().prec = 60  # more digits than the values have

values, conditions = {}, {}
with open(sys.argv[1], newline="") as file:
    for row in csv.DictReader(file):
        key = decimal.Decimal(row["time"]), row["unknown"]
        values[key] = decimal.Decimal(row["value"])
        conditions[key] = [float(row[name]) for name in ("condition_start", "condition_parameters", "condition_time")]

for (time, unknown), value in values.items():
    print(time, unknown, value, *conditions[time, unknown])

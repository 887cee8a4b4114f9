"""Usage: exponent.py SUBCERT SCHEME [exact | WIDTH]. The exponent is exact, its enclosure at most 1e-12 wide, its
certificate verified; with `exact` within 120 s of processor time, with WIDTH it need not be exact, but is to be enclosed
that narrowly by then. For euler:D the joint spectral radius of the matrices of Euler's partition function with D digits, instead."""
import json
import os
import subprocess
import sys
import tempfile
from decimal import Decimal


def euler(digits):
    """Entry (i, j) of matrix t is 1 where 0 <= 2i + t - j < digits."""
    size = range(digits - 1)
    return [[[int(0 <= 2 * i + t - j < digits) for j in size] for i in size] for t in (0, 1)]


def main():
    program, scheme, *in_short_time = sys.argv[1:]
    width = [] if in_short_time == ["exact"] else in_short_time
    with tempfile.TemporaryDirectory() as folder:
        certificate = os.path.join(folder, "exponent.cert")
        command, subject, key = "regularity", scheme, "holder"
        if scheme.startswith("euler:"):
            command, subject, key = "jsr", os.path.join(folder, "euler.json"), "radius"
            with open(subject, "w", encoding="ascii") as file:
                json.dump({"matrices": euler(int(scheme.split(":")[1]))}, file)
        budget = "120" if in_short_time else "480"  # of processor time: two cores for a minute, or four
        run = subprocess.run([program, command, subject, "--json", "--budget", budget, "--certificate", certificate],
                             capture_output=True, text=True)
        if run.returncode != 0 and not (width and run.returncode == 2):
            sys.exit(f"subcert {command} {scheme} ended with {run.returncode}: {run.stderr}{run.stdout}")
        answer = json.loads(run.stdout)
        if not width and answer["exact"] is not True:
            sys.exit(f"{scheme}: not exact, {answer.get('exactness')}")
        found = Decimal(answer[key]["upper"]) - Decimal(answer[key]["lower"])
        if found > Decimal(width[0] if width else "1e-12"):
            sys.exit(f"{scheme}: the enclosure is {found} wide")
        verified = subprocess.run([program, "verify", certificate], capture_output=True, text=True)
        if verified.returncode != 0 or "VERIFIED" not in verified.stdout:
            sys.exit(f"{scheme}: the certificate was not verified: {verified.stdout}{verified.stderr}")


main()

"""Usage: exponent.py SUBCERT SCHEME. The exponent is exact, its enclosure at most 1e-12 wide, its certificate verified."""
import json
import os
import subprocess
import sys
import tempfile
from decimal import Decimal


def main():
    program, scheme = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        certificate = os.path.join(folder, "exponent.cert")
        run = subprocess.run([program, "regularity", scheme, "--json", "--budget", "240", "--certificate", certificate],
                             capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"subcert regularity {scheme} ended with {run.returncode}: {run.stderr}{run.stdout}")
        answer = json.loads(run.stdout)
        if answer["exact"] is not True:
            sys.exit(f"{scheme}: not exact, {answer.get('exactness')}")
        width = Decimal(answer["holder"]["upper"]) - Decimal(answer["holder"]["lower"])
        if width > Decimal("1e-12"):
            sys.exit(f"{scheme}: the enclosure is {width} wide")
        verified = subprocess.run([program, "verify", certificate], capture_output=True, text=True)
        if verified.returncode != 0 or "VERIFIED" not in verified.stdout:
            sys.exit(f"{scheme}: the certificate was not verified: {verified.stdout}{verified.stderr}")


main()

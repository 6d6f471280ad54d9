"""What is known of every triangle and point of a scene: the range of the
coordinates, how small and thin triangles may be, of how many digits numbers are.
What error bounds (error_bounds.py) are computed from.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Final

DIGITS: Final = {"f32": 24, "f64": 53}
LARGEST: Final = {"f32": 2.0**127, "f64": 2.0**1023}  # a power of two below it
SMALLEST: Final = {"f32": 2.0**-149, "f64": 5e-324}  # above 0
SMALLEST_NORMAL: Final = {"f32": 2.0**-126, "f64": 2.0**-1022}
INTEGER_RANGE: Final = {
    "i32": (-(2**31), 2**31 - 1),
    "i16": (-(2**15), 2**15 - 1),
    "u8": (0, 255),
}


@dataclasses.dataclass(frozen=True)
class Extent:
    """What is known of every triangle and point of a scene. `quantum`: all
    coordinates are whole multiples of it, as far as the scene says (0: unknown);
    only a power of two says anything about binary numbers, but any keeps
    coordinates apart.
    """

    scalar: str
    low: float
    high: float
    altitude: float  # h: no triangle has a smaller one
    longest: float  # L: no edge is longer
    quantum: float = 0.0

    @property
    def unit(self) -> float:
        """u, the largest relative error of a rounding."""
        return 2.0 ** -DIGITS[self.scalar]

    @property
    def largest(self) -> float:
        return max(abs(self.low), abs(self.high))

    @property
    def width(self) -> float:
        return self.high - self.low

    @property
    def diameter(self) -> float:
        """No two points are farther apart."""
        return math.sqrt(2) * self.width

    @property
    def step(self) -> float:
        """A power of two of which every coordinate is a multiple: the last bit
        of the smallest number in the range, or the quantum if that is one.
        """
        mantissa, _ = math.frexp(self.quantum) if self.quantum else (0.0, 0)
        own = self.quantum if mantissa == 0.5 else 0.0
        return max(self._last_bit(), own)

    @property
    def least_difference(self) -> float:
        """Two coordinates that differ, differ by no less."""
        # Decimals are rounded to binary numbers, both of the two.
        apart = self.quantum - 2 * self.unit * self.largest
        return max(self.step, apart)

    @property
    def least_magnitude(self) -> float:
        """No coordinate but 0 is nearer to 0."""
        if self.low > 0 or self.high < 0:
            return min(abs(self.low), abs(self.high))
        return self.least_difference

    def steps(self, length: float) -> float:
        return length / self.step

    def _last_bit(self) -> float:
        nearest = min(abs(self.low), abs(self.high))
        if self.low <= 0 <= self.high:
            return SMALLEST[self.scalar]
        _, exponent = math.frexp(nearest)
        return max(2.0 ** (exponent - DIGITS[self.scalar]), SMALLEST[self.scalar])

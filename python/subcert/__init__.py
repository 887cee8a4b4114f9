"""Certifies what is claimed about subdivision schemes: exact masks, proved convergence, Hölder exponents with
certificates, exact limits and variances, ranges of parameters, refinement and smoothing of data.

>>> import subcert
>>> exponent = subcert.scheme("primal:n=5").holder()
>>> print(exponent)
1.9901439593863
>>> exponent.verify().accepted
True
"""

from ._certificates import Certificate, Verification, verify
from ._core import version as __version__
from ._data import Smoothed, refine, refine_mesh, smooth
from ._errors import (
    CertificateError,
    DataError,
    DomainError,
    Error,
    MissingFileError,
    SizeError,
    UndecidedError,
    UsageError,
)
from ._exact import Decision, Enclosure, Exact, Truth, fraction
from ._families import (
    CurvePiece,
    ExponentCurve,
    Family,
    Levels,
    LevelsExponent,
    LevelsLimit,
    LocalExponent,
    Piece,
    PropertyRange,
    RangeEnd,
    SpecialValue,
    exponent_of_levels,
    family,
)
from ._proofs import (
    CheckedStatement,
    Comparison,
    Comparisons,
    PropertyAnswer,
    Statement,
    check,
    check_statements,
    papers,
    reproduce,
    statements,
)
from ._regularity import (
    Bound,
    HolderExponent,
    JointSpectralRadius,
    JointSpectralSubradius,
    jsr,
    p_radius,
    subradius,
)
from ._schemes import (
    DataDependentScheme,
    LimitRange,
    MultivariateScheme,
    Scheme,
    Symbol,
    VarianceRange,
    VectorScheme,
    families,
    limit_in_turn,
    mask,
    refinable,
    scheme,
)
from ._sweeps import Atlas, AtlasAnswers, AtlasEntry, SweepAnswer, sweep
from ._tables import SchemeTable, compare
from ._vertices import (
    EveryValence,
    StencilWeight,
    Vertex,
    VertexRules,
    VertexStencils,
    WeightCell,
    WeightEnd,
    WeightMap,
    WeightPiece,
    WeightRange,
    every_valence,
    vertex_map,
    vertex_ranges,
    vertex_rules,
    vertex_stencils,
    vertices,
)

__all__ = [name for name in dir() if not name.startswith("_")]

# Where people look for it: subcert.UsageError, not subcert._errors.UsageError.
for _name in __all__:
    if getattr(globals()[_name], "__module__", "").startswith("subcert."):
        globals()[_name].__module__ = "subcert"

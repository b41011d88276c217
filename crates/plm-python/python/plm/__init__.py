"""Planar mechanisms: declared as text or by a builder, compiled and run without Rust."""

from ._builder import Builder as Builder, parts as parts
from ._declared import Mechanism as Mechanism, check as check
from ._errors import DeclarationError as DeclarationError
from ._experiment import Experiment as Experiment, Unknown as Unknown
from ._expression import Expression as Expression
from ._fit import Estimate as Estimate, Fit as Fit, NotConverged as NotConverged, Residuals as Residuals
from ._gradient import Gradient as Gradient
from ._native import __version__ as __version__
from ._rollouts import Rollouts as Rollouts
from ._saved import Snapshot as Snapshot
from ._sim import Show as Show, Sim as Sim
from ._values import Event as Event, Fault as Fault, Jacobian as Jacobian, Linearisation as Linearisation
from ._values import Pose as Pose, Quantity as Quantity, Results as Results

__all__ = [
    "Builder",
    "DeclarationError",
    "Estimate",
    "Event",
    "Experiment",
    "Expression",
    "Fault",
    "Fit",
    "Gradient",
    "Jacobian",
    "Linearisation",
    "Mechanism",
    "NotConverged",
    "Pose",
    "Quantity",
    "Residuals",
    "Results",
    "Rollouts",
    "Show",
    "Sim",
    "Snapshot",
    "Unknown",
    "check",
    "parts",
]

"""Kinds of parameters: name, label, unit, default, limits and help are declared together, once.

A parameter makes its QGIS definition, and reads and checks its value. A value that cannot be used raises
`InputError` with one sentence for the user. Parameters that are files are in `files`.
"""

# ruff: noqa: D102 - an override is described at the method or property that it overrides.

import math
import sys
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
    QgsProcessingParameterString,
)

from ...algorithms.errors import InputError
from ..language import translated


@dataclass(frozen=True)
class Parameter(ABC):
    """Base of the parameters.

    Attributes
    ----------
    name : str
        The name that scripts and models store.
    label : str
        What the dialog shows.
    help : str
        Plain text: what it does, and when to change it.
    """

    name: str
    label: str
    help: str

    @property
    def description(self) -> str:
        """The label, with the unit if the parameter has one."""
        return self.label

    @property
    def explanation(self) -> str:
        """The help, with the default and the limits if the parameter has them."""
        return self.help

    def definition(self) -> QgsProcessingParameterDefinition:
        """Return a new definition, which QGIS will own."""
        definition = self._definition()
        definition.setDescription(translated(self.description))
        definition.setHelp(translated(self.explanation))
        return definition

    @abstractmethod
    def _definition(self) -> QgsProcessingParameterDefinition:
        """Return a definition without help."""

    @abstractmethod
    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Any:
        """Return the value of this parameter among `parameters`, or raise `InputError`."""

    def sources(self, value: Any) -> list[str]:
        """Return the files that a value refers to; no output may replace them."""
        return []


@dataclass(frozen=True)
class Number(Parameter):
    """A number; without a default it is optional, and None if the user leaves it empty."""

    unit: str
    minimum: float
    default: Optional[float] = None
    maximum: float = sys.float_info.max
    whole: bool = False
    advanced: bool = False
    decimals: int = 3

    @property
    def description(self) -> str:
        # A label such as `Number of planes` says what is counted.
        return self.label if self.unit == "count" else f"{self.label} ({self.unit})"

    @property
    def explanation(self) -> str:
        default = "not set" if self.default is None else _written(self.default)
        return f"{self.help} Default {default}; {self._limits()}."

    def _definition(self) -> QgsProcessingParameterNumber:
        kinds = QgsProcessingParameterNumber.Type
        definition = QgsProcessingParameterNumber(
            self.name,
            self.description,
            kinds.Integer if self.whole else kinds.Double,
            self.default,
            self.default is None,
            self.minimum,
            min(self.maximum, 2**31 - 1) if self.whole else self.maximum,
        )
        definition.setMetadata({"widget_wrapper": {"decimals": self.decimals}})
        return marked(definition) if self.advanced else definition

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Union[int, float, None]:
        # As a string, because QGIS reads both a word and an empty value as 0.
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        if not text:
            return self.default
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not self.minimum <= value <= self.maximum or (self.whole and value % 1):
            kind = "whole number" if self.whole else "number"
            raise InputError(f"{self.name} must be a {kind}, {self._limits()} ({self.unit}), not {text}.")
        return int(value) if self.whole else value

    def _limits(self) -> str:
        if self.maximum == sys.float_info.max:
            return f"at least {_written(self.minimum)}"
        return f"from {_written(self.minimum)} to {_written(self.maximum)}"


@dataclass(frozen=True)
class Choice(Parameter):
    """One of several options, by its number from 0; the first is the default."""

    options: tuple[str, ...]
    optional: bool = False

    @property
    def names(self) -> list[str]:
        """The options as the dialog shows them."""
        return [translated(option) for option in self.options]

    @property
    def explanation(self) -> str:
        numbered = "; ".join(f"{number} {option}" for number, option in enumerate(self.names))
        return f"{self.help} {numbered}. Default 0."

    def _definition(self) -> QgsProcessingParameterEnum:
        # A choice that was added later is optional, because older models have no value for it.
        return QgsProcessingParameterEnum(
            self.name,
            self.description,
            self.names,
            allowMultiple=False,
            defaultValue=0,
            optional=self.optional,
        )

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> int:
        # As a string, because QGIS replaces an unknown value by the default.
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        numbers = {str(number): number for number in range(len(self.options))}
        if text and text not in numbers:
            choices = " or ".join(f"{number} ({option})" for number, option in enumerate(self.names))
            raise InputError(f"{self.name} must be {choices}, not {text}.")
        return numbers.get(text, 0)


@dataclass(frozen=True)
class Flag(Parameter):
    """A choice between yes and no."""

    default: bool
    advanced: bool = True
    optional: bool = False

    @property
    def explanation(self) -> str:
        return f"{self.help} Default {'yes' if self.default else 'no'}."

    def _definition(self) -> QgsProcessingParameterBoolean:
        # A flag that was added later is optional, because older models have no value for it.
        definition = QgsProcessingParameterBoolean(self.name, self.description, self.default, self.optional)
        return marked(definition) if self.advanced else definition

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> bool:
        # As a string, because QGIS reads any word as yes.
        text = algorithm.parameterAsString(parameters, self.name, context).strip().lower()
        words = {
            "true": True,
            "yes": True,
            "1": True,
            "false": False,
            "no": False,
            "0": False,
            "": self.default,
        }
        if text not in words:
            raise InputError(f"{self.name} must be true or false, not {text}.")
        return words[text]


@dataclass(frozen=True)
class Text(Parameter):
    """A line of text; empty if the user leaves it so."""

    advanced: bool = False

    def _definition(self) -> QgsProcessingParameterString:
        definition = QgsProcessingParameterString(self.name, self.description, optional=True)
        return marked(definition) if self.advanced else definition

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> str:
        return str(algorithm.parameterAsString(parameters, self.name, context)).strip()


@dataclass(frozen=True)
class Place(Parameter):
    """An optional point in plan, picked on the map or written as x,y."""

    def _definition(self) -> QgsProcessingParameterPoint:
        return marked(QgsProcessingParameterPoint(self.name, self.description, optional=True))

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Optional[tuple[float, float]]:
        given = parameters.get(self.name)
        if given is None or not str(given).strip():
            return None
        point = algorithm.parameterAsPoint(parameters, self.name, context)
        if point.isEmpty():
            raise InputError(f"{self.name} must be a point like 412345.6,5812345.7, not {given}.")
        return point.x(), point.y()


@dataclass(frozen=True)
class Position(Parameter):
    """An optional position in space: three numbers, None if the user leaves it empty."""

    def _definition(self) -> QgsProcessingParameterString:
        return QgsProcessingParameterString(self.name, self.description, optional=True)

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Optional[np.ndarray]:
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        if not text:
            return None
        try:
            position = np.array([float(part) for part in text.replace(",", " ").split()])
        except ValueError:
            position = np.empty(0)
        if position.shape != (3,) or not np.all(np.isfinite(position)):
            raise InputError(f"{self.name} must be three numbers, x y z in metres, not {text}.")
        return position


@dataclass(frozen=True)
class ReferenceSystem(Parameter):
    """An optional coordinate reference system."""

    def _definition(self) -> QgsProcessingParameterCrs:
        return QgsProcessingParameterCrs(self.name, self.description, optional=True)

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Optional[QgsCoordinateReferenceSystem]:
        crs = algorithm.parameterAsCrs(parameters, self.name, context)
        if crs.isValid():
            return crs
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        if text:
            raise InputError(f"{self.name} {text} is not known; write it like EPSG:25832.")
        return None


def marked(definition: QgsProcessingParameterDefinition) -> QgsProcessingParameterDefinition:
    """Return the definition, shown among the advanced ones."""
    advanced = QgsProcessingParameterDefinition.Flag.FlagAdvanced
    definition.setFlags(definition.flags() | advanced)
    return definition


def _written(number: float) -> str:
    """Return a number as people write it, without an exponent."""
    return f"{number:.9f}".rstrip("0").rstrip(".")

"""The algorithms as QGIS Processing shows them: parameters, help, log, files and styles. It computes nothing.

Public names: `provider.Provider`, which QGIS registers; `algorithm.Algorithm` and `algorithm.Outcome`, from
which an algorithm is made; `log.Log`. The algorithms are in `algorithms`, their parameters in `parameters`.
"""

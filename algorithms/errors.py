"""The exceptions of the core. Each message is one sentence for the user."""


class IchnographError(Exception):
    """Root of every error the core raises on purpose."""


class InputError(IchnographError):
    """A file or a parameter that cannot be used; the message names it and the remedy."""


class MissingPackageError(InputError):
    """A file that cannot be read or written without packages that are not installed.

    Parameters
    ----------
    what : str
        The file.
    modules : tuple of str
        As they are imported.
    done : str
        What cannot be done with it.
    """

    def __init__(self, what: str, modules: tuple[str, ...], done: str = "read") -> None:
        super().__init__(f"{what} cannot be {done} without {' and '.join(modules)}; install what is missing.")
        self.what = what
        self.modules = modules
        self.done = done

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        # Of the message alone, pickle could not make it again.
        return type(self), (self.what, self.modules, self.done)


class NothingFoundError(IchnographError):
    """The input is sound, but no result remains; the message says which step removed what.

    Parameters
    ----------
    message : str
    warnings : tuple of str
        What was noticed before, and may be the reason.
    """

    def __init__(self, message: str, warnings: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.warnings = warnings


class CancelledError(IchnographError):
    """The user asked to stop."""

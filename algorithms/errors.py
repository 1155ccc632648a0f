"""The exceptions of the core. Each message is one sentence for the user."""


class IchnographError(Exception):
    """Root of every error the core raises on purpose."""


class InputError(IchnographError):
    """A file or a parameter that cannot be used; the message names it and the remedy."""


class NothingFoundError(IchnographError):
    """The input is sound, but no result remains; the message says which step removed what."""


class CancelledError(IchnographError):
    """The user asked to stop."""

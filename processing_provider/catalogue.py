"""Translation of finished sentences.

A text is matched to the pattern that it was made of. What was filled in is translated likewise, and fills the
pattern of the other language. A text without a pattern is divided into parts that may have one.
"""

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping
from functools import cache, lru_cache
from typing import Callable, NamedTuple

HOLE = re.compile(r"%(\d{1,2})")
"""Stands in a pattern for what is filled in, as in Qt."""

WORD = re.compile(r"[^\W\d_]+")

SENTENCES, CLAUSES = ". ", ("\n", "; ", ": ", ", ", " (")
"""Where a text without a pattern of its own is divided into texts that may have one."""

EDGES = (re.compile(r"^\W+|\W+$"), re.compile(r"^[\W\d_]*\W|\W[\W\d_]*$"))
"""What stands before and after a text: no letters, but never a part of a word such as a01; with and without
numbers, which may belong to the text."""

DEEPEST = 4
"""Levels of patterns within patterns; the core has three."""

MOST_SENTENCES = 12
"""A longer text is divided after all its sentences, and not where most of it is known."""


class Translation(NamedTuple):
    """A text in the other language, and how many letters of the English one were known."""

    text: str
    known: int


class Catalogue:
    """Texts and their translations.

    Parameters
    ----------
    translations : dict of str to str
        By their English; both with %1, %2 ... in place of what is filled in.
    """

    def __init__(self, translations: Mapping[str, str]) -> None:
        self._translations = translations
        self._patterns = _indexed(source for source in translations if HOLE.search(source))
        self._cached = lru_cache(maxsize=100_000)(self._translation)

    def translate(self, text: str) -> str:
        """Return a text in the other language, as far as it is known; the rest remains as it is."""
        return self._cached(text, DEEPEST).text

    def _translation(self, text: str, depth: int) -> Translation:
        """Return the best translation, with patterns within patterns to a depth."""
        if not WORD.search(text):
            return Translation(text, 0)
        if text in self._translations and not HOLE.search(text):
            return Translation(self._translations[text], len(text))
        # Of equals the first: the parts of a list, before a pattern that fits its ends.
        options = [Translation(text, 0), *self._divided(text, depth)]
        if depth:
            options += self._filled(text, depth - 1)
        return max(options, key=lambda option: option.known)

    def _filled(self, text: str, depth: int) -> Iterator[Translation]:
        """Yield translations by the patterns that fit the whole text."""
        for word in dict.fromkeys(WORD.findall(text)):
            for pattern in map(_pattern, self._patterns.get(word, ())):
                match = pattern.regex.fullmatch(text)
                if match:
                    parts = [self._cached(part, depth) for part in match.groups()]
                    text_of = _filling(part.text for part in parts)
                    filled = HOLE.sub(text_of, self._translations[pattern.source])
                    yield Translation(filled, pattern.known + sum(part.known for part in parts))

    def _divided(self, text: str, depth: int) -> Iterator[Translation]:
        """Yield translations of the text in parts."""
        inners = dict.fromkeys(edges.sub("", text) for edges in EDGES)
        for inner in (found for found in inners if found != text):
            before, _, after = text.partition(inner)
            found = self._cached(inner, depth)
            yield Translation(before + found.text + after, found.known)
        places = [found.end() - 1 for found in re.finditer(re.escape(SENTENCES), text)]
        if 0 < len(places) <= MOST_SENTENCES:
            for place in places:
                yield self._joined([text[:place], text[place + 1 :]], " ", depth)
        elif places:
            yield self._joined(text.split(SENTENCES), SENTENCES, depth)
        for divider in CLAUSES:
            if divider in text:
                yield self._joined(text.split(divider), divider, depth)

    def _joined(self, texts: list[str], divider: str, depth: int) -> Translation:
        parts = [self._cached(text, depth) for text in texts]
        return Translation(divider.join(part.text for part in parts), sum(part.known for part in parts))


class _Pattern(NamedTuple):
    source: str
    regex: "re.Pattern[str]"
    known: int


def _filling(texts: Iterable[str]) -> Callable[["re.Match[str]"], str]:
    """Return what gives the text of a hole."""
    numbered = dict(enumerate(texts, start=1))
    return lambda hole: numbered[int(hole[1])]


def _indexed(sources: Iterable[str]) -> dict[str, list[str]]:
    """Return the patterns by the one of their words that the fewest other patterns have."""
    words = {source: {*WORD.findall(HOLE.sub("%", source))} for source in sources}
    counts = Counter(word for found in words.values() for word in found)
    patterns = defaultdict(list)
    for source, found in words.items():
        rarest = min(found, key=lambda word: (counts[word], -len(word), word))
        patterns[rarest].append(source)
    return patterns


@cache
def _pattern(source: str) -> _Pattern:
    """Return a pattern whose holes match anything."""
    literals = HOLE.split(source)[::2]
    regex = "(.*?)".join(map(re.escape, literals))
    return _Pattern(source, re.compile(regex, re.DOTALL), len("".join(literals)))

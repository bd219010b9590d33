"""Three certificates from which a root does not follow, for attack.py: each is refused for one reason."""
from fractions import Fraction

# Conditions: (name, text of the checker, the text with which the condition always holds).
CONDITIONS = [
    ("three certificates of one problem", 'need(len(same) == 1 and not low.zeros and parts[3] == "",', "need(True,"),
    ("starts that match", 'need(low.starts == high.starts == both.starts and between == "[%s, %s]" % (first, last),', "need(True,"),
    ("values that are apart", "need(fraction(ends[0]) < fraction(ends[1]),", "need(True,"),
]


def made_certificates(accepted, whole, exponential):
    """(name, text) about y' = y, y(0) = 1 .. 11/10, up to t = 1/4."""
    quarter, unit = Fraction(1, 4), 1 << 200

    def at(start, claim):
        return exponential(quarter, (1 << 100, 1 << 120), claim=claim, size=24, start=start, middle=Fraction(start))

    def between(start):
        return exponential(quarter, (unit // 10, unit // 5), claim="-9 9", size=24, start=start, middle=Fraction(21, 20))
    low, high, both = at("1", "1.284 1.285"), at("11/10", "1.412 1.413"), between("[1, 11/10]")
    if not accepted(whole, low + high + both):
        raise SystemExit("roots.py: the true certificate is refused")
    yield "another equation", low + high + both.replace("y' = y", "y' = 1*y")
    yield "other text behind", low + high + both + "more"
    yield "another interval of starts", low + high + between("[1, 21/20]")
    yield "values on the same side", at("1", "0 9") + at("11/10", "0 9") + both

"""Numbers as text."""


def number(value, digits=3):
    """For tables: with commas and to the unit from a thousand on."""
    return f"{value:.{digits}g}" if value < 1000 else f"{value:,.0f}"


def milliseconds(value):
    """Times from a dispatch's microseconds to brute force's seconds, in one column."""
    return f"{value:.4f}" if value < 100 else f"{value:,.1f}"


def rounded(value, digits=2):
    """For sentences: as many digits as count, and no power of ten."""
    text = f"{float(f'{value:.{digits}g}'):,.10f}"
    return text.rstrip("0").rstrip(".")


def span(pair, digits=2):
    low, high = (rounded(value, digits) for value in pair)
    return low if low == high else f"{low} to {high}"


def megabytes(value):
    return None if value is None else f"{value / 1e6:,.1f}" if value < 1e8 else f"{value / 1e6:,.0f}"

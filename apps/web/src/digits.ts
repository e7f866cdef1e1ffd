/** A number with three digits that count. */
export const short = (value: number): string =>
  value >= 100 ? Math.round(value).toLocaleString("en") : value.toFixed(value >= 10 ? 1 : value >= 1 ? 2 : 3);

/** The same of any size, without zeros at its end: 0.0741, 834, 1.5e-7. */
export const significant = (value: number, digits = 3): string => String(Number(value.toPrecision(digits)));

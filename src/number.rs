//! The one number formatter of tables, records, CSV and JSON.

/// The least and the largest of these values; of none, ends that cross.
pub fn ends_of(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    values.fold(none, |[low, high], value| [low.min(value), high.max(value)])
}

/// `value` with fixed decimals, never a negative zero; "-" where it is not finite.
pub fn number(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "-".to_owned();
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| c == '0' || c == '.') => digits.to_owned(),
        _ => text,
    }
}

/// `value` with fixed decimals, never more than it is: how the lower end of a proof is printed.
pub fn below(value: f64, decimals: usize) -> String {
    rounded_to(value, decimals, -1.0)
}

/// `value` with fixed decimals, never less than it is: how the upper end of a proof is printed.
pub fn above(value: f64, decimals: usize) -> String {
    rounded_to(value, decimals, 1.0)
}

/// Rounded to the nearest, and by one in the last digit towards `sign` where that lies on the wrong side.
fn rounded_to(value: f64, decimals: usize, sign: f64) -> String {
    let nearest = number(value, decimals);
    let is_wrong = |text: &str| {
        text.parse::<f64>()
            .is_ok_and(|near| sign * near < sign * value)
    };
    if !is_wrong(&nearest) {
        return nearest;
    }
    let step = 10f64.powi(-(decimals as i32));
    number(value + sign * step / 2.0, decimals)
}

/// As [`number`], without trailing zeros.
pub fn short(value: f64, decimals: usize) -> String {
    let text = number(value, decimals);
    if !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// `value` with 9 significant digits, for machines; empty where it is not finite.
pub fn nine_digits(value: f64) -> String {
    if !value.is_finite() {
        return String::new();
    }
    let rounded: f64 = format!("{value:.8e}").parse().unwrap_or(value);
    // Adding zero turns a negative zero into a positive one.
    let rounded = rounded + 0.0;
    if rounded != 0.0 && !(1e-6..1e15).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded}")
    }
}

/// `value` with 9 significant digits, rounded towards `sign` where the nearest lies on the other side.
pub fn nine_outwards(value: f64, sign: f64) -> f64 {
    let nearest: f64 = nine_digits(value).parse().unwrap_or(value);
    if sign * nearest >= sign * value {
        return nearest;
    }
    let step = 10f64.powi(value.abs().log10().floor() as i32 - 8);
    nine_digits(value + sign * step / 2.0)
        .parse()
        .unwrap_or(value)
}

/// A relative amount as a percentage: one decimal, and two below 0.1 %.
pub fn percent(relative: f64) -> String {
    let percent = 100.0 * relative;
    let decimals = if percent.abs() < 0.095 { 2 } else { 1 };
    format!("{} %", number(percent, decimals))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_proofs_are_rounded_outwards() {
        assert_eq!(below(0.289_523_821, 6), "0.289523");
        assert_eq!(above(0.289_523_821, 6), "0.289524");
        assert_eq!(above(0.289_523_121, 6), "0.289524");
        assert_eq!(
            (below(0.5, 5), above(0.5, 5)),
            ("0.50000".into(), "0.50000".into())
        );
        assert_eq!(
            (below(-0.000_001, 5), above(-0.000_001, 5)),
            ("-0.00001".into(), "0.00000".into())
        );
        assert_eq!(
            (below(0.999_999_9, 3), above(0.999_999_9, 3)),
            ("0.999".into(), "1.000".into())
        );
        assert_eq!(above(f64::NAN, 2), "-");
        assert_eq!(nine_outwards(0.123_456_789_4, 1.0), 0.123_456_79);
        assert_eq!(nine_outwards(0.123_456_789_4, -1.0), 0.123_456_789);
        assert_eq!(nine_outwards(99.999_999_99, -1.0), 99.999_999_9);
        assert_eq!(nine_outwards(0.0, 1.0), 0.0);
    }

    #[test]
    fn no_negative_zero_and_no_non_finite_number() {
        assert_eq!(number(-0.00001, 3), "0.000");
        assert_eq!(number(-0.01, 2), "-0.01");
        assert_eq!(number(f64::NAN, 2), "-");
        assert_eq!(short(8.0, 3), "8");
        assert_eq!(short(100.0, 0), "100");
        assert_eq!(nine_digits(-0.0), "0");
        assert_eq!(nine_digits(0.642_858_571_234), "0.642858571");
        assert_eq!(nine_digits(1.5e-12), "1.5e-12");
        assert_eq!(nine_digits(f64::INFINITY), "");
    }
}

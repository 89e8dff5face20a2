//! The one number formatter of tables, records, CSV and JSON.

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

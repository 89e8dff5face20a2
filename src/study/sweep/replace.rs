//! Putting a value into the file of a case.

use toml::{Table, Value};

/// When a key is replaced: what is computed from other keys comes after them.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Rank {
    Plain,
    Aspect,
    Refine,
}

impl Rank {
    pub(super) fn of(key: &str) -> Self {
        match key {
            "aspect" => Rank::Aspect,
            "refine" => Rank::Refine,
            _ => Rank::Plain,
        }
    }
}

/// Why a key of a case cannot vary, or not so.
#[derive(Debug, PartialEq)]
pub(super) struct Unvaried {
    pub what: String,
    /// What to write instead; without it, any key that can vary.
    pub help: Option<&'static str>,
}

impl<T: Into<String>> From<T> for Unvaried {
    fn from(what: T) -> Self {
        let what = what.into();
        Self { what, help: None }
    }
}

fn instead(what: &str, help: &'static str) -> Unvaried {
    let what = what.to_owned();
    let help = Some(help);
    Unvaried { what, help }
}

/// Puts a value into a case.
pub(super) fn replace(table: &mut Table, key: &str, value: &Value) -> Result<(), Unvaried> {
    match key {
        "aspect" => {
            let aspect = as_number(value).ok_or("the aspect of a unit is a number")?;
            let height = number_of(table, "height")?;
            set_unit(table, "length", aspect * height)
        }
        "refine" => refine(table, value),
        "title" | "source" | "references" => Err("it says nothing about the wall".into()),
        "head_joints" => Err(instead(
            "it is a column of its own",
            "write `head_joints = \"both\"` at the top",
        )),
        _ => put(table, key, value),
    }
}

/// Puts a value into a table, or, where there are points in the key, into what is in it.
fn put(table: &mut Table, key: &str, value: &Value) -> Result<(), Unvaried> {
    let Some((first, rest)) = key.split_once('.') else {
        table.insert(key.to_owned(), value.clone());
        return Ok(());
    };
    match table.get_mut(first) {
        Some(Value::Table(table)) => put(table, rest, value),
        Some(Value::Array(list)) => put_into_list(list, first, rest, value),
        _ => Err(format!("the case has no table `{first}`").into()),
    }
}

/// The same of a list, whose items are counted from 1.
fn put_into_list(list: &mut [Value], name: &str, key: &str, value: &Value) -> Result<(), Unvaried> {
    let (place, rest) = key.split_once('.').unwrap_or((key, ""));
    let index = place
        .parse()
        .ok()
        .and_then(|place: usize| place.checked_sub(1));
    let item = index.and_then(|index| list.get_mut(index));
    match (item, rest) {
        (None, _) => Err(format!("`{name}` has no item {place}; the first is 1").into()),
        (Some(item), "") => {
            *item = value.clone();
            Ok(())
        }
        (Some(Value::Table(table)), _) => put(table, rest, value),
        (Some(Value::Array(list)), _) => put_into_list(list, place, rest, value),
        (Some(_), _) => Err(format!("item {place} of `{name}` has no `{rest}`").into()),
    }
}

const A_BOND: &str = "write the case as `bond = \"running\"`, `courses = 6`, `units = 5`";

/// Cuts every unit of a bond into n by n of them: more courses in a wall of the same size.
fn refine(table: &mut Table, value: &Value) -> Result<(), Unvaried> {
    let times = value
        .as_integer()
        .filter(|times| (1..=1000).contains(times));
    let (what, help) = (
        "it cuts a unit into n by n",
        "write whole numbers from 1 to 1000",
    );
    let times = times.ok_or_else(|| instead(what, help))?;
    for key in ["courses", "units"] {
        let count = table.get(key).and_then(Value::as_integer);
        let count = count.ok_or_else(|| instead("the case has no bond", A_BOND))?;
        let count = count.checked_mul(times).ok_or("too many courses")?;
        table.insert(key.to_owned(), Value::Integer(count));
    }
    let times = times as f64;
    for (key, parts) in [
        ("length", times),
        ("height", times),
        ("weight", times * times),
    ] {
        let size = number_of(table, key)?;
        set_unit(table, key, size / parts)?;
    }
    Ok(())
}

fn as_number(value: &Value) -> Option<f64> {
    let whole = value.as_integer().map(|whole| whole as f64);
    value.as_float().or(whole)
}

/// A number of the table `unit`.
fn number_of(table: &Table, key: &str) -> Result<f64, Unvaried> {
    let unit = table.get("unit").and_then(Value::as_table);
    let number = unit.and_then(|unit| unit.get(key)).and_then(as_number);
    number.ok_or_else(|| format!("the case has no `unit` with a `{key}`").into())
}

fn set_unit(table: &mut Table, key: &str, number: f64) -> Result<(), Unvaried> {
    let unit = table.get_mut("unit").and_then(Value::as_table_mut);
    let unit = unit.ok_or("the case has no `unit`")?;
    unit.insert(key.to_owned(), Value::Float(number));
    Ok(())
}

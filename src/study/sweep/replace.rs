//! Putting a value into the file of a case.

use toml::{Table, Value};

/// What is computed from other keys is put in after them.
pub(super) fn rank(key: &str) -> usize {
    ["aspect", "refine"]
        .iter()
        .position(|known| *known == key)
        .map_or(0, |at| at + 1)
}

/// What can vary, for help lines.
const VARIES: &str = "vary a key of the case, such as `overburden` or `\"unit.length\"`, a setting \
                      such as `\"settings.starts\"`, `aspect` or `refine`";

/// Why a key of a case cannot vary, or not so, and what to write instead.
type Unvaried = (String, &'static str);

fn unvaried(what: impl Into<String>) -> Unvaried {
    (what.into(), VARIES)
}

/// Puts a value into a case.
pub(super) fn replace(table: &mut Table, key: &str, value: &Value) -> Result<(), Unvaried> {
    match key {
        "aspect" => {
            let aspect =
                as_number(value).ok_or_else(|| unvaried("the aspect of a unit is a number"))?;
            let height = number_of(table, "height")?;
            set_unit(table, "length", aspect * height)
        }
        "refine" => refine(table, value),
        "title" | "source" | "references" | "demand" => {
            Err(unvaried("it says nothing about the wall"))
        }
        "head_joints" => Err((
            "it is a column of its own".to_owned(),
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
        _ => Err(unvaried(format!("the case has no table `{first}`"))),
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
        (None, _) => Err(unvaried(format!(
            "`{name}` has no item {place}; the first is 1"
        ))),
        (Some(item), "") => {
            *item = value.clone();
            Ok(())
        }
        (Some(Value::Table(table)), _) => put(table, rest, value),
        (Some(Value::Array(list)), _) => put_into_list(list, place, rest, value),
        (Some(_), _) => Err(unvaried(format!(
            "item {place} of `{name}` has no `{rest}`"
        ))),
    }
}

const A_BOND: &str = "write the case as `bond = \"running\"`, `courses = 6`, `units = 5`";

/// Cuts every unit of a bond into n by n of them: more courses in a wall of the same size.
fn refine(table: &mut Table, value: &Value) -> Result<(), Unvaried> {
    let times = value.as_integer().filter(|n| (1..=1000).contains(n));
    let times = times.ok_or_else(|| {
        let what = "it cuts a unit into n by n".to_owned();
        (what, "write whole numbers from 1 to 1000")
    })?;
    for key in ["courses", "units"] {
        let count = table.get(key).and_then(Value::as_integer);
        let count = count.ok_or_else(|| ("the case has no bond".to_owned(), A_BOND))?;
        let count = count.checked_mul(times);
        let count = count.ok_or_else(|| unvaried("too many courses"))?;
        table.insert(key.to_owned(), Value::Integer(count));
    }
    let n = times as f64;
    for (key, parts) in [("length", n), ("height", n), ("weight", n * n)] {
        let size = match number_of(table, key) {
            // A unit is the unit of force, however small.
            Err(_) if key == "weight" => continue,
            size => size?,
        };
        set_unit(table, key, size / parts)?;
    }
    Ok(())
}

fn as_number(value: &Value) -> Option<f64> {
    let whole = value.as_integer().map(|whole| whole as f64);
    value.as_float().or(whole)
}

fn number_of(table: &Table, key: &str) -> Result<f64, Unvaried> {
    let unit = table.get("unit").and_then(Value::as_table);
    let number = unit.and_then(|unit| unit.get(key)).and_then(as_number);
    number.ok_or_else(|| unvaried(format!("the case has no `unit` with a `{key}`")))
}

fn set_unit(table: &mut Table, key: &str, number: f64) -> Result<(), Unvaried> {
    let unit = table.get_mut("unit").and_then(Value::as_table_mut);
    let unit = unit.ok_or_else(|| unvaried("the case has no `unit`"))?;
    unit.insert(key.to_owned(), Value::Float(number));
    Ok(())
}

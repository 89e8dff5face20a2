//! Pictures read back: where texts stand, how much room they take, and what ticks say.

#![allow(dead_code, reason = "every test binary uses its own part")]

/// A text of a picture, in pixels.
#[derive(Clone, Debug)]
pub struct Text {
    pub words: String,
    /// Class, where it has one.
    pub class: String,
    /// The point that it stands at.
    pub at: [f64; 2],
    /// Left, top, right, bottom.
    pub room: [f64; 4],
}

/// Widths of Helvetica in thousandths of the font size, roughly: narrow, wide and other letters. Less
/// than the true width, so that what overlaps here overlaps.
fn width(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | '\'' => 200.0,
        ' ' | '.' | ',' | ':' | ';' | 'f' | 't' | 'I' | '/' | '(' | ')' | '-' => 270.0,
        'm' | 'w' | 'M' | 'W' | '%' => 720.0,
        _ => 500.0,
    }
}

/// Value of an attribute of an element.
fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    let after = element.split_once(&format!(" {name}=\""))?.1;
    after.split_once('"').map(|(value, _)| value)
}

fn number(element: &str, name: &str) -> Option<f64> {
    attribute(element, name)?.parse().ok()
}

/// Every text of a picture.
pub fn texts(svg: &str) -> Vec<Text> {
    let mut found = Vec::new();
    for part in svg.split("<text").skip(1) {
        let (inside, after) = part.split_once('>').expect("an element ends");
        let element = format!(" {inside}");
        let words = after.split_once("</text>").expect("a text ends").0;
        let mut plain = String::new();
        let mut is_tag = false;
        for c in words.chars() {
            match c {
                '<' => is_tag = true,
                '>' => is_tag = false,
                _ if !is_tag => plain.push(c),
                _ => {}
            }
        }
        let plain = plain
            .replace("&amp;", "&")
            .replace("&lt;", "<")
            .replace("&gt;", ">");
        let size = number(&element, "font-size").unwrap_or(13.0);
        let long = plain.chars().map(width).sum::<f64>() * size / 1000.0;
        let at = ["x", "y"].map(|name| number(&element, name).expect("a text has a place"));
        let before = match attribute(&element, "text-anchor") {
            Some("middle") => long / 2.0,
            Some("end") => long,
            _ => 0.0,
        };
        let [x, y] = at;
        let room = if attribute(&element, "transform").is_some() {
            [x - 0.7 * size, y - long / 2.0, x, y + long / 2.0]
        } else {
            [x - before, y - 0.7 * size, x - before + long, y]
        };
        found.push(Text {
            words: plain,
            class: attribute(&element, "class").unwrap_or_default().to_owned(),
            at,
            room,
        });
    }
    found
}

/// Pairs of texts that cover each other, and texts that leave the picture, in words.
pub fn faults(svg: &str) -> Vec<String> {
    let all = texts(svg);
    let sizes = svg
        .split_once("viewBox=\"0 0 ")
        .expect("a picture has a size")
        .1;
    let sizes: Vec<f64> = (sizes.split_once('"').expect("it ends").0.split(' '))
        .map(|size| size.parse().expect("a number"))
        .collect();
    let mut faults = Vec::new();
    for (index, a) in all.iter().enumerate() {
        let [left, top, right, bottom] = a.room;
        if left < 0.0 || top < 0.0 || right > sizes[0] || bottom > sizes[1] {
            faults.push(format!("`{}` leaves the picture: {:?}", a.words, a.room));
        }
        for b in &all[index + 1..] {
            let wide = right.min(b.room[2]) - left.max(b.room[0]);
            let high = bottom.min(b.room[3]) - top.max(b.room[1]);
            if wide > 0.0 && high > 0.0 {
                faults.push(format!("`{}` covers `{}`", a.words, b.words));
            }
        }
    }
    faults
}

/// Ticks of every axis of a picture, as (number, pixels), labels of powers of ten as their logarithm
/// where `is_logarithmic`. Labels that are no numbers are left out.
pub fn axes(svg: &str, class: &str, is_logarithmic: bool) -> Vec<Vec<(f64, f64)>> {
    let mut axes: Vec<(f64, Vec<(f64, f64)>)> = Vec::new();
    for text in texts(svg).into_iter().filter(|text| text.class == class) {
        let Ok(value) = text.words.parse::<f64>() else {
            continue;
        };
        let value = if is_logarithmic { value.log10() } else { value };
        let (along, across) = match class {
            "x-tick" => (text.at[0], text.at[1]),
            _ => (text.at[1], text.at[0]),
        };
        // Labels of one axis stand on one line and rise; those of the next plot begin again.
        match axes.last_mut() {
            Some((line, ticks)) if *line == across && ticks[ticks.len() - 1].0 < value => {
                ticks.push((value, along));
            }
            _ => axes.push((across, vec![(value, along)])),
        }
    }
    axes.into_iter().map(|(_, ticks)| ticks).collect()
}

/// Asserts that every tick stands where its label says: on the line through the first and the last, to
/// half a digit of the label or half a pixel.
#[track_caller]
pub fn assert_true_ticks(axes: &[Vec<(f64, f64)>]) {
    for ticks in axes {
        let [(first, from), .., (last, to)] = ticks[..] else {
            continue;
        };
        for &(value, along) in ticks {
            let expected = from + (to - from) * (value - first) / (last - first);
            assert!(
                (along - expected).abs() < 0.05,
                "{value} stands at {along}, not {expected}"
            );
        }
    }
}

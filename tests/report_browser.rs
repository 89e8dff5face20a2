//! The report in a real browser: skipped, and saying so, where none is installed.

mod skipped;
mod webdriver;

use std::path::{Path, PathBuf};
use std::process::Command;

use skipped::skipped;
use webdriver::{Browser, installed};

/// Names the folder that screenshots go to, and another report to look at instead of a small one.
const SCREENSHOTS: &str = "TRILITH_SCREENSHOTS";
const REPORT: &str = "TRILITH_REPORT";

/// A report of small walls; or the one that is asked for.
fn report(folder: &Path) -> PathBuf {
    if let Some(path) = std::env::var_os(REPORT) {
        return PathBuf::from(path)
            .canonicalize()
            .expect("the report exists");
    }
    let cases = ["paper-1", "openings-4", "stack"];
    let sweep =
        "case,method,lower,upper,overburden\na,macro-block,0.4,0.9,0\na,macro-block,0.3,0.8,1\n";
    std::fs::write(folder.join("sweep.csv"), sweep).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_trilith"))
        .current_dir(folder)
        .arg("report")
        .args(cases)
        .args([
            "--method",
            "macro-block,associative,interval,pushover",
            "--head-joints",
            "open",
        ])
        .args(["--sweep", "sweep.csv", "--out", "."])
        .output()
        .expect("the program starts");
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    folder.join("report.html")
}

#[test]
fn the_report_works_in_a_browser() {
    if !installed() {
        skipped("no chromium and chromium-driver, with which Debian tests the report");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let path = report(folder.path());
    let size = std::fs::metadata(&path).unwrap().len();
    assert!(size < 5_000_000, "the report has {size} bytes");
    let browser = Browser::start();
    browser.resize(1440, 1000);
    // The browser's own first page.
    browser.log("performance");
    browser.open(&path);

    replay_moves(&browser);
    tables_sort(&browser);
    has_names_and_order(&browser);
    let shots = std::env::var_os(SCREENSHOTS).map(PathBuf::from);
    for (width, height) in [(1440, 1000), (390, 844)] {
        browser.resize(width, height);
        nothing_overflows(&browser, width);
        if let Some(folder) = &shots {
            std::fs::create_dir_all(folder).unwrap();
            browser.screenshot(&folder.join(format!("report-{width}.png")), true);
        }
    }

    let console = browser.log("browser");
    assert!(console.is_empty(), "{console:?}");
    for entry in browser.log("performance") {
        let message = entry["message"].as_str().unwrap_or_default();
        let message: serde_json::Value = serde_json::from_str(message).unwrap();
        let message = &message["message"];
        if message["method"] == "Network.requestWillBeSent" {
            let url = message["params"]["request"]["url"].as_str().unwrap();
            let own = url.starts_with("data:")
                || url.starts_with("chrome:")
                || url.split('#').next() == Some(&address(&path));
            assert!(own, "the page asks for {url}");
        }
    }
}

fn address(path: &Path) -> String {
    format!("file://{}", path.display())
}

/// The slider changes the pose, and playing moves the slider to the end by itself.
fn replay_moves(browser: &Browser) {
    let poses = browser.run(
        "const f = document.querySelector('figure.replay'), s = f.querySelector('input');
         const pose = () => [...f.querySelectorAll('.bodies path')].map(p => p.getAttribute('transform')).join();
         const at = v => { s.value = v; s.dispatchEvent(new Event('input')); return pose(); };
         return [s.max, at(0), at(s.max >> 1), at(s.max)];",
    );
    let last: u32 = poses[0].as_str().unwrap().parse().unwrap();
    assert!(last >= 10, "{last} frames");
    assert!(poses[1] != poses[2] && poses[2] != poses[3]);
    assert!(poses[3].as_str().unwrap().contains("rotate("));
    let button = "const f = document.querySelector('figure.replay'), b = f.querySelector('button'), s = f.querySelector('input');";
    browser.run(&format!(
        "{button} s.value = 0; s.dispatchEvent(new Event('input')); b.click(); return 0;"
    ));
    // Until the slider has moved: the browser waits for the promise.
    browser.run(&format!(
        "{button} return new Promise(moved => {{
           const look = () => +s.value > 0 ? moved(0) : requestAnimationFrame(look); look(); }});"
    ));
    let paused = browser.run(&format!(
        "{button} const word = b.textContent; b.click(); return [word, +s.value, b.textContent];"
    ));
    assert_eq!((&paused[0], &paused[2]), (&"Pause".into(), &"Play".into()));
    let reached = paused[1].as_u64().unwrap();
    assert!(reached > 0, "playing does not move the slider");
    // Twenty frames later.
    let now = browser.run(&format!(
        "{button} return new Promise(done => {{
           let left = 20; const next = () => left-- > 0 ? requestAnimationFrame(next) : done(+s.value);
           next(); }});"
    ));
    assert_eq!(
        now.as_u64().unwrap(),
        reached,
        "a paused replay stands still"
    );
}

/// A click on λ sorts by number, the next one turns it round; nothing is lost.
fn tables_sort(browser: &Browser) {
    let sorted = browser.run(
        "const t = document.querySelector('#multipliers table'), h = [...t.tHead.rows[0].cells];
         const i = h.findIndex(c => c.textContent === 'λ'), b = h[i].querySelector('button');
         const column = () => [...t.tBodies[0].rows].map(r => parseFloat(r.cells[i].textContent)).filter(v => !isNaN(v));
         const before = column(); b.click();
         const up = [column(), h[i].getAttribute('aria-sort')]; b.click();
         return [before, ...up, column(), h[i].getAttribute('aria-sort')];",
    );
    let column = |k: usize| -> Vec<f64> {
        sorted[k]
            .as_array()
            .unwrap()
            .iter()
            .map(|v| v.as_f64().unwrap())
            .collect()
    };
    let (before, up, down) = (column(0), column(1), column(3));
    assert!(before.len() >= 6, "{before:?}");
    assert!(!before.is_sorted());
    assert!(up.is_sorted() && up.len() == before.len(), "{up:?}");
    assert!(down.iter().rev().is_sorted(), "{down:?}");
    assert_eq!(
        (&sorted[2], &sorted[4]),
        (&"ascending".into(), &"descending".into())
    );
}

/// Every control has a name, drawings have alternatives, headings do not skip, ids are unique.
fn has_names_and_order(browser: &Browser) {
    let faults = browser.run(
        "const all = s => [...document.querySelectorAll(s)], faults = [];
         all('button').forEach(b => b.textContent.trim() || faults.push('button without a name'));
         all('input').forEach(i => i.getAttribute('aria-label') || faults.push('input without a name'));
         all('svg').forEach(s => s.getAttribute('aria-label') || faults.push('svg without a name'));
         all('svg').forEach(s => s.getAttribute('viewBox') || faults.push('svg that a narrow page cuts off'));
         all('img').forEach(i => i.alt || faults.push('image without a name'));
         all('.scroll').forEach(s => s.tabIndex === 0 && s.getAttribute('aria-label') || faults.push('scroll'));
         let level = 0;
         all('h1,h2,h3,h4').forEach(h => { const l = +h.tagName[1]; l > level + 1 && faults.push(h.textContent); level = l; });
         const ids = all('[id]').map(e => e.id), twice = ids.filter((id, i) => ids.indexOf(id) !== i);
         twice.length && faults.push('ids twice: ' + twice);
         all('a[href^=\"#\"]').forEach(a => document.getElementById(a.hash.slice(1)) || faults.push('link to ' + a.hash));
         return faults;",
    );
    assert_eq!(faults, serde_json::json!([]));
}

/// Nothing makes the page wider than the window; what is wide scrolls by itself, also unfolded.
fn nothing_overflows(browser: &Browser, width: u32) {
    let wide = browser.run(
        "document.querySelectorAll('details').forEach(d => { d.open = true; });
         const w = document.documentElement.clientWidth, out = [];
         if (document.documentElement.scrollWidth > w) {
           for (const e of document.querySelectorAll('body *')) {
             if (!e.closest('.scroll, svg, .skip') && e.getBoundingClientRect().right > w + 0.5) {
               out.push(e.tagName + '.' + e.className + ' ' + e.getBoundingClientRect().right);
             }
           }
           out.push(document.documentElement.scrollWidth);
         }
         document.querySelectorAll('details').forEach(d => { d.open = false; });
         return out;",
    );
    assert_eq!(wide, serde_json::json!([]), "at {width} px");
}

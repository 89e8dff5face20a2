//! What every page has around its contents: head, style, script. It refers to nothing outside itself.

use maud::{DOCTYPE, Markup, PreEscaped, html};

pub struct Document<'a> {
    pub title: String,
    /// Class of the page, which its style depends on.
    pub class: &'a str,
    pub heading: &'a str,
    pub lead: String,
    /// Links to sections: id and name.
    pub links: Vec<(String, String)>,
    pub body: Markup,
}

pub fn document(page: &Document) -> String {
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                // Nothing outside this file is needed; nothing is even asked for.
                meta http-equiv="Content-Security-Policy"
                    content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";
                link rel="icon" href="data:,";
                title { (page.title) }
                style { (PreEscaped(include_str!("style.css"))) }
            }
            body class=(page.class) {
                a.skip href="#main" { "Skip to the results" }
                header {
                    p.brand { "trilith" }
                    h1 { (page.heading) }
                    p.lead { (page.lead) }
                    nav aria-label="Sections" {
                        ul { @for (id, title) in &page.links { li { a href={"#" (id)} { (title) } } } }
                    }
                }
                main #main { (page.body) }
                footer { p { "Written by trilith " (env!("CARGO_PKG_VERSION")) ". One file, no network." } }
                script { (PreEscaped(include_str!("script.js"))) }
            }
        }
    };
    markup.into_string()
}

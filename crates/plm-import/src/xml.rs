//! XML as a tree of owned elements with places.

use std::rc::Rc;

use crate::notice::{Notices, Place};

/// Elements within elements: more than any model has, and far from the end of the stack.
const DEEPEST: usize = 200;
/// The bound of numbers.
const UNBOUNDED: f64 = 1e16;

/// An attribute of an element.
#[derive(Clone, Debug)]
pub(crate) struct Attribute {
    pub(crate) name: String,
    pub(crate) value: String,
    pub(crate) place: Place,
}

/// An element with its attributes and children.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    /// With the prefix of a namespace, as in `drake:joint`.
    pub(crate) name: String,
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) children: Vec<Element>,
    /// The text of the element, without that of its children, trimmed.
    pub(crate) text: String,
    pub(crate) place: Place,
}

/// The root of a text.
///
/// # Errors
/// The text is no XML, or is nested too deeply: place and message.
pub(crate) fn parse(file: &Rc<str>, text: &str) -> Result<Element, (Place, String)> {
    // Prefixes without a declaration are usual (`drake:`); roxmltree refuses them, so that they become part of the name.
    let plain = plainer(text);
    let document = roxmltree::Document::parse(&plain).map_err(|why| {
        let at = why.pos();
        (Place { file: file.clone(), line: at.row, column: at.col }, format!("this is no XML: {why}"))
    })?;
    element(document.root_element(), text, file, 0)
}

/// An element of the plain text; `text` is the file's own, in which its tag has its colon at the same place.
fn element(
    node: roxmltree::Node<'_, '_>,
    text: &str,
    file: &Rc<str>,
    depth: usize,
) -> Result<Element, (Place, String)> {
    let at = |position: usize| {
        let at = node.document().text_pos_at(position);
        Place { file: file.clone(), line: at.row, column: at.col }
    };
    let place = at(node.range().start);
    if depth > DEEPEST {
        return Err((place, format!("elements are nested more than {DEEPEST} deep")));
    }
    let attributes = node.attributes().map(|attribute| Attribute {
        name: attribute.name().to_owned(),
        value: attribute.value().trim().to_owned(),
        place: at(attribute.range().start),
    });
    let inner: String =
        node.children().filter(roxmltree::Node::is_text).filter_map(|text| text.text()).collect();
    let children = node.children().filter(roxmltree::Node::is_element);
    let plain = node.tag_name().name();
    let start = node.range().start + 1;
    Ok(Element {
        name: text.get(start..start + plain.len()).unwrap_or(plain).to_owned(),
        attributes: attributes.collect(),
        children: children.map(|child| element(child, text, file, depth + 1)).collect::<Result<_, _>>()?,
        text: inner.trim().to_owned(),
        place,
    })
}

/// The text with `_` for the colon of a prefix in the name of an element, `<drake_joint>`, and for hyphens in comments. Columns stay.
fn plainer(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(open) = rest.find('<') {
        let (before, tag) = rest.split_at(open);
        plain.push_str(before);
        let skip = ["<!--", "<![CDATA[", "<?", "<!"].into_iter().find(|start| tag.starts_with(start));
        let end = match skip {
            Some("<!--") => tag.find("-->").map(|at| at + 3),
            Some("<![CDATA[") => tag.find("]]>").map(|at| at + 3),
            Some(_) => tag.find('>').map(|at| at + 1),
            None => Some(tag.find(|c: char| c.is_whitespace() || c == '>').unwrap_or(tag.len())),
        };
        let (name, after) = tag.split_at(end.unwrap_or(tag.len()));
        match skip {
            // Two hyphens within a comment are no XML either, and usual.
            Some("<!--") if name.len() >= 7 => {
                let inner = &name[4..name.len() - 3];
                plain.push_str("<!--");
                plain.push_str(&inner.replace('-', "_"));
                plain.push_str("-->");
            }
            Some(_) => plain.push_str(name),
            None => plain.push_str(&name.replace(':', "_")),
        }
        rest = after;
    }
    plain.push_str(rest);
    plain
}

impl Element {
    pub(crate) fn attribute(&self, name: &str) -> Option<&Attribute> {
        self.attributes.iter().find(|attribute| attribute.name == name)
    }

    pub(crate) fn get(&self, name: &str) -> Option<&str> {
        self.attribute(name).map(|attribute| attribute.value.as_str())
    }

    pub(crate) fn child(&self, name: &str) -> Option<&Element> {
        self.children.iter().find(|child| child.name == name)
    }

    pub(crate) fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Element> {
        self.children.iter().filter(move |child| child.name == name)
    }

    /// The element in messages: its tag, with its name where it has one.
    pub(crate) fn shown(&self) -> String {
        match self.get("name") {
            Some(name) => format!("<{}> `{name}`", self.name),
            None => format!("<{}>", self.name),
        }
    }

    /// Numbers of an attribute; of one that holds others there is an error and none.
    pub(crate) fn numbers(&self, name: &str, notices: &mut Notices) -> Option<Vec<f64>> {
        let attribute = self.attribute(name)?;
        let numbers = numbers(&attribute.value);
        if numbers.is_none() {
            notices.error(&attribute.place, format!("{name}: expected numbers, found `{}`", attribute.value));
        }
        numbers
    }

    /// An attribute that is one number.
    pub(crate) fn number(&self, name: &str, notices: &mut Notices) -> Option<f64> {
        self.exactly::<1>(name, notices).map(|[number]| number)
    }

    /// An attribute that is this many numbers.
    pub(crate) fn exactly<const N: usize>(&self, name: &str, notices: &mut Notices) -> Option<[f64; N]> {
        let numbers = self.numbers(name, notices)?;
        let found = numbers.len();
        let numbers = <[f64; N]>::try_from(numbers).ok();
        if numbers.is_none() {
            let place = self.attribute(name).map_or(&self.place, |attribute| &attribute.place);
            notices.error(place, format!("{name}: expected {N} numbers, found {found}"));
        }
        numbers
    }

    /// The text of the element as this many numbers.
    pub(crate) fn text_numbers<const N: usize>(&self, notices: &mut Notices) -> Option<[f64; N]> {
        let found = numbers(&self.text).and_then(|numbers| <[f64; N]>::try_from(numbers).ok());
        if found.is_none() {
            notices
                .error(&self.place, format!("<{}>: expected {N} numbers, found `{}`", self.name, self.text));
        }
        found
    }

    /// The text of a child as one number.
    pub(crate) fn child_number(&self, name: &str, notices: &mut Notices) -> Option<f64> {
        self.child(name)?.text_numbers::<1>(notices).map(|[number]| number)
    }
}

/// Numbers with blanks between; infinite ones are the 1e16 by which SDF says that there is no bound.
fn numbers(text: &str) -> Option<Vec<f64>> {
    let number = |word: &str| word.parse().ok().filter(|number: &f64| !number.is_nan());
    text.split_whitespace()
        .map(|word| number(word).map(|number| number.clamp(-UNBOUNDED, UNBOUNDED)))
        .collect()
}

//! `<default>`: attributes of elements that do not say them, by class.

use std::collections::BTreeMap;

use crate::notice::Notices;
use crate::xml::{Attribute, Element};

/// The class that all others inherit from.
const MAIN: &str = "main";

/// Default classes with what they inherit.
#[derive(Debug)]
pub(super) struct Defaults<'a> {
    /// By class and tag.
    classes: BTreeMap<String, BTreeMap<&'a str, Vec<&'a Attribute>>>,
}

impl<'a> Defaults<'a> {
    pub(super) fn new(root: &'a Element, notices: &mut Notices) -> Defaults<'a> {
        let mut defaults = Defaults { classes: BTreeMap::from([(MAIN.to_owned(), BTreeMap::new())]) };
        for class in root.all("default") {
            defaults.read(class, MAIN, notices);
        }
        defaults
    }

    fn read(&mut self, class: &'a Element, parent: &str, notices: &mut Notices) {
        let name = class.get("class").unwrap_or(MAIN).to_owned();
        let mut own =
            self.classes.get(&name).or_else(|| self.classes.get(parent)).cloned().unwrap_or_default();
        for element in class.children.iter().filter(|child| child.name != "default") {
            let attributes = own.entry(element.name.as_str()).or_default();
            for attribute in &element.attributes {
                attributes.retain(|known: &&Attribute| known.name != attribute.name);
                attributes.push(attribute);
            }
        }
        self.classes.insert(name.clone(), own);
        for inner in class.all("default") {
            if inner.get("class").is_none() {
                notices.error(&inner.place, "<default>: a class within another has a name");
            }
            self.read(inner, &name, notices);
        }
    }

    /// The element with all attributes that hold for it: its own, else those of its class, else of the class of the bodies around it.
    pub(super) fn styled(
        &self,
        element: &Element,
        childclass: Option<&str>,
        notices: &mut Notices,
    ) -> Element {
        let class = element.get("class").or(childclass).unwrap_or(MAIN);
        let Some(tags) = self.classes.get(class) else {
            notices
                .error(&element.place, format!("{}: there is no default class `{class}`", element.shown()));
            return element.clone();
        };
        let mut styled = element.clone();
        for attribute in tags.get(element.name.as_str()).into_iter().flatten() {
            if styled.attribute(&attribute.name).is_none() {
                styled.attributes.push((*attribute).clone());
            }
        }
        styled
    }
}

//! Arguments of a tool: their schema, and their values, of which a wrong one is told by name.

use serde_json::{Map, Value, json};

use super::folder::Folder;

/// An argument.
pub(super) struct Field {
    pub(super) name: &'static str,
    pub(super) kind: Kind,
    pub(super) about: &'static str,
    pub(super) is_needed: bool,
}

/// The kind of an argument.
pub(super) enum Kind {
    Text,
    Seconds,
    Bare,
    /// Names with values: numbers, or texts with units.
    Values,
    OneOf(&'static [&'static str]),
}

impl Field {
    fn schema(&self) -> Value {
        let mut schema = match self.kind {
            Kind::Text => json!({ "type": "string" }),
            Kind::Seconds => json!({ "type": "number", "minimum": 0 }),
            Kind::Bare => json!({ "type": "boolean" }),
            Kind::Values => {
                json!({ "type": "object", "additionalProperties": { "type": ["number", "string"] } })
            }
            Kind::OneOf(words) => json!({ "type": "string", "enum": words }),
        };
        schema["description"] = json!(self.about);
        schema
    }

    fn is_of_kind(&self, value: &Value) -> bool {
        match self.kind {
            Kind::Text => value.is_string(),
            Kind::Seconds => value.is_number(),
            Kind::Bare => value.is_boolean(),
            Kind::Values => value
                .as_object()
                .is_some_and(|all| all.values().all(|value| value.is_number() || value.is_string())),
            Kind::OneOf(words) => value.as_str().is_some_and(|word| words.contains(&word)),
        }
    }

    fn wanted(&self) -> String {
        match self.kind {
            Kind::Text => "a text".to_owned(),
            Kind::Seconds => "a number of seconds".to_owned(),
            Kind::Bare => "true or false".to_owned(),
            Kind::Values => {
                "an object of names with numbers or texts with units, as in {\"length\": \"20 cm\"}"
                    .to_owned()
            }
            Kind::OneOf(words) => format!("one of {}", words.join(", ")),
        }
    }
}

/// The schema of the arguments of a tool.
pub(super) fn schema<'f>(fields: impl Iterator<Item = &'f Field>) -> Value {
    let (mut properties, mut needed) = (Map::new(), Vec::new());
    for field in fields {
        properties.insert(field.name.to_owned(), field.schema());
        needed.extend(field.is_needed.then_some(field.name));
    }
    json!({ "type": "object", "properties": properties, "required": needed, "additionalProperties": false })
}

/// Arguments of a call, of the kinds that their fields say.
pub(super) struct Arguments<'a> {
    given: Map<String, Value>,
    folder: &'a Folder,
}

impl<'a> Arguments<'a> {
    /// # Errors
    /// One is unknown, missing or of another kind.
    pub(super) fn new<'f>(
        fields: impl Iterator<Item = &'f Field> + Clone,
        given: &Value,
        folder: &'a Folder,
    ) -> Result<Self, String> {
        let given = match given {
            Value::Null => Map::new(),
            Value::Object(given) => given.clone(),
            _ => return Err("the arguments of a tool are an object".to_owned()),
        };
        let names: Vec<&str> = fields.clone().map(|field| field.name).collect();
        if let Some(other) = given.keys().find(|name| !names.contains(&name.as_str())) {
            return Err(format!("there is no argument `{other}`; there are {}", names.join(", ")));
        }
        for field in fields {
            match given.get(field.name) {
                None if field.is_needed => {
                    return Err(format!("the argument `{}` is missing: {}", field.name, field.about));
                }
                Some(value) if !field.is_of_kind(value) => {
                    return Err(format!("`{}` is {value}, and {} is wanted", field.name, field.wanted()));
                }
                _ => {}
            }
        }
        Ok(Arguments { given, folder })
    }

    pub(super) fn text(&self, name: &str) -> Option<&str> {
        self.given.get(name).and_then(Value::as_str)
    }

    pub(super) fn seconds(&self, name: &str) -> Option<f64> {
        self.given.get(name).and_then(Value::as_f64)
    }

    pub(super) fn is_true(&self, name: &str) -> bool {
        self.given.get(name).and_then(Value::as_bool).unwrap_or_default()
    }

    /// A file or folder within the folder of the server.
    ///
    /// # Errors
    /// It is outside.
    pub(super) fn place(&self, name: &str) -> Result<Option<&str>, String> {
        self.text(name).map(|file| self.folder.within(file)).transpose()
    }

    /// Options of the command line for names with values: `--set=length=20 cm`.
    pub(super) fn values(&self, name: &str) -> Vec<String> {
        let all = self.given.get(name).and_then(Value::as_object).into_iter().flatten();
        let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        all.map(|(own, value)| format!("--{name}={own}={}", text(value))).collect()
    }

    /// The declaration: the word by which the command line finds it, and its standard input.
    ///
    /// # Errors
    /// Neither `text` nor `file` is given or both are, the file is outside the folder of the server or cannot be read, or it names such
    /// a file.
    pub(super) fn declaration(&self) -> Result<(String, String), String> {
        match (self.text("text"), self.place("file")?) {
            (Some(text), None) => {
                self.folder.holds_all_of("<stdin>", text)?;
                Ok(("-".to_owned(), text.to_owned()))
            }
            (None, Some(file)) => {
                let shown = self.folder.root().join(file);
                let read = crate::read::file(&shown.to_string_lossy(), &mut std::io::empty());
                // The folder of the server is no affair of whoever calls.
                let read = read.map_err(|why| why.replace(&*shown.to_string_lossy(), file))?;
                self.folder.holds_all_of(file, &read.text)?;
                // In front of a name that begins as options do.
                let word = if file.starts_with('-') { format!("./{file}") } else { file.to_owned() };
                Ok((word, String::new()))
            }
            (None, None) => {
                Err("a declaration is wanted: `text`, or `file` in the folder of the server".to_owned())
            }
            (Some(_), Some(_)) => Err("one declaration is wanted: `text` or `file`, not both".to_owned()),
        }
    }
}

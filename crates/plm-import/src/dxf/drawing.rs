//! The sections of a DXF file: its unit, its layers, its blocks, its entities.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::entities::{Chain, Entity};
use super::groups::{Group, groups};
use super::place::Placing;
use crate::notice::Notices;

/// Blocks within blocks, at most.
const DEEPEST: usize = 16;
/// Lines of points, at most: blocks in blocks grow without bound.
const MOST: usize = 200_000;

/// Unit, lines and layers of a drawing.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    /// `$INSUNITS`.
    pub(super) unit: Option<i64>,
    pub(super) chains: Vec<Chain>,
    /// Layers on which something is drawn.
    pub(super) layers: BTreeSet<String>,
}

/// A block: its base point and its entities.
#[derive(Default)]
struct Block<'g> {
    base: [f64; 2],
    entities: Vec<Entity<'g>>,
}

/// The file as it is read.
#[derive(Default)]
struct File<'g> {
    unit: Option<i64>,
    blocks: BTreeMap<&'g str, Block<'g>>,
    entities: Vec<Entity<'g>>,
    /// Layers that are off or frozen.
    hidden: BTreeSet<&'g str>,
}

impl<'g> File<'g> {
    fn read(groups: &'g [Group]) -> File<'g> {
        let mut file = File::default();
        let (mut section, mut block) = ("", None);
        let mut k = 0;
        while k < groups.len() {
            let end = (k + 1..groups.len()).find(|&next| groups[next].code == 0).unwrap_or(groups.len());
            let entity = Entity {
                name: &groups[k].value,
                place: &groups[k].place,
                groups: &groups[k + 1..end],
                vertices: Vec::new(),
            };
            k = end;
            match (section, entity.name) {
                (_, "SECTION") => section = entity.text(2).unwrap_or_default(),
                (_, "ENDSEC") => section = "",
                ("TABLES", "LAYER") => {
                    let is_hidden = entity.count(62) < 0 || entity.count(70) & 1 == 1;
                    file.hidden.extend(entity.text(2).filter(|_| is_hidden));
                }
                ("BLOCKS", "BLOCK") => {
                    block = entity.text(2);
                    let base = entity.point(10).unwrap_or_default();
                    file.blocks.entry(block.unwrap_or_default()).or_default().base = base;
                }
                ("BLOCKS", "ENDBLK") => block = None,
                ("BLOCKS", _) => {
                    let own = block.and_then(|name| file.blocks.get_mut(name));
                    if let Some(own) = own {
                        push(&mut own.entities, &entity);
                    }
                }
                ("ENTITIES", _) => push(&mut file.entities, &entity),
                _ => {}
            }
            if section == "HEADER" {
                file.unit = unit(entity.groups).or(file.unit);
            }
        }
        file
    }
}

/// Adds an entity; a corner goes to the polyline before it.
fn push<'g>(entities: &mut Vec<Entity<'g>>, entity: &Entity<'g>) {
    let Entity { name, place, groups, .. } = *entity;
    if name != "VERTEX" {
        return entities.push(Entity { name, place, groups, vertices: Vec::new() });
    }
    // What the control polygon of a smoothed line has is no corner of it.
    if let (Some(line), Some(at)) =
        (entities.last_mut(), entity.point(10).filter(|_| entity.count(70) & 16 == 0))
    {
        line.vertices.push((at, entity.number(42).unwrap_or_default()));
    }
}

fn unit(groups: &[Group]) -> Option<i64> {
    let at = groups.iter().position(|group| group.code == 9 && group.value == "$INSUNITS")?;
    groups.get(at + 1)?.value.parse().ok()
}

impl Drawing {
    /// Reads a drawing, of its layers those with these names, of which none stands for all.
    pub(super) fn read(
        file: &Rc<str>,
        text: &str,
        layers: &[String],
        notices: &mut Notices,
    ) -> Option<Drawing> {
        let groups = groups(file, text, notices)?;
        let file = File::read(&groups);
        let mut drawing = Drawing { unit: file.unit, ..Drawing::default() };
        let mut walk = Walk { file: &file, layers, drawing: &mut drawing, notices };
        walk.entities(&file.entities, &Placing::HERE, (None, 0));
        Some(drawing)
    }
}

/// A way through entities and the blocks in them.
struct Walk<'a, 'g> {
    file: &'a File<'g>,
    layers: &'a [String],
    drawing: &'a mut Drawing,
    notices: &'a mut Notices,
}

impl Walk<'_, '_> {
    /// Entities at a place; those on layer `0` of a block are on the layer of its use. `depth` counts blocks within blocks.
    fn entities(
        &mut self,
        entities: &[Entity<'_>],
        placing: &Placing,
        (outer, depth): (Option<&str>, usize),
    ) {
        for entity in entities.iter().filter(|entity| !entity.is_elsewhere()) {
            let layer = match (entity.layer(), outer) {
                ("0", Some(outer)) => outer,
                (own, _) => own,
            };
            if self.file.hidden.contains(layer) || self.drawing.chains.len() > MOST {
                continue;
            }
            if entity.name == "INSERT" {
                self.insert(entity, placing, (layer, depth));
                continue;
            }
            let is_wanted =
                self.layers.is_empty() || self.layers.iter().any(|own| own.eq_ignore_ascii_case(layer));
            if !is_wanted {
                self.drawing.layers.insert(layer.to_owned());
                continue;
            }
            let chain = entity.chain(placing, self.notices);
            if chain.is_some() {
                self.drawing.layers.insert(layer.to_owned());
            }
            self.drawing.chains.extend(chain);
        }
    }

    fn insert(&mut self, insert: &Entity<'_>, placing: &Placing, (layer, depth): (&str, usize)) {
        let name = insert.text(2).unwrap_or_default();
        let Some(block) = self.file.blocks.get(name).filter(|_| depth < DEEPEST) else {
            let why = if depth < DEEPEST { "there is no block" } else { "it is within itself: the block" };
            self.notices.error(insert.place, format!("INSERT: {why} `{name}`"));
            return;
        };
        for inner in placing.inserted(insert, block.base, self.notices) {
            self.entities(&block.entities, &inner, (Some(layer), depth + 1));
        }
    }
}

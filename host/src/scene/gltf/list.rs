//! Lists of a document.

use super::GltfError;
use super::json::Index;
use serde::de::{DeserializeOwned, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, de};
use serde_json::value::RawValue;
use std::cell::Cell;
use std::fmt;
use std::marker::PhantomData;

/// A list whose items are read each on its own: one that nothing refers to refuses no file. Anything but a list has no items.
pub(super) struct List<T>(Vec<Item<T>>);

struct Item<T> {
    read: Result<T, String>,
    /// Whether the scene needs it.
    is_needed: Cell<bool>,
}

impl<T> Default for List<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T> List<T> {
    pub const fn len(&self) -> usize {
        self.0.len()
    }

    /// An item, if it is there and can be read.
    pub fn get(&self, index: usize) -> Option<&T> {
        self.0.get(index)?.read.as_ref().ok()
    }

    /// All items that can be read, with their indices.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &T)> {
        let all = self.0.iter().enumerate();
        all.filter_map(|(index, item)| Some((index, item.read.as_ref().ok()?)))
    }

    /// The items that the scene needed so far.
    pub fn needed(&self) -> impl Iterator<Item = &T> {
        let needed = self.0.iter().filter(|item| item.is_needed.get());
        needed.filter_map(|item| item.read.as_ref().ok())
    }

    /// The item with this index, which stands at a place in the JSON. `what` names the list.
    pub fn item(
        &self,
        what: &'static str,
        Index(index): Index,
        place: impl FnOnce() -> String,
    ) -> Result<&T, GltfError> {
        let item = self.0.get(index);
        let read = item.map(|item| {
            item.is_needed.set(true);
            &item.read
        });
        match read {
            Some(Ok(item)) => Ok(item),
            Some(Err(message)) => Err(GltfError::Unreadable {
                what,
                index,
                message: message.clone(),
            }),
            None => Err(GltfError::NoSuch {
                place: place(),
                index,
                what,
                count: self.len(),
            }),
        }
    }
}

impl<'de, T: DeserializeOwned> Deserialize<'de> for List<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Items<T>(PhantomData<T>);

        impl<'de, T: DeserializeOwned> Visitor<'de> for Items<T> {
            type Value = List<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<List<T>, A::Error> {
                let mut items = Vec::new();
                while let Some(text) = list.next_element::<&RawValue>()? {
                    let read = serde_json::from_str(text.get()).map_err(|error| {
                        // The line and the column would be those in the item.
                        let message = error.to_string();
                        let end = message.find(" at line ").unwrap_or(message.len());
                        crate::text::shorten(&message[..end], 120)
                    });
                    items.push(Item {
                        read,
                        is_needed: Cell::new(false),
                    });
                }
                Ok(List(items))
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<List<T>, A::Error> {
                while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
                Ok(List::default())
            }

            fn visit_unit<E: de::Error>(self) -> Result<List<T>, E> {
                Ok(List::default())
            }

            fn visit_bool<E: de::Error>(self, _: bool) -> Result<List<T>, E> {
                Ok(List::default())
            }

            fn visit_i64<E: de::Error>(self, _: i64) -> Result<List<T>, E> {
                Ok(List::default())
            }

            fn visit_u64<E: de::Error>(self, _: u64) -> Result<List<T>, E> {
                Ok(List::default())
            }

            fn visit_f64<E: de::Error>(self, _: f64) -> Result<List<T>, E> {
                Ok(List::default())
            }

            fn visit_str<E: de::Error>(self, _: &str) -> Result<List<T>, E> {
                Ok(List::default())
            }
        }
        from.deserialize_any(Items(PhantomData))
    }
}

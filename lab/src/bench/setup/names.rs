//! Names of setups.

use super::{Lights, Setup, Triangles, Update};
use crate::measure::step::Step;
use slimbvh::reduce::Reduce;
use slimbvh::{CodeBits, TreeKind};
use slimbvh_cli::output::things;

impl Setup {
    /// The name in tables: the settings that differ from the usual setup.
    pub fn name(&self, usual: &Self) -> String {
        let mut parts = Vec::new();
        if self.reduce != usual.reduce && self.mesh != Triangles::Leaf10 {
            parts.push(format!("reduce {}", self.reduce_name()));
        }
        if self.lights != usual.lights {
            parts.push("lights apart".into());
        }
        if self.nodes != usual.nodes {
            parts.push(format!("nodes {}", self.nodes_name()));
        }
        if self.mesh != usual.mesh {
            parts.push(format!("mesh {}", self.mesh_name()));
        }
        if self.codes != usual.codes {
            parts.push(format!("{}-bit codes", self.code_bits()));
        }
        if self.tree != usual.tree {
            parts.push(format!("tree {}", self.tree_name()));
        }
        if self.update != usual.update {
            parts.push(self.update_name().into());
        }
        if self.threads != usual.threads {
            parts.push(things(self.threads, "thread"));
        }
        match parts.is_empty() {
            true => "default".into(),
            false => parts.join(", "),
        }
    }

    pub fn reduce_name(&self) -> &'static str {
        match self.reduce {
            Reduce::Auto => "auto",
            Reduce::On => "on",
            Reduce::Off => "off",
        }
    }

    pub fn lights_name(&self) -> &'static str {
        match self.lights {
            Lights::Grouped => "grouped",
            Lights::Apart => "apart",
        }
    }

    pub fn nodes_name(&self) -> &'static str {
        self.nodes.name()
    }

    pub fn mesh_name(&self) -> String {
        match self.mesh {
            Triangles::Full => "f32".into(),
            Triangles::Leaf10 => "leaf10".into(),
            Triangles::Lattice(Step::Finest) => "lattice".into(),
            Triangles::Lattice(Step::Pixels(pixels)) => format!("lattice {pixels}px"),
        }
    }

    pub fn code_bits(&self) -> u32 {
        match self.codes {
            CodeBits::Bits30 => 30,
            CodeBits::Bits63 => 63,
        }
    }

    pub fn tree_name(&self) -> &'static str {
        match self.tree {
            TreeKind::Radix => "radix",
            TreeKind::Clustered => "clustered",
        }
    }

    pub fn update_name(&self) -> &'static str {
        match self.update {
            Update::Rebuild => "rebuild",
            Update::Refit => "refit",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_what_is_not_as_usual() {
        let usual = Setup::usual(2);
        let names = Setup::one_at_a_time(2, 2);
        let names: Vec<String> = names.iter().map(|(_, setup)| setup.name(&usual)).collect();
        assert_eq!(names[0], "default");
        assert_eq!(names[1], "reduce off");
        assert!(names.contains(&"nodes paper10, mesh leaf10".into()));
        assert!(names.contains(&"nodes q10, mesh lattice 0.5px".into()));
        assert!(names.contains(&"nodes w4-48, mesh lattice 0.5px".into()));
        assert!(names.contains(&"1 thread".into()));
    }
}

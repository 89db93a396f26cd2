//! Scenes like those of the papers.

mod doll;
mod shiny;
mod toasters;
mod twenty_four_cell;

pub use doll::doll;
pub use shiny::shiny;
pub use toasters::toasters;
pub use twenty_four_cell::{TwentyFourCell, twenty_four_cell};

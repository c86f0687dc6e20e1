//! The families: a name, and who draws it. Shapes are told apart inside a family by words and size.

mod bathroom;
mod beds;
mod decor;
mod electronics;
mod fittings;
mod kitchen;
mod leisure;
mod lighting;
mod openings;
mod panels;
mod robots;
mod safety;
mod seating;
mod sport;
mod storage;
mod tables;
mod toys;
mod vehicles;

use crate::ask::Ask;
use crate::model::Model;

pub(crate) use leisure::unknown;

/// Draws one object.
pub(crate) type Maker = fn(&Ask) -> Model;

/// All families; the aliases that lead to them are in `lexicon.txt`.
pub(crate) const FAMILIES: &[(&str, Maker)] = &[
    ("aed", safety::aed),
    ("air_conditioner", leisure::air_conditioner),
    ("alarm", safety::alarm),
    ("aquarium", decor::aquarium),
    ("armchair", seating::sofa),
    ("ball", decor::ball),
    ("basket", leisure::basket),
    ("bathtub", bathroom::bathtub),
    ("bed", beds::bed),
    ("bench", seating::bench),
    ("bin", leisure::bin),
    ("blinds", openings::blinds),
    ("board", panels::board),
    ("book", decor::book),
    ("bookshelf", storage::bookshelf),
    ("bottle", decor::bottle),
    ("box", leisure::crate_box),
    ("cabinet", storage::cabinet),
    ("candle", lighting::candle),
    ("cart", robots::cart),
    ("ceiling_light", lighting::ceiling_light),
    ("car", vehicles::car),
    ("chair", seating::chair),
    ("chandelier", lighting::chandelier),
    ("chest", storage::chest),
    ("clock", decor::clock),
    ("clothes_rack", storage::clothes_rack),
    ("coat_rack", storage::coat_rack),
    ("coffee_machine", kitchen::coffee_machine),
    ("computer", electronics::computer),
    ("cone", safety::cone),
    ("conveyor", robots::conveyor),
    ("exam_table", beds::exam_table),
    ("counter", tables::counter),
    ("crib", beds::crib),
    ("cup", decor::cup),
    ("curtain", openings::curtain),
    ("desk", tables::desk),
    ("desk_lamp", lighting::desk_lamp),
    ("detector", safety::detector),
    ("device", electronics::device),
    ("dish", decor::dish),
    ("dispenser", bathroom::dispenser),
    ("display_case", storage::display_case),
    ("dock", robots::dock),
    ("door", openings::door),
    ("drone", robots::drone),
    ("dumbbell_rack", sport::dumbbell_rack),
    ("easel", panels::easel),
    ("emergency_shower", bathroom::emergency_shower),
    ("exercise_bike", leisure::bike),
    ("exit_sign", safety::exit_sign),
    ("extinguisher", safety::extinguisher),
    ("fan", leisure::fan),
    ("fire_box", safety::fire_box),
    ("fireplace", openings::fireplace),
    ("first_aid", safety::first_aid),
    ("fitting_room", fittings::fitting_room),
    ("floor_lamp", lighting::floor_lamp),
    ("folded_clothes", fittings::folded),
    ("fridge", kitchen::fridge),
    ("fume_hood", robots::fume_hood),
    ("phone", electronics::gadget),
    ("game_table", tables::game_table),
    ("garage_door", fittings::garage_door),
    ("gondola", storage::gondola),
    ("hand_truck", fittings::hand_truck),
    ("hood", kitchen::hood),
    ("kettlebell", sport::kettlebell),
    ("kettle", kitchen::kettle),
    ("keyboard", electronics::keyboard),
    ("kiosk", electronics::kiosk),
    ("ladder", openings::ladder),
    ("lamp", lighting::lamp),
    ("laptop", electronics::laptop),
    ("lectern", tables::lectern),
    ("locker", storage::locker),
    ("machine", robots::machine),
    ("microwave", kitchen::microwave),
    ("mirror", panels::mirror),
    ("mobile_robot", robots::mobile_robot),
    ("monitor", electronics::monitor),
    ("office_chair", seating::office_chair),
    ("ottoman", seating::ottoman),
    ("pallet", robots::pallet),
    ("pan", decor::pan),
    ("paper", decor::paper),
    ("parasol", decor::parasol),
    ("partition", openings::partition),
    ("pendant", lighting::pendant),
    ("person", decor::person),
    ("piano", leisure::piano),
    ("picture", panels::picture),
    ("pillar", openings::pillar),
    ("plant", decor::plant),
    ("platform", tables::platform),
    ("printer", electronics::printer),
    ("projection_screen", panels::screen),
    ("projector", electronics::projector),
    ("rack", storage::rack),
    ("radiator", leisure::radiator),
    ("robot_arm", robots::robot_arm),
    ("rug", panels::rug),
    ("sconce", lighting::sconce),
    ("server_rack", storage::server_rack),
    ("shelf", storage::open_shelf),
    ("shower", bathroom::shower),
    ("sink", kitchen::sink),
    ("sofa", seating::sofa),
    ("cushion", beds::soft),
    ("speaker", electronics::speaker),
    ("stairs", openings::stairs),
    ("statue", decor::statue),
    ("stool", seating::stool),
    ("stove", kitchen::stove),
    ("suitcase", leisure::suitcase),
    ("table", tables::table),
    ("table_lamp", lighting::table_lamp),
    ("tank", robots::tank),
    ("teddy", toys::teddy),
    ("till", electronics::till),
    ("toaster", kitchen::toaster),
    ("toilet", bathroom::toilet),
    ("tool_board", fittings::tool_board),
    ("towel_rail", bathroom::towel_rail),
    ("treadmill", leisure::treadmill),
    ("tv_stand", storage::tv_stand),
    ("urinal", bathroom::urinal),
    ("vase", decor::vase),
    ("wardrobe", storage::wardrobe),
    ("washer", kitchen::washer),
    ("water_dispenser", fittings::water_dispenser),
    ("weight_bench", sport::weight_bench),
    ("wheelchair", seating::wheelchair),
    ("window", openings::window),
    ("workbench", tables::workbench),
];

/// Who draws a family.
pub(crate) fn maker(family: &str) -> Option<(&'static str, Maker)> {
    FAMILIES.iter().find(|(name, _)| *name == family).copied()
}

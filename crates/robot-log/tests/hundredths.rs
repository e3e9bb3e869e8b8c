//! Headings in hundredths of a degree, as MAVLink has them: known by a name that says so, asked where none does.

use estimate::drive::Event;
use robot_log::{Files, Quantity, units_of};

const FROM_NORTH: &str = "0.01 deg from north";

fn of(column: &str, cells: &[&str]) -> Files {
    let rows = cells.iter().zip(0..).map(|(cell, i)| format!("{},-338999672,1512000558,{cell}\n", 200 + 500 * i));
    let mut files = Files::default();
    let text = format!("time_ms,lat_e7,lon_e7,{column}\n{}", rows.collect::<String>());
    files.add("nav.csv", &text).expect("a file");
    files.add("wheels.csv", "t,v,omega\n0,1,0\n1,1,0\n").expect("a file");
    files
}

fn heading(files: &Files) -> (Option<&'static str>, String) {
    let file = &files.files()[0];
    let at = file.role().values().iter().position(|value| value.name == "heading").expect("a role of sensors");
    assert_eq!(file.columns()[at], Some(3), "{:?}", file.header());
    (file.units()[at].map(|unit| unit.name), file.asks().join(" "))
}

#[test]
fn a_name_that_says_hundredths_is_read_in_them() {
    for name in ["heading_cdeg", "hdg_cdeg", "hdg [cdeg]", "cog_centideg", "headingCentidegrees", "hdg (0.01 deg)"] {
        let (unit, asks) = heading(&of(name, &["15175", "14753", "35999"]));
        assert_eq!((unit, asks.as_str()), (Some(FROM_NORTH), ""), "{name}");
    }
    let drive = of("hdg_cdeg", &["0", "9000", "15175", "65535"]).read().expect("sound");
    assert!(drive.notes.iter().any(|note| note.contains("1 reading of 65535 left out")), "{:?}", drive.notes);
    let read: Vec<f64> = (drive.log.drive.rows.iter())
        .filter_map(|row| if let Event::Heading { theta, .. } = row.event { Some(theta) } else { None })
        .collect();
    let wanted = [90.0_f64, 0.0, 90.0 - 151.75].map(f64::to_radians);
    assert_eq!(read.len(), 3);
    assert!(read.iter().zip(wanted).all(|(read, wanted)| (read - wanted).abs() < 1e-15), "{read:?}");
}

#[test]
fn a_heading_of_more_than_a_full_turn_and_one_that_is_called_hdg_alone_are_asked() {
    let turned: [&[&str]; 2] = [&["15175", "14753"], &["151.75", "147.53"]];
    for (name, cells, asked) in [
        ("hdg", turned[0], true),
        ("hdg", turned[1], true),
        ("cog", turned[0], true),
        ("heading", turned[0], true),
        ("heading_deg", turned[0], true),
        ("cog", turned[1], false),
        ("hdg_deg", turned[1], false),
        ("heading_deg", &["0", "360"], false),
    ] {
        let mut files = of(name, cells);
        let (unit, asks) = heading(&files);
        let wanted = format!("In which unit is \u{201c}{name}\u{201d}?");
        assert_eq!(
            (unit, asks),
            if asked { (None, wanted) } else { (Some("deg from north"), String::new()) },
            "{name}"
        );
        assert!(files.set_unit(0, "heading", FROM_NORTH) && files.read().is_ok());
    }
    // It may stand near north for a while, and turn later.
    let later: Vec<String> = (0..400).map(|k| (if k < 300 { 12 } else { 60 * k }).to_string()).collect();
    let later: Vec<&str> = later.iter().map(String::as_str).collect();
    assert_eq!(heading(&of("heading_deg", &later)).0, None);
    assert!(units_of(Quantity::Angle).iter().any(|unit| unit.name == "0.01 deg"));
}

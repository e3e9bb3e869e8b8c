//! Sightings whose rows say where the landmark is, and a last row that is cut.

use estimate::Landmark;
use robot_log::{Error, Files, Understood};

const DRIVE: &str = "time,v,omega\n0,0.5,0\n1,0.5,0\n2,0.5,0\n3,0.5,0\n4,0.5,0\n5,0.5,0\n";
const SEEN: &str = "time,beacon,beacon_x,beacon_y,range\n0.5,7,3,4,5.25\n1.5,9,3,-4,4.75\n2.5,7,3,4,4.50\n\
                    3.5,9,3,-4,4.25\n4.0,7,3,4,4.05\n4.5,9,3,-4,4.0";

fn read(all: &[(&str, &str)]) -> Result<Understood, Error> {
    let mut files = Files::default();
    all.iter().for_each(|(name, text)| files.add(name, text).expect(name));
    files.read()
}

#[test]
fn landmarks_are_where_the_rows_of_their_sightings_say() {
    let read = read(&[("drive.csv", DRIVE), ("seen.csv", &format!("{SEEN}5\n"))]).expect("sound");
    let [north, south] = [Landmark { id: 7, x: 3.0, y: 4.0 }, Landmark { id: 9, x: 3.0, y: -4.0 }];
    assert_eq!(read.log.drive.landmarks, [north, south]);
    assert_eq!(read.log.drive.rows.len(), 12);
}

#[test]
fn a_list_of_landmarks_goes_before_the_places_in_sightings_and_it_is_said() {
    let list = ("landmarks.csv", "landmark,x,y\n7,3.5,4\n9,3.5,-4\n");
    for all in [[("drive.csv", DRIVE), list, ("seen.csv", SEEN)], [("seen.csv", SEEN), ("drive.csv", DRIVE), list]] {
        let read = read(&all).expect("sound");
        assert_eq!(read.log.drive.landmarks.iter().map(|it| it.x).collect::<Vec<_>>(), [3.5, 3.5]);
        let said = "Landmarks are where their list has them: the places beside their sightings are not read.";
        assert!(read.notes.iter().any(|note| note == said), "{:?}", read.notes);
    }
}

#[test]
fn a_landmark_that_moves_is_refused_at_its_row() {
    let moved = SEEN.replace("4.0,7,3,4", "4.0,7,3,4.5");
    let error = read(&[("drive.csv", DRIVE), ("seen.csv", &moved)]).expect_err("it moves");
    assert_eq!((error.file, error.line), (1, 6));
    assert!(error.message.starts_with("the landmark is at (3, 4.5) here, and at (3, 4) in an earlier row"), "{error}");
}

#[test]
fn a_last_row_that_may_be_cut_is_left_out_and_it_is_said() {
    let read = |text: &str| read(&[("drive.csv", DRIVE), ("seen.csv", text)]).expect("sound");
    let cut = read(SEEN);
    assert_eq!(cut.log.drive.rows.len(), 11);
    let said = "seen.csv: it ends within line 7, which has fewer fields or digits than those above";
    assert!(cut.notes.iter().any(|note| note.starts_with(said)), "{:?}", cut.notes);
    // A line that ends is whole, and so is one whose last number has as many digits.
    for whole in [format!("{SEEN}\n"), format!("{SEEN}3")] {
        let read = read(&whole);
        assert_eq!(read.log.drive.rows.len(), 12);
        assert!(!read.notes.iter().any(|note| note.contains("ends within")), "{:?}", read.notes);
    }
}

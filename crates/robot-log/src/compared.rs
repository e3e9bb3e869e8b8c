//! The rows of a log's files compared with one another: the clocks, the truth's frame, and the headings.

use crate::again::added;
use crate::beside;
use crate::files::Files;
use crate::opposite::opposite;
use crate::own::{Own, own};

impl Files {
    /// Compares the times of the files with those of the motion, the headings with how the robot turned, and the truth
    /// with the fixes and with the motion: a file that has another clock asks from then on, and so does a truth with a
    /// frame or a clock of its own. The unit of headings that turn the other way round than the robot is asked where
    /// nobody has said it. A log without fixes has no truth compared, nor has one with several truths.
    pub fn compare(&mut self) {
        if core::mem::replace(&mut self.compared, true) {
            return;
        }
        self.files.iter_mut().for_each(|file| file.source.other_clock = None);
        // One file has nothing to be compared with but the headings in it.
        let compares = added(&self.files) > 1 || self.files.iter().any(|file| file.source.guesses_heading());
        let gathered = (compares && self.is_sound()).then(|| self.gathered(true).ok()).flatten();
        if let Some((reading, times)) = gathered {
            if added(&self.files) > 1 {
                let clocks = beside::clocks(&self.files, &times);
                self.files.iter_mut().zip(clocks).for_each(|(file, clock)| file.source.other_clock = clock);
            }
            let all = reading.to.rows();
            for (file, times) in self.files.iter_mut().zip(times) {
                if file.source.guesses_heading() && opposite(all, &all[times.rows[0]..times.rows[1]]) {
                    file.source.doubt_heading();
                }
            }
        }
        let found = beside::compared(&self.files).and_then(|(at, framed)| Some((at, self.found(framed)?)));
        for (at, file) in self.files.iter_mut().enumerate() {
            file.source.own = found.filter(|(truth, _)| *truth == at).map(|(_, own)| own);
        }
    }

    /// What brings the truth onto the fixes, where the files can be read so far.
    fn found(&self, framed: bool) -> Option<Own> {
        let log = self.is_sound().then(|| self.gathered(true).ok()?.0.finish(None, None).ok())??.log;
        own(&log.drive, framed)
    }

    /// Whether each file can be read as far as it says by itself.
    fn is_sound(&self) -> bool {
        self.files.iter().all(|file| file.check().is_ok() && file.source.asks_itself().is_empty())
    }
}

//! Runs each lab for 10,000 steps and prints the hash of every number on the way, for the test that compares this
//! machine's own code with wasm in Node and in browsers.

use labs::Lab;

fn print<L: Lab>() -> Result<(), estimate::Error> {
    let mut lab = L::new(L::Params::default())?;
    lab.run(10_000)?;
    println!("{} {:016x}", L::NAME, lab.digest());
    Ok(())
}

fn main() -> Result<(), estimate::Error> {
    print::<labs::ObserverBench>()?;
    print::<labs::OdometryHook>()?;
    print::<labs::ObservabilityProbe>()
}

//! The chosen constants of every scenario, for the chapter's table of them.

use crate::givens::Givens;
use lab::Listing;
use sim::scenarios::{HOOK, LOOP_CLOSURE, THREE_SENSORS, TUNING};
use sim::{LandmarkSensor, paths::Rectangle};

pub(super) fn list(givens: &Givens, to: &mut Listing) {
    hook(to);
    probe(givens, to);
    slam(givens, to);
    late(to);
    three_sensors(to);
}

fn course(to: &mut Listing, id: &str, course: &Rectangle) {
    let [first, second] = course.ticks.map(|ticks| f64::from(ticks) * course.ds);
    to.add(format!("{id}.long"), first, "first and third side of the course, m")
        .add(format!("{id}.wide"), second, "second and fourth side, m")
        .add(format!("{id}.ds"), course.ds, "way of a tick, m")
        .add(format!("{id}.lap"), f64::from(course.lap()), "ticks a lap");
}

fn sensor(to: &mut Listing, id: &str, sensor: &LandmarkSensor) {
    to.add(format!("{id}.range"), sensor.range_sigma, "standard deviation of a range, m")
        .add(format!("{id}.bearing"), sensor.bearing_sigma, "standard deviation of a bearing, rad")
        .add(format!("{id}.reach"), sensor.reach, "reach of the sensor, m");
}

fn hook(to: &mut Listing) {
    to.by("sim::scenarios::HOOK", None);
    course(to, "const.hook", &HOOK.course);
    sensor(to, "const.hook", &HOOK.sensor);
    to.add("const.hook.period", HOOK.period, "a tick, s")
        .add("const.hook.baseline", HOOK.wheels.baseline, "distance of the wheels, m")
        .add("const.hook.radius", HOOK.wheels.radius, "nominal radius of a wheel, m")
        .add("const.hook.counts", HOOK.wheels.ticks_per_turn, "encoder counts a turn")
        .add("const.hook.slip", HOOK.slip, "standard deviation of a wheel's slip in a tick, m")
        .add("const.hook.bias", HOOK.bias, "by how much the right wheel is believed too large")
        .add("const.hook.bias.sigma", HOOK.bias_sigma, "first standard deviation of a bias that is learned");
}

fn probe(givens: &Givens, to: &mut Listing) {
    let probe = &givens.probe;
    to.by("sim::scenarios::PROBE", None);
    course(to, "const.probe", &probe.course);
    sensor(to, "const.probe", &probe.sensor);
    to.add("const.probe.room", probe.room, "side of the room, m")
        .add("const.probe.steps", f64::from(probe.steps), "steps of the quoted run")
        .vector("const.probe.v", &probe.v_sigma, "process noise a tick, standard deviation: m, m, rad")
        .vector("const.probe.p0", &probe.p0_sigma, "first uncertainty, standard deviation: m, m, rad");
    for (j, landmark) in (1..).zip(probe.landmarks) {
        to.vector(&format!("const.probe.landmark{j}"), &[landmark.x, landmark.y], "place of a landmark, m");
    }
}

fn slam(givens: &Givens, to: &mut Listing) {
    let linear = &givens.linear_slam.variances;
    to.by("sim::scenarios::LINEAR_SLAM", None)
        .add("const.linear.v", linear.v, "process variance in each coordinate of the robot, m²")
        .add("const.linear.w", linear.w, "variance of a displacement in each coordinate, m²")
        .add("const.linear.robot", linear.p0_robot, "first variance of each coordinate of the robot, m²")
        .add("const.linear.landmark", linear.p0_landmark, "first variance of each landmark coordinate, m²")
        .add("const.linear.steps", f64::from(givens.linear_slam.steps), "steps");
    let slam = &givens.range_bearing_slam;
    to.by("sim::scenarios::RANGE_BEARING_SLAM", None);
    sensor(to, "const.rbslam", &slam.sensor);
    to.add("const.rbslam.poses", f64::from(slam.poses), "poses")
        .vector("const.rbslam.u", &slam.u_sigma, "noise of the input a tick, standard deviation: m, rad")
        .add("const.rbslam.gate", slam.gate, "the gate on χ²")
        .add("const.rbslam.found", slam.found, "χ² above which a sighting founds a landmark");
}

fn late(to: &mut Listing) {
    to.by("sim::scenarios::TUNING", None)
        .add("const.tune.hidden", libm::exp10(TUNING.hidden), "the greatest hidden q and W; the least is one over it")
        .add("const.tune.reach", libm::exp10(TUNING.reach), "the filter's greatest q and W; the least is one over it")
        .by("sim::scenarios::LOOP_CLOSURE", None);
    course(to, "const.loop", &LOOP_CLOSURE.course);
    sensor(to, "const.loop", &LOOP_CLOSURE.sensor);
    to.vector("const.loop.u", &LOOP_CLOSURE.u_sigma, "noise of the input a tick, standard deviation: m, rad").add(
        "const.loop.landmarks",
        LOOP_CLOSURE.landmarks.len() as f64,
        "landmarks on the corridor's walls",
    );
}

fn three_sensors(to: &mut Listing) {
    let constants = THREE_SENSORS;
    to.by("sim::scenarios::THREE_SENSORS", None)
        .vector("const.late.sigma", &constants.sigma, "standard deviation of sonar, laser and camera, m")
        .vector("const.late.p0", &constants.p0_sigma, "first uncertainty, standard deviation: m, m/s")
        .add("const.late.speed", constants.speed, "the speed at the start, m/s")
        .add("const.late.q", constants.q, "density of the acceleration's noise, m²/s³")
        .add("const.late.tick", constants.tick, "a tick, s")
        .add("const.late.end", constants.tick * constants.ticks as f64, "a run, s")
        .add("const.late.settled", constants.settled, "what is said of a run is said of the time from here on, s");
}

//! `plm import`: what holds links to each other is taken, or an error.

use super::{Said, plm};

/// A file of Drake with two pendulums, and what stands after them.
fn pendulums(after: &str) -> String {
    let link = |name: &str| {
        format!(
            "<link name=\"{name}\"><inertial><origin xyz=\"0 0 .5\"/><mass value=\"1\"/>\
             <inertia ixx=\".1\" iyy=\".1\" izz=\".1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
        )
    };
    let joint = |name: &str, x: f64, child: &str| {
        format!(
            "<joint name=\"{name}\" type=\"continuous\"><origin xyz=\"{x} 0 0\"/><parent link=\"world\"/><child link=\"{child}\"/>\
             <axis xyz=\"0 -1 0\"/></joint>"
        )
    };
    format!(
        "<robot name=\"two\" xmlns:drake=\"http://drake.mit.edu\"><link name=\"world\"/>{}{}{}{}\n{after}</robot>",
        link("crank"),
        link("rocker"),
        joint("a", 0.0, "crank"),
        joint("d", 1.0, "rocker")
    )
}

/// Numbers by a program that is written apart: RK4 of steps of 0.5 ms, generalised forces by differences of the bushing's displacement
/// in the axes halfway between its frames (Drake's documentation of LinearBushingRollPitchYaw).
#[test]
fn bushings_and_springs_of_drake_act() {
    let text = pendulums(
        "<frame name=\"fa\" link=\"crank\" xyz=\"0.5 0 1\" rpy=\"0 0.3 0\"/><frame name=\"fc\" link=\"rocker\" xyz=\"-0.4 0 1\" rpy=\"0 0.1 0\"/>\
         <drake:linear_bushing_rpy><drake:bushing_frameA name=\"fa\"/><drake:bushing_frameC name=\"fc\"/>\
         <drake:bushing_torque_stiffness value=\"1 2 3\"/><drake:bushing_torque_damping value=\"4 .5 6\"/>\
         <drake:bushing_force_stiffness value=\"7 8 9\"/><drake:bushing_force_damping value=\".10 .11 .12\"/></drake:linear_bushing_rpy>\
         <drake:linear_spring_damper><drake:linear_spring_damper_body_A name=\"crank\"/><drake:linear_spring_damper_p_AP value=\"0 0 1\"/>\
         <drake:linear_spring_damper_body_B name=\"world\"/><drake:linear_spring_damper_p_BQ value=\"2 0 1\"/>\
         <drake:linear_spring_damper_free_length value=\"1.5\"/><drake:linear_spring_damper_stiffness value=\"12\"/>\
         <drake:linear_spring_damper_damping value=\"0.2\"/></drake:linear_spring_damper>",
    );
    let Said { code, output, errors } = plm(&["import", "-"], &text);
    assert_eq!((code, errors.as_str()), (0, ""), "{output}");
    let said = plm(&["run", "-", "--until", "1", "--every", "1", "--csv", "-"], &output);
    let last: Vec<f64> =
        said.output.lines().last().unwrap().split(',').map(|number| number.parse().unwrap()).collect();
    for (found, expected) in last[1..3].iter().zip([-1.140_290_65, -1.806_413_72]) {
        assert!((found - expected).abs() < 1e-8, "{found} for {expected}");
    }
}

/// The kind of an element that holds links to each other: taken, or an error.
#[test]
fn no_loop_is_left_out() {
    let ball = "<drake:ball_constraint><drake:ball_constraint_body_A name=\"crank\"/><drake:ball_constraint_p_AP value=\"0.5 0 1\"/>\
                <drake:ball_constraint_body_B name=\"rocker\"/><drake:ball_constraint_p_BQ value=\"-0.5 0 1\"/></drake:ball_constraint>";
    let Said { code, output, errors } = plm(&["import", "-"], &pendulums(ball));
    assert!(
        code == 0 && output.contains("revolute ball_4(crank.ball_4, rocker.ball_4);"),
        "{output}{errors}"
    );
    for element in [
        "<drake:weld_constraint><drake:body_A name=\"crank\"/><drake:body_B name=\"rocker\"/></drake:weld_constraint>",
        "<drake:tendon_constraint><drake:tendon_constraint_joint name=\"a\" a=\"1\"/></drake:tendon_constraint>",
        "<drake:joint name=\"p\" type=\"planar\"><drake:parent link=\"world\"/><drake:child link=\"rocker\"/></drake:joint>",
        "<loop_joint name=\"l\" type=\"revolute\"><link1 link=\"crank\"/><link2 link=\"rocker\"/></loop_joint>",
        "<gazebo><joint name=\"l\" type=\"revolute\"><parent>crank</parent><child>rocker</child></joint></gazebo>",
        "<gazebo><plugin name=\"p\" filename=\"libroboticsgroup_gazebo_mimic_joint_plugin.so\"/></gazebo>",
        "<gazebo reference=\"rocker\"><turnGravityOff>true</turnGravityOff></gazebo>",
        "<xacro:property name=\"l\" value=\"1\"/>",
    ] {
        let Said { code, output, errors } = plm(&["import", "-"], &pendulums(element));
        assert!(code == 1 && output.is_empty() && errors.starts_with("error: <"), "{element}\n{errors}");
    }
    for element in [
        "<drake:collision_filter_group name=\"g\"><drake:member link=\"crank\"/><drake:member link=\"rocker\"/></drake:collision_filter_group>",
        "<gazebo reference=\"crank\"><mu1>0.2</mu1></gazebo>",
    ] {
        let Said { code, errors, .. } = plm(&["import", "-"], &pendulums(element));
        // The tag is shown as it stands.
        let tag = element[..element.find([' ', '>']).unwrap()].to_owned();
        assert!(code == 0 && errors.starts_with(&format!("warning: {tag}")), "{element}\n{errors}");
    }
}

/// Names that the language or emitted code has for itself, for links, joints and frames.
#[test]
fn names_that_are_taken_get_a_word_after_them() {
    let words = "x y theta t pi angle omega vx position mass inertia centre body frame force state param input port start when given repeat in \
                 for if then else and not min turn dot cross rate clamp on from within contour friction fn type mod struct self Self crate m N kg s \
                 rad deg ground alpha State time run step find at drift method notice clone spring revolute wheel free_slide halfway_bushing";
    for word in words.split_whitespace() {
        let text = format!(
            "<robot name=\"{word}\"><link name=\"world\"/><link name=\"{word}\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/>\
             </inertial></link><link name=\"Pole\"><inertial><origin xyz=\"0 0 -.5\"/><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial></link>\
             <joint name=\"{word}\" type=\"prismatic\"><parent link=\"world\"/><child link=\"{word}\"/><axis xyz=\"1 0 0\"/><limit effort=\"3\" lower=\"-1\" upper=\"1\"/>\
             </joint><joint name=\"pole\" type=\"continuous\"><parent link=\"{word}\"/><child link=\"Pole\"/><axis xyz=\"0 -1 0\"/></joint>\
             <frame name=\"{word}\" link=\"Pole\" xyz=\"0 0 1\"/></robot>"
        );
        let said = plm(&["import", "-"], &text);
        assert_eq!((said.code, said.errors.as_str()), (0, ""), "{word}\n{}", said.output);
    }
}

#[test]
fn actuators_are_told_by_what_they_act() {
    let text = |actuator: &str| {
        format!(
            "<mujoco><option><flag contact=\"disable\"/></option><worldbody><body name=\"a\"><joint name=\"p\" axis=\"0 1 0\"/><geom size=\"1\"/>\
             <site name=\"tip\"/></body></worldbody><tendon><fixed name=\"rope\"><joint joint=\"p\" coef=\"1\"/></fixed></tendon>\
             <actuator><motor name=\"pull\" {actuator}/></actuator></mujoco>"
        )
    };
    for (actuator, told) in [
        ("tendon=\"rope\"", "<motor> `pull` acts by the tendon `rope`, which is not taken"),
        (
            "slidersite=\"tip\" cranksite=\"tip\" cranklength=\"1\"",
            "<motor> `pull` acts by a slider-crank on the site `tip`, which is not taken",
        ),
        ("site=\"tip\"", "<motor> `pull` acts at the site `tip`, which is not taken"),
        ("joint=\"q\"", "<motor> `pull` drives the joint `q`, which is not known"),
    ] {
        let said = plm(&["import", "-"], &text(actuator));
        assert!(said.code == 0 && said.errors.contains(told), "{said:?}");
    }
}

#[test]
fn a_base_that_contact_holds_is_told_and_can_be_fixed() {
    let text = "<sdf version=\"1.9\"><model name=\"m\"><link name=\"base\"><inertial><mass>1</mass></inertial>\
                <collision name=\"c\"><geometry><box><size>1 1 1</size></box></geometry></collision></link>\
                <link name=\"arm\"><inertial><pose>0 0 -1 0 0 0</pose><mass>1</mass></inertial></link>\
                <joint name=\"pin\" type=\"revolute\"><parent>base</parent><child>arm</child><axis><xyz>0 1 0</xyz></axis></joint></model></sdf>";
    let told = "nothing but contact holds `base`, and contacts are left out: it falls; `--fix base` joins it to the world";
    let said = plm(&["import", "-"], text);
    assert!(said.code == 0 && said.errors.contains(told) && said.output.contains("body base {"), "{said:?}");
    let said = plm(&["import", "-", "--fix", "base"], text);
    assert!(!said.errors.contains("falls") && !said.output.contains("body base {"), "{said:?}");
    assert!(said.output.contains("revolute pin(arm.pin, ground.pin);"), "{said:?}");
    let said = plm(&["import", "-", "--fix", "bass"], text);
    assert!(
        said.code == 1 && said.errors.contains("there is no link `bass` to fix; links: base, arm"),
        "{said:?}"
    );
}

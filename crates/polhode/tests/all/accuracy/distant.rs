//! Motions at times beyond the tables.

use polhode::prelude::*;

use crate::accuracy::free_motion::error_of;

/// A motion at a time beyond the tables: its inputs, the time, and ω and attitude then (from the
/// functions of `fixtures/free_motion.py`).
pub(crate) struct Distant {
    pub(crate) what: &'static str,
    pub(crate) periods: &'static str,
    /// Principal moments, or the tensor elements xx, yy, zz, xy, xz, yz.
    inertia: &'static [f64],
    omega0: [f64; 3],
    t: f64,
    omega: [f64; 3],
    attitude: [f64; 4],
    /// Error bound by the laws stated in the book, rad.
    law: f64,
}

const ORDINARY: &[f64] = &[1.3717213, 2.0942331, 2.9163007];
const TURNED: &[f64] = &[
    2.146032727164142,
    2.2436623966078404,
    1.9803048762280144,
    0.10184836812087561,
    -0.27017229538057286,
    -0.7018842007823459,
];
const NEAR_SPHERE: &[f64] = &[
    1.3700001094006982,
    1.3700001294723636,
    1.3700000911269368,
    1.7773000071663603e-08,
    -4.07327779838873e-08,
    -1.0467616240461552e-07,
];

pub(crate) const DISTANT: [Distant; 21] = [
    Distant {
        what: "awkward",
        periods: "1e12",
        inertia: ORDINARY,
        omega0: [0.31117, -0.49321, 0.87113],
        t: 10715531023709.016,
        omega: [0.31107117393841777, -0.49328671462379686, 0.8711154087701932],
        attitude: [0.6479199180991396, -0.11714436799444142, 0.2835097315576221, -0.6972081532008301],
        law: 4e-15,
    },
    Distant {
        what: "awkward",
        periods: "1e16",
        inertia: ORDINARY,
        omega0: [0.31117, -0.49321, 0.87113],
        t: 1.0715531023709016e17,
        omega: [0.2882084162258249, -0.5100916534821561, 0.8678582713278462],
        attitude: [0.7651356254366888, 0.09041590409949786, -0.239944468085084, 0.5906090849359191],
        law: 7e-15,
    },
    Distant {
        what: "awkward",
        periods: "1e20",
        inertia: ORDINARY,
        omega0: [0.31117, -0.49321, 0.87113],
        t: 1.0715531023709015e21,
        omega: [-0.14865890203415622, -0.5789828703718591, 0.8532146120147593],
        attitude: [0.988527768757468, -0.037023396304859145, 0.14124294631984044, -0.038633517006947254],
        law: 3e-11,
    },
    Distant {
        what: "spherical (turns)",
        periods: "1e24",
        inertia: &[1.3717213, 1.3717213, 1.3717213],
        omega0: [0.31117, -0.49321, 0.87113],
        t: 5.993642463030814e24,
        omega: [0.31117, -0.49321, 0.87113],
        attitude: [0.4822920616645954, 0.260026725878792, -0.4121469983310698, 0.7279528287263941],
        law: 4e-15,
    },
    Distant {
        what: "1 − m = 2.8e-18, awkward",
        periods: "1e9",
        inertia: ORDINARY,
        omega0: [0.7775305807590485, 0.3123, 0.4999228361994028],
        t: 244459283753.84387,
        omega: [0.777531846827135, 0.3122961207374207, 0.4999236502334284],
        attitude: [0.34714546478687613, -0.5206394520543951, -0.3192619338441624, -0.7116856081448385],
        law: 4e-15,
    },
    Distant {
        what: "1 − m = 7.1e-26, awkward",
        periods: "1e9",
        inertia: ORDINARY,
        omega0: [0.45293239970919785, 0.3123, 0.2912184491163998],
        t: 532415668740.3536,
        omega: [0.4529312575669109, 0.3123020385586925, 0.2912177147619891],
        attitude: [0.9883224917657933, 0.07641284635453928, 0.08043718781219274, 0.10444897318172643],
        law: 4e-15,
    },
    Distant {
        what: "1 − m = 3.3e-32, awkward",
        periods: "1e3",
        inertia: ORDINARY,
        omega0: [0.43303317468895697, 0.3123, 0.27842399799580553],
        t: 681779.8827289486,
        omega: [0.4330331746906554, 0.31229999999710173, 0.27842399799689754],
        attitude: [-0.9747864118249328, -0.11045892828905253, -0.12162161823210572, -0.1509915840744463],
        law: 7e-13,
    },
    Distant {
        what: "1 − m = 3.3e-32, awkward",
        periods: "1e6",
        inertia: ORDINARY,
        omega0: [0.43303317468895697, 0.3123, 0.27842399799580553],
        t: 681779882.7289486,
        omega: [0.43303317711535594, 0.3122999958594792, 0.27842399955588853],
        attitude: [0.3991723975243425, -0.45387262329347744, -0.49973979542414226, -0.6204201606563102],
        law: 7e-10,
    },
    Distant {
        what: "1 − m = 3.3e-32, awkward",
        periods: "1e9",
        inertia: ORDINARY,
        omega0: [0.43303317468895697, 0.3123, 0.27842399799580553],
        t: 681779882728.9486,
        omega: [0.43303480594967536, 0.31229721632271207, 0.27842504683491887],
        attitude: [-0.5941420100303516, 0.3981771368782679, 0.43841156589687363, 0.54428442791648],
        law: 7e-07,
    },
    Distant {
        what: "with products of inertia",
        periods: "1e12",
        inertia: TURNED,
        omega0: [0.3, -0.5, 0.8],
        t: 12296620101691.31,
        omega: [0.3003858705708302, -0.5004205256016991, 0.7995464877680165],
        attitude: [-0.37005194100624084, 0.13955192095634986, -0.6112359216339681, 0.6855490284576151],
        law: 4e-15,
    },
    Distant {
        what: "with products of inertia",
        periods: "1e16",
        inertia: TURNED,
        omega0: [0.3, -0.5, 0.8],
        t: 1.2296620101691314e17,
        omega: [-0.4594842858983518, -0.8958530986625809, 0.052861806626639245],
        attitude: [-0.7187589856910401, 0.2589302335505602, 0.35513406166940115, -0.5387211271929415],
        law: 7e-15,
    },
    Distant {
        what: "with products of inertia, 1 − m = 1e-9",
        periods: "1e9",
        inertia: TURNED,
        omega0: [0.5559078042819826, 0.34713881345765896, 0.1953973773726145],
        t: 186646395798.7185,
        omega: [0.5559081139457283, 0.34713829122023543, 0.1953972805994701],
        attitude: [-0.8740831951387318, -0.4176379907575933, -0.24809489514485655, 0.002449419337049739],
        law: 3e-13,
    },
    Distant {
        what: "with products of inertia, 1 − m = 1e-12",
        periods: "1e9",
        inertia: TURNED,
        omega0: [0.5559078043531684, 0.3471388136813859, 0.19539737766142565],
        t: 241520283411.14215,
        omega: [0.5559084488124544, 0.34713772682140903, 0.19539717626084227],
        attitude: [-0.052895092433699255, 0.8585299556603087, 0.5100030025348695, -0.00503605358954743],
        law: 4e-15,
    },
    Distant {
        what: "with products of inertia, moments equal to 2e-7",
        periods: "1e9",
        inertia: NEAR_SPHERE,
        omega0: [0.3, -0.5, 0.8],
        t: 6.566822193780437e16,
        omega: [0.3000002970673504, -0.5000002090921761, 0.7999997579170145],
        attitude: [0.4747544063129786, 0.26671615247052677, -0.44452708744205266, 0.7112428672598521],
        law: 5e-15,
    },
    Distant {
        what: "with products of inertia, moments equal to 2e-7",
        periods: "1e12",
        inertia: NEAR_SPHERE,
        omega0: [0.3, -0.5, 0.8],
        t: 6.566822193780437e19,
        omega: [0.3002156997500876, -0.500151869239347, 0.7998241314938881],
        attitude: [-0.9908184050650148, -0.040880442133091534, 0.06841026283798435, -0.10921407223366898],
        law: 2e-12,
    },
    Distant {
        what: "awkward",
        periods: "9e20",
        inertia: ORDINARY,
        omega0: [0.31117, -0.49321, 0.87113],
        t: 1e22,
        omega: [0.5426046518068295, -0.009120498765987145, 0.9168165232171948],
        attitude: [0.6705605798330097, 0.279629513129473, -0.1748951723578735, 0.6645054723980093],
        law: 2e-10,
    },
    Distant {
        what: "awkward",
        periods: "7e23",
        inertia: ORDINARY,
        omega0: [0.31117, -0.49321, 0.87113],
        t: 7e24,
        omega: [0.2389782031831057, 0.540494074359913, 0.8616546787363728],
        attitude: [-0.5174877968528948, -0.09469109268787285, 0.006523557229400383, 0.8504101482666987],
        law: 1e-7,
    },
    Distant {
        what: "awkward, symmetric",
        periods: "7e23 (turns)",
        inertia: &[1.3717213, 1.3717213, 2.9163007],
        omega0: [0.31117, -0.49321, 0.87113],
        t: 7e24,
        omega: [0.3373829406448811, -0.47566335192214737, 0.87113],
        attitude: [0.7162815982242388, 0.11962727322679492, -0.17871120448132402, 0.6638465884061515],
        law: 1e-7,
    },
    Distant {
        what: "with products of inertia",
        periods: "8e20",
        inertia: TURNED,
        omega0: [0.3, -0.5, 0.8],
        t: 1e22,
        omega: [-0.22036820852129188, -0.19730320324023834, 0.9640555479252593],
        attitude: [-0.5940053719114374, -0.12978437596717785, -0.5638081998730388, 0.5589579122358755],
        law: 2e-10,
    },
    Distant {
        what: "with products of inertia",
        periods: "6e23",
        inertia: TURNED,
        omega0: [0.3, -0.5, 0.8],
        t: 7e24,
        omega: [-0.2840691871661043, -0.1767895991438009, 0.9500926684648685],
        attitude: [0.8950514007017357, 0.14699602497433956, 0.3926792167408507, -0.15191507984198355],
        law: 1e-7,
    },
    Distant {
        what: "spherical (turns)",
        periods: "5e37",
        inertia: &[1.3717213, 1.3717213, 1.3717213],
        omega0: [0.31117, -0.49321, 0.87113],
        t: 3e38,
        omega: [0.31117, -0.49321, 0.87113],
        attitude: [-0.11556825889991221, 0.2948417082197218, -0.46732936629832234, 0.8254184441991393],
        law: 5e-8,
    },
];

pub(crate) fn measured() -> Vec<f64> {
    let error = |distant: &Distant| {
        let start = State {
            time: 0.0,
            attitude: Attitude::identity(),
            omega: AngularVelocity::from_array(distant.omega0),
        };
        let motion = match *distant.inertia {
            [a, b, c] => FreeMotion::of_moments([a, b, c], start),
            [xx, yy, zz, xy, xz, yz] => {
                let inertia = InertiaTensor::with_negative_products([xx, yy, zz], [xy, xz, yz]).unwrap();
                FreeMotion::of(
                    &Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).unwrap()),
                    start,
                )
            }
            _ => panic!("{}: neither moments nor a tensor", distant.what),
        };
        let attitude = Attitude::from_quaternion(distant.attitude).unwrap();
        let [omega, attitude] = error_of(&motion.unwrap().at(distant.t), distant.omega, attitude);
        let error = omega.max(attitude);
        assert!(error <= distant.law, "{} after {} periods: {error:e}", distant.what, distant.periods);
        error
    };
    DISTANT.iter().map(error).collect()
}

//! Different forms of a value give the same body.

use super::{Folder, budget, csv, estimate, same};

/// Body at a generic place, in SI, with every number in a separate column.
const PLAIN: &str = "\
name,mass,mass sd,x,y,z,x sd,y sd,z sd,Ixx,Iyy,Izz,Ixy,Ixz,Iyz,Ixx sd,Iyy sd,Izz sd,Ixy sd,Ixz sd,Iyz sd,products,about
box,1.25,0.05,0.012,-0.034,0.056,0.001,0.002,0.003,0.0021,0.0033,0.0042,0.0003,-0.0002,0.0004,1e-5,2e-5,3e-5,4e-6,5e-6,6e-6,tensor elements,center
rod,0.4,0,0.3,0.2,-0.1,0,0,0,0.001,0.002,0.0025,0,0,0,0,0,0,0,0,0,tensor elements,center
";

#[test]
fn units_and_errors_have_many_forms() {
    let plain = budget(PLAIN);
    let united = "# products = \"tensor elements\"\n# about = \"center\"\n\
         name,mass,x,y,z,Ixx,Iyy,Izz,Ixy,Ixz,Iyz\n\
         box,1250 g ± 50 g,12 ± 1 mm,(-34 ± 2) mm,5.6 cm +- 3 mm,2100 kg mm^2 +/- 10 kg mm^2,\
         33 ± 0.2 kg cm^2,42 ± 0.3 kg cm^2,3e-4 kg m^2 ± 4e-6 kg m^2,-2e-4 ± 5e-6 kg m^2,4e-4 ± 6e-6 kg m^2\n\
         rod,0.4 kg,0.3 m,0.2 m,-0.1 m,0.001 kg m^2,0.002 kg m^2,0.0025 kg m^2,0,0,0\n";
    same(&plain, &budget(united), "units in cells");
    let headed = "# products = \"tensor elements\"\n# about = \"center\"\n\
         name,mass [g],x [mm],y [mm],z [mm],Ixx (kg mm^2),Iyy (kg mm^2),Izz (kg mm^2),Ixy (kg mm^2),Ixz (kg mm^2),Iyz (kg mm^2)\n\
         box,1250 ± 4 %,12 ± 1,-34 ± 2,56 ± 3,2100 ± 10,3300 ± 20,4200 ± 30,300 ± 4,-200 ± 5,400 ± 6\n\
         rod,400,300,200,-100,1000,2000,2500,0,0,0\n";
    same(&plain, &budget(headed), "units in headings");
    let doubled = headed.replace("# about", "# coverage_factor = 2\n# about").replace(
        "1250 ± 4 %,12 ± 1,-34 ± 2,56 ± 3,2100 ± 10,3300 ± 20,4200 ± 30,300 ± 4,-200 ± 5,400 ± 6",
        "1250 ± 8 %,12 ± 2,-34 ± 4,56 ± 6,2100 ± 20,3300 ± 40,4200 ± 60,300 ± 8,-200 ± 10,400 ± 12",
    );
    same(&plain, &budget(&doubled), "a coverage factor");
    let columns = PLAIN
        .replace("mass sd", "mass ± [%]")
        .replace("1.25,0.05", "1.25,4")
        .replace("x sd,y sd,z sd", "x sd [mm],y sd [mm],z ± [mm]")
        .replace("0.001,0.002,0.003,0.0021", "1,2,3,0.0021");
    same(&plain, &budget(&columns), "errors in columns");
    let inch = PLAIN.replace("mass,mass sd", "mass [lb],mass sd [oz]").replace("1.25,0.05", "1.25 kg,50 g");
    same(
        &plain,
        &budget(&inch.replace("rod,0.4,", "rod,400 g,")),
        "another unit in a cell than in its heading",
    );
}

#[test]
fn points_and_signs_are_taken_as_they_are_said() {
    let plain = budget(PLAIN);
    let flipped = PLAIN.replace("0.0003,-0.0002,0.0004", "-0.0003,0.0002,-0.0004").replacen(
        "tensor elements",
        "positive integrals",
        1,
    );
    same(&plain, &budget(&flipped), "positive integrals");
    // About a point p, the tensor is I + m (d² 1 − d dᵀ), d = c − p. Its errors do not transform in
    // this way, so they are left out.
    let exact = "name,mass,x,y,z,Ixx,Iyy,Izz,Ixy,Ixz,Iyz,products,about\n";
    let m = 1.25;
    let moved = |p: [f64; 3], about: &str| {
        let d = [0.012 - p[0], -0.034 - p[1], 0.056 - p[2]];
        let [x, y, z] = d;
        let e = [
            0.0021 + m * (y * y + z * z),
            0.0033 + m * (x * x + z * z),
            0.0042 + m * (x * x + y * y),
            0.0003 - m * x * y,
            -0.0002 - m * x * z,
            0.0004 - m * y * z,
        ];
        let list: Vec<String> = e.iter().map(|e| format!("{e:e}")).collect();
        budget(&format!(
            "{exact}box,1.25,0.012,-0.034,0.056,{},tensor elements,\"{about}\"\n",
            list.join(",")
        ))
    };
    let central = moved([0.012, -0.034, 0.056], "center");
    same(&central, &moved([0.0; 3], "origin"), "origin");
    same(&central, &moved([0.1, 0.25, -0.3], "100 mm, 25 cm, -0.3 m"), "a point");
    same(&central, &moved([0.1, 0.25, -0.3], "[0.1; 0.25; -0.3]"), "a point in SI");
    // About the origin of another row's frame, which is at that point.
    let [xx, yy, zz, xy, xz, yz] = [0.0021, 0.0033, 0.0042, 0.0003, -0.0002, 0.0004];
    let (x, y, z) = (0.012 - 0.1, -0.034 - 0.25, 0.056 + 0.3);
    let framed = format!(
        "name,parent,mass,x,y,z,at x,at y,at z,Ixx,Iyy,Izz,Ixy,Ixz,Iyz,products,about\nwhole,,,,,,,,,,,,,,,,\n\
         datum,whole,,,,,0.1,0.25,-0.3,,,,,,,,\nbox,whole,1.25,0.012,-0.034,0.056,,,,{:e},{:e},{:e},{:e},{:e},{:e},tensor elements,datum\n",
        xx + m * (y * y + z * z),
        yy + m * (x * x + z * z),
        zz + m * (x * x + y * y),
        xy - m * x * y,
        xz - m * x * z,
        yz - m * y * z,
    );
    same(&central, &budget(&framed), "a frame by name");
}

#[test]
fn rotations_have_the_forms_that_scenarios_have() {
    let list = |columns: &str, cells: &str| {
        budget(&format!(
            "name,parent,at x [mm],at y [mm],at z [mm],{columns},mass [g],x [mm],y [mm],z [mm],Ixx [g mm^2],Iyy [g mm^2],Izz [g mm^2],about\n\
             frame,,10,-20,30,{cells},,,,,,,,\n\
             part,frame,,,,{},500,12,34,-56,200000,300000,400000,center\n",
            ",".repeat(columns.matches(',').count()),
        ))
    };
    // Rotations by 90° about z, then 0° about y and 40° about x.
    let (half, s) = (20_f64.to_radians(), 0.5_f64.sqrt());
    let q = [s * half.cos(), s * half.sin(), s * half.sin(), s * half.cos()];
    let angles = list("roll [deg],pitch [deg],yaw [deg]", "40,0,90");
    let quaternion = list("qw,qx,qy,qz", &q.map(|q| format!("{q:e}")).join(","));
    same(&angles, &quaternion, "a quaternion");
    for written in [
        "{ roll_pitch_yaw = ['40 deg', 0, '90 deg'] }".to_owned(),
        "roll_pitch_yaw = ['40 deg', 0, '90 deg']".to_owned(),
        format!("quaternion = [{:e}, {:e}, {:e}, {:e}]", q[0], q[1], q[2], q[3]),
        format!("quaternion_xyzw = [{:e}, {:e}, {:e}, {:e}]", q[1], q[2], q[3], q[0]),
        format!("mrp = [{:e}, {:e}, {:e}]", q[1] / (1.0 + q[0]), q[2] / (1.0 + q[0]), q[3] / (1.0 + q[0])),
    ] {
        same(&angles, &list("rotate", &format!("\"{written}\"")), &written);
    }
    // A rotation by 90° about z takes x to y and y to −x.
    let quarter = list("yaw [deg]", "90");
    let turned = list("rotate", "\"axis = [0, 0, 1], angle = '90 deg'\"");
    same(&quarter, &turned, "an axis");
    let center = estimate(&quarter).properties.center_of_mass().to_array();
    for (found, expected) in center.iter().zip([0.010 - 0.034, -0.020 + 0.012, 0.030 - 0.056]) {
        assert!((found - expected).abs() < 1e-15, "{center:?}");
    }
}

#[test]
fn trees_are_given_by_paths_or_by_parents() {
    let paths = budget(
        "path,quantity,copies,mass [kg],x [m],y [m],z [m],at x [m],yaw [deg],at x sd [mm],rotate z sd [deg]\n\
         bus,,,,,,,,,,\nbus/panel,2,,0.5,0.1,0.2,0.3,0.4,30,2,0.5\nbus/panel/cell,7,independent,0.01 ± 0.001,0,0.02,0.01,0.05,,,\n",
    );
    let parents = budget(
        "name,parent,quantity,copies,mass [kg],x [m],y [m],z [m],at x [m],yaw [deg],at x sd [mm],rotate z sd [deg]\n\
         cell,panel,7,independent,0.01 ± 0.001,0,0.02,0.01,0.05,,,\npanel,bus,2,alike,0.5,0.1,0.2,0.3,0.4,30,2,0.5\nbus,,,,,,,,,,,\n",
    );
    same(&paths, &parents, "paths and parents");
    assert!((estimate(&paths).properties.mass() - 2.0 * (0.5 + 7.0 * 0.01)).abs() < 1e-15);
    // Two equal panels with seven cells each, weighed one by one.
    assert!((estimate(&paths).sd(0) - 2.0 * 7_f64.sqrt() * 0.001).abs() < 1e-15);
    let one_row = "name,mass [kg],at x sd [mm]\nball,2,3\n";
    assert!((estimate(&budget(one_row)).sd(1) - 0.003).abs() < 1e-15);
}

#[test]
fn a_hollow_part_has_an_inner_radius() {
    let tube =
        budget("name,mass [kg],shape,radius [m],inner_radius [m],length [m]\ntube,3,cylinder,0.5,0.4,1.2\n");
    let inertia = estimate(&tube).properties.inertia().matrix();
    // m (r² + q²)/2 along the axis, m (3 (r² + q²) + l²)/12 across
    let square = 0.5_f64.powi(2) + 0.4_f64.powi(2);
    assert!((inertia[2][2] - 1.5 * square).abs() < 1e-15);
    assert!((inertia[0][0] - 0.25 * (3.0 * square + 1.44)).abs() < 1e-15);
    let error = super::csv("name,mass,outer radius\ntube,3,0.5\n").unwrap_err();
    let hint = error.hint().unwrap_or_default();
    assert!(hint.contains("radius, inner radius, top radius") && !hint.contains("yaw"), "{hint}");
    for list in ["name,mass [kg],inner_radius [m]\na,3,0.4\n", "name,inner_radius [m]\na,0.4\n"] {
        let error = super::csv(list).unwrap_err().to_string();
        assert!(error.contains("inner_radius [m] = 0.4 must be left out of a"), "{error}");
    }
}

#[test]
fn shapes_have_the_keys_of_scenarios() {
    let list = |columns: &str, cells: &str| budget(&format!("name,{columns}\npart,{cells}\n"));
    // 100 × 50 × 20 mm of 2700 kg/m³
    let m = 2700.0 * 0.1 * 0.05 * 0.02;
    let (a, b, c): (f64, f64, f64) = (0.1, 0.05, 0.02);
    let tensor = format!(
        "{m:e},{:e},{:e},{:e}",
        m / 12.0 * (b * b + c * c),
        m / 12.0 * (a * a + c * c),
        m / 12.0 * (a * a + b * b)
    );
    let tensor = list("mass,Ixx,Iyy,Izz", &tensor);
    for (columns, cells) in [
        ("shape,size [mm],material", "box,100 × 50 × 20,aluminium"),
        ("shape,size,density", "box,100 x 50 x 20 mm,2.7 g/cm^3"),
        ("shape,size,density [g/cm^3]", "box,\"100 mm, 5 cm, 20 mm\",2.7"),
        ("shape,size [cm],mass [g]", "box,\"['100 mm', '50 mm', '20 mm']\",270"),
        ("shape,size,mass [g]", "box,0.1; 0.05; 0.02,270"),
    ] {
        same(&tensor, &list(columns, cells), cells);
    }
    let known = list("shape,size [mm],density", "box,100 × 50 × 20,2700 kg/m^3 ± 3 %");
    same(&list("shape,size [mm],mass [g]", "box,100 × 50 × 20,270 ± 8.1"), &known, "the error of a density");
    let plate = list("shape,size [mm],density [kg/m^2]", "plate,300 × 200,4.5");
    same(&list("shape,size [mm],thickness [mm],density", "plate,300 × 200,2,2250 kg/m^3"), &plate, "a plate");
    let tube = list("shape,radius [mm],length [mm],ends,mass [kg]", "cylinder_shell,40,0.3 m,true,1.5");
    let open = list("shape,radius [mm],length [mm],ends,mass [kg]", "cylinder_shell,40,0.3 m,no,1.5");
    let izz = |budget| estimate(budget).properties.inertia().matrix()[2][2];
    assert!((izz(&open) - 1.5 * 0.04 * 0.04).abs() < 1e-15 && izz(&tube) < izz(&open));
    let moved = list("shape,radius [mm],height [mm],mass [kg],x [mm],y [mm],z [mm]", "cone,30,90,0.7,5,6,7");
    let center = estimate(&moved).properties.center_of_mass().to_array();
    assert_eq!(center, [0.005, 0.006, 0.007]);
}

#[test]
fn files_are_read_by_reference() {
    let folder = Folder::new("reference");
    let stl = |scale: f64| {
        // Right tetrahedron with edges 1, 2, 3 along the axes.
        let corners = [[0.0, 0.0, 0.0], [scale, 0.0, 0.0], [0.0, 2.0 * scale, 0.0], [0.0, 0.0, 3.0 * scale]];
        let mut text = "solid t\n".to_owned();
        for face in [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] {
            text += "facet normal 0 0 0\nouter loop\n";
            for k in face {
                let [x, y, z] = corners[k];
                text += &format!("vertex {x} {y} {z}\n");
            }
            text += "endloop\nendfacet\n";
        }
        text + "endsolid t\n"
    };
    folder.write("t.stl", stl(10.0));
    folder.write(
        "body.toml",
        "[[body.part]]\nshape = \"tetrahedron\"\nvertices = [[0,0,0],['10 mm',0,0],[0,'20 mm',0],[0,0,'30 mm']]\nmass = '80 g'\n",
    );
    folder.write(
        "report.txt",
        "Mass = 2.50 kilograms\nCenter of mass: ( meters )\n X = 1.00  Y = -2.00  Z = 0.50\n\
         Moments of inertia: ( kilograms * square meters )\nTaken at the center of mass and aligned with the output coordinate system.\n\
         Lxx = 10.00  Lxy = 1.00   Lxz = -0.50\nLyx = 1.00   Lyy = 8.00   Lyz = 0.75\nLzx = -0.50  Lzy = 0.75   Lzz = 5.00\n\
         Moments of inertia: ( kilograms * square meters )\nTaken at the output coordinate system.\n\
         Ixx = 20.63  Ixy = -4.00  Ixz = 0.75\nIyx = -4.00  Iyy = 11.13  Iyz = -1.75\nIzx = 0.75   Izy = -1.75  Izz = 17.50\n",
    );
    let list = |columns: &str, cells: &str| {
        let text = format!("name,at x [mm],yaw [deg],{columns}\npart,15,25,{cells}\n");
        folder.read("list.csv", text).unwrap()
    };
    let only = |file: polhode_budget::read::BudgetFile| file.configurations[0].budget.clone();
    let shape = only(list(
        "shape,vertices,mass [g]",
        "tetrahedron,\"[[0,0,0],['10 mm',0,0],[0,'20 mm',0],[0,0,'30 mm']]\",80",
    ));
    for (columns, cells) in [
        ("mesh,unit,mass [g]", "t.stl,mm,80"),
        ("file,unit,density [g/cm^3]", "t.stl,mm,80"),
        ("file", "body.toml"),
        ("scenario", "body.toml"),
    ] {
        same(&shape, &only(list(columns, cells)), cells);
    }
    let report = only(list("cad", "report.txt"));
    // These products are positive integrals, as the parallel axes prove.
    let tensor = only(list(
        "mass,x,y,z,Ixx,Iyy,Izz,Ixy,Ixz,Iyz,products,about",
        "2.5,1,-2,0.5,10,8,5,1,-0.5,0.75,positive integrals,center",
    ));
    same(&tensor, &report, "a report");
    let read = list("file,mass sd [%],x sd [mm],Ixx sd [%]", "report.txt,2,4,1");
    let whole = estimate(&only(read.clone()));
    assert!((whole.sd(0) - 0.05).abs() < 1e-15);
    let lines = read.sources();
    assert!(
        lines.iter().any(
            |line| line.ends_with("list.csv: report.txt: products of inertia positive, by parallel axes")
        ),
        "{lines:?}"
    );
}

#[test]
fn what_is_taken_as_given_is_said() {
    let file = csv(
        "a remark,,,,\n\nname,mass [g],x,y,z,notes,Part number,quantity\nbolt,5 ± 0.1,0.1,0.2,0.3,of steel,M4,4\nnut,2,0.1,0.2,0.35,,,1\n",
    )
    .unwrap();
    let lines = file.sources();
    let expected = [
        "2 rows",
        "all rows are in one frame, \"whole\", because no row has a parent",
        "rows above the headings in row 3 were ignored",
        "ignored columns: notes, Part number",
        "no unit given, SI assumed (kg, m, rad): x, y, z",
        "± is one standard deviation: no coverage_factor is given",
        "2 parts without tensor or shape: all mass at one point",
        "1 row with several copies, which share the same error",
    ];
    assert_eq!(lines, expected.map(|line| format!("list.csv: {line}")));
    assert!((estimate(&file.configurations[0].budget).sd(0) - 0.0004).abs() < 1e-18);
}

#[test]
fn numbers_may_have_a_decimal_comma_in_a_list_with_semicolons() {
    let comma = budget("name;mass [g];x [mm];y [mm];z [mm]\na;12,5 ± 0,25;-3,25;1;2\nb;7;1,125;0,5;0\n");
    let point = budget("name,mass [g],x [mm],y [mm],z [mm]\na,12.5 ± 0.25,-3.25,1,2\nb,7,1.125,0.5,0\n");
    same(&comma, &point, "proved");
    let told = budget(
        "# decimal = \"comma\"\nname\tmass [g]\tx [mm]\ty [mm]\tz [mm]\na\t12,5 ± 0,25\t-3,25\t1\t2\nb\t7\t1,125\t0,5\t0\n",
    );
    same(&told, &point, "told");
    let about = budget("name;mass [g];x [mm];y [mm];z [mm];ixx [g mm^2];iyy [g mm^2];izz [g mm^2];about;shape;size [mm]\n\
                        a;12,5;1;2;3;900;900;900;1,5 mm; 0; 2,5 mm;;\nb;7,5;0;0;0;;;;;box;10,5 × 20 × 5,25\nc;7,5;0;0;0;;;;;box;\"['10.5 mm', '20 mm', '5.25 mm']\"\n"
        .replace("1,5 mm; 0; 2,5 mm", "\"1,5 mm; 0; 2,5 mm\"").as_str());
    let other = budget(
        "name,mass [g],x [mm],y [mm],z [mm],ixx [g mm^2],iyy [g mm^2],izz [g mm^2],about,shape,size [mm]\n\
                        a,12.5,1,2,3,900,900,900,1.5 mm; 0; 2.5 mm,,\nb,15,0,0,0,,,,,box,10.5 × 20 × 5.25\n",
    );
    same(&about, &other, "lists of lengths");
    let with_mark = budget(
        "\u{feff}# title = \"µ\"\r\n\"name\",\"mass [g]\",\"x [mm]\",y [mm],z [mm]\r\n\"a\",12.5 ± 0.25,-3.25,1,2\r\n\r\n,,,,\r\nb,7,1.125,0.5,0\r\n",
    );
    same(&with_mark, &point, "a byte order mark, quotes, and other ends of lines");
}

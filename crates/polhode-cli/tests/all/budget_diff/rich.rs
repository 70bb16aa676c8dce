//! Parts list that uses every feature.

/// Parts list that uses every feature, without its rows.
pub(super) const RICH: &str = r#"title = "Rich"
products = "tensor elements"
about = "center"
coverage_factor = 2
ignore = ["colour"]
configurations = ["stowed", "deployed", "stored"]
[growth]
E = "25 %"
B = "4 %"
[[group]]
name = "arms"
mass = 0.9
center = 0.1
tensor = 0.2
position = 0.3
rotation = 0.4
density = 0.6
[result]
about = ["10 mm", 0, 0]
axes = { axis = [0, 0, 1], angle = "30 deg" }
draws = 2000
seed = 7
basis = "basic"
[[limit]]
name = "the centre"
of = "center distance"
along = "z"
from = ["1 mm", 0, 0]
most = "3 m"
basis = "basic"
[[limit]]
name = "the product"
of = "product"
axes = ["x", "y"]
about = "origin"
products = "positive integrals"
least = -50
most = 60
[[limit]]
name = "the axis"
of = "tilt"
along = [1, 2, 3]
number = 2
within = "80 deg"
[[limit]]
name = "the ratio"
of = "principal ratio"
numbers = [1, 3]
most = 2.5
[[site]]
name = "disc"
at = [0, 0, "-10 mm"]
radius = "80 mm"
normal = "z"
rim = true
most = "0.3 kg"
[[site]]
name = "line"
at = [0, 0, "1 mm"]
to = [0, 0, "1 m"]
[[site]]
name = "bolts"
at = [0, 0, "20 mm"]
radius = "70 mm"
normal = "z"
holes = 8
first = "x"
sizes = ["10 g", "20 g"]
[ballast]
most = "0.7 kg"
deviations = 1.5
[[tank]]
name = "fuel"
frame = "tank"
configuration = ["stowed", "deployed"]
shape = "cylinder"
radius = "150 mm"
length = "300 mm"
ends = ["11 mm", "22 mm"]
density = 900
settles = "-z"
fill = "75 %"
fill_sd = "2 %"
density_sd = "1 %"
group = "arms"
[[tank]]
name = "gas"
mass = "1.5 kg"
products = "positive integrals"
[[tank.table]]
mass = "1 kg"
level = "120 mm"
center = [0, 0, "5 mm"]
moments = [0.2, 0.21, 0.1]
products = [0.01, 0, 0]
[[tank.table]]
mass = "3 kg"
level = "320 mm"
center = [0, 0, "5 mm"]
moments = [0.6, 0.61, 0.3]
products = [0.01, 0, 0]
[[tank]]
name = "ball"
mass = 0.25
mass_sd = "20 g"
shape = "ellipsoid"
semi_axes = ["90 mm", "91 mm", "92 mm"]
density = 1000
settles = "x"
[[tank]]
name = "crate"
mass = 0.5
shape = "box"
size = ["100 mm", "110 mm", "120 mm"]
density = 1000
settles = "y"
[[tank]]
name = "grain"
table = "grain.csv"
mass = "0.75 kg"
density_sd = "3 %"
[sequence]
configuration = "stowed"
until = "60 s"
spin = [0, 0, "30 rpm"]
[[burn]]
tank = "fuel"
from = "10 s"
until = "30 s"
flow = "0.2 kg/s"
[[burn]]
tank = "gas"
until = "20 s"
mass = "0.5 kg"
[[drop]]
time = "40 s"
rows = ["adapter"]
[[deploy]]
time = "35 s"
configuration = "deployed"
[[exit]]
position = [0, 0, "-1 m"]
radius = "30 mm"
axis = [0, 0, 1]
share = 0.4
[[exit]]
position = [0, 0, "-2 m"]
share = 0.6
"#;

/// Table file of the solid grain, and a changed one.
pub(super) const GRAINS: [(&str, &str); 2] =
    [("grain.csv", "mass [kg],z [mm]\n1,5\n3,9\n"), ("heavy.csv", "mass [kg],z [mm]\n1,5\n3.5,9\n")];

/// Rows of the list.
pub(super) const PARTS: &str = "name,parent,quantity,copies,configuration,group,maturity,growth,subtotal [kg],allowable [kg],mass [kg],x [mm],y [mm],z [mm],Ixx [kg m^2],Iyy [kg m^2],Izz [kg m^2],Ixy [kg m^2],Ixz [kg m^2],Iyz [kg m^2],at x [mm],at y [mm],at z [mm],yaw [deg],rotate z sd [deg],colour
bus,,,,,,,,,90,20 ± 0.5,1,2,3 ± 0.7,1.1 ± 0.02,1.2,1.3,0.01,0.02,0.03,0,0,0,0,,red
tank,bus,,,,,E,,,,1.2,0,0,0,,,,,,,0,0,-400,0,,
cells,bus,4,independent,,,,0.08,2.4,3.5,0.6 ± 0.01,4,-2,0,,,,,,,0,0,80,0,,
arm,bus,,,stowed; stored,arms,B,,,,0.9 ± 0.02,50,0,0,,,,,,,100 ± 4,0,0,15,0.3,
arm,bus,,,deployed,arms,B,,,,0.9 ± 0.02,50,0,0,,,,,,,300,0,0,75,0.3,
boom,bus,,,,arms,,,,,0.8 ± 0.03,5,6,7,,,,,,,-100,0,0,0,0.2,
adapter,bus,,,,,,,,,3,0,0,-900,,,,,,,0,0,0,0,,
";

//! Tensors, by the geometry of their links.

use super::{Example, Rule};
use crate::finding::Severity::{Note, Suspect};

/// A link with a box of 0.1 m × 0.2 m × 0.3 m and 1.2 kg, whose moments are 0.013, 0.010 and 0.005 kg·m².
macro_rules! block {
    ($origin:literal, $inertia:literal, $visual:literal) => {
        concat!(
            "<link name=\"arm\">\n  <inertial>\n    <origin ",
            $origin,
            "/>\n    <mass value=\"1.2\"/>\n    <inertia ",
            $inertia,
            "/>\n  </inertial>\n  <visual>\n    <origin ",
            $visual,
            "/>\n    <geometry><box size=\"0.1 0.2 0.3\"/></geometry>\n  </visual>\n</link>"
        )
    };
}

pub(super) const RULES: [Rule; 10] = [
    Rule {
        code: "gyration.too_large",
        severity: Suspect,
        title: "the radius of gyration √(i3/m) is no longer than the body",
        why: "Mass beyond all that is drawn: the tensor belongs to another link, or to another unit. Light links that are padded with small equal \
              moments are a note.",
        mend: "Compute the tensor of the link's own mesh: polhode inertia MESH --mass KG --write urdf.",
        example: Some(Example {
            model: block!(
                "xyz=\"0 0 0\"",
                "ixx=\"0.91\" iyy=\"0.83\" izz=\"0.74\" ixy=\"0\" ixz=\"0\" iyz=\"0\"",
                "xyz=\"0 0 0\""
            ),
            old: "ixx=\"0.91\" iyy=\"0.83\" izz=\"0.74\"",
            new: "ixx=\"0.013\" iyy=\"0.010\" izz=\"0.005\"",
        }),
    },
    Rule {
        code: "inertia.unit",
        severity: Suspect,
        title: "moments of inertia are in kg·m²",
        why: "CAD programs print g·mm², kg·mm² or lb·in², and a robot's file does not say which it took over.",
        mend: "Convert all six: 1 kg·mm² is 1e-6 kg·m², 1 g·mm² is 1e-9 kg·m². A fix is written where geometry and density then agree.",
        example: Some(Example {
            model: block!(
                "xyz=\"0 0 0\"",
                "ixx=\"13000\" iyy=\"10000\" izz=\"5000\" ixy=\"0\" ixz=\"0\" iyz=\"0\"",
                "xyz=\"0 0 0\""
            ),
            old: "ixx=\"13000\" iyy=\"10000\" izz=\"5000\"",
            new: "ixx=\"0.013\" iyy=\"0.010\" izz=\"0.005\"",
        }),
    },
    Rule {
        code: "inertia.geometry",
        severity: Suspect,
        title: "the moments in sum are within a factor of three of the geometry's, and none is off by a known slip",
        why: "All mass at the corners of a box has three times the moments of the uniform box in sum, and no mass within the box has more; thin \
              shells have twice the moments at most. All three may be smaller if mass and volume give less than 500 kg/m³. Below that factor a tensor is suspect if a known slip explains every element: the mass left out, a power of ten, a wrong \
              pair of lengths, full lengths in the place of half ones, the formula of a slender rod.",
        mend: "Compute the tensor of the link's own mesh: polhode inertia MESH --mass KG --write urdf. A fix is written where one slip alone explains \
               all elements, the mass and the density.",
        example: Some(Example {
            model: block!(
                "xyz=\"0 0 0\"",
                "ixx=\"0.013\" iyy=\"0.010\" izz=\"0.010\" ixy=\"0\" ixz=\"0\" iyz=\"0\"",
                "xyz=\"0 0 0\""
            ),
            old: "izz=\"0.010\"",
            new: "izz=\"0.005\"",
        }),
    },
    Rule {
        code: "inertia.order",
        severity: Suspect,
        title: "the six elements stand in their own places",
        why: "URDF and SDF name each element, MJCF's fullinertia is xx yy zz xy xz yz; a list by rows, xx xy xz yy yz zz, puts products where moments \
              belong.",
        mend: "Move the elements to their places.",
        example: Some(Example {
            model: block!(
                "xyz=\"0 0 0\"",
                "ixx=\"0.005\" iyy=\"0.010\" izz=\"0.013\" ixy=\"0\" ixz=\"0\" iyz=\"0\"",
                "xyz=\"0 0 0\""
            ),
            old: "ixx=\"0.005\" iyy=\"0.010\" izz=\"0.013\"",
            new: "ixx=\"0.013\" iyy=\"0.010\" izz=\"0.005\"",
        }),
    },
    Rule {
        code: "inertia.placeholder",
        severity: Suspect,
        title: "a tensor follows from the mass and the shape of its own link",
        why: "The identity, or one round number on link after link, stands in for a tensor. It is a note where no geometry contradicts, and where \
              the links are dummies of some grams that are fixed to others. One finding names all links that share a number.",
        mend: "Compute the tensor of each link's own mesh: polhode inertia MESH --mass KG --write urdf.",
        example: Some(Example {
            model: block!(
                "xyz=\"0 0 0\"",
                "ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"",
                "xyz=\"0 0 0\""
            ),
            old: "ixx=\"1\" iyy=\"1\" izz=\"1\"",
            new: "ixx=\"0.013\" iyy=\"0.010\" izz=\"0.005\"",
        }),
    },
    Rule {
        code: "inertia.about_origin",
        severity: Suspect,
        title: "a tensor is about the centre of mass",
        why: "CAD programs print two, one about the centre of mass and one about the origin. The latter counts the mass's distance twice.",
        mend: "Subtract m (c² 1 − c cᵀ), or take the other one of the two.",
        example: Some(Example {
            model: block!(
                "xyz=\"0 0 0.15\"",
                "ixx=\"0.040\" iyy=\"0.037\" izz=\"0.005\" ixy=\"0\" ixz=\"0\" iyz=\"0\"",
                "xyz=\"0 0 0.15\""
            ),
            old: "ixx=\"0.040\" iyy=\"0.037\"",
            new: "ixx=\"0.013\" iyy=\"0.010\"",
        }),
    },
    Rule {
        code: "inertia.sign",
        severity: Suspect,
        title: "the products of a tensor are −∫xy dm, −∫xz dm, −∫yz dm",
        why: "Some CAD programs print +∫xy dm. Moments and plausibility stay the same, and the principal axes are mirrored.",
        mend: "Change the sign of all products, or of those that were taken from the mirrored side.",
        example: Some(Example {
            model: block!(
                "xyz=\"0 0 0\"",
                "ixx=\"0.01116\" iyy=\"0.010\" izz=\"0.00684\" ixy=\"0\" ixz=\"0.00337\" iyz=\"0\"",
                "rpy=\"0 0.5 0\""
            ),
            old: "0.00337",
            new: "-0.00337",
        }),
    },
    Rule {
        code: "inertia.conjugate",
        severity: Suspect,
        title: "the attitude of an inertial takes its components to the link's: I_link = R I Rᵀ",
        why: "The inverse attitude, numbers along the link's axes beside an attitude that is left over, or a quaternion x y z w where w x y z belongs: \
              each gives a possible tensor along wrong axes.",
        mend: "Write the inverse attitude, or none where the numbers are along the link's axes.",
        example: Some(Example {
            model: block!(
                "rpy=\"0 -0.5 0\"",
                "ixx=\"0.013\" iyy=\"0.010\" izz=\"0.005\" ixy=\"0\" ixz=\"0\" iyz=\"0\"",
                "rpy=\"0 0.5 0\""
            ),
            old: "0 -0.5 0",
            new: "0 0.5 0",
        }),
    },
    Rule {
        code: "mass.center_outside",
        severity: Suspect,
        title: "the centre of mass lies in the convex hull of the link's geometry",
        why: "It is a mean of the body's points, so no distribution of mass within the geometry has it outside. The distance is that from the convex \
              hull of all shapes of the link; up to 2 % of their diagonal is allowed for simplified meshes and parts that are not \
              drawn.",
        mend: "Look for a wrong sign, another unit, or a centre that is measured from another frame. A fix is written where one of these alone brings it \
               to the geometry's centroid.",
        example: Some(Example {
            model: block!(
                "xyz=\"0 0 0.4\"",
                "ixx=\"0.013\" iyy=\"0.010\" izz=\"0.005\" ixy=\"0\" ixz=\"0\" iyz=\"0\"",
                "xyz=\"0 0 0\""
            ),
            old: "xyz=\"0 0 0.4\"",
            new: "xyz=\"0 0 0.1\"",
        }),
    },
    Rule {
        code: "geometry.unreadable",
        severity: Note,
        title: "shapes can be measured",
        why: "What cannot be measured is not compared with the inertia: a mesh that is not there, lies outside the roots, or is of a kind that is not \
              read.",
        mend: "Name the folder that holds the packages: --root DIR.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <visual><geometry><mesh filename=\"package://arm/arm.stl\"/></geometry></visual>\n</link>",
            old: "<mesh filename=\"package://arm/arm.stl\"/>",
            new: "<box size=\"0.1 0.2 0.3\"/>",
        }),
    },
];

//! Marching cubes: extracts the surface where values on a grid change sign, cell by cell.
//!
//! Source of the table: MarchingCubeCpp (public domain), which MuJoCo uses. Each entry contains the
//! number of triangles, then the cell edges with their corners, four bits each, the lowest first.

/// Corners at the ends of each edge. The bits of a corner are its steps along x, y and z.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Returns triangles in grid units, in single precision as in MuJoCo. `numbers` is ordered by x,
/// then y, then z.
pub(super) fn triangles(numbers: &[f32], [nx, ny, nz]: [usize; 3]) -> Vec<[[f32; 3]; 3]> {
    let mut triangles = Vec::new();
    for z in 0..nz - 1 {
        for y in 0..ny - 1 {
            for x in 0..nx - 1 {
                let corners: [f32; 8] = std::array::from_fn(|corner| {
                    let [i, j, k] = steps(corner);
                    numbers.get(((z + k) * ny + y + j) * nx + x + i).copied().unwrap_or(f32::NAN)
                });
                let signs =
                    (0..8).filter(|corner| corners[*corner] < 0.0).fold(0, |all, corner| all | 1 << corner);
                let entry = TABLE[signs];
                let vertex = |number: u64| {
                    let [low, high] = EDGES[(entry >> (4 + 4 * number) & 15) as usize];
                    let [i, j, k] = steps(low);
                    let mut place = [x + i, y + j, z + k].map(|c| c as f32);
                    let axis = (high ^ low) >> 1; // 1, 2, 4
                    place[axis] += corners[low] / (corners[low] - corners[high]);
                    place
                };
                triangles
                    .extend((0..entry & 15).map(|t| [vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2)]));
            }
        }
    }
    triangles
}

const fn steps(corner: usize) -> [usize; 3] {
    [corner & 1, corner >> 1 & 1, corner >> 2]
}

#[rustfmt::skip]
const TABLE: [u64; 256] = [
    0x0, 0x8401, 0x9051, 0x9845942, 0x4a11, 0x8a10812, 0x594a12, 0x8a99a5a153, 0x51b1, 0x4081b52, 0xb901b02, 0x98bb818413,
    0x54ab5a2, 0xab88b0b503, 0xb9aa949043, 0xb98ab82, 0x6821, 0x6402602, 0x8260592, 0x4566525923, 0x682a142, 0x2112a26a3,
    0x4a12685903, 0x592152126a164, 0xb516822, 0x51b0264063, 0x82601b90b3, 0xb919619261644, 0x682ab54a53, 0x250ab5a526a24,
    0x90494ab9a6824, 0xab9a926a23, 0x7291, 0x2978402, 0x5720522, 0x5744787283, 0x9724a12, 0x2978a10813, 0x14a5720523,
    0x18a5711787284, 0x97251b2, 0x9721b58403, 0x122171b73, 0xb717211242844, 0x97254ab5a3, 0xb50b08ab82974, 0x2070a704a7ab4,
    0x8ab8b72873, 0x7689782, 0x6477494093, 0x7655606803, 0x5747642, 0x4a18976873, 0x109619a166974, 0x68060576514a4, 0x57656a15a3,
    0xb517689783, 0x409497647b514, 0xb0176bb606804, 0x764741b713, 0x976896b54ab44, 0x970b506a0ab0765, 0x4a0680b70760ab5,
    0xab6b762, 0xa631, 0x84063a2, 0x590a632, 0xa634598493, 0x4631432, 0x1033060863, 0x594631433, 0x3158356388594, 0x1b5a632,
    0xa63084b513, 0x3a6b901b03, 0x84181b98b3a64, 0x46556b63b3, 0xb503b03086384, 0x604b90b063b64, 0xb98b863b63, 0xa823a22,
    0x2300343a43, 0x90523a82a3, 0x392459493a434, 0x3122181483, 0x2303102, 0x1481823129054, 0x2312159253, 0x1b5a823a23,
    0x3a434023051b4, 0x901b91823a834, 0x41b43a4924234b95, 0x23b42b8244b54, 0x2303b50b3, 0x48249043b4b94235, 0xb939232, 0x63a2972,
    0x8403a69723, 0x63a2057253, 0x728784574a634, 0x7293146343, 0x860631037294, 0x7205706314614, 0x8638728158578315, 0xb51297a633,
    0xb512973a68404, 0x1b717201263a4, 0x28424172171ba635, 0x63b6b54659724, 0x3b53506306089725, 0xb72b63b04b46b205,
    0x728b783b83864, 0x89aa939733, 0x97309303a40a4, 0x5707a073a0a84, 0x457473a433, 0x1738978714814, 0x3103097393,
    0x8058148738318575, 0x5717312, 0x97393a89a1b54, 0x9707340343ab515, 0x73a71b7807017a85, 0x1b7417a47a734, 0x3b53973483893545,
    0xb503b07307094, 0xb734802, 0x3b71, 0xb371, 0x7b38402, 0x7b39052, 0x7b39845943, 0xa1437b2, 0xb37108a183, 0x59037b4a13,
    0xa15a598a97b34, 0x7513712, 0x4081375173, 0x1300393793, 0x7139877818414, 0x5477434a33, 0x750a7037aa084, 0x79390330a04a4,
    0x98a9a37933, 0x37b6822, 0x37b6402603, 0x7b30596823, 0x59252645637b4, 0x68214a7b33, 0x26a2a1021b374, 0x7b30592684a14,
    0x159192a12a267b35, 0x2687513713, 0x5137534026424, 0x3793901308264, 0x9269379419139645, 0x4a34375472684, 0xa37a26a50a02a755,
    0x4a0a39039376825, 0x379a396a96924, 0x9b32932, 0x849b32933, 0x20330b05b3, 0x32b24b284b454, 0xa14329b393, 0xb329b2a108a04,
    0x5b0b3203a144, 0x5b35a152858a5325, 0x3211252953, 0x2952513214084, 0x3201302, 0x1321284183, 0x9325499434a34,
    0x5085295a353258a5, 0x320304a343, 0x8a2a322, 0x9b88b6b363, 0x649b00b6b364, 0x5b0b300383684, 0x64565b36b3, 0xb36b689b84a14,
    0x6a16b360969b6105, 0x368380b30b054a15, 0xb365b615616a4, 0x1353853685894, 0x9519409369649135, 0x130368063, 0x6434132,
    0x36834a3953543895, 0x9506a32, 0x4a30438038364, 0x6a31, 0xba67b62, 0x84067ba6b3, 0x590ba67b63, 0x7ba67a5984584, 0x6744717b13,
    0xb167b6b08604, 0x7b17146740594, 0x15917b1861671985, 0x75665a51a3, 0x51a5a67568404, 0x191691a69674, 0x1a61841791981675,
    0x7546742, 0x6756508603, 0x4674790493, 0x6787982, 0xa8bb878273, 0x27a0740aa7b4, 0x82787ba8b5904, 0x27b2592a42452ba5,
    0x7b12712148244, 0x102127b173, 0x27b2b18218145905, 0x7b12719219154, 0x81a7517182784, 0xa40a51a27a75a025, 0x79078271a7a87015,
    0x792a412, 0x7547482783, 0x7525022, 0x9047942742484, 0x2791, 0xba99a2a623, 0xa62a29ba90844, 0x520ba55a2a624,
    0x2842a625b2ba2455, 0x9b16912966144, 0x6296086b161069b5, 0xb14b05b62b20b465, 0x5b18622, 0x9525122161a64, 0x1a61625125298405,
    0x20121a62a3, 0x84128162161a4, 0x5465629523, 0x2956258658504, 0x4606202, 0x8621, 0x9b8ba82, 0x9ba9a40943, 0xba8b805b03,
    0x45a5ba2, 0x89b8b14813, 0x9b0b102, 0x5b80b48b4b14, 0x15b1, 0xa89a951a53, 0x51a95a09a0a44, 0xa818012, 0xa411, 0x8949542,
    0x951, 0x4801, 0x0,
];

# polhode 0.1.0: mass properties for rocketpy.Rocket, without a motor, in kg, m, kg m^2: bracket
# the body's z axis is the rocket's axis, towards the nose; x and y are its e_1 and e_2
mass = 2.3
# I_11, I_22, I_33, I_12, I_13, I_23 about the centre of mass; products are negative integrals: I_12 = -integral(x y dm)
inertia = (3.1, 4.2, 5.3, 0.4, -0.3, 0.2)
# coordinate of the centre of mass along the axis, from the body's origin
center_of_mass_without_motor = 0.23
coordinate_system_orientation = "tail_to_nose"
# where the centre of mass is across the axis: Rocket.add_cm_eccentricity(*center_of_mass_eccentricity)
center_of_mass_eccentricity = (0.11, -0.07)

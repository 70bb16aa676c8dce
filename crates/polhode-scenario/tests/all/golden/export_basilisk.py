# polhode 0.1.0: mass properties for the hub of a Basilisk spacecraft, in kg, m, kg m^2: bracket
# the body's axes and origin are those of the hub's frame B
def set_hub(spacecraft):
    spacecraft.hub.mHub = 2.3
    # from the origin of B to the centre of mass Bc, in B
    spacecraft.hub.r_BcB_B = [[0.11], [-0.07], [0.23]]
    # tensor about Bc in B; products are negative integrals: I[0][1] = -integral(x y dm)
    spacecraft.hub.IHubPntBc_B = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]

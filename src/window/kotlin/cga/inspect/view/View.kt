package cga.inspect.view

/**
 * What of the lighting model the window shows.
 *
 * @param title the name in the panel, with the sheet's letters.
 * @param legend how to read the picture.
 * @param factor the number that `factors.frag` knows it by, or null where the scene's own shader shows it.
 */
internal enum class View(
    val title: String,
    val legend: String,
    val factor: Int? = null,
) {
    FULL("everything", "L_O, the whole formula."),
    EMISSION("A  emission M_e", "M_e times the colour of the object; no light has a say in it."),
    AMBIENT("B  ambient M_d·L_a", "Black while L_a is 0: raise it under \"Scene\"."),
    DIFFUSE("C  diffuse M_d·cos α", "Matt reflection: brightest where the surface faces the light."),
    SPECULAR("D  specular M_s·(cos β)^k", "The highlight: it moves when you move."),
    NORMAL("normal n", "View space: red is right, green is up, blue is towards you.", 0),
    TO_CAMERA("to camera v", "View space, as for n. Blue all over: you look at what is ahead.", 1),
    TO_LIGHT("to light l", "View space, as for n, for the light chosen below.", 2),
    HALF_VECTOR("half vector h", "(l + v) / |l + v|, as for n. Blinn-Phong compares it with n.", 3),
    REFLECTED("reflected r", "2(n·l)n − l, as for n. Phong compares it with v.", 4),
    COS_ALPHA("cos α = n·l", "Black 0, white 1; blue is negative: the light is behind the surface.", 5),
    COS_BETA("cos β = n·h or r·v", "Black 0, white 1, blue negative; the exponent k is not applied yet.", 6),
    HIGHLIGHT("(cos β)^k", "The same to the power of k: larger k, smaller highlight.", 7),
    ATTENUATION("attenuation F", "1 / (K_c + K_l·d + K_q·d²). White is 1, orange more: up to 2.", 8),
    CONE("cone I", "White within the inner angle, black beyond the outer one; 1 for a point light.", 9),
    ;

    /** Whether it speaks of one light and not of all that are on. */
    val isOfOneLight: Boolean get() = factor != null && this != NORMAL && this != TO_CAMERA
}

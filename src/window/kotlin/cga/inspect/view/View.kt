package cga.inspect.view

import cga.coach.ui.say

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
    FULL(say("everything", "alles"), say("L_O, the whole formula.", "L_O, die ganze Formel.")),
    EMISSION(
        "A  emission M_e",
        say(
            "M_e times the colour of the object; no light has a say in it.",
            "M_e mal die Farbe des Objekts; kein Licht hat daran Anteil.",
        ),
    ),
    AMBIENT(
        say("B  ambient M_d·L_a", "B  Umgebung M_d·L_a"),
        say("Black while L_a is 0: raise it below.", "Schwarz, solange L_a 0 ist: unten erhöhen."),
    ),
    DIFFUSE(
        say("C  diffuse M_d·cos α", "C  diffus M_d·cos α"),
        say(
            "Matt reflection: brightest where the surface faces the light.",
            "Matte Reflexion: am hellsten, wo die Fläche zum Licht zeigt.",
        ),
    ),
    SPECULAR(
        say("D  specular M_s·(cos β)^k", "D  spekular M_s·(cos β)^k"),
        say("The highlight: it moves when you move.", "Das Glanzlicht: Es wandert mit dem Blick."),
    ),
    NORMAL(
        say("normal n", "Normale n"),
        say("View space: red is right, green is up, blue is towards you.", "Viewspace: Rot ist rechts, Grün oben, Blau zu Ihnen hin."),
        0,
    ),
    TO_CAMERA(
        say("to camera v", "zur Kamera v"),
        say(
            "View space, as for n. Blue all over: you look at what is ahead.",
            "Viewspace, wie bei n. Überall blau: Man sieht, was vor einem liegt.",
        ),
        1,
    ),
    TO_LIGHT(
        say("to light l", "zum Licht l"),
        say("View space, as for n, for the light chosen below.", "Viewspace, wie bei n, für das unten gewählte Licht."),
        2,
    ),
    HALF_VECTOR(
        say("half vector h", "Half-Vector h"),
        say(
            "(l + v) / |l + v|, as for n. Blinn-Phong compares it with n.",
            "(l + v) / |l + v|, wie bei n. Blinn-Phong vergleicht ihn mit n.",
        ),
        3,
    ),
    REFLECTED(
        say("reflected r", "gespiegelt r"),
        say("2(n·l)n − l, as for n. Phong compares it with v.", "2(n·l)n − l, wie bei n. Phong vergleicht ihn mit v."),
        4,
    ),
    COS_ALPHA(
        "cos α = n·l",
        say(
            "Black 0, white 1; blue is negative: the light is behind the surface.",
            "Schwarz 0, Weiß 1; Blau ist negativ: Das Licht ist hinter der Fläche.",
        ),
        5,
    ),
    COS_BETA(
        "cos β = n·h or r·v",
        say(
            "Black 0, white 1, blue negative; the exponent k is not applied yet.",
            "Schwarz 0, Weiß 1, Blau negativ; noch ohne den Exponenten k.",
        ),
        6,
    ),
    HIGHLIGHT(
        "(cos β)^k",
        say("The same to the power of k: larger k, smaller highlight.", "Dasselbe hoch k: größeres k, kleineres Glanzlicht."),
        7,
    ),
    ATTENUATION(
        say("attenuation F", "Abschwächung F"),
        say(
            "1 / (K_c + K_l·d + K_q·d²). White is 1, orange more: up to 2.",
            "1 / (K_c + K_l·d + K_q·d²). Weiß ist 1, Orange mehr: bis 2.",
        ),
        8,
    ),
    CONE(
        say("cone I", "Kegel I"),
        say(
            "White within the inner angle, black beyond the outer one; 1 for a point light.",
            "Weiß im inneren Winkel, schwarz jenseits des äußeren; 1 beim Punktlicht.",
        ),
        9,
    ),
    ;

    /** Whether it speaks of one light and not of all that are on. */
    val isOfOneLight: Boolean get() = factor != null && this != NORMAL && this != TO_CAMERA
}

package cga.coach.host

import cga.coach.ui.KeyHelp
import cga.coach.ui.say

/** The keys of the window. */
internal object Keys {
    /** All that are not the program's own. */
    val ALL: List<KeyHelp> =
        listOf(
            KeyHelp(
                "Tab",
                say("panel and cursor; the right button turns the camera", "Tafel und Cursor; die rechte Taste dreht die Kamera"),
            ),
            KeyHelp("H, F1", say("these keys", "diese Tasten")),
            KeyHelp("P", say("time stands still, or goes on", "Zeit anhalten oder weiterlaufen lassen")),
            KeyHelp("R", say("load the program anew; time and drive go on", "Programm neu laden; Zeit und Fahrt gehen weiter")),
            KeyHelp("F5", say("start from the beginning", "von vorn beginnen")),
            KeyHelp("F12", say("save the picture", "Bild speichern")),
            KeyHelp("W A S D, " + say("mouse", "Maus"), say("the program's own", "gehören dem Programm")),
        )
}

package cga.coach.host

import cga.coach.ui.Columns

/** A key of the window, and what it does. */
internal class Keys private constructor(
    val name: String,
    val effect: String,
) {
    companion object {
        /** All that are not the program's own. */
        val ALL: List<Keys> =
            listOf(
                Keys("Tab", say("panel and cursor; the right button turns the camera", "Tafel und Cursor; die rechte Taste dreht die Kamera")),
                Keys("H, F1", say("these keys", "diese Tasten")),
                Keys("P", say("time stands still, or goes on", "Zeit anhalten oder weiterlaufen lassen")),
                Keys("R", say("load the program anew; time and drive go on", "Programm neu laden; Zeit und Fahrt gehen weiter")),
                Keys("F5", say("start from the beginning", "von vorn beginnen")),
                Keys("F12", say("save the picture", "Bild speichern")),
                Keys("W A S D, " + say("mouse", "Maus"), say("the program's own", "gehören dem Programm")),
            )
        val COLUMNS = Columns(0.25f, 0.75f)
    }
}

package cga.inspect

import cga.coach.ui.KeyHelp
import cga.coach.ui.say

/** The keys of the window, for people. */
internal object InspectedKeys {
    val ALL: List<KeyHelp> =
        listOf(
            KeyHelp("W A S D", say("drive and steer", "fahren und lenken")),
            KeyHelp(say("mouse", "Maus"), say("turns the camera about the motorcycle", "dreht die Kamera um das Motorrad")),
            KeyHelp("1 – 8", say("steps of the sheet", "Schritte des Blattes")),
            KeyHelp("B", say("Phong or Blinn-Phong", "Phong oder Blinn-Phong")),
            KeyHelp(
                "Tab",
                say("panel and cursor: click a pixel for its numbers", "Tafel und Cursor: Ein Klick zeigt die Zahlen eines Pixels"),
            ),
            KeyHelp("V", say("what is shown; with Shift the one before", "was gezeigt wird; mit Umschalt das vorige")),
            KeyHelp("F", say("Phong beside Blinn-Phong", "Phong neben Blinn-Phong")),
            KeyHelp("G", say("where the lights are", "wo die Lichter sind")),
            KeyHelp("P", say("time stands still, or goes on", "Zeit anhalten oder weiterlaufen lassen")),
            KeyHelp("C", say("copy the numbers as Kotlin code", "die Zahlen als Kotlin-Code kopieren")),
            KeyHelp("R", say("read the shaders anew", "Shader neu lesen")),
            KeyHelp("F9", say("save all input since the start", "alle Eingaben seit dem Start speichern")),
            KeyHelp("F12", say("save the picture", "Bild speichern")),
            KeyHelp("Esc", say("close the window", "Fenster schließen")),
        )
}

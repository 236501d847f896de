package cga.exercise

import cga.exercise.game.Game

fun main() {
    println(Game.HELP)
    Game().run()
}
